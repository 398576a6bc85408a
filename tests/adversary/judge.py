"""What really happens in a case, by looking very often, and what is wrong with a report of it.

Shapes and polynomials are read from the case; where things are comes from `kinematics`, how far
they are apart from `gaps`. Of the check only the report is used.
"""

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tests.adversary.cases import Case
from tests.adversary.gaps import Posed, distance, rough, sharpened
from tests.adversary.kinematics import frames
from vrts.base.pose import Pose
from vrts.check.verdict import CollisionReport
from vrts.engine.memory.records import GRAVITY, Lie
from vrts.geometry.shapes import Box, Cylinder, Shape
from vrts.robots.model import SphericalWristArm

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

ROBOT = "robot"
COARSE, FINE = 1e-3, 1e-4  # [s] between instants
FAR = 0.015  # [m] what is farther apart is not looked at
AT_ONCE = 40  # instants of a part at which it may be nearest
STUCK = 3e-4  # [m] by so much moving about may be wrong
TOLERANCE = 2e-4  # [m] deeper is a contact
BAND = 1.2e-5  # [m] nearer to the tolerance nobody has to tell
SHALLOW = 2e-3  # [m] less deep than this there is one best direction
TELLS = 1e-5  # [m] of a depth or distance that is told
SLACK = 1.1e-4  # [m] of a smallest distance
PROMPT = 1.5e-3  # [s] of the time at which a contact begins


class Part(NamedTuple):
    """Something that moves, or stands still as part of what moves."""

    group: str  # as reports call it
    shape: Shape
    frame: int  # of the arm; -1: none
    X: Array  # in the frame, or in W, (4, 4)
    slide: float  # along y by so much of the opening
    start_s: float
    end_s: float
    falls: bool


class Nearest(NamedTuple):
    """The deepest, or nearest, moment found of a group and the thing."""

    distance: float  # [m]
    time_s: float


class Judge:
    """Knows a case."""

    def __init__(self, case: Case) -> None:
        """Read it."""
        self.case = case
        body = case.scene.bodies[0]
        (self.thing,) = body.pieces
        self.name = body.name
        self.X_thing = _matrix(body.X_WO) @ _matrix(self.thing.X_OP)
        self.segments = case.record.timeline.segments
        self.parts = tuple(_parts(case))
        self.groups = tuple(dict.fromkeys(part.group for part in self.parts))

    def nearest(self, group: str) -> Nearest:
        """Return the deepest moment of a group, of all instants; `FAR` if it is never nearer."""
        own = [part for part in self.parts if part.group == group]
        found = [self._roughly(part) for part in own]
        least = min(one.distance for one in found)
        if least >= FAR:
            return Nearest(FAR, found[0].time_s)
        return min(
            self._closely(part, one.time_s)
            for part, one in zip(own, found, strict=True)
            if one.distance < least + STUCK
        )

    def at(self, group: str, time_s: float) -> float:
        """Return how far a group is from the thing at one instant [m]; `FAR` if farther."""
        time = np.array([time_s])
        own = [p for p in self.parts if p.group == group and p.start_s <= time_s <= p.end_s]
        pairs = [self._posed(part, time) for part in own]
        near = [(a, b) for a, b in pairs if float(_balls(a, b)[0]) < FAR]
        known = [float(distance(a, b)[0][0]) for a, b in near]
        least = min(known, default=FAR)
        close = [
            pair for pair, value in zip(near, known, strict=True) if value < min(FAR, least + STUCK)
        ]
        return min((self._sharp(a, b, 0) for a, b in close), default=FAR)

    def touches(self, group: str, times: Array) -> bool:
        """Return whether a group is in contact at one of some instants."""
        return any(-self.at(group, time) > TOLERANCE - BAND for time in times.tolist())

    def _roughly(self, part: Part) -> Nearest:
        """Return the deepest moment of a part, of those every 0.1 ms, not sharpened."""
        far = Nearest(FAR, 0.0)
        times = self._times(part)
        if not len(times):
            return far
        a, b = self._posed(part, times)
        margin = self._moves(part, times)
        near = np.flatnonzero(_balls(a, b) < FAR + margin)
        if not len(near):
            return far
        gaps = rough(a.at(near), b.at(near))[0].max(axis=1)
        close = near[gaps < min(gaps.min() + 1e-3, FAR) + margin[near]]
        if not len(close):
            return far
        between = (times[close][:, None] + np.arange(-5, 6) * FINE).ravel()
        fine = np.unique(np.clip(between, times[0], times[-1]))
        a, b = self._posed(part, fine)
        bounds = rough(a, b)[0].max(axis=1)  # none is nearer than this says
        order = np.argsort(bounds)
        best = far
        for first in range(0, len(order), AT_ONCE):
            rows = order[first : first + AT_ONCE]
            rows = rows[bounds[rows] < best.distance]
            if not len(rows):
                break
            known, _ = distance(a.at(rows), b.at(rows))
            k = int(known.argmin())
            best = min(best, Nearest(float(known[k]), float(fine[rows[k]])))
        return best

    def _closely(self, part: Part, time_s: float) -> Nearest:
        """Return the deepest moment of a part about one instant, sharpened."""
        start, end = part.start_s, min(part.end_s, self.segments[-1].end_s)
        around = np.clip(time_s + np.linspace(-FINE, FINE, 21), start, end)
        known, _ = distance(*self._posed(part, around))
        k = int(known.argmin())
        return Nearest(self._sharp(*self._posed(part, around), k), float(around[k]))

    def _sharp(self, a: Posed, b: Posed, row: int) -> float:
        one = a.at(np.array([row])), b.at(np.array([row]))
        value, way = distance(*one)
        return max(float(value[0]), sharpened(*one, 0, way[0]))

    def _times(self, part: Part) -> Array:
        """Return every millisecond at which a part is there; a few of where all stands still."""
        found: list[Array] = []
        for segment in self.segments:
            start, end = max(segment.start_s, part.start_s), min(segment.end_s, part.end_s)
            if end <= start:
                continue
            still = not part.falls and all(len(row) == 1 for row in segment.coefficients)
            count = 2 if still else int(np.ceil((end - start) / COARSE)) + 1
            found.append(np.linspace(start, end, count))
        return np.unique(np.concatenate(found)) if found else np.empty(0)

    def _moves(self, part: Part, times: Array) -> Array:
        """Return how far points of a part get in a step of time, (n,) [m]."""
        posed, _ = self._posed(part, times)
        size = _ball(part.shape)[1]
        corners = np.concatenate([np.eye(3), -np.eye(3)]) * size
        points = posed.origin[:, None] + corners @ np.swapaxes(posed.rotation, 1, 2)
        steps = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1, initial=0.0)
        padded = np.concatenate([[0.0], steps, [0.0]])
        return 2.0 * np.maximum(padded[:-1], padded[1:])

    def _posed(self, part: Part, times: Array) -> tuple[Posed, Posed]:
        """Return a part and the thing at times."""
        count = len(times)
        there = np.tile(part.X, (count, 1, 1))
        if part.frame >= 0:
            values = self._values(times)
            there[:, 1, 3] += part.slide * values[:, 6]
            there = frames(values[:, :6])[part.frame] @ there
        if part.falls:
            there[:, 2, 3] -= 0.5 * GRAVITY * (times - part.start_s) ** 2
        return (
            Posed(part.shape, there[:, :3, :3], there[:, :3, 3]),
            Posed(
                self.thing.shape,
                np.tile(self.X_thing[:3, :3], (count, 1, 1)),
                np.tile(self.X_thing[:3, 3], (count, 1)),
            ),
        )

    def _values(self, times: Array) -> Array:
        """Return joints and opening at times, (n, 7)."""
        found = np.empty((len(times), 7))
        starts = np.array([segment.start_s for segment in self.segments])
        which = np.clip(np.searchsorted(starts, times, side="right") - 1, 0, len(starts) - 1)
        for number, segment in enumerate(self.segments):
            own = which == number
            since = times[own] - segment.start_s
            for column, row in enumerate(segment.coefficients):
                found[own, column] = sum(c * since**n for n, c in enumerate(row))
        return found


def faults(judge: Judge, report: CollisionReport, truth: dict[str, Nearest]) -> list[str]:
    """Return what is wrong with a report, in words that begin with the class of fault."""
    return [words for group in judge.groups for words in _faults(judge, report, truth, group)]


def _faults(
    judge: Judge, report: CollisionReport, truth: dict[str, Nearest], group: str
) -> Iterator[str]:
    real = truth[group]
    about = group, judge.name
    contacts = [e for e in report.contacts if (e.first, e.second) == about]
    doubtful = [e for e in report.undetermined if (e.first, e.second) == about]
    depth = -real.distance
    if depth > TOLERANCE + BAND and not contacts:
        kind = "undetermined" if doubtful else "missed"
        yield f"{kind}: {about} {1e3 * depth:.5f} mm deep at {real.time_s:.5f} s"
    if contacts and depth < TOLERANCE - BAND:
        yield f"false: {about}, {1e3 * depth:.5f} mm deep at most"
    if doubtful and not contacts and depth < TOLERANCE - BAND:
        yield f"undetermined: {about}, {1e3 * depth:.5f} mm deep at most"
    for event in contacts:
        there = -judge.at(group, event.deepest_s)
        # of what is deep in each other, moving about finds no less than the depth, and maybe more
        if event.depth_m > there + TELLS or event.depth_m < min(there, SHALLOW) - TELLS:
            yield f"depth: {about} told {1e3 * event.depth_m:.5f}, is {1e3 * there:.5f} mm"
        if event.start_s > PROMPT:
            before = -judge.at(group, event.start_s - PROMPT)
            later = event.start_s + PROMPT * np.linspace(-1.0, 1.0, 7)
            if before > TOLERANCE + BAND or not judge.touches(group, later):
                yield f"start: {about} at {event.start_s:.5f} s, {1e3 * before:.5f} mm before"
    deepest = max((event.depth_m for event in contacts), default=depth)
    if contacts and min(depth, SHALLOW) > deepest + SLACK:
        yield f"deeper: {about} told {1e3 * deepest:.5f}, is {1e3 * depth:.5f} mm"
    for miss in report.near_misses:
        if (miss.first, miss.second) == about:
            there = judge.at(group, miss.nearest_s)
            if abs(there - miss.distance_m) > TELLS:
                yield f"near miss: told {1e3 * miss.distance_m:.5f}, is {1e3 * there:.5f} mm"
            if (
                not contacts
                and len(report.near_misses) == 1
                and real.distance < miss.distance_m - SLACK
            ):
                yield f"nearer: told {1e3 * miss.distance_m:.5f}, is {1e3 * real.distance:.5f} mm"
    nearest = report.clearance
    if nearest is not None and real.distance < nearest.distance_m - SLACK:
        yield f"clearance: told {1e3 * nearest.distance_m:.5f}, {1e3 * real.distance:.5f} mm found"


def _parts(case: Case) -> Iterator[Part]:
    machine = case.scene.robot
    assert isinstance(machine.arm, SphericalWristArm)
    ever = 0.0, np.inf
    for link in machine.arm.links[1:]:  # the base moves against nothing that is fixed
        for piece in link.pieces:
            yield Part(ROBOT, piece.shape, link.joint, _matrix(piece.X_OP), 0.0, *ever, False)
    for piece in machine.gripper.body:
        yield Part(ROBOT, piece.shape, 7, _matrix(piece.X_OP), 0.0, *ever, False)
    for finger in machine.gripper.fingers:
        for piece in finger.pieces:
            slide = 0.5 * finger.side
            yield Part(ROBOT, piece.shape, 7, _matrix(piece.X_OP), slide, *ever, False)
    for body in case.scene.bodies[1:]:
        for lie in case.record.placements[body.name]:
            for piece in body.pieces:
                X = _matrix(lie.X) @ _matrix(piece.X_OP)
                if lie.lie is Lie.HELD:
                    yield Part(ROBOT, piece.shape, 7, X, 0.0, lie.start_s, lie.end_s, False)
                elif lie.lie is Lie.FALLING:
                    yield Part(body.name, piece.shape, -1, X, 0.0, lie.start_s, lie.end_s, True)


def _matrix(pose: Pose) -> Array:
    found = np.eye(4)
    found[:3, :3] = np.array(pose.rotation).reshape(3, 3)
    found[:3, 3] = pose.translation
    return found


def _ball(shape: Shape) -> tuple[Array, float]:
    """Return middle and radius of a ball round a shape in its frame."""
    match shape:
        case Box(half_extents=half):
            return np.zeros(3), float(np.linalg.norm(half))
        case Cylinder(radius=radius, half_length=half_length):
            return np.zeros(3), float(np.hypot(radius, half_length))
        case hull:
            points = np.array(hull.points)
            middle = points.mean(axis=0)
            return middle, float(np.linalg.norm(points - middle, axis=1).max())


def _balls(a: Posed, b: Posed) -> Array:
    """Return how far the balls round shapes are apart, (n,) [m]: no more than the shapes."""
    (middle_a, ball_a), (middle_b, ball_b) = _ball(a.shape), _ball(b.shape)
    between = b.origin + b.rotation @ middle_b - a.origin - a.rotation @ middle_a
    return np.linalg.norm(between, axis=1) - ball_a - ball_b
