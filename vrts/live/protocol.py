"""Messages between browser and server: JSON text frames on `/ws`, told apart by `type`.

The first message of a connection is `Join`; the answer is `Welcome`, then `Snapshot`. Poses come as
binary frames (`vrts.live.session.views.frame`), latest value wins. Messages with a `number` are
reliable: a client that comes back says the last number it saw, and gets what it missed. Those
without are states, sent whole whenever they change and after every join.

What people do passes `Command` with the lease of the control right and a number that grows by any
amount from command to command; `Panic` needs neither. Who may do what is decided at the server:
viewer, operator (who holds the control right), supervisor.
"""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from vrts.live.actions import Action, Number, Strict

VERSION = 1
LONGEST_MESSAGE = 256 * 1024  # bytes; of a text frame from a client
LONGEST_CHAT = 1000  # characters

Id = Annotated[str, Meta(max_length=64)]
Text = Annotated[str, Meta(max_length=LONGEST_CHAT)]
Count = Annotated[int, Meta(ge=0, le=2**53)]
Rate = Annotated[int, Meta(ge=1, le=60)]
Of = Annotated[int, Meta(ge=0, le=2**31)]  # the sender's own number, named in the answer
Role = Literal["viewer", "operator", "supervisor"]

# --- from the browser -----------------------------------------------------------------------------


class Join(Strict, frozen=True, tag="join"):
    """Enter a room; the account is known by the cookie."""

    room: Id = ""  # empty: the account's own room, else the first one
    rate: Rate = 50  # pose frames a second
    resume: Annotated[str, Meta(max_length=128)] = ""  # `Welcome.resume` of the dropped connection
    seen: Count = 0  # last `number` that was seen
    version: int = VERSION


class SetRate(Strict, frozen=True, tag="rate"):
    """Choose the pose frames a second."""

    rate: Rate


class Command(Strict, frozen=True, tag="command"):
    """An action of the operator, answered by `Result` or `Refused`."""

    lease: Id  # `Control.lease`
    number: Of  # greater than the one before on this lease
    action: Action


class Panic(Strict, frozen=True, tag="panic"):
    """Stop the arm now. Operator and supervisor; needs no lease, is never held back."""


class RequestControl(Strict, frozen=True, tag="request_control"):
    """Ask for the control right: at once if it is free, else stand in the queue."""


class HandBack(Strict, frozen=True, tag="hand_back"):
    """Give the control right back, or leave the queue."""


class RaiseHand(Strict, frozen=True, tag="raise_hand"):
    """Raise or lower one's hand."""

    up: bool


class Say(Strict, frozen=True, tag="say"):
    """Chat, with everybody in the room or with the supervisors only."""

    text: Text
    private: bool = False
    to: Id = ""  # supervisors may answer one person privately


class AskReach(Strict, frozen=True, tag="reach"):
    """Ask whether the tool can go somewhere; answered by `Reach`."""

    of: Of
    position_m: tuple[Number, Number, Number]
    oat_rad: tuple[Number, Number, Number]
    straight: bool = False


class AskProgram(Strict, frozen=True, tag="program"):
    """Ask for what was done as a VAL-II program, without saving; answered by `Program`."""

    of: Of
    name: Annotated[str, Meta(max_length=64)]


class HandOver(Strict, frozen=True, tag="hand_over"):
    """Supervisor: give the control right to somebody, bypassing the queue."""

    person: Id = ""  # empty: take it from its holder; the queue's first is next


class Lock(Strict, frozen=True, tag="lock"):
    """Supervisor: the operator's commands are refused while locked."""

    on: bool


class Freeze(Strict, frozen=True, tag="freeze"):
    """Supervisor: stop and refuse commands, in this room or in all."""

    on: bool
    everywhere: bool = False


class Kick(Strict, frozen=True, tag="kick"):
    """Supervisor: send somebody away from the room, who cannot enter it again until `Allow`.

    An account is known by itself, a guest by the browser's cookie and the name: whoever takes
    another browser and another name comes in again with the class code.
    """

    person: Id


class Allow(Strict, frozen=True, tag="allow"):
    """Supervisor: let those enter the room again who were sent away under a name."""

    name: Annotated[str, Meta(max_length=64)]  # of `People.barred`


class Mute(Strict, frozen=True, tag="mute"):
    """Supervisor: what somebody says reaches nobody."""

    person: Id
    on: bool


class SetChat(Strict, frozen=True, tag="set_chat"):
    """Supervisor: chat on or off in this room."""

    on: bool


class SetTurn(Strict, frozen=True, tag="set_turn"):
    """Supervisor: the longest turn while others wait, and the longest idle time."""

    turn_s: Annotated[float, Meta(ge=0.0, le=86_400.0)]  # 0: no limit
    idle_s: Annotated[float, Meta(ge=0.0, le=86_400.0)]  # 0: no limit


class SetScene(Strict, frozen=True, tag="set_scene"):
    """Supervisor: begin anew in a scene of the set, the same one or another."""

    scene: Id  # id of a `SceneEntry`


class NewRoom(Strict, frozen=True, tag="room"):
    """A room to be made."""

    name: Annotated[str, Meta(min_length=1, max_length=64)]
    scene: Id  # id of a `SceneEntry`


class MakeRooms(Strict, frozen=True, tag="make_rooms"):
    """Supervisor: make a room for each entry of a list."""

    rooms: Annotated[tuple[NewRoom, ...], Meta(min_length=1, max_length=64)]


class CloseRoom(Strict, frozen=True, tag="close_room"):
    """Supervisor: end a session for good."""

    room: Id


class Broadcast(Strict, frozen=True, tag="broadcast"):
    """Supervisor: a message, a scene, or both, to all rooms."""

    text: Text = ""
    scene: Id = ""


class WatchWall(Strict, frozen=True, tag="watch_wall"):
    """Supervisor: ask for `Wall` every second, or no longer."""

    on: bool


class Project(Strict, frozen=True, tag="project"):
    """Supervisor: which room the projector shows; clients with `?projector` follow."""

    room: Id


class ExportLog(Strict, frozen=True, tag="export_log"):
    """Supervisor: where the log of a room can be fetched; answered by `LogFile`."""

    of: Of
    room: Id


FromClient = (
    Join
    | SetRate
    | Command
    | Panic
    | RequestControl
    | HandBack
    | RaiseHand
    | Say
    | AskReach
    | AskProgram
    | HandOver
    | Lock
    | Freeze
    | Kick
    | Allow
    | Mute
    | SetChat
    | SetTurn
    | SetScene
    | MakeRooms
    | CloseRoom
    | Broadcast
    | WatchWall
    | Project
    | ExportLog
)

# --- from the server ------------------------------------------------------------------------------


class Message(msgspec.Struct, frozen=True, tag_field="type"):
    """What the server sends."""


class Person(msgspec.Struct, frozen=True):
    """Somebody in a room."""

    id: str  # of this membership, not of the account
    name: str
    role: Role
    hand: bool = False  # raised
    muted: bool = False
    away: bool = False  # the connection dropped; the place is kept for a while
    rate: int = 0  # pose frames a second; told to supervisors only


class Welcome(Message, frozen=True, tag="welcome"):
    """You are in: who you are here."""

    you: str  # id of `Person`
    name: str
    supervisor: bool  # the account may supervise
    room: str
    resume: str  # to be given to `Join` after the connection dropped
    resumed: bool  # what was missed follows; no need to clear the chat
    rate: int
    version: int = VERSION


class SceneEntry(msgspec.Struct, frozen=True):
    """A scene of the set that rooms can be given, with its task if it has one."""

    id: str
    task: bool


class RoomEntry(msgspec.Struct, frozen=True):
    """A room that can be entered."""

    id: str
    name: str
    scene: str  # id of a `SceneEntry`
    task: str  # title; empty without one
    people: int


class Chat(Message, frozen=True, tag="chat"):
    """Something said."""

    number: int
    at: float  # Unix time [s]
    person: str  # id; empty: the server
    name: str
    text: str
    private: bool = False
    to: str = ""  # name of the only reader but supervisors; empty: a private line is for them


class Snapshot(Message, frozen=True, tag="snapshot"):
    """Everything about the room now."""

    room: RoomEntry
    rooms: tuple[RoomEntry, ...]
    scenes: tuple[SceneEntry, ...]  # the set; empty unless supervisor
    number: int  # last reliable number that is contained
    session: int  # number of the session in pose frames; changes with scene
    scene_url: str  # what is to be drawn, as JSON (`Ready.scene`); empty: not there yet
    state: msgspec.Raw  # the session's `Snapshot`; null: it does not run, a `State` follows
    chat: tuple[Chat, ...]  # empty when resumed


class People(Message, frozen=True, tag="people"):
    """Who is here."""

    people: tuple[Person, ...]
    barred: tuple[str, ...] = ()  # names of those who were sent away; told to supervisors only


class Control(Message, frozen=True, tag="control"):
    """The control right."""

    holder: str  # id of a person; empty: free
    lease: str  # told to the holder only, else empty
    queue: tuple[str, ...]  # ids, first is next
    locked: bool
    frozen: bool
    chat: bool  # chat is on
    turn_s: float
    idle_s: float
    ends: float = 0.0  # Unix time when the turn ends [s]; 0: open


class Happened(Message, frozen=True, tag="event"):
    """What the session tells: `Moved`, `Happened`, `Output`, `Programs`, `Checked`, `Began`."""

    number: int
    event: msgspec.Raw


class Now(Message, frozen=True, tag="now"):
    """The session's `Status`, latest value wins; at most ten times a second."""

    status: msgspec.Raw


class State(Message, frozen=True, tag="state"):
    """The state of the session process, whole, after a jump in time or a new scene."""

    session: int
    scene_url: str
    state: msgspec.Raw  # the session's `Snapshot`; null: it has ended, and another will begin


class Result(Message, frozen=True, tag="result"):
    """What became of a command: told to who gave it."""

    number: int
    of: int  # `Command.number`
    result: msgspec.Raw  # the session's `Done`


class Refused(Message, frozen=True, tag="refused"):
    """A message was not obeyed, and why."""

    of: int  # number of the command or question; 0: another message
    code: str  # such as "role", "lease", "replayed", "rate", "frozen", "locked", "muted"
    text: str
    help: str = ""


class Reach(Message, frozen=True, tag="reached"):
    """Whether the tool can go there."""

    of: int
    result: msgspec.Raw


class Program(Message, frozen=True, tag="program_text"):
    """What was done, as VAL-II text."""

    of: int
    result: msgspec.Raw


class WallRow(msgspec.Struct, frozen=True):
    """A room on the wall."""

    id: str
    name: str
    scene: str
    task: str
    operator: str  # name
    people: int
    hands: tuple[str, ...]  # names of those with raised hands
    queue: int
    time_s: float
    line: str  # of the program that runs
    contacts: int
    mark: float | None  # public mark live
    joints_rad: tuple[float, ...]  # for the still
    alive: bool  # the session process runs
    scene_url: str = ""  # what is to be drawn; empty: not there yet
    hand_m: float = 0.0  # opening
    bodies: tuple[msgspec.Raw, ...] = ()  # how each movable body lies: `session.messages.Placed`


class Wall(Message, frozen=True, tag="wall"):
    """All rooms, to supervisors who watch."""

    rooms: tuple[WallRow, ...]
    projector: str  # id of the room


class Rooms(Message, frozen=True, tag="rooms"):
    """The rooms have changed."""

    rooms: tuple[RoomEntry, ...]
    projector: str


class LogFile(Message, frozen=True, tag="log_file"):
    """Where a log can be fetched, with the cookie."""

    of: int
    url: str


class Closed(Message, frozen=True, tag="closed"):
    """The connection ends now, and why."""

    code: str  # such as "kicked", "room closed", "replaced", "room", "version"
    text: str


FromServer = (
    Welcome
    | Snapshot
    | People
    | Control
    | Chat
    | Happened
    | Now
    | State
    | Result
    | Refused
    | Reach
    | Program
    | Wall
    | Rooms
    | LogFile
    | Closed
)

# --- by HTTP: POST with a JSON body, answered with JSON -------------------------------------------


class Enter(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /enter`: a join link's token or a class code, and the name to be shown."""

    code: Annotated[str, Meta(min_length=6, max_length=128)]
    name: Annotated[str, Meta(max_length=40)] = ""  # a link may bring its own


class LogIn(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /login`: a local account."""

    user: Annotated[str, Meta(min_length=1, max_length=64)]
    password: Annotated[str, Meta(min_length=1, max_length=256)]


class MakeLink(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /link`, supervisors only: a link that lets many into one room, under their names."""

    room: Id


class Link(msgspec.Struct, frozen=True):
    """The answer to `/link`."""

    url: str
    picture: str  # QR code, SVG


class Me(msgspec.Struct, frozen=True):
    """`GET /me`, and the answer to `/enter` and `/login`; 401 when nobody is logged in.

    `POST /logout` has no body and ends the cookie.
    """

    name: str
    supervisor: bool
    rooms: tuple[RoomEntry, ...]
    alone: bool = False  # there is nobody else


class Problem(msgspec.Struct, frozen=True):
    """The body of an HTTP refusal."""

    code: str
    text: str
    help: str = ""
