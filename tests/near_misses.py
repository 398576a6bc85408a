"""Random fast motions past thin things, and a sampler that shares nothing with the certified check.

The sampler looks every 0.1 ms. To be quick it first asks, every millisecond, whether the ball round
a part of the robot comes near the ball or line of the obstacle; no part moves faster than 30 m/s.
"""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tests.collision_runs import Line, Record, fixed, hermite, movable, scene_of
from tests.support_segments import blend, slowed
from vrts.base.pose import IDENTITY, Pose, rotation_about, translation
from vrts.engine.records import Lie, Placement, Segment
from vrts.geometry.narrow import pair, transform
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.geometry.support import support
from vrts.robots.batch import link_frames
from vrts.robots.catalog import robot
from vrts.robots.kinematics import forward
from vrts.robots.model import Configuration, SphericalWristArm
from vrts.scene.model import Body, Scene

Array: TypeAlias = npt.NDArray[np.float64]

FASTEST = 30.0  # [m/s] no point of these motions moves faster
KINDS = ("rod", "plate", "post", "block")
CONTACT = -2.1e-4  # [m] deeper than tolerance and band


class NearMiss(NamedTuple):
    """One random case."""

    kind: str
    scene: Scene
    record: Record
    duration: float


def near_miss(seed: int, *, high: bool = False) -> NearMiss:
    """Return a motion of 0.5 to 1.5 s with something thin within millimetres of the hand's way.

    Args:
        seed: Chooses everything.
        high: Whether the motion is of degree 8, moving at its end, instead of a cubic.
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
    past = float(random.uniform(-2e-3, 3e-3))
    name = f"{kind}"
    body = fixed(name, *_obstacle(kind, tip, past, random))
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
    machine = case.scene.robot
    obstacle = case.scene.bodies[0].pieces[0]
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
    coarse = np.linspace(0.0, case.duration, math.ceil(case.duration / 1e-3) + 1)
    fine = np.arange(0.0, case.duration, step_s)
    near = {id(part): _near(case, part, obstacle, coarse) for part in parts}
    hits: set[float] = set()
    for part in parts:
        which = near[id(part)]
        if not which.any():
            continue
        number = np.minimum((fine / coarse[1]).astype(np.int64), len(coarse) - 2)
        times = fine[which[number] | which[number + 1]]
        rotations, origins = _placed(case, part, times)
        function = pair(part.piece.shape, obstacle.shape)
        other = transform(
            np.array(obstacle.X_OP.rotation).reshape(3, 3), np.array(obstacle.X_OP.translation)
        )
        for t, rotation, origin in zip(times.tolist(), rotations, origins, strict=True):
            if function.distance(transform(rotation, origin), other) < CONTACT:
                hits.add(t)
    return np.array(sorted(hits))


def _near(case: NearMiss, part: _Part, obstacle: Piece, times: Array) -> npt.NDArray[np.bool_]:
    """Return at which times a part may touch the obstacle within half a millisecond."""
    rotations, origins = _placed(case, part, times)
    middle, ball = _ball(part.piece)
    centres = origins + rotations @ middle
    X_WO = obstacle.X_OP
    local = (centres - np.array(X_WO.translation)) @ np.array(X_WO.rotation).reshape(3, 3)
    half = _half(obstacle)
    apart = np.linalg.norm(np.maximum(np.abs(local) - half, 0.0), axis=1)
    return apart < ball + FASTEST * 1e-3


def _placed(case: NearMiss, part: _Part, times: Array) -> tuple[Array, Array]:
    segment = case.record.timeline.segments[0]
    powers = times[:, None] ** np.arange(len(segment.coefficients[0]))
    q = powers @ np.array(segment.coefficients[:6]).T
    rotations, origins = link_frames(case.scene.robot.arm, q)
    R, p = rotations[part.frame], origins[part.frame]
    X_LP = part.piece.X_OP
    slide = np.array([0.0, part.slide * segment.coefficients[6][0], 0.0])
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
