"""Curves with pieces above degree 3 among cubics: values, bounds, jumps."""

import math

import numpy as np
import pytest

from tests.support_segments import blend, sampled, segment, slowed
from vrts.check.curves.timeline_arrays import curves
from vrts.engine.memory.records import Segment

CUBIC = (0.0, 0.0, 3.0, -2.0)  # from 0 to 1 in 1 s, at rest at both ends
QUARTIC = blend(1.0, 0.0, -2.0, 1.0)
STOPPING = slowed(blend(0.0, -2.0, 1.0, 1.0), 1.0, -0.5)  # degree 8, under a falling rate of time


def line() -> list[Segment]:
    return [
        segment(CUBIC),
        segment(QUARTIC, start_s=1.0),
        segment(STOPPING, start_s=2.0),
        segment((0.5,), start_s=3.0),
    ]


def test_every_piece_is_evaluated_with_all_its_coefficients() -> None:
    known = curves(line())
    u = np.linspace(0.0, 0.999, 50)
    for k, row in enumerate((CUBIC, QUARTIC, STOPPING, (0.5,))):
        assert len(row) == (4, 5, 9, 1)[k]
        assert known.values(k + u)[:, 0] == pytest.approx(sampled(row, u), abs=1e-12)
        assert known.velocities(k + u)[:, 0] == pytest.approx(sampled(row, u, 1), abs=1e-12)
    assert (known.values(u)[:, 1:] == 0.1).all()


def test_bounds_over_pieces_and_parts_of_them_are_those_of_dense_samples() -> None:
    known = curves(line())
    for t0, t1 in ((0.0, 1.0), (1.2, 1.9), (1.0, 2.0), (2.1, 2.9), (0.5, 2.5), (0.0, 4.0)):
        spread = known.spread(np.array([t0]), np.array([t1]))
        times = np.linspace(t0, math.nextafter(t1, 0.0), 20001)
        values, speeds = known.values(times)[:, 0], np.abs(known.velocities(times)[:, 0])
        assert spread.upper[0, 0] == pytest.approx(values.max(), abs=1e-7)
        assert spread.lower[0, 0] == pytest.approx(values.min(), abs=1e-7)
        assert spread.speed[0, 0] == pytest.approx(speeds.max(), abs=1e-6)
        slopes = np.abs(np.diff(known.velocities(times)[:, 0])) / (times[1] - times[0])
        steady = np.diff(known.piece_at(times)) == 0
        assert spread.acceleration[0, 0] == pytest.approx(slopes[steady].max(), rel=1e-3)


@pytest.mark.parametrize("which", [slice(0, 1), slice(1, 3), slice(0, 6)])
@pytest.mark.parametrize(
    "times",
    [
        [(0.1, 0.9), (1.2, 1.9), (2.1, 2.9), (3.2, 3.3)],  # parts of pieces, of all kinds
        [(0.0, 1.0), (1.0, 2.0), (2.0, 3.0), (3.0, 4.0)],  # whole pieces
        [(0.5, 2.5), (0.0, 4.0)],  # more than one
    ],
)
def test_some_coordinates_turn_as_far_as_they_do_among_all(
    times: list[tuple[float, float]], which: slice
) -> None:
    known = curves(line())
    start, end = np.array(times).T
    middle = 0.5 * (start + end)
    values, spread = known.values(middle), known.spread(start, end)
    farthest = np.maximum(spread.upper - values, values - spread.lower)
    assert (known.values(middle, which) == values[:, which]).all()
    assert (known.turn(start, middle, end, which) == farthest[:, which]).all()
    assert (farthest[:, 0] > 0.0).any()


def test_the_acceleration_of_a_blend_is_largest_in_between() -> None:
    known = curves([segment(QUARTIC)])
    whole = known.pieces
    # c (6 t - 6 t^2) with c = -2: 0 at both ends, 3 in the middle
    assert whole.acceleration[0, 0] == pytest.approx(3.0, abs=1e-12)
    assert whole.speed[0, 0] == pytest.approx(2.0, abs=1e-12)
    part = known.spread(np.array([0.0]), np.array([0.25]))
    assert part.acceleration[0, 0] == pytest.approx(12.0 * 0.25 * 0.75, abs=1e-12)


def test_what_stands_still_in_a_high_piece_has_no_speed_at_all() -> None:
    assert (curves([segment(STOPPING)]).pieces.speed[0, 1:] == 0.0).all()


def test_rows_padded_with_zeros_are_cubics() -> None:
    padded = segment((*CUBIC, 0.0, 0.0, 0.0, 0.0, 0.0))
    known = curves([padded])
    assert known.high is None
    assert known.values(np.array([0.5]))[0, 0] == pytest.approx(0.5)


def test_velocities_jump_where_they_do_and_nowhere_else() -> None:
    known = curves(line())
    stops = sampled(STOPPING, np.array([1.0]), 1)[0]
    assert stops != pytest.approx(0.0, abs=1e-3)  # cut while it moves
    assert known.jumps().tolist() == [3.0]
    steeper = segment(blend(0.0, 0.25, 1.0, 1.0), start_s=1.0)
    assert curves([segment(CUBIC), steeper]).jumps().tolist() == [1.0]


def test_a_run_in_which_no_time_passes_stands_still() -> None:
    known = curves([segment((0.5,), length=0.0)])
    times = np.array([-1.0, 0.0, 1.0])
    assert known.values(times)[:, 0].tolist() == [0.5, 0.5, 0.5]
    assert not known.velocities(times).any()


def test_a_timeline_without_a_segment_has_no_curves() -> None:
    with pytest.raises(ValueError, match="without a segment"):
        curves([])
