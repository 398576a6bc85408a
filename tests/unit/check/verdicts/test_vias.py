"""Via points passed on segments of any degree, against dense samples of the tool."""

import numpy as np
import pytest

from tests.laws import first
from tests.support_runs import run, with_segments
from tests.support_segments import blend, sampled, segment, slowed
from vrts.base.pose import distance
from vrts.check.task.task import ViaPoint
from vrts.check.verdicts.vias import visits_of
from vrts.engine.memory.records import Segment
from vrts.robots.kinematics.kinematics import forward

SCENE = run().scene
ARM = SCENE.robot.arm


def tool_at(piece: Segment, u: float) -> tuple[float, float, float]:
    a, b, c, d, e, f = (float(sampled(row, np.array([u]))[0]) for row in piece.coefficients[:6])
    return (forward(ARM, (a, b, c, d, e, f)) @ SCENE.X_FT).translation


def motion() -> list[Segment]:
    """A blend, and one that is slowed down to a stop in the middle of it."""
    _, q2, q3, _, q5, _ = ARM.ready
    first = blend(0.0, 0.0, 1.5, 1.0)
    second = slowed(blend(sum(first), 1.5, 1.0, 1.0), 1.0, -0.9)
    still = ((q2 + 0.3,), (q3 - 0.9,), (0.0,), (q5 + 0.4,), (0.0,))
    return [segment(first, *still), segment(second, *still, start_s=1.0)]


@pytest.mark.parametrize(("piece", "u"), [(0, 0.4), (0, 0.95), (1, 0.2), (1, 0.9)])
@pytest.mark.parametrize("radius", first(1, [0.02, 0.002]))
def test_the_times_near_a_point_are_those_of_dense_samples(
    piece: int, u: float, radius: float
) -> None:
    pieces = motion()
    x, y, z = tool_at(pieces[piece], u)
    point = (x, y, z + 0.5 * radius)
    (found,) = visits_of(with_segments(*pieces), [ViaPoint("gate", point, radius, None)])
    grid = np.linspace(0.0, 1.0, 4001)
    gaps = [(p.start_s + v, distance(tool_at(p, v), point)) for p in pieces for v in grid.tolist()]
    inside = [t for t, gap in gaps if gap <= radius]
    start, end = found.intervals[0]
    assert len(found.intervals) == 1
    assert start == pytest.approx(inside[0], abs=5e-4)
    assert end == pytest.approx(inside[-1], abs=5e-4)
    assert found.nearest_m <= radius


def test_a_point_beyond_where_the_arm_was_stopped_is_missed() -> None:
    pieces = motion()
    full = blend(sum(pieces[0].coefficients[0]), 1.5, 1.0, 1.0)  # as if nobody had stopped it
    gone_on = pieces[1]._replace(coefficients=(full, *pieces[1].coefficients[1:]))
    via = ViaPoint("gate", tool_at(gone_on, 0.75), 0.01, None)
    (missed,) = visits_of(with_segments(*pieces), [via])
    (met,) = visits_of(with_segments(pieces[0], gone_on), [via])
    assert missed.intervals == ()
    assert met.intervals
    grid = np.linspace(0.0, 1.0, 2001).tolist()
    nearest = min(distance(tool_at(p, u), via.point) for p in pieces for u in grid)
    assert nearest - 1e-4 <= missed.nearest_m <= nearest + 6e-4


def test_a_tool_that_stands_still_stays_where_it_is() -> None:
    (piece,) = (segment(*((q,) for q in ARM.ready), length=3.0),)
    near = ViaPoint("near", tool_at(piece, 0.0), 0.01, None)
    far = ViaPoint("far", (0.5, 0.5, 0.5), 0.01, None)
    found = visits_of(with_segments(piece), [near, far])
    assert [visit.intervals for visit in found] == [((0.0, 3.0),), ()]
