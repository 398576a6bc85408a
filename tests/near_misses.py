"""Random fast motions past thin things, and a sampler that shares nothing with the certified check.

The sampler looks every 0.1 ms. To be quick it first looks every millisecond: at the distance of the
ball round each part of the robot from the obstacle, then at that of the part itself. As no part
moves faster than 30 m/s, what is far apart then need not be looked at more finely.
"""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tests.collision_runs import Line, Record, fixed, hermite, movable, scene_of
from tests.support_segments import blend, slowed
from vrts.base.pose import IDENTITY, Pose, rotation_about, translation
from vrts.engine.memory.records import Lie, Placement, Segment
from vrts.geometry.coal_engine import pair, transform
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.geometry.support import support
from vrts.robots.catalog import robot
from vrts.robots.kinematics.batch import link_frames
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import Configuration, SphericalWristArm
from vrts.scene.model import Body, Scene

Array: TypeAlias = npt.NDArray[np.float64]

COARSE = 1e-3  # [s] between instants of a first look
FASTEST = 30.0  # [m/s] no point of these motions moves faster
KINDS = ("rod", "plate", "post", "block")
CONTACT = -2.1e-4  # [m] deeper than tolerance and band


class NearMiss(NamedTuple):
    """One random case."""

    kind: str
    scene: Scene
    record: Record
    duration: float


def near_miss(
    seed: int, *, high: bool = False, past: tuple[float, float] = (-2e-3, 3e-3)
) -> NearMiss:
    """Return a motion of 0.5 to 1.5 s with something thin within millimetres of the hand's way.

    Args:
        seed: Chooses everything.
        high: Whether the motion is of degree 8, moving at its end, instead of a cubic.
        past: From how far to how far the thing reaches into the fingertip, in m.
    """
    random = np.random.default_rng((2026, seed))
    machine = robot("puma761")
    arm = machine.arm
    lower, upper = np.array(arm.lower), np.array(arm.upper)
    duration = float(random.uniform(0.5, 1.5))
    start = random.uniform(lower, upper)
    step = random.uniform(-1.0, 1.0, 6) * np.array(arm.speed) * duration / 1.5
    goal = np.clip(start + step, lower, upper)
    rows = [
        hermite(float(a), float(b), 0.0, 0.0, duration) for a, b in zip(start, goal, strict=True)
    ]
    if high:
        rate = float(random.uniform(0.6, 1.4))
        rows = [
            _high(float(a), 0.5 * float(b - a), rate, duration)
            for a, b in zip(start, goal, strict=True)
        ]
    opening = float(random.uniform(0.0, 0.08))
    segment = Segment(0.0, duration, (*rows, (opening,)), None)
    at = float(random.uniform(0.2, 0.8)) * duration
    X_WF = forward(arm, _at(rows, at))
    finger = machine.gripper.fingers[seed % 2]
    slid = 0.5 * finger.side * opening
    later = forward(arm, _at(rows, at + 1e-5)).apply((0.0, 0.0, 0.165))
    way = np.subtract(later, forward(arm, _at(rows, at)).apply((0.0, 0.0, 0.165)))
    tip = _beyond(finger.pieces[0], X_WF @ translation(0.0, slid, 0.0), way)
    kind = KINDS[seed % len(KINDS)]
    carries = seed % 3 == 0
    reach = float(random.uniform(*past))
    body = fixed(kind, *_obstacle(kind, tip, reach, random))
    bodies: tuple[Body, ...] = (body,)
    placements: dict[str, tuple[Placement, ...]] = {}
    if carries:
        can = movable("can", Piece(Cylinder(0.03, 0.05), IDENTITY), at=(0.0, 0.0, 9.0), on=None)
        bodies = (body, can)
        X_FO = translation(0.0, 0.0, 0.15)
        placements["can"] = (Placement("can", 0.0, math.inf, Lie.HELD, X_FO, None),)
    record = Record(Line((segment,)), (), (), placements)
    return NearMiss(kind, scene_of(*bodies, machine=machine), record, duration)


def _high(start: float, step: float, rate: float, duration: float) -> tuple[float, ...]:
    """Return a quartic from rest to motion, under a rate of time that changes all along."""
    path = tuple(c * step for c in blend(0.0, 0.0, 2.0, 1.0))
    first, *others = slowed(path, rate / duration, 2.0 * (1.0 - rate) / duration**2)
    return (start + first, *others)


def _at(rows: list[tuple[float, ...]], t: float) -> Configuration:
    a, b, c, d, e, f = (sum(k * t**n for n, k in enumerate(row)) for row in rows)
    return (a, b, c, d, e, f)


def _beyond(finger: Piece, X_WF: Pose, way: Array) -> Pose:
    """Return a frame on the outermost point of a fingertip beside its way, z out of the finger."""
    way = way / np.linalg.norm(way)
    out = np.array(X_WF.approach)
    out = out - (out @ way) * way
    out /= np.linalg.norm(out)
    n = np.cross(out, way)
    a, b, c, d, e, f, g, h, i = np.column_stack([way, n, out]).ravel().tolist()
    return Pose((a, b, c, d, e, f, g, h, i), support(finger, X_WF, (c, f, i)))


def _obstacle(kind: str, tip: Pose, past: float, random: np.random.Generator) -> tuple[Piece, ...]:
    """Return a thing whose end is `past` metres inside the fingertip (negative: short of it)."""
    turn = Pose(rotation_about((0.0, 0.0, 1.0), float(random.uniform(0.0, math.tau))), (0, 0, 0))
    match kind:
        case "rod":  # lying across
            lying = Pose(rotation_about((1.0, 0.0, 0.0), math.pi / 2), (0.0, 0.0, 1e-3 - past))
            return (Piece(Cylinder(1e-3, 0.05), tip @ turn @ lying),)
        case "plate":  # edge on
            return (Piece(Box((1e-3, 0.02, 0.02)), tip @ turn @ translation(0, 0, 0.02 - past)),)
        case "post":  # end on
            return (Piece(Cylinder(1e-3, 0.1), tip @ turn @ translation(0, 0, 0.1 - past)),)
        case _:
            return (Piece(Box((0.02, 0.02, 0.02)), tip @ turn @ translation(0, 0, 0.02 - past)),)


class _Part(NamedTuple):
    """A piece of the robot or of what it holds, in a link frame."""

    piece: Piece
    frame: int
    slide: float


def sampled(case: NearMiss, step_s: float = 1e-4) -> Array:
    """Return the times, of those every `step_s`, at which robot and obstacle are in contact."""
    fine = np.arange(0.0, case.duration, step_s)
    number = np.rint(fine / COARSE).astype(np.int64)
    coarse = np.arange(int(number[-1]) + 1, dtype=np.float64) * COARSE
    frames = _frames(case, coarse)
    obstacle = case.scene.bodies[0].pieces[0]
    hits: set[float] = set()
    for part in _parts(case):
        rotations, origins = _placed(case, part, frames)
        near = np.nonzero(_near(part, obstacle, rotations, origins))[0]
        distances = _distances(part, obstacle, rotations[near], origins[near])
        near = near[distances < 0.5 * COARSE * FASTEST + 1e-5]
        times = fine[np.isin(number, near)]
        if len(times):
            placed = _placed(case, part, _frames(case, times))
            hits |= set(times[_distances(part, obstacle, *placed) < CONTACT].tolist())
    return np.array(sorted(hits))


def sampled_plainly(case: NearMiss, step_s: float = 1e-4) -> Array:
    """Return the same, by looking at every part at every instant."""
    times = np.arange(0.0, case.duration, step_s)
    frames = _frames(case, times)
    hit = np.zeros(len(times), dtype=np.bool_)
    obstacle = case.scene.bodies[0].pieces[0]
    for part in _parts(case):
        hit |= _distances(part, obstacle, *_placed(case, part, frames)) < CONTACT
    return times[hit]


def _parts(case: NearMiss) -> list[_Part]:
    """Return everything that moves."""
    machine = case.scene.robot
    assert isinstance(machine.arm, SphericalWristArm)
    X_LF = translation(0.0, 0.0, machine.arm.d6)
    parts = [_Part(Piece(p.shape, X_LF @ p.X_OP), 6, 0.0) for p in machine.gripper.body] + [
        _Part(Piece(p.shape, X_LF @ p.X_OP), 6, 0.5 * f.side)
        for f in machine.gripper.fingers
        for p in f.pieces
    ]
    parts += [_Part(p, link.joint, 0.0) for link in machine.arm.links[1:] for p in link.pieces]
    for body in case.scene.bodies[1:]:
        X_FO = case.record.placements[body.name][0].X
        parts += [_Part(Piece(p.shape, X_LF @ X_FO @ p.X_OP), 6, 0.0) for p in body.pieces]
    return parts


def _near(part: _Part, obstacle: Piece, rotations: Array, origins: Array) -> npt.NDArray[np.bool_]:
    """Return where a part may touch the obstacle within half a millisecond."""
    middle, ball = _ball(part.piece)
    centres = origins + rotations @ middle
    X_WO = obstacle.X_OP
    local = (centres - np.array(X_WO.translation)) @ np.array(X_WO.rotation).reshape(3, 3)
    apart = np.linalg.norm(np.maximum(np.abs(local) - _half(obstacle), 0.0), axis=1)
    return apart < ball + 0.5 * COARSE * FASTEST


def _distances(part: _Part, obstacle: Piece, rotations: Array, origins: Array) -> Array:
    """Return the distances of a part from the obstacle, shape (n,)."""
    function = pair(part.piece.shape, obstacle.shape)
    X_WO = obstacle.X_OP
    other = transform(np.array(X_WO.rotation).reshape(3, 3), np.array(X_WO.translation))
    places = map(transform, rotations, origins)
    return np.array([function.distance(place, other) for place in places])


def _frames(case: NearMiss, times: Array) -> tuple[Array, Array]:
    """Return where the frames of the arm are."""
    segment = case.record.timeline.segments[0]
    powers = times[:, None] ** np.arange(len(segment.coefficients[0]))
    return link_frames(case.scene.robot.arm, powers @ np.array(segment.coefficients[:6]).T)


def _placed(case: NearMiss, part: _Part, frames: tuple[Array, Array]) -> tuple[Array, Array]:
    """Return rotations and origins of a part in W."""
    R, p = frames[0][part.frame], frames[1][part.frame]
    X_LP = part.piece.X_OP
    opening = case.record.timeline.segments[0].coefficients[6][0]
    slide = np.array([0.0, part.slide * opening, 0.0])
    return R @ np.array(X_LP.rotation).reshape(3, 3), p + R @ (np.array(X_LP.translation) + slide)


def _half(piece: Piece) -> Array:
    match piece.shape:
        case Box(half_extents=half):
            return np.array(half)
        case Cylinder(radius=radius, half_length=half_length):
            return np.array([radius, radius, half_length])
        case _:
            raise AssertionError


def _ball(piece: Piece) -> tuple[Array, float]:
    match piece.shape:
        case Box(half_extents=half):
            return np.zeros(3), float(np.linalg.norm(half))
        case Cylinder(radius=radius, half_length=half_length):
            return np.zeros(3), math.hypot(radius, half_length)
        case hull:
            points = np.array(hull.points)
            middle = points.mean(axis=0)
            return middle, float(np.linalg.norm(points - middle, axis=1).max())
