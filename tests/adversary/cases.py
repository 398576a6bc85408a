"""Runs that touch, nearly touch or just do not, in every way in which convex shapes can."""

import math
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tests.adversary.features import CORNER, EDGE, FACE, Feature, across, facing, feature
from tests.adversary.kinematics import frames
from tests.collision_runs import Line, Record, fixed, hermite, movable, scene_of
from tests.exactly_touching import touching
from tests.near_misses import near_miss
from vrts.base.pose import IDENTITY, Pose
from vrts.engine.memory.records import GRAVITY, Lie, Placement, Segment
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape
from vrts.robots.catalog import robot
from vrts.robots.model import Robot
from vrts.scene.model import Body, Scene

Array: TypeAlias = npt.NDArray[np.float64]
Random: TypeAlias = np.random.Generator

THING, HELD = "thing", "held"
TOLERANCE = 2e-4  # [m] deeper is a contact
NEAR = 5e-3  # [m] nearer is a near miss
AWAY = 0.45  # [m] what is held is so far before the flange, clear of the hand

# gaps across which shapes face each other [m]
TOUCH = (0.0, 1e-12, -1e-12, 1e-9, -1e-9, -3e-8, -1e-7, 1e-7, -1e-6, 1e-6, -9e-6, -1.1e-5)
BESIDE_TOLERANCE = (-3e-5, -1.5e-5, -1.15e-5, 1.15e-5, 1.5e-5, 3e-5)  # beyond the tolerance


class Case(NamedTuple):
    """A run, and what moves in it."""

    name: str
    scene: Scene
    record: Record


class Kind(NamedTuple):
    """How two shapes face each other."""

    name: str
    first: str  # feature of what moves
    second: str  # feature of the thing
    shapes: tuple[Callable[[Random], Shape], Callable[[Random], Shape]]
    parallel: bool  # or turned by any angle
    middle: bool = False


def box(random: Random) -> Shape:
    """Return a box of any size, now and then a thin one."""
    a, b, c = np.exp(random.uniform(math.log(2e-3), math.log(0.1), 3)).tolist()
    return Box((a, b, c))


def rod(random: Random) -> Shape:
    """Return a cylinder of any size."""
    radius, half = np.exp(random.uniform(math.log(1e-3), math.log(0.1), 2)).tolist()
    return Cylinder(radius, half)


def hull(random: Random) -> Shape:
    """Return the hull of points, or a ring as dishes have them."""
    if random.random() < 0.5:
        points = random.normal(size=(int(random.integers(4, 15)), 3)) * random.uniform(0.01, 0.05)
    else:
        angle = np.arange(16) * math.tau / 16
        low, high = random.uniform(0.01, 0.05, 2)
        ring = np.column_stack([np.cos(angle), np.sin(angle)])
        height = random.uniform(0.01, 0.05)
        points = np.concatenate(
            [np.column_stack([s * ring, np.full(16, z)]) for s, z in ((low, 0.0), (high, height))]
        )
    return Hull(tuple((x, y, z) for x, y, z in points.tolist()))


KINDS = (
    Kind("edge to edge", EDGE, EDGE, (box, box), parallel=False),
    Kind("parallel edges", EDGE, EDGE, (box, box), parallel=True),
    Kind("parallel faces", FACE, FACE, (box, box), parallel=True),
    Kind("faces", FACE, FACE, (box, box), parallel=False),
    Kind("corner to face", CORNER, FACE, (box, box), parallel=False),
    Kind("coaxial cylinders", FACE, FACE, (rod, rod), parallel=True, middle=True),
    Kind("cylinders side by side", EDGE, EDGE, (rod, rod), parallel=True),
    Kind("crossing cylinders", EDGE, EDGE, (rod, rod), parallel=False),
    Kind("rim to edge", CORNER, EDGE, (rod, box), parallel=False),
    Kind("rim to rim", CORNER, CORNER, (rod, rod), parallel=False),
    Kind("edge to cylinder", EDGE, EDGE, (box, rod), parallel=False),
    Kind("facet to face", FACE, FACE, (hull, box), parallel=True),
    Kind("facets", FACE, FACE, (hull, hull), parallel=True),
    Kind("corner to facet", CORNER, FACE, (hull, hull), parallel=False),
    Kind("hull edges", EDGE, EDGE, (hull, hull), parallel=False),
    Kind("facet to cylinder", FACE, EDGE, (hull, rod), parallel=True),
)
HOW = ("held", "hand", "falling", "held")


def case(seed: int) -> Case:
    """Return the case of a number: a third of them passes fast, the others face and wait."""
    if seed % 3 == 0:
        number = seed // 3
        passing = near_miss(number, high=number % 3 == 0, past=(-1e-3, 1e-3))
        return Case(f"passing {passing.kind}", passing.scene, passing.record)
    if seed % 2999 == 1:
        return Case("exactly touching", *touching())
    random = np.random.default_rng((2027, seed))
    kind = KINDS[seed // 3 % len(KINDS)]
    how = HOW[int(random.integers(len(HOW)))]
    first = kind.shapes[0](random)
    if how == "falling" and isinstance(first, Hull):
        how = "held"
    return _faced(kind, how, first, kind.shapes[1](random), _gap(random), random)


def _gap(random: Random) -> float:
    choice = random.random()
    if choice < 0.35:
        return float(random.choice(TOUCH))
    if choice < 0.7:
        return -TOLERANCE + float(random.choice(BESIDE_TOLERANCE))
    if choice < 0.8:
        return NEAR + float(random.choice((-1e-5, 1e-5, -1e-3, 1e-3)))
    return float(random.uniform(-1e-3, 1e-3))


def _faced(kind: Kind, how: str, first: Shape, second: Shape, gap: float, random: Random) -> Case:
    machine = robot("puma761")
    arm = machine.arm
    lower, upper = np.array(arm.lower) + 0.3, np.array(arm.upper) - 0.3
    goal = random.uniform(lower, upper)
    opening = float(random.uniform(0.0, 0.08))
    X_WF = frames(goal[None])[7, 0]
    if how == "hand":
        there, first = _of_hand(machine, X_WF, opening, first)
    else:
        there = X_WF.copy()
        there[:3, 3] += AWAY * X_WF[:3, 2]
        there[:3, :3] = _turned(random)
    here = feature(first, kind.first, random, middle=kind.middle)
    if how == "falling":  # it falls past the thing: out of it is level
        there[:3, :3] = _level(here.outward, random)
    opposite = feature(second, kind.second, random, middle=kind.middle)
    twist = 0.0 if kind.parallel else float(random.uniform(0.2, math.pi - 0.2))
    rotation, origin = facing(here, there[:3, :3], there[:3, 3], opposite, gap, twist)
    body = fixed(THING, Piece(second, _pose(rotation, origin)))
    name = f"{kind.name}, {how}"
    if how == "falling":
        return _falling(name, machine, body, first, there, goal, opening, random)
    X_FA = _inverse(X_WF) @ there
    segments = _to_and_fro(goal, X_FA, here, there, opening, random)
    bodies: list[Body] = [body]
    placements: dict[str, tuple[Placement, ...]] = {}
    if how == "held":
        bodies.append(movable(HELD, Piece(first, IDENTITY), at=(0.0, 0.0, 9.0), on=None))
        X_FO = _pose(X_FA[:3, :3], X_FA[:3, 3])
        placements[HELD] = (Placement(HELD, 0.0, math.inf, Lie.HELD, X_FO, None),)
    record = Record(Line(segments), (), (), placements)
    return Case(name, scene_of(*bodies, machine=machine), record)


def _of_hand(machine: Robot, X_WF: Array, opening: float, wanted: Shape) -> tuple[Array, Shape]:
    """Return a piece of the hand of the wanted class, or else a finger, and where it is."""
    finger = machine.gripper.fingers[0]
    pieces = [(p, 0.5 * finger.side * opening) for p in finger.pieces]
    pieces += [(p, 0.0) for p in machine.gripper.body]
    alike = [(p, slid) for p, slid in pieces if type(p.shape) is type(wanted)]
    piece, slid = (alike or pieces)[0]
    X_FP = np.eye(4)
    X_FP[:3, :3] = np.array(piece.X_OP.rotation).reshape(3, 3)
    X_FP[:3, 3] = piece.X_OP.translation
    X_FP[1, 3] += slid
    return X_WF @ X_FP, piece.shape


def _to_and_fro(
    goal: Array, X_FA: Array, here: Feature, X_WA: Array, opening: float, random: Random
) -> tuple[Segment, ...]:
    """Return a motion up to where the shapes face each other, a wait there, and the way back."""
    out = X_WA[:3, :3] @ here.outward
    step = random.uniform(-0.15, 0.15, 6)

    def point(q: Array) -> Array:
        X = frames(q[None])[7, 0] @ X_FA
        return X[:3, :3] @ here.point + X[:3, 3]

    if (point(goal + step) - point(goal)) @ out > 0.0:
        step = -step
    start = goal + step
    there, back, wait = random.uniform(0.25, 0.6, 3).tolist()
    times = np.cumsum((0.0, there, wait, back)).tolist()
    rows = [
        [
            hermite(a, b, 0.0, 0.0, there)
            for a, b in zip(start.tolist(), goal.tolist(), strict=True)
        ],
        [(b,) for b in goal.tolist()],
        [hermite(b, a, 0.0, 0.0, back) for a, b in zip(start.tolist(), goal.tolist(), strict=True)],
    ]
    return tuple(
        Segment(times[k], times[k + 1], (*own, (opening,)), None) for k, own in enumerate(rows)
    )


def _falling(
    name: str,
    machine: Robot,
    thing: Body,
    shape: Shape,
    X_WA: Array,
    goal: Array,
    opening: float,
    random: Random,
) -> Case:
    """Return a run in which what was held falls past the thing, from above it."""
    above, below = random.uniform(0.05, 0.3, 2).tolist()
    X_WO = X_WA.copy()
    X_WO[2, 3] += above
    let_go, landed = 0.2, 0.2 + math.sqrt(2.0 * (above + below) / GRAVITY)
    X_FO = _inverse(frames(goal[None])[7, 0]) @ X_WO
    lies = X_WO.copy()
    lies[2, 3] -= above + below
    rows = [(v,) for v in goal.tolist()]
    segment = Segment(0.0, landed + 0.2, (*rows, (opening,)), None)
    placements = {
        HELD: (
            Placement(HELD, 0.0, let_go, Lie.HELD, _pose(X_FO[:3, :3], X_FO[:3, 3]), None),
            Placement(HELD, let_go, landed, Lie.FALLING, _pose(X_WO[:3, :3], X_WO[:3, 3]), None),
            Placement(HELD, landed, math.inf, Lie.TOPPLED, _pose(lies[:3, :3], lies[:3, 3]), None),
        )
    }
    body = movable(HELD, Piece(shape, IDENTITY), at=(0.0, 0.0, 9.0), on=None)
    scene = scene_of(thing, body, machine=machine)
    return Case(name, scene, Record(Line((segment,)), (), (), placements))


def _turned(random: Random) -> Array:
    w, x, y, z = (random.normal(size=4)).tolist()
    length = w * w + x * x + y * y + z * z
    a = np.array(((0.0, -z, y), (z, 0.0, -x), (-y, x, 0.0)))
    return np.eye(3) + 2.0 / length * (w * a + a @ a)


def _inverse(X: Array) -> Array:
    found = np.eye(4)
    found[:3, :3] = X[:3, :3].T
    found[:3, 3] = -X[:3, :3].T @ X[:3, 3]
    return found


def _level(outward: Array, random: Random) -> Array:
    """Return a rotation in which a direction of a shape is level."""
    angle = random.uniform(0.0, math.tau)
    level = np.array((math.cos(angle), math.sin(angle), 0.0))
    way = across(outward)
    tilt = random.uniform(0.0, math.tau) if random.random() < 0.5 else 0.0
    up = np.array((0.0, 0.0, 1.0))
    turned = math.cos(tilt) * up + math.sin(tilt) * np.cross(level, up)
    world = np.column_stack([level, turned, np.cross(level, turned)])
    local = np.column_stack([outward, way, np.cross(outward, way)])
    return world @ local.T


def _pose(rotation: Array, origin: Array) -> Pose:
    a, b, c, d, e, f, g, h, i = rotation.ravel().tolist()
    x, y, z = origin.tolist()
    return Pose((a, b, c, d, e, f, g, h, i), (x, y, z))
