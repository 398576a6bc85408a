"""What a browser is told of a rehearsal. Lines are of the rehearsed text, from 1; 0: of none."""

from typing import Final

import msgspec

from vrts.live.session.channel.messages import Json, Marked

NO_MEMORY: Final = 71  # exit status of a rehearsal's process, which tells the server


class _Told(msgspec.Struct, frozen=True, tag_field="type"):
    id: int


class Problem(msgspec.Struct, frozen=True):
    """Something wrong with the text; columns from 1, ends are exclusive."""

    line: int
    column: int
    end_line: int
    end_column: int
    code: str
    severity: str  # "error", "warning", "note"
    message: str
    help: str
    program: str = ""  # of the room's memory, where it is in that one: `line` is 0 then


class Refused(_Told, frozen=True, tag="refused"):
    """There is no rehearsal; where the text is to blame, with what is wrong in it."""

    message: str
    problems: tuple[Problem, ...] = ()
    more: int = 0  # problems that are not told
    # where one question alone is refused, and the rehearsal goes on: its type, and of a block which
    of: str | msgspec.UnsetType = msgspec.UNSET
    number: int | msgspec.UnsetType = msgspec.UNSET


class Place(msgspec.Struct, frozen=True):
    """A breakpoint."""

    line: int
    verified: bool  # a step begins there, or at a later line of the program
    at: int  # the line at which it stops


class Placed(_Told, frozen=True, tag="breakpoints"):
    """The breakpoints of now."""

    breakpoints: tuple[Place, ...]


class Mark(msgspec.Struct, frozen=True):
    """Something that happened, for the time line."""

    time_s: float
    kind: str  # "contact", "near", "fault", "program"
    text: str
    line: int


class End(msgspec.Struct, frozen=True):
    """How the program ended."""

    why: str  # value of `Ending`
    line: int
    time_s: float
    text: str  # in words


class Ready(_Told, frozen=True, tag="ready"):
    """The program was run to its end, or to a limit."""

    begin_s: float  # when the run begins, of the clock that all times are of
    duration_s: float
    ended: End
    breakpoints: tuple[Place, ...]
    marks: tuple[Mark, ...]
    contacts: tuple[Json, ...]
    near: tuple[Json, ...]
    undetermined: bool  # of some pairs nothing could be proven
    mark: Marked | None  # by the public checks; None: no task, or it does not begin at the start
    problems: tuple[Problem, ...]  # warnings, and what went wrong in the run
    programs: tuple[str, ...]  # names of the programs in the text
    note: str  # what has to be said; empty: nothing
    more: int = 0  # problems that are not told
    blocks: Json = {}


class Variable(msgspec.Struct, frozen=True):
    """A name with its value."""

    name: str
    value: str
    group: str  # "local", "variable", "location"


class Stopped(_Told, frozen=True, tag="stopped"):
    """Where it stands now."""

    why: str  # "breakpoint", "step", "start", "end", "error", "time"
    time_s: float
    program: str
    line: int
    step_text: str
    depth: int  # programs that called each other
    variables: tuple[Variable, ...]
    more: int  # variables that are not told
    typed: tuple[str, ...]  # the last lines of output up to here
    text: str = ""  # why, in words


class Block(_Told, frozen=True, tag="block"):
    """A minute of the run, as `session.looking.block` makes it; or why there is none."""

    number: int
    data: Json | None = None
    message: str = ""


class Ended(_Told, frozen=True, tag="ended"):
    """The process of the rehearsal is gone."""

    message: str


class Closed(msgspec.Struct, frozen=True, tag_field="type", tag="closed"):
    """The server closes the connection."""

    code: str
    text: str


Told = Refused | Placed | Ready | Stopped | Block | Ended
