"""What the server says.

Poses come as binary frames (`vrts.live.session.views.frame`), latest value wins. Messages with a
`number` are reliable: a client that comes back says the last number it saw, and gets what it
missed. Those without are states, sent whole whenever they change and after every join.
"""

import msgspec

from vrts.live.protocol.fields import VERSION, Role
from vrts.live.protocol.listed import Hand, Person, RoomEntry, SceneEntry, WallRow


class Message(msgspec.Struct, frozen=True, tag_field="type"):
    """What the server sends."""


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


class Chat(Message, frozen=True, tag="chat"):
    """Something said."""

    number: int
    at: float  # Unix time [s]
    person: str  # id; empty: the server
    name: str
    text: str
    private: bool = False
    to: str = ""  # name of the only reader but supervisors; empty: a private line is for them
    role: Role | None = None  # of the speaker then; none: the server, or it is not known any more


class Noted(Message, frozen=True, tag="noted"):
    """A note at a moment of the session."""

    number: int
    at_s: float  # session time
    name: str  # of who put it
    text: str


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
    notes: tuple[Noted, ...] = ()  # of the session, in order


class People(Message, frozen=True, tag="people"):
    """Who is here."""

    people: tuple[Person, ...]
    barred: tuple[str, ...] = ()  # names of those who were sent away; told to supervisors only
    muted: tuple[
        str, ...
    ] = ()  # names of those who are not heard, here or not; to supervisors only


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


class NoSession(Message, frozen=True, tag="no_session"):
    """Why there is no session and none begins by itself; empty: there is one, or it comes."""

    why: str = ""
    help: str = ""  # what to do; told to supervisors only
    choices: tuple[str, ...] = ()  # "again", "without_last", "begin"; told to supervisors only


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


class Branched(Message, frozen=True, tag="branched"):
    """A private room was made for who asked."""

    of: int
    room: str


class Wall(Message, frozen=True, tag="wall"):
    """All rooms, to supervisors who watch."""

    rooms: tuple[WallRow, ...]
    projector: str  # id of the room


class Rooms(Message, frozen=True, tag="rooms"):
    """The rooms have changed."""

    rooms: tuple[RoomEntry, ...]
    projector: str


class ClassCode(Message, frozen=True, tag="code"):
    """The class code that works now; told to supervisors when they join and whenever it changes."""

    code: str  # in groups; empty: there is none
    url: str  # that lets in by it


class Announced(Message, frozen=True, tag="announced"):
    """What a supervisor has announced, until it is taken down; a later one replaces it."""

    id: int  # 0: nothing is announced
    at: float = 0.0  # Unix time [s]
    name: str = ""  # who announced it
    text: str = ""
    seen: int = 0  # people here who have it on a screen; told to supervisors only, as what follows
    closed: int = 0  # people here who have closed it
    people: int = 0  # how many are here, supervisors aside


class Stopped(Message, frozen=True, tag="stopped"):
    """Somebody pressed PANIC, and the arm was stopped; over when it moves again."""

    at: float  # Unix time [s]; 0: that is over
    person: str = ""  # id
    name: str = ""
    role: Role | None = None


class Hands(Message, frozen=True, tag="hands"):
    """Hands that are up in rooms of their own: all to those who lead, else one's own."""

    hands: tuple[Hand, ...]
    more: int = 0  # hands that are not listed
    rooms: int = 0  # rooms of their own; told to those who lead, as what follows
    awake: int = 0  # of them


class Pointed(Message, frozen=True, tag="pointed"):
    """Somebody points at a thing of the scene."""

    person: str  # id
    body: str  # empty: at nothing any more


class LogFile(Message, frozen=True, tag="log_file"):
    """Where a log can be fetched, with the cookie."""

    of: int
    url: str


class Closed(Message, frozen=True, tag="closed"):
    """The connection ends now, and why."""

    code: str  # such as "kicked", "room closed", "replaced", "room", "version", "left"
    text: str


FromServer = (
    Welcome
    | Snapshot
    | People
    | Control
    | Chat
    | Noted
    | Happened
    | Now
    | State
    | NoSession
    | Result
    | Refused
    | Reach
    | Program
    | Branched
    | Wall
    | Rooms
    | ClassCode
    | Announced
    | Stopped
    | Hands
    | Pointed
    | LogFile
    | Closed
)
