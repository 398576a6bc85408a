"""Messages between the server and the process of a session.

To the session goes one JSON document a line on its standard input, the first of them `Start`. From
it comes a stream of messages, each behind its length in bytes (u32, little endian): those that
begin with the byte 1 are pose frames (`frame`), the others JSON. The session never reads a clock
but the one it is given; by default that is `time.monotonic`, which server and session share, so the
server stamps a command that arrives now with `time.monotonic() - Ready.epoch_s`.

A command takes effect at its stamp, or at the time the session has reached if that is later:
`Done.at_s` says which. The list of (`Done.at_s`, `Act` or `Halt`) with the `Start` is all that
`replay` needs; entries with `Done.counts` false may be left out.

Lengths are in m, angles in rad, times in s since the session began, in the world frame. Poses `X`
are twelve numbers, as the viewer takes them: the rotation row by row, then the translation.
"""

import struct
from typing import Annotated, Final

import msgspec
from msgspec import Meta

from vrts.live.actions import Action, Name, Number
from vrts.live.session.channel.rows import (
    HandPlace,
    Lost,
    Part,
    Placed,
    ProgramEntry,
    WayTouch,
)
from vrts.live.settings import HISTORY_QUOTA

LENGTH: Final = struct.Struct("<I")  # before every message from the session
BEAT: Final = 0.020  # [s] between pose frames, unless `Pace` says otherwise
SILENCE: Final = 0.200  # [s] without `Keep` after which a held key counts as released
LONGEST_ORDER: Final = 1 << 20  # bytes of a line to the session
BLOCK: Final = 60.0  # [s] of the past that are asked for at once

Stamp = Annotated[float, Meta(ge=0.0, le=1e7)]
Ref = Annotated[int, Meta(ge=0, le=2**53)]
Owner = Annotated[str, Meta(pattern=r"^[a-z0-9][a-z0-9_-]{0,39}\Z")]
Json = dict[str, object]


class Order(msgspec.Struct, frozen=True, forbid_unknown_fields=True, tag_field="type"):
    """A message to the session."""


class Start(Order, frozen=True, tag="start"):
    """The first message: what it is about. Paths are the server's own, never a client's."""

    session: Annotated[int, Meta(ge=0, le=65535)]  # number in pose frames
    folder: str  # exists; the session writes nowhere else
    scene: str = ""  # name or path; empty: the task's, or the robot alone
    task: str = ""  # path of a task file
    lab: str = ""  # path of a lab file
    dialect: str = "val2"
    quota: int = 64_000_000  # bytes of users' folders
    history: int = HISTORY_QUOTA  # bytes of the file of what is older than ten minutes
    before: str = ""  # file of what was done before the server ended; the session removes it
    until_s: Stamp = 0.0  # how far the session had come then
    exact: bool = False  # it stops just there, where another session stood
    slept: bool = False  # the room was asleep: it goes on just there, and nothing is stopped
    asleep_sha256: str = ""  # of the state in its folder with which it wakes; empty: there is none
    scene_sha256: str = ""  # of `Ready.scene` then; with another scene it begins anew
    controller: str = ""  # model that it went by then; empty: the setting's own
    controller_sha256: str = ""  # of what that model said; empty: not asked for


class Act(Order, frozen=True, tag="act"):
    """An action of the operator; answered by `Done`."""

    ref: Ref
    stamp_s: Stamp
    owner: Owner  # whose folder the monitor uses; the server's safe name of a user
    action: Action


class Halt(Order, frozen=True, tag="halt"):
    """Panic: overtakes everything that waits; answered by `Done`."""

    ref: Ref
    stamp_s: Stamp


class AskReach(Order, frozen=True, tag="ask_reach"):
    """Whether the tool can go somewhere from where it is; answered by `Reached`."""

    ref: Ref
    position_m: tuple[Number, Number, Number]
    oat_rad: tuple[Number, Number, Number]
    straight: bool = False
    asker: Annotated[str, Meta(max_length=64)] = ""  # of theirs, only the last question counts


class AskSnapshot(Order, frozen=True, tag="ask_snapshot"):
    """Everything a client needs that comes now; answered by `Snapshot`."""

    ref: Ref


class AskProgram(Order, frozen=True, tag="ask_program"):
    """What was done as a VAL-II program; answered by `ProgramText`."""

    ref: Ref
    name: Name


class AskBlock(Order, frozen=True, tag="ask_block"):
    """A block of the past, for somebody who looks at it; answered by `Looked`."""

    ref: Ref
    number: Annotated[int, Meta(ge=0, le=200_000)]  # it begins at `number * BLOCK`


class AskState(Order, frozen=True, tag="ask_state"):
    """The state of now, for somebody's rehearsal; answered by `Left`."""

    ref: Ref


class Sleep(Order, frozen=True, tag="sleep"):
    """Get ready to end with everything kept, if nothing is under way; answered by `Slept`."""

    ref: Ref


class Pace(Order, frozen=True, tag="pace"):
    """How many pose frames to make a second."""

    rate: Annotated[int, Meta(ge=1, le=60)]
    seldom: bool = False  # fewer will do while nothing is under way


class Stop(Order, frozen=True, tag="stop"):
    """End; the end of input means the same."""


ToSession = (
    Start
    | Act
    | Halt
    | AskReach
    | AskSnapshot
    | AskProgram
    | AskBlock
    | AskState
    | Sleep
    | Pace
    | Stop
)

# --- from the session -----------------------------------------------------------------------------


class News(msgspec.Struct, frozen=True, tag_field="type"):
    """A message from the session."""


class Ready(News, frozen=True, tag="ready"):
    """The session has begun."""

    session: int
    epoch_s: float  # what the clock showed at session time 0
    arm: str
    scene: Json  # what the viewer draws (`scene_data`)
    task: str  # title; empty without one
    carried_s: float | None = None  # it goes on from then; None: it begins
    anew: str = ""  # why it does not go on, where it was to
    controller: str = ""  # model that it goes by
    controller_sha256: str = ""  # of what that model says


class Failed(News, frozen=True, tag="failed"):
    """The session cannot begin, or ends for want of memory, time or a fault; it is over."""

    text: str


class Done(News, frozen=True, tag="done"):
    """What became of an action. What the monitor writes comes as `Output`."""

    ref: int
    at_s: float  # when it took effect; the time to be logged
    accepted: bool
    text: str = ""  # what the monitor answered, or why it was refused
    help: str = ""
    code: str = ""  # of the diagnostic, such as "V331"; "busy", "limit" ... without one
    counts: bool = True  # whether a replay needs it
    row: str = ""  # of what was recorded: its line of `.LOCATIONS`, as STORE writes it


class Reached(News, frozen=True, tag="reached"):
    """Whether the tool can go there, and what the way touches."""

    ref: int
    reachable: bool
    why: str = ""  # in words, when it cannot, or why the way is unknown
    code: str = ""
    branch: tuple[str, ...] = ()  # such as ("lefty", "above", "noflip")
    joints_rad: tuple[float, ...] = ()  # at the goal
    way: str = ""  # "free", "touches", "unknown"; empty: there is none
    touches: tuple[WayTouch, ...] = ()  # the first ones
    path_m: tuple[float, ...] = ()  # x y z of the tool's point on the way, evenly in time
    method: str = ""  # of the check: "certified"


class ProgramText(News, frozen=True, tag="program_text"):
    """What was done, as VAL-II text with `.LOCATIONS`."""

    ref: int
    name: str
    text: str


class Looked(News, frozen=True, tag="looked"):
    """A block of the past (`looking.block`); where it cannot be told, why."""

    ref: int
    data: str = ""  # JSON, gzipped, in base64
    whole: bool = False  # it will never be another one, unless session time jumps
    why: str = ""


class Left(News, frozen=True, tag="left"):
    """The state of a session (`looking.state`); where it cannot be told, why."""

    ref: int
    data: str = ""  # in base64
    why: str = ""


class Slept(News, frozen=True, tag="slept"):
    """The session may end; it goes on if a command comes first."""

    ref: int
    at_s: float = 0.0  # session time at which it wakes
    sha256: str = ""  # of the state in its folder; empty: it wakes from its log
    text: str = ""  # why it cannot sleep; empty: it can


class Unfit(News, frozen=True, tag="unfit"):
    """The state in its folder is none that it can wake with; it is over."""

    text: str


class Moved(News, frozen=True, tag="moved"):
    """Bodies were grasped, let go, or came to rest. Several rows of a body follow one another."""

    time_s: float
    bodies: tuple[Placed, ...]


class Happened(News, frozen=True, tag="happened"):
    """An event of the run, as the list of the replay shows it."""

    time_s: float
    kind: str
    text: str
    program: str = ""
    line: int = 0  # of the program's text; 0: none


class Output(News, frozen=True, tag="output"):
    """What the monitor's terminal shows next: typed lines, answers, what programs write."""

    time_s: float
    text: str
    prompt: str  # that stands before the next line


class Status(News, frozen=True, tag="status"):
    """The state of things, sent when it changes, at most ten times a second."""

    time_s: float
    joints_rad: tuple[float, ...]
    location: tuple[float, ...]  # X Y Z [mm] O A T [degrees], as WHERE shows it
    hand_m: float
    program: str  # that executes or has stopped; empty: none
    mode: str  # "idle", "moving", "running", "waiting", "stopped", "jogging", "braking"
    step: int  # 0: none
    line: int  # of the program's text; 0: none
    text: str  # of that line
    speed: float  # of the monitor [%]
    signals: tuple[int, ...]  # that are on
    held: str  # body in the hand
    prompt: str
    contacts: int  # certified so far
    checked_s: float  # up to this time
    mark: float | None = None  # of the public checks so far; None: no task, or not judged yet
    tool: tuple[float, ...] = ()  # pose of TOOL in the flange frame
    total: float = 10.0  # the mark is out of so many points


class Programs(News, frozen=True, tag="programs"):
    """The programs in memory have changed; all of them."""

    programs: tuple[ProgramEntry, ...]


class Checked(News, frozen=True, tag="checked"):
    """What was found since the message before, or another mark; rows as in the replay's data."""

    checked_s: float  # certified up to here
    contacts: tuple[Json, ...]
    near: tuple[Json, ...]
    undetermined: bool = False
    mark: float | None = None  # as in `Status`


class Marked(News, frozen=True, tag="marked"):
    """The public mark of now with every lost point: sent when something about it has changed."""

    time_s: float  # up to this time
    mark: float
    total: float
    lost: tuple[Lost, ...]
    parts: tuple[Part, ...]


class Began(News, frozen=True, tag="began"):
    """Session time has jumped: scene reset, or session rewound. A `Snapshot` follows."""

    time_s: float
    epoch_s: float  # from now on


class Snapshot(News, frozen=True, tag="snapshot"):
    """Everything now."""

    ref: int  # 0: after `Began`
    status: Status
    bodies: tuple[Placed, ...]  # one row for each movable body
    programs: tuple[ProgramEntry, ...]
    contacts: tuple[Json, ...]
    near: tuple[Json, ...]
    events: tuple[Happened, ...]  # the last ones
    output: str  # the end of what the terminal shows
    task: Json | None = None  # what the page shows of it (`task_view`)
    marked: Marked | None = None  # None: no task, or not judged yet
    places: tuple[HandPlace, ...] = ()


FromSession = (
    Ready
    | Failed
    | Done
    | Reached
    | ProgramText
    | Looked
    | Left
    | Slept
    | Unfit
    | Moved
    | Happened
    | Output
    | Status
    | Programs
    | Checked
    | Marked
    | Began
    | Snapshot
)
