"""How long a rounded corner takes is a number of the arm, not only of its acceleration."""

from dataclasses import replace
from itertools import pairwise

import pytest

from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import compile_source
from vrts.scene.default import robot_alone

CORNER = """\
.PROGRAM corner
  MOVE #a
  MOVE #b
  MOVE #c
.END
.LOCATIONS
#a 0 -60 90 0 0 0
#b 80 -60 90 0 0 0
#c 80 -60 160 0 0 0
.END
"""


def run(acceleration_s: float, blend_s: float | None) -> Run:
    module = compile_source(SourceFile("corner.v2", CORNER)).module
    assert module is not None
    alone = robot_alone()
    arm = replace(alone.robot.arm, acceleration_time=acceleration_s, blend_time=blend_s)
    return execute(module, replace(alone, robot=replace(alone.robot, arm=arm)))


def corner_s(found: Run) -> float:
    """Return how long the first corner takes: the one piece of degree 4."""
    first = next(s for s in found.timeline.segments if max(map(len, s.coefficients)) == 5)
    return first.end_s - first.start_s


@pytest.mark.parametrize(
    ("blend_s", "expected_s"), [(None, 0.448), (0.28, 0.28), (0.336, 0.336), (0.56, 0.56)]
)
def test_a_corner_takes_as_long_as_the_arm_says(blend_s: float | None, expected_s: float) -> None:
    found = run(0.224, blend_s)
    assert all(motion.blended for motion in found.motions[:2])
    assert corner_s(found) == pytest.approx(expected_s, abs=1e-9)


@pytest.mark.parametrize("blend_s", [0.224, 0.28, 0.56])
def test_the_arm_has_no_jump_in_place_or_speed_where_corners_begin(blend_s: float) -> None:
    segments = run(0.224, blend_s).timeline.segments
    for before, after in pairwise(segments):
        t = before.end_s - before.start_s
        for joint in range(6):
            row, following = before.coefficients[joint], after.coefficients[joint]
            place = sum(c * t**k for k, c in enumerate(row))
            speed = sum(k * c * t ** (k - 1) for k, c in enumerate(row) if k)
            assert following[0] == pytest.approx(place, abs=1e-9)
            assert (following[1] if len(following) > 1 else 0.0) == pytest.approx(speed, abs=1e-9)
