"""Bounds of pieces of any degree are never too small, and never more than a hair too large."""

import math

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from tests.support_segments import Row, blend, sampled, slowed
from vrts.check.curves.extremes import fastest
from vrts.check.curves.high_pieces import is_high
from vrts.check.curves.timeline_arrays import curves
from vrts.engine.memory.records import Segment

SAMPLES = 4001
LENGTH = st.floats(1e-3, 1.5)
SHARE = st.floats(0.0, 1.0)
COEFFICIENT = st.one_of(
    st.floats(-5.0, 5.0), st.just(0.0), st.sampled_from([1e-14, -1e-20, 1e-300])
)


@st.composite
def rows(draw: st.DrawFn, length: float) -> Row:
    """Blends, blends under a changing rate of time, and any polynomial at all, on [0, length]."""
    kind = draw(st.sampled_from(["blend", "slowed", "any", "still"]))
    if kind == "still":
        return (draw(st.floats(-3.0, 3.0)),)
    if kind == "any":
        terms = draw(st.lists(COEFFICIENT, min_size=1, max_size=9))
        return tuple(c / length**power for power, c in enumerate(terms))
    start, before, after = (draw(st.floats(-3.0, 3.0)) for _ in range(3))
    if kind == "blend":
        return blend(start, before, after, length)
    rate = draw(SHARE)
    change = draw(st.floats(-1.0, 1.0)) / length
    return slowed(blend(start, before, after, length), rate, change)


@st.composite
def timelines(draw: st.DrawFn) -> list[Segment]:
    found: list[Segment] = []
    t = draw(st.sampled_from([0.0, 3600.0]))
    for _ in range(draw(st.integers(1, 4))):
        end = t + draw(LENGTH)
        found.append(Segment(t, end, tuple(draw(rows(end - t)) for _ in range(7)), None))
        t = end
    return found


@given(timelines(), SHARE, SHARE)
def test_bounds_hold_everywhere_and_are_reached(
    segments: list[Segment], first: float, last: float
) -> None:
    begin, end = segments[0].start_s, segments[-1].end_s
    t0 = min(end, begin + min(first, last) * (end - begin))
    t1 = min(end, begin + max(first, last) * (end - begin))
    spread = curves(segments).spread(np.array([t0]), np.array([t1]))
    known = [spread.upper[0], -spread.lower[0], spread.speed[0], spread.acceleration[0]]
    most = np.full((4, 7), -math.inf)
    slack = np.zeros((4, 7))
    for k, (start_s, end_s, coefficients, _) in enumerate(segments):
        if (
            start_s > t1
            or end_s < t0
            or (start_s == t1 > t0)
            or (end_s == t0 and k + 1 < len(segments))
        ):
            continue
        low, high = max(t0, start_s) - start_s, min(t1, end_s) - start_s
        u = np.linspace(low, high, SAMPLES)
        step, whole = (high - low) / (SAMPLES - 1), np.array([end_s - start_s])
        for i, row in enumerate(coefficients):
            sizes = tuple(map(abs, row))
            values = sampled(row, u)
            for n, found in enumerate(
                (values, -values, np.abs(sampled(row, u, 1)), np.abs(sampled(row, u, 2)))
            ):
                order = max(0, n - 1)
                most[n, i] = max(most[n, i], found.max())
                # between samples a curve rises by at most f'' step^2 / 8
                bend = float(sampled(sizes, whole, order + 2)[0]) * step * step / 8
                rounding = 1e-13 * float(sampled(sizes, whole, order)[0])
                slack[n, i] = max(slack[n, i], bend + rounding)
    high = all(is_high(segment.coefficients) for segment in segments)  # widened by rounding
    for n in range(4):
        tiny = 0.0 if high else 1e-14 * (1.0 + np.abs(most[n]))
        assert (known[n] >= most[n] - tiny).all()
        assert (known[n] <= most[n] + slack[n] + tiny).all()


@given(st.data(), LENGTH)
def test_the_fastest_moment_is_the_fastest(data: st.DataObject, length: float) -> None:
    row = data.draw(rows(length))
    found = fastest(row, length)
    u = np.linspace(0.0, length, SAMPLES)
    size = float(sampled(tuple(map(abs, row)), np.array([length]), 1)[0]) + 1e-290
    assert 0.0 <= found.at <= length
    assert found.size >= np.abs(sampled(row, u, 1)).max() - 1e-14 * size
    there = abs(sampled(row, np.array([found.at]), 1)[0])
    assert abs(found.size - there) <= 1e-13 * size
