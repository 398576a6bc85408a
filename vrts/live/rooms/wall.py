"""The wall: all rooms at a glance, with a still of each; and the still that a page begins with."""

import msgspec

from vrts.live.door import text_frame
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Wall
from vrts.live.protocol.listed import WallRow
from vrts.live.protocol.over_http import Still
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Room
from vrts.live.session.views.frame import unpacked


class Watched(msgspec.Struct, frozen=True):
    """What the wall shows of a session's `Status`."""

    time_s: float = 0.0
    joints_rad: tuple[float, ...] = ()
    hand_m: float = 0.0
    text: str = ""
    contacts: int = 0
    mark: float | None = None
    tool: tuple[float, ...] = ()


class _Placed(msgspec.Struct, frozen=True):
    """What the wall reads of a session's `Moved` or `Snapshot`: rows of `Placed`."""

    bodies: tuple[msgspec.Raw, ...] = ()


class _Body(msgspec.Struct, frozen=True):
    body: str


_placed = msgspec.json.Decoder(_Placed)
_body = msgspec.json.Decoder(_Body)
_watched = msgspec.json.Decoder(Watched)


def learn_bodies(room: Room, message: bytes, *, whole: bool) -> None:
    """Learn how bodies lie from a session's `Moved`, or all of them from its `Snapshot`."""
    if whole:
        room.placed.clear()
    for row in _placed.decode(message).bodies:  # later rows of a body replace earlier ones
        room.placed[_body.decode(row).body] = row.copy()


def still(room: Room) -> Still | None:
    """Return how a room's arm stands; None while that is not known."""
    process = room.process
    if process is None or not process.ready or not (room.frame or room.status):
        return None
    status = _watched.decode(room.status) if room.status else Watched()
    frame = unpacked(room.frame) if room.frame else None
    return Still(
        scene_url=room.scene_url,
        scene=msgspec.Raw(process.scene),
        time_s=frame.time_s if frame else status.time_s,
        joints_rad=frame.joints if frame else status.joints_rad,
        hand_m=frame.hand_m if frame else status.hand_m,
        tool=status.tool,
        bodies=tuple(room.placed.values()),
    )


def show_wall(hub: Hub) -> None:
    """Send the wall to those who watch it."""
    watching = [m for m in hub.everybody() if m.wall]
    if watching:
        rows = {id_: _row(room) for id_, room in hub.rooms.items() if room.own is None}
        whole = text_frame(encode(Wall(tuple(rows.values()), hub.projector)))
        for member in watching:
            if member.door is not None:
                led = whole if member.account.supervisor else _led(member, rows, hub.projector)
                member.door.latest("wall", led)


def _led(member: Member, rows: dict[str, WallRow], projector: str) -> bytes:
    """Return the wall of the rooms that an assistant leads."""
    led = tuple(row for id_, row in rows.items() if member.account.leads_in(id_))
    return text_frame(encode(Wall(led, projector)))


def _row(room: Room) -> WallRow:
    """Return a room as the wall shows it."""
    status = _watched.decode(room.status) if room.status else Watched()
    holder = room.members.get(room.control.holder)
    reached = room.reached
    return WallRow(
        id=room.id,
        name=room.kept.name,
        scene=room.kept.scene,
        task=room.task,
        operator=holder.account.name if holder else "",
        people=room.crowd,
        hands=tuple(m.account.name for m in room.members.values() if m.hand),
        queue=len(room.control.queue),
        time_s=status.time_s if reached is None else reached.time_s,
        line=status.text,
        contacts=status.contacts,
        mark=status.mark,
        joints_rad=status.joints_rad,
        alive=room.process is not None and room.process.ready,
        scene_url=room.scene_url,
        hand_m=status.hand_m,
        stopped=room.stopped.name if room.stopped else "",
        bodies=tuple(room.placed.values()),
    )
