"""People, rooms and scenes, as messages list them."""

import msgspec

from vrts.live.protocol.fields import Role


class Person(msgspec.Struct, frozen=True):
    """Somebody in a room."""

    id: str  # of this membership, not of the account
    name: str
    role: Role
    hand: bool = False  # raised
    muted: bool = False
    away: bool = False  # the connection dropped; the place is kept for a while
    rate: int = 0  # pose frames a second; told to supervisors only


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
    offered: bool = True  # the server has its scene; else there is no session in it
    own: str = ""  # whose own room it is; empty: nobody's in particular


class Hand(msgspec.Struct, frozen=True):
    """A hand that is up in a room of somebody's own."""

    room: str  # id
    where: str  # name of the room
    name: str  # of who raised it
    since: float  # Unix time [s]
    text: str  # what it is about; may be empty
    place: int  # in the queue, from 1
    here: bool  # who raised it is there
    helping: tuple[str, ...]  # names of those who lead and are there


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
    stopped: str = ""  # who pressed PANIC; empty: nobody, or it has moved since
    bodies: tuple[msgspec.Raw, ...] = ()  # how each movable body lies: `session.rows.Placed`
