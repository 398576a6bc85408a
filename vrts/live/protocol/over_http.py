"""What is asked and answered over HTTP: POST with a JSON body, answered with JSON."""

from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from vrts.live.protocol.fields import Id
from vrts.live.protocol.listed import RoomEntry


class Enter(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /enter`: a join link's token or a class code, and the name to be shown."""

    code: Annotated[str, Meta(min_length=6, max_length=128)]
    name: Annotated[str, Meta(max_length=160)] = ""  # a link may bring its own


class LogIn(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /login`: a local account, by its name, or by the e-mail address on a course's list."""

    user: Annotated[str, Meta(min_length=1, max_length=254)]
    password: Annotated[str, Meta(min_length=1, max_length=256)]


class HowIn(msgspec.Struct, frozen=True):
    """`GET /door`, to anybody: how people come in here."""

    guests: bool = True  # by the class code or a link, under a name of their own
    title: str = ""  # of the course; empty: there is none
    provider: str = ""  # what the button of a log-in elsewhere says; empty: there is none


class MakeLink(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /link`, supervisors only: a link that lets many into one room, under their names."""

    room: Id


class Link(msgspec.Struct, frozen=True):
    """The answer to `/link`."""

    url: str
    picture: str  # QR code, SVG


class ChangeWays(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """`POST /ways`, supervisors only: renew or end the class code or a link.

    Answered by `Link` where a link was renewed, else by `Ways`.
    """

    do: Literal["renew", "end"]
    id: Id = ""  # of a `WayRow`; empty with `renew`: the class code, or one where there is none
    away: bool = False  # send those away who came in by it


class WayRow(msgspec.Struct, frozen=True):
    """A way in."""

    id: str
    kind: Literal["code", "link", "supervisor"]
    room: str  # name; empty: all rooms
    made: float  # Unix time [s]; 0: not known
    ends: float  # Unix time [s]; 0: when it is renewed
    used: int  # entries so far
    inside: int  # how many of them are still known


class EntriesFrom(msgspec.Struct, frozen=True):
    """Entries from an address."""

    address: str
    hour: int
    day: int


class Ways(msgspec.Struct, frozen=True):
    """`GET /ways`, supervisors only: what lets people in, and how many came in."""

    code: str  # in groups; empty: there is none
    url: str  # with the code
    wrong: int  # guesses at class codes so far
    left: int  # before the code becomes longer
    ways: tuple[WayRow, ...]  # the class code first
    hour: int  # entries
    day: int
    most: tuple[EntriesFrom, ...]  # addresses with most of them, kept in memory for a day
    guests: int
    unused: int  # of them, who never joined a room
    idle: int  # of them, who were not seen for a week


class Me(msgspec.Struct, frozen=True):
    """`GET /me`, and the answer to `/enter` and `/login`; 401 when nobody is logged in.

    `POST /logout` has no body and ends the cookie.
    """

    name: str
    supervisor: bool
    rooms: tuple[RoomEntry, ...]
    alone: bool = False  # there is nobody else
    students_reset: bool = False  # operators may reset and rewind
    course: bool = False  # there are assignments, at `/course/work`
    robots: bool = False  # there are robots of one's own, at `/course/robots`, or time slots
    leads: bool = False  # some rooms, as an assistant, or all of them
    teaches: bool = False  # a course, whose board is at `/course/board`


class Still(msgspec.Struct, frozen=True):
    """How a room's arm stands: all that its first picture needs."""

    scene_url: str
    scene: msgspec.Raw  # what is to be drawn, as under that address
    time_s: float
    joints_rad: tuple[float, ...]
    hand_m: float  # opening
    tool: tuple[float, ...]  # pose of TOOL in the flange frame; empty: not known
    bodies: tuple[msgspec.Raw, ...]  # how each movable body lies: `session.rows.Placed`


class Carried(msgspec.Struct, frozen=True):
    """What `GET /` brings with the page, where somebody is logged in: JSON in its `#carried`."""

    now: float  # Unix time [s]
    me: Me
    still: Still | None  # of the room that is shown; None: its session does not run


class Problem(msgspec.Struct, frozen=True):
    """The body of an HTTP refusal."""

    code: str
    text: str
    help: str = ""
