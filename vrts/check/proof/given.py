"""What a proof is about: the records of a run, what is claimed of them, and what shows it."""

from collections.abc import Iterable, Mapping, Sequence
from math import inf
from typing import NamedTuple, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose, Vector
from vrts.engine.memory.events import Event, Grasped, HandCommanded, Released
from vrts.engine.memory.records import Lie, Placement, Segment
from vrts.geometry.shapes import Piece
from vrts.geometry.solids import Solid

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Pair: TypeAlias = tuple[Indices, Indices]  # of solids, each (m,)
Span: TypeAlias = tuple[float, float]  # start and end [s]

EXACT = 1e-9  # [m, 1] so exactly points lie in solids, and weights sum up
DEEPEST = 30  # halvings of a root interval
BOXES, DIRECTION, EXCUSED = range(3)  # what settles a leaf
NEAR, WITNESS, NEAREST, KEEPS = range(4)  # what points show; see `Points`


class Motions(Protocol):
    """What is read of a timeline."""

    @property
    def segments(self) -> Sequence[Segment]:
        """All segments in time order."""
        ...


class Records(Protocol):
    """What is read of a run."""

    @property
    def timeline(self) -> Motions:
        """How the robot moves."""
        ...

    @property
    def events(self) -> Sequence[Event]:
        """What happened, in time order."""
        ...

    @property
    def placements(self) -> Mapping[str, Sequence[Placement]]:
        """Where every movable body is."""
        ...


class Leaves(NamedTuple):
    """Intervals of rows, which together leave no time out; in the order of rows and times."""

    row: Indices  # (n,) of the list of what has to be covered
    root: Indices  # (n,) interval between two edges
    depth: Indices  # (n,) so often halved
    part: Indices  # (n,) which of the 2^depth parts
    kind: Indices  # (n,) by boxes, by a direction, or excused by a contact
    normal: Array  # (n, 3) direction from the outer solid to the inner; else zero


class Points(NamedTuple):
    """Pairs of points, one in each of two solids: means of corners of both, with weights."""

    use: Indices  # (p,) for what is near, a contact, the smallest distance, what comes no nearer
    time_s: Array  # (p,)
    solids: Indices  # (p, 2)
    corners: Array  # (p, 2, 4, 3) in the frames of the pieces [m]
    weights: Array  # (p, 4) of the corners, not below zero; their sum is 1


class LetGo(NamedTuple):
    """When a finger has parted from what it held."""

    body: str
    finger: int
    grip: int  # number of the grip of this body
    apart_s: float  # first instant at which it is farther than 0.2 mm
    away_s: float  # from then on its distance counts again


Told: TypeAlias = Mapping[int, LetGo]  # by the number of the grip


class Parted(NamedTuple):
    """When the distance of what is carried from what it stood on, or will stand on, counts."""

    body: str
    stay: int  # number of the placement of this body
    other: str
    from_s: float
    to_s: float


class Meeting(NamedTuple):
    """A contact: two names, and the times before and after which there is none."""

    first: str
    second: str
    from_s: float
    to_s: float


class Claims(NamedTuple):
    """What a certificate says is so."""

    meetings: tuple[Meeting, ...]  # and no other contacts
    clearance_m: float | None  # nothing that counts comes nearer; None: nothing is said
    near_miss_m: float | None  # what was farther apart counts again when it comes nearer
    let_go: tuple[LetGo, ...]
    parted: tuple[Parted, ...]


class Apart(NamedTuple):
    """Two solids that have to be so far apart at an instant."""

    first: int
    second: int
    time_s: float
    least_m: float


class Evidence(NamedTuple):
    """What is to show that it is so."""

    edges: Array  # (n + 1,) of the root intervals [s]
    leaves: Leaves
    points: Points


class Demand(NamedTuple):
    """Every piece of one union keeps apart from every piece of another, but for a tolerance."""

    sides: tuple[str, str]  # as contacts name them
    first: Sequence[int]  # solids
    second: Sequence[int]
    start_s: float
    end_s: float
    tolerance: float  # [m]; inf: only the distance matters
    counts: bool  # enters the smallest distance


class Stay(NamedTuple):
    """A body in one of its placements."""

    body: str
    number: int
    span: Span  # [s]
    lie: Lie
    before: str | None  # what it came from
    after: str | None  # what it will stand on
    solids: Sequence[int]
    lowered: Sequence[int]

    @property
    def partners(self) -> tuple[str | None, str | None]:
        """What it came from and what it will stand on."""
        return self.before, self.after


class Window(NamedTuple):
    """Some time with one rule between a finger and a body."""

    span: Span
    depth_m: float  # deeper is a contact
    counts: bool  # enters the smallest distance
    open_s: float = inf  # the body has left the hand
    until_s: float = inf  # the next grip begins, or the run ends
    grip: int = -1  # number of the grip that ends so; else -1


class Release(NamedTuple):
    """A window in which a finger may press: it ends when the finger is first seen to be apart."""

    finger: Sequence[int]  # solids
    stays: Sequence[Stay]
    window: Window
    number: int  # of the finger


class Near(NamedTuple):
    """Two unions that are near each other at some instants, as the certificate has to show."""

    first: Sequence[int]  # solids
    stays: Sequence[Stay]
    times: Sequence[float]
    most_m: float  # no farther apart


class Covered(NamedTuple):
    """What has to be shown; rows are the pairs of solids of the demands, one after the other."""

    solids: list[Solid]
    demands: list[Demand]
    releases: list[Release]
    stays: list[Stay]
    near: list[Near]

    def keep(
        self,
        sides: tuple[str, str],
        first: Sequence[int],
        second: Sequence[int],
        span: Span,
        tolerance: float,
        counts: bool = True,
    ) -> None:
        """Demand that two unions of solids keep apart for a time, if it is any."""
        if span[1] > span[0]:
            self.demands.append(Demand(sides, first, second, *span, tolerance, counts))

    def add(
        self,
        pieces: Iterable[Piece],
        frame: int,
        X: Pose,
        name: str,
        slide: Vector = (0.0, 0.0, 0.0),
        falls: float | None = None,
    ) -> Sequence[int]:
        """Add the pieces of a body and return their numbers; see `Solid`."""
        first = len(self.solids)
        self.solids.extend(Solid(p.shape, frame, X @ p.X_OP, name, slide, falls) for p in pieces)
        return range(first, len(self.solids))


def common(a: Span, b: Span) -> Span:
    """Return the time that two intervals have in common; it may end before it starts."""
    return max(a[0], b[0]), min(a[1], b[1])


def next_support(later: Sequence[Placement]) -> str | None:
    """Return what a body will stand on next, by its later placements; None: on nothing."""
    return next((p.support for p in later if p.lie is not Lie.FALLING), None)


def steps(from_s: float, to_s: float, step_s: float) -> list[float]:
    """Return the instants from one time on, a step apart, before another; or after it, backward."""
    count = int(np.ceil(max(abs(to_s - from_s) - 1e-9, 0.0) / step_s))
    return [from_s + number * (step_s if from_s < to_s else -step_s) for number in range(count)]


def grips_of(body: str, events: Sequence[Event]) -> list[Span]:
    """Return when the hand began to close on a body, and when it let go."""
    found, close_s, began = list[Span](), 0.0, inf
    for event in events:
        if isinstance(event, HandCommanded) and event.action == "close":
            close_s = event.time_s
        elif isinstance(event, Grasped) and event.body == body:
            began = min(close_s, event.time_s)
        elif isinstance(event, Released) and event.body == body and began < inf:
            found.append((began, event.time_s))
            began = inf
    return [*found, (began, inf)] if began < inf else found


class Rows(NamedTuple):
    """The pairs of solids of all demands."""

    first: Indices  # (r,)
    second: Indices
    start_s: Array
    end_s: Array
    least: Array  # they keep farther apart than this [m]
    demand: Indices  # number of the demand
    begin: Indices  # (d,) of each demand: its first row
    size: Indices  # (d,) and how many it has


class Proven(NamedTuple):
    """What a certificate that holds rests on."""

    rows: int  # pairs of solids in times
    leaves: int  # intervals listed
    margin_m: float  # by which the tightest one holds
    nearest_m: float | None  # distance of two points that come nearest of all that counts


class Wrong(Exception):  # noqa: N818 -- names the situation
    """The first thing in a certificate that does not hold."""

    def __init__(self, what: str, time_s: float | None = None, parts: Sequence[str] = ()) -> None:
        """Say what, when, and between which parts."""
        super().__init__(what, time_s, parts)
        self.what, self.time_s, self.parts = what, time_s, tuple(parts)
