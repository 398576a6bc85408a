"""What pages of a course are told, and what they send: JSON."""

from typing import Annotated

import msgspec
from msgspec import Meta

from vrts.course.handing.published import Returning
from vrts.course.handing.words import Block
from vrts.live.actions import LONGEST_PROGRAM


class AssignmentTold(msgspec.Struct, frozen=True):
    """An assignment, as those see it who work on it."""

    id: str  # of the scene too
    title: str
    opens: float  # Unix time [s]; 0: it is open
    due: float  # Unix time [s]; 0: there is no deadline


class CourseTold(msgspec.Struct, frozen=True):
    """`GET /course/me`: the course, and who asks."""

    title: str
    rank: str  # teacher, assistant, student; empty: somebody of no list
    team: str
    assignments: tuple[AssignmentTold, ...]


class LossTold(msgspec.Struct, frozen=True, omit_defaults=True):
    """Points lost."""

    points: str  # such as "2.5"
    cause: str
    line: int | None = None
    time_s: float | None = None
    hint: str = ""
    why: tuple[str, ...] = ()


class AttemptTold(msgspec.Struct, frozen=True, omit_defaults=True):
    """A hand-in, as its student sees it."""

    number: int
    at: float  # Unix time [s]
    state: str
    mark: str = ""  # public; empty: there is none
    total: str = ""
    late: str = ""
    said: str = ""
    by: str = ""  # who handed it in, if somebody else of the team did
    before: int | None = None  # programs that are marked before it; None: it does not wait
    page: bool = False  # whether there is a page about it
    losses: tuple[LossTold, ...] = ()


class WorkTold(msgspec.Struct, frozen=True, omit_defaults=True):
    """An assignment, and how it stands for who asks."""

    id: str
    title: str
    opens: float
    due: float  # one's own, where it is a later one
    closes: float  # Unix time [s]; 0: never
    best: bool  # whether the best attempt counts, and not the latest
    exam: bool
    team: bool
    late: str  # what handing in now would cost, in words
    most: int | None  # attempts; None: as many as one likes
    left: int | None
    refusal: str  # why nothing is taken now; empty: something is
    refusal_help: str
    attempts: tuple[AttemptTold, ...] = ()
    final: Returning | None = None  # what the teacher has published
    own_due: bool = False  # whether the deadline is a later one, given to who asks
    excused: bool = False  # whether a grader has excused who asks


class AllWorkTold(msgspec.Struct, frozen=True):
    """`GET /course/work/now`: what there is to do."""

    title: str  # of the course
    name: str  # of who asks
    rank: str
    team: str
    hands_in: bool
    assignments: tuple[WorkTold, ...]


class TextTold(msgspec.Struct, frozen=True):
    """`GET /course/work/text/ID`: what students get of a task."""

    blocks: tuple[Block, ...]
    start: str
    problem: str


class HandInAsked(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /course/work/hand-in`: a program, and what was agreed to."""

    assignment: Annotated[str, Meta(max_length=64)]
    text: Annotated[str, Meta(max_length=LONGEST_PROGRAM)]
    attempt: Annotated[int, Meta(ge=1, le=100_000)]  # the number that it is going to have
    late: Annotated[str, Meta(max_length=400)]  # what lateness costs, as it was shown


class HandInTold(msgspec.Struct, frozen=True):
    """What was taken."""

    number: int
    at: float
    late: str
    again: bool  # the last attempt is the same program: it counts already
