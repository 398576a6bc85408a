"""Laws of distances and of the certified check, against sampling."""

import math

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.collision_runs import Story, down, fixed, movable, scene_of
from tests.near_misses import near_miss, sampled
from vrts.base.pose import IDENTITY, Pose, rotation_about
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import plan
from vrts.check.curves.timeline_arrays import curves
from vrts.engine.memory.records import Segment
from vrts.geometry.coal_engine import distance, nearest
from vrts.geometry.proposing.choose import here
from vrts.geometry.proving.prover import Prover
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape
from vrts.geometry.support import extent

SIZE = st.floats(0.005, 0.4)
LENGTH = st.floats(-0.6, 0.6)


@st.composite
def poses(draw: st.DrawFn) -> Pose:
    axis = draw(st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: math.hypot(*v) > 0.1))
    size = math.hypot(*axis)
    unit = (axis[0] / size, axis[1] / size, axis[2] / size)
    angle = draw(st.floats(-math.pi, math.pi))
    return Pose(rotation_about(unit, angle), draw(st.tuples(LENGTH, LENGTH, LENGTH)))


@st.composite
def shapes(draw: st.DrawFn) -> Shape:
    a, b, c = draw(SIZE), draw(SIZE), draw(SIZE)
    match draw(st.sampled_from(["box", "cylinder", "hull"])):
        case "box":
            return Box((a, b, c))
        case "cylinder":
            return Cylinder(a, b)
        case _:
            return Hull(((0.0, 0.0, 0.0), (a, 0.0, 0.0), (0.0, b, 0.0), (0.0, 0.0, c), (a, b, c)))


def turned(angle: float, off: float) -> Pose:
    """Return a turn about x; `off` is the rounding of its axis."""
    c, s = math.cos(angle), math.sin(angle)
    return Pose((1.0, off, off, off, c, -s, -off, s, c), (0.0, 0.0, 0.0))


CORNER = Hull(
    ((0.0, 0.0, 0.0), (0.25, 0.0, 0.0), (0.0, 0.25, 0.0), (0.0, 0.0, 0.25), (0.25, 0.25, 0.25))
)


@example(CORNER, IDENTITY, CORNER, turned(2.0, 3e-309))  # coal gives up in one of the orders
@example(CORNER, turned(0.14, 1e-23), CORNER, turned(-2.9, 1e-18))
@given(shapes(), poses(), shapes(), poses())
def test_distance_is_symmetric(a: Shape, X_WA: Pose, b: Shape, X_WB: Pose) -> None:
    first, second = Piece(a, IDENTITY), Piece(b, IDENTITY)
    there, back = distance(first, X_WA, second, X_WB), distance(second, X_WB, first, X_WA)
    # the depth of deep overlaps of round shapes is only approximate
    assert there == pytest.approx(back, abs=3e-6 if there > -5e-3 else 0.05 * abs(there))


@given(shapes(), poses(), shapes(), poses())
def test_no_gap_along_a_direction_is_more_than_the_distance(
    a: Shape, X_WA: Pose, b: Shape, X_WB: Pose
) -> None:
    first, second = Piece(a, IDENTITY), Piece(b, IDENTITY)
    found = nearest(first, X_WA, second, X_WB)
    for direction in (found.normal, X_WA.normal, X_WB.approach):
        gap = extent(second, X_WB, direction).lower - extent(first, X_WA, direction).upper
        assert gap <= max(found.distance, -0.01) + 3e-6
    if found.distance > 1e-3:
        assert math.dist(found.first, found.second) == pytest.approx(found.distance, abs=1e-6)


@given(st.integers(0, 2**32 - 1))
def test_the_spread_of_curves_is_exact(seed: int) -> None:
    random = np.random.default_rng(seed)
    count = int(random.integers(1, 30))
    ends: npt.NDArray[np.float64] = np.cumsum(random.uniform(0.01, 0.5, count))
    starts = np.concatenate([[0.0], ends[:-1]])
    powers = random.normal(size=(count, 7, 4)) * (1.0, 3.0, 5.0, 9.0)
    powers[random.random(powers.shape) < 0.2] = 0.0
    rows: list[list[list[float]]] = powers.tolist()
    begin: list[float] = starts.tolist()
    finish: list[float] = ends.tolist()
    segments = [
        Segment(begin[k], finish[k], tuple(tuple(row) for row in rows[k]), None)
        for k in range(count)
    ]
    known = curves(segments)
    t0 = float(random.uniform(0.0, finish[-1]))
    t1 = float(random.uniform(t0, finish[-1]))
    spread = known.spread(np.array([t0]), np.array([t1]))
    inside = [t for t in ends.tolist() if t0 < t < t1]
    just_before = [math.nextafter(t, 0.0) for t in inside]
    times = np.array([*np.linspace(t0, t1, 3000), *inside, *just_before])
    values, speeds = known.values(times), np.abs(known.velocities(times))
    assert (values.max(axis=0) <= spread.upper[0] + 1e-9).all()
    assert (values.min(axis=0) >= spread.lower[0] - 1e-9).all()
    assert (speeds.max(axis=0) <= spread.speed[0] + 1e-9).all()
    assert np.allclose(values.max(axis=0), spread.upper[0], atol=1e-4)
    assert np.allclose(values.min(axis=0), spread.lower[0], atol=1e-4)
    slope = np.abs(np.diff(known.velocities(times[:3000]), axis=0)) / max((t1 - t0) / 2999, 1e-12)
    steady = np.diff(known.piece_at(times[:3000])) == 0
    if t1 - t0 > 1e-3 and steady.any():
        assert (slope[steady].max(axis=0) <= spread.acceleration[0] + 1e-3).all()


def cases(last: int, *, high: bool) -> list[object]:
    """Return the first twenty cases, and all others of `--all`."""
    thorough = (pytest.mark.thorough,)
    return [
        pytest.param(first, high, marks=thorough if first else ()) for first in range(0, last, 20)
    ]


CUBICS = cases(200, high=False)
DEGREE_8 = cases(60, high=True)


@pytest.mark.thorough
@pytest.mark.parametrize(("first", "high"), CUBICS + DEGREE_8)
def test_no_contact_that_sampling_finds_is_missed(first: int, high: bool) -> None:
    hits = 0
    for seed in range(first, first + 20):
        case = near_miss(seed, high=high)
        times = sampled(case)
        if not len(times):
            continue
        hits += 1
        report = check_collisions(case.scene, case.record, clearance=False)
        found = [event for event in report.contacts if event.second == case.kind]
        assert found, seed
        assert min(event.start_s for event in found) <= times[0] + 1e-3
        assert max(event.end_s for event in found) >= times[-1] - 1e-3
    assert hits >= 10


@pytest.mark.parametrize(
    ("seed", "kind", "shortest_s"),
    [
        (428, "rod", 3e-4),
        (865, "plate", 5e-4),
        (1338, "post", 5e-4),
        (1754, "post", 5e-4),
        (1868, "rod", 7e-4),
        (1954, "post", 0.0),
    ],
)
def test_contacts_shorter_than_a_millisecond_are_found(
    seed: int, kind: str, shortest_s: float
) -> None:
    case = near_miss(seed)
    times = sampled(case)
    assert times[-1] - times[0] == pytest.approx(shortest_s, abs=1e-9)
    report = check_collisions(case.scene, case.record, clearance=False)
    (event,) = (event for event in report.contacts if event.second == kind)
    assert event.start_s <= times[0] + 2e-4
    assert event.end_s >= times[-1] - 2e-4
    assert event.end_s - event.start_s < shortest_s + 1e-3


def story(seed: int) -> Story:
    """Pick, carry along joint and straight motions past a post, drop, leave."""
    random = np.random.default_rng(seed)
    x, y, z = random.uniform((0.8, 0.05, -0.3), (1.1, 0.4, -0.1)).tolist()
    post = (x, y, z)
    can = movable(
        "can1", Piece(Cylinder(0.03, 0.0575), IDENTITY), at=(0.9, 0.0, -0.2425), on="table"
    )
    other = movable(
        "can2", Piece(Cylinder(0.03, 0.0575), IDENTITY), at=(1.1, 0.1, -0.2425), on="table"
    )
    scene = scene_of(
        fixed("table", Piece(Box((0.4, 0.7, 0.02)), IDENTITY), at=(1.0, 0.0, -0.32)),
        fixed("post", Piece(Cylinder(0.005, 0.1), IDENTITY), at=post),
        can,
        other,
    )
    told = Story(scene, (0.0, -1.0, 1.5, 0.0, 1.0, 0.0))
    told.move(down(0.9, 0.0, -0.1))
    told.line(down(0.9, 0.0, -0.225))
    told.grasp("can1")
    told.line(down(0.9, 0.0, float(random.uniform(-0.2, 0.1))))
    told.move(down(0.9, 0.35, float(random.uniform(-0.2, 0.1))), 0.8)
    told.line(down(float(random.uniform(0.8, 1.1)), 0.35, -0.2), 0.5)
    fall = told.X_WP.translation[2] + 0.225
    told.release("can1", "table", fall=fall)
    told.line(down(0.9, 0.35, 0.0))
    told.wait(0.3)
    return told


@pytest.mark.parametrize("seed", range(6))
def test_no_sample_is_nearer_than_the_certified_clearance(seed: int) -> None:
    told = story(seed)
    record = told.record()
    report = check_collisions(told.scene, record)
    motion = curves(record.timeline.segments)
    todo = plan(told.scene, record, motion)
    prober = Prober(told.scene.robot.arm, motion, todo.solids, Prover(todo.solids, here()))
    random = np.random.default_rng(seed)
    pairs = todo.pairs
    rows = np.arange(len(pairs.first)).repeat(40)
    times = pairs.start_s[rows] + random.random(len(rows)) * (pairs.end_s - pairs.start_s)[rows]
    distances = prober.distances(pairs.first[rows], pairs.second[rows], times)
    deep = distances < -pairs.tolerance[rows] - 1e-5
    groups = {todo.groups[int(group)] for group in np.unique(pairs.group[rows[deep]])}
    assert groups <= {(event.first, event.second) for event in report.contacts}
    if not report.contacts:
        assert report.clearance is not None
        least = float(distances[pairs.counts[rows]].min())
        assert least > report.clearance.distance_m - report.clearance.tolerance_m - 1e-5
