"""What supervisors may say besides."""

from typing import Annotated

from msgspec import Meta

from vrts.live.actions import Strict
from vrts.live.protocol.fields import Id, Of, Text


class HandOver(Strict, frozen=True, tag="hand_over"):
    """Supervisor: give the control right to somebody, bypassing the queue."""

    person: Id = ""  # empty: take it from its holder; the queue's first is next


class LowerHand(Strict, frozen=True, tag="lower_hand"):
    """Supervisor: take the hand down that is up in a room of somebody's own: it is helped."""

    room: Id


class Lock(Strict, frozen=True, tag="lock"):
    """Supervisor: the operator's commands are refused while locked."""

    on: bool


class Freeze(Strict, frozen=True, tag="freeze"):
    """Supervisor: stop and refuse commands, in this room or in all."""

    on: bool
    everywhere: bool = False


class Kick(Strict, frozen=True, tag="kick"):
    """Supervisor: send somebody away from the room, who cannot enter it again until `Allow`.

    An account with a password is known by itself, a guest by the browser and the name: whoever
    takes another browser and another name comes in again with the class code.
    """

    person: Id


class Allow(Strict, frozen=True, tag="allow"):
    """Supervisor: let those enter the room again who were sent away under a name."""

    name: Annotated[str, Meta(max_length=200)]  # of `People.barred`


class Mute(Strict, frozen=True, tag="mute"):
    """Supervisor: what somebody says reaches nobody, under whatever name their browser enters."""

    person: Id
    on: bool


class Unmute(Strict, frozen=True, tag="unmute"):
    """Supervisor: let those be heard again who were muted under a name, here or not."""

    name: Annotated[str, Meta(max_length=200)]  # of `People.muted`


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


class GoOn(Strict, frozen=True, tag="go_on"):
    """Supervisor: try again with a session that has died too often (`NoSession`)."""

    without_last: bool = False  # as if the last command had not been given


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
    """Supervisor: a message, a scene, or both, to all rooms; the message is announced."""

    text: Text = ""
    scene: Id = ""


class EndAnnouncement(Strict, frozen=True, tag="end_announcement"):
    """Supervisor: take the announcement down, on every page."""


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
