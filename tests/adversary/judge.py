"""What really happens in a case, by looking very often, and what is wrong with a report of it.

Shapes and polynomials are read from the case; where things are comes from `kinematics`, how far
they are apart from `gaps`. Of the check only the report is used.
"""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from tests.adversary.cases import Case
from tests.adversary.gaps import Posed, distance, rough, sharpened, surely
from tests.adversary.kinematics import frames
from vrts.base.pose import Pose
from vrts.check.verdict import CollisionReport
from vrts.engine.memory.records import GRAVITY, Lie, Placement, Segment
from vrts.geometry.shapes import Box, Cylinder, Shape
from vrts.robots.model import Finger, Robot, SphericalWristArm
from vrts.scene.model import Body

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]
Group: TypeAlias = tuple[str, str]
"""What meets what, as reports call it."""

ROBOT = "robot"
FLANGE = 7  # frame
COARSE, FINE = 1e-3, 1e-4  # [s] between instants
FAR = 0.015  # [m] what is farther apart is not looked at
AT_ONCE = 40  # instants of a part at which it may be nearest
AGAIN = 1e-6  # [m] better than that, moving about had got stuck
STUCK = 3e-4  # [m] by so much moving about may be wrong
TOLERANCE = 2e-4  # [m] deeper is a contact
BAND = 1.2e-5  # [m] nearer to the tolerance nobody has to tell
SHALLOW = 2e-3  # [m] less deep than this there is one best direction
TELLS = 1e-5  # [m] of a depth or distance that is told
SLACK = 1.1e-4  # [m] of a smallest distance
PROMPT = 1.5e-3  # [s] of the time at which a contact begins


class Part(NamedTuple):
    """A convex piece, on the arm or not."""

    shape: Shape
    frame: int  # of the arm; -1: none
    X: Array  # in the frame, or in W, (4, 4)
    slide: float  # along y by so much of the opening
    falls_from_s: float | None = None


class Meeting(NamedTuple):
    """Two parts that may meet, when, and how deep they may then."""

    group: Group
    first: Part
    second: Part
    start_s: float
    end_s: float
    eased: float = 0.0  # so much deeper than the tolerance is no contact [m]
    counts: bool = True  # how near they come is told


class Nearest(NamedTuple):
    """The deepest, or nearest, moment found of a group, less what is allowed there."""

    distance: float  # [m]
    time_s: float


class Judge:
    """Knows what moves, and what it may meet."""

    def __init__(self, segments: Sequence[Segment], meetings: Iterable[Meeting]) -> None:
        """Start with joints and opening over time, and all that may meet."""
        self.segments = segments
        self.meetings = tuple(meetings)
        self.groups: tuple[Group, ...] = tuple(dict.fromkeys(m.group for m in self.meetings))

    def nearest(self, group: Group) -> Nearest:
        """Return the deepest moment of a group, of all instants; `FAR` if it is never nearer."""
        own = self._of(group)
        found = [self._roughly(meeting) for meeting in own]
        least = min(one.distance for one in found)
        if least >= FAR:
            return Nearest(FAR, found[0].time_s)
        return min(
            self._closely(meeting, one.time_s)
            for meeting, one in zip(own, found, strict=True)
            if one.distance < least + STUCK
        )

    def at(self, group: Group, time_s: float) -> float:
        """Return how near a group is at one instant, less what is allowed [m]; at most `FAR`."""
        return min((away + m.eased for m, away in self._now(group, time_s)), default=FAR)

    def depth(self, group: Group, time_s: float) -> float:
        """Return how deep at one instant those are that go farthest beyond what they may [m]."""
        now = self._now(group, time_s)
        return -min(((away + m.eased, away) for m, away in now), default=(FAR, FAR))[1]

    def touches(self, group: Group, times: Array) -> bool:
        """Return whether a group is in contact at one of some instants."""
        return any(-self.at(group, time) > TOLERANCE - BAND for time in times.tolist())

    def always_counts(self, group: Group) -> bool:
        """Return whether every touch of a group is judged alike, and every distance told."""
        return all(m.counts and m.eased == 0.0 for m in self._of(group))

    def distances(self, meeting: Meeting, times: Array) -> Array:
        """Return how far two parts are apart at some instants, from below [m]."""
        a, b = self._posed(meeting, times)
        once, which = _different(a, b)
        return distance(a.at(once), b.at(once))[0][which]

    def _of(self, group: Group) -> list[Meeting]:
        return [meeting for meeting in self.meetings if meeting.group == group]

    def _now(self, group: Group, time_s: float) -> list[tuple[Meeting, float]]:
        """Return what of a group is near each other at one instant, and how far apart."""
        time = np.array([time_s])
        own = [m for m in self._of(group) if m.start_s <= time_s <= m.end_s]
        pairs = [(m, *self._posed(m, time)) for m in own]
        near = [(m, a, b) for m, a, b in pairs if float(_balls(a, b)[0]) < FAR]
        known = [float(distance(a, b)[0][0]) + m.eased for m, a, b in near]
        least = min(known, default=FAR)
        return [
            (m, self._sharp(a, b, 0))
            for (m, a, b), value in zip(near, known, strict=True)
            if value < min(FAR, least + STUCK)
        ]

    def _roughly(self, meeting: Meeting) -> Nearest:
        """Return the deepest moment of two parts, of those every 0.1 ms, not sharpened."""
        far = Nearest(FAR, 0.0)
        times = self._times(meeting)
        if not len(times):
            return far
        a, b = self._posed(meeting, times)
        margin = _steps(a, b)
        near = np.flatnonzero(_balls(a, b) < FAR + margin)
        if not len(near):
            return far
        coarse = self._deepest(meeting, times[near], far)
        bounds = rough(a.at(near), b.at(near))[0].max(axis=1) + meeting.eased
        close = near[bounds < coarse.distance + margin[near]]
        if not len(close):
            return coarse
        between = (times[close][:, None] + np.arange(-5, 6) * FINE).ravel()
        return self._deepest(meeting, np.unique(np.clip(between, times[0], times[-1])), coarse)

    def _deepest(self, meeting: Meeting, times: Array, known: Nearest) -> Nearest:
        """Return the deepest of some instants, if it is deeper than a moment that is known."""
        a, b = self._posed(meeting, times)
        once, _ = _different(a, b)  # what is carried along stays where it is, seen from the hand
        times, a, b = times[once], a.at(once), b.at(once)
        bounds = rough(a, b)[0].max(axis=1) + meeting.eased  # none is nearer than this says
        order, best = np.argsort(bounds), known
        for first in range(0, len(order), AT_ONCE):
            rows = order[first : first + AT_ONCE]
            rows = rows[bounds[rows] < best.distance]
            if not len(rows):
                break
            found = distance(a.at(rows), b.at(rows))[0] + meeting.eased
            # moving about may have got stuck: what seems the deepest is looked at again
            while found.min() < best.distance:
                k = int(found.argmin())
                again = surely(a.at(rows[k : k + 1]), b.at(rows[k : k + 1]))[0] + meeting.eased
                if again[0] < found[k] + AGAIN:
                    best = Nearest(float(again[0]), float(times[rows[k]]))
                    break
                found[k] = again[0]
        return best

    def _closely(self, meeting: Meeting, time_s: float) -> Nearest:
        """Return the deepest moment of two parts about one instant, sharpened."""
        start, end = meeting.start_s, min(meeting.end_s, self.segments[-1].end_s)
        around = np.clip(time_s + np.linspace(-FINE, FINE, 21), start, end)
        known, _ = surely(*self._posed(meeting, around))
        k = int(known.argmin())
        sharp = self._sharp(*self._posed(meeting, around), k)
        return Nearest(sharp + meeting.eased, float(around[k]))

    def _sharp(self, a: Posed, b: Posed, row: int) -> float:
        one = a.at(np.array([row])), b.at(np.array([row]))
        value, way = surely(*one)
        return max(float(value[0]), sharpened(*one, 0, way[0]))

    def _times(self, meeting: Meeting) -> Array:
        """Return every millisecond at which parts may meet; a few of where all stands still."""
        falls = any(part.falls_from_s is not None for part in (meeting.first, meeting.second))
        found: list[Array] = []
        for segment in self.segments:
            start = max(segment.start_s, meeting.start_s)
            end = min(segment.end_s, meeting.end_s)
            if end <= start:
                continue
            still = not falls and all(len(row) == 1 for row in segment.coefficients)
            count = 2 if still else int(np.ceil((end - start) / COARSE)) + 1
            found.append(np.linspace(start, end, count))
        return np.unique(np.concatenate(found)) if found else np.empty(0)

    def _posed(self, meeting: Meeting, times: Array) -> tuple[Posed, Posed]:
        """Return two parts at times."""
        values = self._values(times)
        first, second = meeting.first, meeting.second
        return self._placed(first, times, values), self._placed(second, times, values)

    def _placed(self, part: Part, times: Array, values: Array) -> Posed:
        there = np.tile(part.X, (len(times), 1, 1))
        if part.frame >= 0:
            there[:, 1, 3] += part.slide * values[:, 6]
            there = frames(values[:, :6])[part.frame] @ there
        if part.falls_from_s is not None:
            there[:, 2, 3] -= 0.5 * GRAVITY * (times - part.falls_from_s) ** 2
        return Posed(part.shape, there[:, :3, :3], there[:, :3, 3])

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


def judge_of(case: Case) -> Judge:
    """Return the judge of a case in which everything that moves may meet one thing."""
    return Judge(case.record.timeline.segments, _meetings(case))


def faults(judge: Judge, report: CollisionReport, truth: dict[Group, Nearest]) -> list[str]:
    """Return what is wrong with a report, in words that begin with the class of fault."""
    return [words for group in judge.groups for words in _faults(judge, report, truth, group)]


def _faults(
    judge: Judge, report: CollisionReport, truth: dict[Group, Nearest], about: Group
) -> Iterator[str]:
    real = truth[about]
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
        there = judge.depth(about, event.deepest_s)
        # of what is deep in each other, moving about finds no less than the depth, and maybe more
        if event.depth_m > there + TELLS or event.depth_m < min(there, SHALLOW) - TELLS:
            yield f"depth: {about} told {1e3 * event.depth_m:.5f}, is {1e3 * there:.5f} mm"
        if event.start_s > PROMPT:
            before = -judge.at(about, event.start_s - PROMPT)
            later = event.start_s + PROMPT * np.linspace(-1.0, 1.0, 7)
            if before > TOLERANCE + BAND or not judge.touches(about, later):
                yield f"start: {about} at {event.start_s:.5f} s, {1e3 * before:.5f} mm before"
    if not judge.always_counts(about):
        return
    deepest = max((event.depth_m for event in contacts), default=depth)
    if contacts and min(depth, SHALLOW) > deepest + SLACK:
        yield f"deeper: {about} told {1e3 * deepest:.5f}, is {1e3 * depth:.5f} mm"
    for miss in report.near_misses:
        if (miss.first, miss.second) == about:
            there = judge.at(about, miss.nearest_s)
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


def _meetings(case: Case) -> Iterator[Meeting]:
    """Yield everything that moves, and the one thing that stands."""
    stands, *others = case.scene.bodies
    (piece,) = stands.pieces
    thing = Part(piece.shape, -1, matrix(stands.X_WO) @ matrix(piece.X_OP), 0.0)
    for part in (*arm_parts(case.scene.robot), *hand_parts(case.scene.robot)):
        yield Meeting((ROBOT, stands.name), part, thing, 0.0, np.inf)
    for body in others:
        for lie in case.record.placements[body.name]:
            if lie.lie in (Lie.HELD, Lie.FALLING):
                group = ROBOT if lie.lie is Lie.HELD else body.name, stands.name
                for part in parts_of(body, lie):
                    yield Meeting(group, part, thing, lie.start_s, lie.end_s)


def arm_parts(machine: Robot) -> tuple[Part, ...]:
    """Return what moves of an arm: its base moves against nothing that is fixed."""
    assert isinstance(machine.arm, SphericalWristArm)
    return tuple(
        Part(piece.shape, link.joint, matrix(piece.X_OP), 0.0)
        for link in machine.arm.links[1:]
        for piece in link.pieces
    )


def hand_parts(machine: Robot) -> tuple[Part, ...]:
    """Return palm and fingers."""
    fingers = (part for finger in machine.gripper.fingers for part in finger_parts(finger))
    return (*palm_parts(machine), *fingers)


def palm_parts(machine: Robot) -> tuple[Part, ...]:
    """Return the hand without its fingers."""
    return tuple(Part(p.shape, FLANGE, matrix(p.X_OP), 0.0) for p in machine.gripper.body)


def finger_parts(finger: Finger) -> tuple[Part, ...]:
    """Return a finger."""
    slide = 0.5 * finger.side
    return tuple(Part(p.shape, FLANGE, matrix(p.X_OP), slide) for p in finger.pieces)


def parts_of(body: Body, lie: Placement) -> tuple[Part, ...]:
    """Return a body where it is placed."""
    frame = FLANGE if lie.lie is Lie.HELD else -1
    falls = lie.start_s if lie.lie is Lie.FALLING else None
    return tuple(
        Part(p.shape, frame, matrix(lie.X) @ matrix(p.X_OP), 0.0, falls) for p in body.pieces
    )


def matrix(pose: Pose) -> Array:
    """Return a pose as a matrix, (4, 4)."""
    found = np.eye(4)
    found[:3, :3] = np.array(pose.rotation).reshape(3, 3)
    found[:3, 3] = pose.translation
    return found


def _steps(a: Posed, b: Posed) -> Array:
    """Return how far points of A get, seen from B, in a step of time, (n,) [m]."""
    rotation, origin = _seen(a, b)
    corners = np.concatenate([np.eye(3), -np.eye(3)]) * _ball(a.shape)[1]
    points = origin[:, None] + corners @ np.swapaxes(rotation, 1, 2)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1, initial=0.0)
    padded = np.concatenate([[0.0], steps, [0.0]])
    return 2.0 * np.maximum(padded[:-1], padded[1:])


def _different(a: Posed, b: Posed) -> tuple[Indices, Indices]:
    """Return places of A that differ, as seen from B, and for every place which it is of these."""
    rotation, origin = _seen(a, b)
    table = np.rint(np.concatenate([rotation.reshape(-1, 9), origin], axis=1) * 1e11)
    _, once, which = np.unique(table, axis=0, return_index=True, return_inverse=True)
    return once, which.reshape(-1)


def _seen(a: Posed, b: Posed) -> tuple[Array, Array]:
    """Return where A is in the frame of B."""
    back = np.swapaxes(b.rotation, 1, 2)
    return back @ a.rotation, np.einsum("nij,nj->ni", back, a.origin - b.origin)


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
