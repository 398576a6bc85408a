"""What the board's page is told: JSON. Times are Unix times [s], 0 where there is none."""

import msgspec


class ColumnTold(msgspec.Struct, frozen=True):
    """An assignment."""

    id: str
    title: str
    opens: float
    due: float
    total: float  # full marks; 0: nothing is marked yet
    counts: str  # best, or latest: which attempt counts
    begun: int  # students who have handed in
    full: int  # of them, who have full marks
    mean: float | None  # of the marks that count
    marked: bool = False  # whether the course says where its marking is


class CellTold(msgspec.Struct, frozen=True, omit_defaults=True):
    """What somebody has done for an assignment; everything at its default: nothing."""

    tries: int = 0
    mark: float | None = None  # public, of the attempt that counts
    last: float | None = None  # of the last one
    at: float = 0.0  # when that was handed in
    state: str = ""  # of the last one: waiting, marked, refused, failed
    late: str = ""  # in words
    cause: str = ""  # key of what costs most in the last attempt
    same: int = 0  # so many attempts in a row have lost by that


class StudentTold(msgspec.Struct, frozen=True):
    """A row of the board."""

    id: int  # account
    name: str
    key: str  # what the lists call them
    team: str
    listed: bool
    room: str  # name of the room they are in; empty: none
    cells: tuple[CellTold, ...]  # in the order of the columns


class CauseTold(msgspec.Struct, frozen=True):
    """What costs points in the last attempts of some."""

    key: str
    assignment: str
    words: str
    points: float  # lost by it, of all of them together
    students: tuple[int, ...]  # accounts, those that lose by it longest first
    stuck: int  # of them, who have lost by it in three attempts in a row


class WaitTold(msgspec.Struct, frozen=True):
    """Somebody who waits."""

    id: int  # account
    name: str
    why: str  # hand: for help; marking: for a mark
    since: float
    room: str  # id of the room; empty: none
    text: str


class BoardTold(msgspec.Struct, frozen=True):
    """`GET /course/board/now`."""

    title: str
    now: float
    columns: tuple[ColumnTold, ...]
    students: tuple[StudentTold, ...]
    causes: tuple[CauseTold, ...]
    waits: tuple[WaitTold, ...]


class AttemptTold(msgspec.Struct, frozen=True):
    """An attempt of somebody."""

    assignment: str
    number: int
    at: float
    state: str
    mark: float | None
    total: float
    late: str
    losses: tuple[tuple[str, float], ...]  # words, and points


class WorkTold(msgspec.Struct, frozen=True):
    """`GET /course/board/student/ID`: everything that somebody has handed in."""

    id: int
    name: str
    attempts: tuple[AttemptTold, ...]  # in the order of time
