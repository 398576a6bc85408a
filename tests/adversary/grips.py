"""Grips: a thing between the pads is closed on, lifted, set down and let go, and touched again.

Every step of it comes to a threshold or just not: pads before they close, how far they press, what
is held and its support, how far they open, and how deep they touch what lies free again. A fixed
thing faces a finger or what is held.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tests.adversary.cases import Case, box, hull, rod
from tests.adversary.features import CORNER, EDGE, FACE, facing, feature
from tests.adversary.kinematics import frames
from tests.collision_runs import BRANCH, TEXT, Line, Record, fixed, hermite, movable, scene_of
from vrts.base.pose import IDENTITY, Pose, rotation_about
from vrts.base.source import Span
from vrts.engine.memory.events import Cause, Event, Grasped, HandCommanded, Released
from vrts.engine.memory.records import GRAVITY, Lie, Placement, Segment
from vrts.geometry.shapes import Box, Cylinder, Piece, Shape
from vrts.robots.catalog import robot
from vrts.robots.kinematics.kinematics import solve
from vrts.robots.model import Robot

Array: TypeAlias = npt.NDArray[np.float64]
Random: TypeAlias = np.random.Generator

THING, SHELF, GRASPED = "thing", "shelf", "grasped"
WIDEST = 0.035  # [m] half of what fits between the pads
BESIDE = (-1e-3, -1e-4, -3e-5, -1.5e-5, 1.5e-5, 3e-5, 1e-4, 1e-3)  # a threshold
STRICT, PRESSED, LOWERED = -2e-4, -1e-3, -1.2e-3  # gaps at which a touch becomes a contact [m]
FREE = 2e-4  # [m] a finger farther away has come free
CAUSE = Cause("grips", 1, Span(TEXT, 0, 4))


class Moment(NamedTuple):
    """Where the arm and the fingers are at a time."""

    time_s: float
    q: Array
    opening: float


def case(seed: int) -> Case:
    """Return the case of a number."""
    random = np.random.default_rng((2028, seed))
    machine = robot("puma761")
    start = _down(machine, random)
    X_WF = frames(start[None])[7, 0]
    shape, X_FO, sides = _between_pads(machine, random)
    X_WO = X_WF @ X_FO
    moments, events, close_s, held_s, open_s = _story(machine, start, sides, random)
    back = frames(_at(moments, open_s).q[None])[7, 0] @ X_FO
    placements = [
        Placement(GRASPED, 0.0, held_s, Lie.RESTING, _pose(X_WO), SHELF),
        Placement(GRASPED, held_s, open_s, Lie.HELD, _pose(X_FO), None),
        *_let_go(open_s, back, random),
    ]
    gap = float(random.choice((0.0, STRICT, LOWERED))) + _beside(random)
    shelf = _shelf(shape, X_WO, gap, random)
    opening = _at(moments, (close_s, 0.5 * (held_s + open_s))[int(random.integers(2))]).opening
    thing = _thing(machine, shape, X_FO, X_WF, opening, random)
    body = movable(GRASPED, Piece(shape, IDENTITY), at=(0.0, 0.0, 9.0), on=SHELF)
    scene = scene_of(fixed(THING, thing), fixed(SHELF, shelf), body, machine=machine)
    segments = tuple(_segment(a, b) for a, b in pairwise(moments))
    record = Record(Line(segments), (), events, {GRASPED: tuple(placements)})
    return Case(f"grip of a {type(shape).__name__.lower()}", scene, record)


def _story(
    machine: Robot, start: Array, sides: tuple[float, float], random: Random
) -> tuple[list[Moment], tuple[Event, ...], float, float, float]:
    """Return what the hand does, its events, and when it closes, holds and lets go.

    Args:
        machine: The robot.
        start: Where the arm grasps.
        sides: How far the thing reaches to either side of the middle between the pads [m].
        random: Chooses everything.
    """
    wide, narrow = max(sides), min(sides)

    def opened(gap: float) -> float:
        """Return the opening at which the pad that is nearer has a gap."""
        return float(np.clip(2.0 * (wide + gap), 0.0, 0.08))

    before = opened(STRICT + _beside(random) if random.random() < 0.4 else 5e-3)
    press = PRESSED + _beside(random) if random.random() < 0.7 else -float(random.uniform(0, 1e-3))
    grasped = opened(press)
    lift = _lifted(machine, start, random)
    waits = random.uniform(0.1, 0.3, 8).tolist()
    events: list[Event] = []
    moments = [Moment(0.0, start, before)]

    def then(seconds: float, q: Array, opening: float) -> float:
        moments.append(Moment(moments[-1].time_s + seconds, q, opening))
        return moments[-1].time_s

    close_s = then(waits[0], start, before)
    held_s = then(waits[1], start, grasped)
    events += [HandCommanded(close_s, "close", CAUSE), Grasped(held_s, GRASPED, IDENTITY, CAUSE)]
    then(waits[2], lift, grasped)
    then(waits[3], lift, grasped)
    set_down = start if random.random() < 0.7 else _shifted(machine, start, random)
    open_s = then(waits[4], set_down, grasped)
    events += [Released(open_s, GRASPED, 0.0, CAUSE), HandCommanded(open_s, "open", CAUSE)]
    free = FREE + _beside(random)  # of the finger that comes free last, or not at all
    let_go = float(np.clip(2.0 * (wide + free), 0.0, 0.08))
    then(waits[5], set_down, let_go)
    then(waits[6], set_down, let_go)
    again = float(random.choice((STRICT, PRESSED))) + _beside(random)
    if random.random() < 0.5:  # the hand closes on nothing, as far as it knows
        events.append(HandCommanded(moments[-1].time_s, "close", CAUSE))
        then(waits[7], set_down, opened(again))
    else:  # the arm pushes
        there = _beside_of(machine, set_down, float(random.choice((-1, 1))) * (free - again))
        then(waits[7], there, let_go)
    then(0.1, moments[-1].q, moments[-1].opening)
    if narrow > wide - 1e-3 and random.random() < 0.3:  # and lets go for good
        events.append(HandCommanded(moments[-1].time_s, "open", CAUSE))
        then(0.1, moments[-1].q, 0.08)
        then(0.05, moments[-1].q, 0.08)
    return moments, tuple(events), close_s, held_s, open_s


def _between_pads(machine: Robot, random: Random) -> tuple[Shape, Array, tuple[float, float]]:
    """Return a shape, where it is in the flange's frame, and how far it reaches to either side."""
    while True:
        shape = (box, rod, hull)[int(random.integers(3))](random)
        X = np.eye(4)
        X[:3, :3] = _turn(random)
        left, right = _reach(shape, X, 1), _reach(shape, X, -1)
        if 2e-3 < left + right < 2.0 * WIDEST:
            break
    off = float(random.choice((0.0, 0.0, 1e-4, -5e-4)))  # from the middle
    X[1, 3] = 0.5 * (right - left) + off
    X[2, 3] = machine.gripper.X_FP.translation[2] + random.uniform(-5e-3, 20e-3)
    X[0, 3] = random.uniform(-5e-3, 5e-3)
    return shape, X, (_reach(shape, X, 1), _reach(shape, X, -1))


def _reach(shape: Shape, X: Array, side: int) -> float:
    """Return how far a shape reaches along y, to one side [m]."""
    way = side * X[1, :3]
    match shape:
        case Box(half_extents=half):
            far = float(np.abs(way) @ np.array(half))
        case Cylinder(radius=radius, half_length=half_length):
            far = radius * math.hypot(way[0], way[1]) + half_length * abs(float(way[2]))
        case points:
            far = float((np.array(points.points) @ way).max())
    return far + side * float(X[1, 3])


def _shelf(shape: Shape, X_WO: Array, gap: float, random: Random) -> Piece:
    """Return a box so far below a shape."""
    turned = np.eye(4)
    turned[1] = X_WO[2]
    low = -_reach(shape, turned, -1)
    half = (*random.uniform(2e-3, 0.02, 2).tolist(), 0.01)
    at = (float(X_WO[0, 3]), float(X_WO[1, 3]), low - gap - half[2])
    return Piece(Box((half[0], half[1], half[2])), Pose(IDENTITY.rotation, at))


def _thing(
    machine: Robot, shape: Shape, X_FO: Array, X_WF: Array, opening: float, random: Random
) -> Piece:
    """Return a thing that faces a finger, or what is between the pads, at the grasp."""
    there, faced = X_WF @ X_FO, shape
    if random.random() < 0.6:
        finger = machine.gripper.fingers[int(random.integers(2))]
        X_FP = np.eye(4)
        X_FP[:3, 3] = finger.pieces[0].X_OP.translation
        X_FP[1, 3] += 0.5 * finger.side * opening
        there, faced = X_WF @ X_FP, finger.pieces[0].shape
    kinds = (FACE, EDGE, CORNER)
    here = feature(faced, str(random.choice(kinds)), random, middle=False)
    other = (box, rod)[int(random.integers(2))](random)
    opposite = feature(other, str(random.choice(kinds)), random, middle=False)
    gap = float(random.choice((0.0, STRICT))) + _beside(random)
    twist = float(random.choice((0.0, 1.0))) * float(random.uniform(0.2, 2.9))
    rotation, origin = facing(here, there[:3, :3], there[:3, 3], opposite, gap, twist)
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = rotation, origin
    return Piece(other, _pose(X))


def _let_go(open_s: float, X_WO: Array, random: Random) -> list[Placement]:
    """Return where the thing is after the release: there, or after a short fall."""
    fall = 0.0 if random.random() < 0.7 else float(random.uniform(1e-3, 8e-3))
    rest = X_WO.copy()
    rest[2, 3] -= fall
    landed = open_s + math.sqrt(2.0 * fall / GRAVITY)
    falling = Placement(GRASPED, open_s, landed, Lie.FALLING, _pose(X_WO), None)
    lies = Placement(GRASPED, landed, math.inf, Lie.RESTING, _pose(rest), SHELF)
    return [falling, lies] if fall > 0.0 else [lies]


def _down(machine: Robot, random: Random) -> Array:
    """Return where the hand points down, but for a tilt."""
    x, y, z = random.uniform((0.6, -0.4, -0.2), (1.0, 0.4, 0.4)).tolist()
    turn, tilt = random.uniform(-2.0, 2.0), random.uniform(-0.4, 0.4)
    down = rotation_about((1.0, 0.0, 0.0), math.pi + float(tilt))
    X = Pose(rotation_about((0.0, 0.0, 1.0), float(turn)), (x, y, z)) @ Pose(down, (0.0, 0.0, 0.0))
    q = solve(machine.arm, X, BRANCH, (0.0, -1.0, 1.0, 0.0, 0.5, 0.0))
    assert q is not None
    return np.array(q)


def _moved(machine: Robot, q: Array, by: Sequence[float]) -> Array:
    """Return the joints with the flange so far away in the base."""
    X = frames(q[None])[7, 0]
    X[:3, 3] += by
    a, b, c, d, e, f = q.tolist()
    found = solve(machine.arm, _pose(X), BRANCH, (a, b, c, d, e, f))
    assert found is not None
    return np.array(found)


def _lifted(machine: Robot, q: Array, random: Random) -> Array:
    return _moved(machine, q, (0.0, 0.0, float(random.uniform(2e-3, 0.1))))


def _shifted(machine: Robot, q: Array, random: Random) -> Array:
    return _moved(machine, q, (*random.uniform(-0.02, 0.02, 2).tolist(), 0.0))


def _beside_of(machine: Robot, q: Array, by: float) -> Array:
    return _moved(machine, q, (by * frames(q[None])[7, 0, :3, 1]).tolist())


def _beside(random: Random) -> float:
    return float(random.choice(BESIDE))


def _at(moments: Sequence[Moment], time_s: float) -> Moment:
    """Return the last moment that is not after a time."""
    return [moment for moment in moments if moment.time_s <= time_s][-1]


def _segment(a: Moment, b: Moment) -> Segment:
    length = b.time_s - a.time_s
    joints = [
        (x,) if x == y else hermite(x, y, 0.0, 0.0, length)
        for x, y in zip(a.q.tolist(), b.q.tolist(), strict=True)
    ]
    steady = a.opening == b.opening
    opening = (a.opening,) if steady else (a.opening, (b.opening - a.opening) / length)
    return Segment(a.time_s, b.time_s, (*joints, opening), None)


def _turn(random: Random) -> Array:
    """Return any rotation, or now and then one that lays faces flat against the pads."""
    if random.random() < 0.4:
        flat = np.eye(3)[:, random.permutation(3)] * random.choice((-1.0, 1.0), 3)
        return flat if np.linalg.det(flat) > 0.0 else -flat
    w, x, y, z = random.normal(size=4).tolist()
    length = w * w + x * x + y * y + z * z
    a = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    return np.eye(3) + 2.0 / length * (w * a + a @ a)


def _pose(X: Array) -> Pose:
    a, b, c, d, e, f, g, h, i = X[:3, :3].ravel().tolist()
    x, y, z = X[:3, 3].tolist()
    return Pose((a, b, c, d, e, f, g, h, i), (x, y, z))
