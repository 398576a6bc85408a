"""Bounds on place, direction and speed of the tool hold at every instant of an interval."""

import numpy as np
import pytest

from tests.support_programs import run_body
from tests.unit.robots.test_every_robot import PICK_AND_PLACE, run_in, scene_of
from vrts.check.curves.timeline_arrays import Curves, curves
from vrts.check.curves.tool_motion import Bounded, tool_angle, tool_distance, tool_speed
from vrts.engine.run import Run

BODY = " MOVE a\n MOVES b\n BREAK\n MOVES c\n READY"


@pytest.fixture(scope="module", params=["puma761", "ur5"])
def run(request: pytest.FixtureRequest) -> Run:
    if request.param == "puma761":
        return run_body(BODY)
    return run_in(scene_of("ur5"), PICK_AND_PLACE)


def quantities(run: Run, motion: Curves) -> list[Bounded]:
    return [
        tool_distance(run.scene, motion, (0.9, 0.0, 0.1)),
        tool_angle(run.scene, motion, (0.0, 0.6, -0.8)),
        tool_speed(run.scene, motion),
    ]


@pytest.mark.parametrize("which", [0, 1, 2], ids=["distance", "angle", "speed"])
def test_values_lie_within_the_bound_around_the_middle(run: Run, which: int) -> None:
    motion = curves(run.timeline.segments)
    quantity = quantities(run, motion)[which]
    random = np.random.default_rng(3)
    start = motion.starts + random.random(len(motion.starts)) * (motion.ends - motion.starts)
    end = start + random.random(len(start)) * (motion.ends - start)
    value, change = quantity(start, 0.5 * (start + end), end)
    for share in (0.0, 0.1, 0.35, 0.8, 1.0):
        t = start + (0.999 * share + 5e-4) * (end - start)
        other, _ = quantity(t, t, t)
        assert (np.abs(other - value) <= change + 1e-9).all()


def test_places_and_speeds_are_those_of_the_run(run: Run) -> None:
    motion = curves(run.timeline.segments)
    times = np.linspace(0.05, run.horizon_s - 0.05, 60)
    gap, _ = quantities(run, motion)[0](times, times, times)
    speed, _ = quantities(run, motion)[2](times, times, times)
    for k, t in enumerate(times.tolist()):
        before, at, after = (
            np.array((run.at(s).X_WF @ run.scene.X_FT).translation) for s in (t - 1e-5, t, t + 1e-5)
        )
        assert gap[k] == pytest.approx(float(np.linalg.norm(at - (0.9, 0.0, 0.1))), abs=1e-9)
        assert speed[k] == pytest.approx(float(np.linalg.norm(after - before)) / 2e-5, abs=2e-3)
