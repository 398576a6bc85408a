"""What is shown of a room that is asleep: the last that was seen of its session."""

from pathlib import Path

import msgspec

from vrts.live.rooms.room import Room
from vrts.live.session.growing.folder import SHOWN


class LastSeen(msgspec.Struct, frozen=True):
    """As the session wrote it when it fell asleep."""

    state: msgspec.Raw  # its `Snapshot`
    scene: msgspec.Raw  # what is drawn


_nothing = LastSeen(msgspec.Raw(b"null"), msgspec.Raw(b"null"))


def drawn(room: Room) -> bytes:
    """Return what the viewer draws of a room, JSON; empty: that is not known now."""
    if room.process is not None and room.process.ready:
        return room.process.scene
    scene = bytes(last_seen(room).scene)
    return b"" if scene == b"null" else scene


def last_seen(room: Room) -> LastSeen:
    """Return it; nothing, where the room is not asleep, or its folder is gone."""
    if room.rest not in ("asleep", "waking") or not room.resting_in:
        return _nothing
    try:
        data = (Path(room.resting_in) / SHOWN).read_bytes()
        return msgspec.json.decode(data, type=LastSeen)
    except (OSError, msgspec.DecodeError):  # it is shown when the room is awake again
        return _nothing
