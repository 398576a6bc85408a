"""Puts the session of a room to sleep, with everything it has done in the log and in its folder."""

import asyncio
from pathlib import Path
from typing import Final

from vrts.live.protocol.coding import encode
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.keeping import log_soon, stamped
from vrts.live.rooms.room import Held, Room
from vrts.live.store.waiting.journal import NO_ROOM

MOST_HELD: Final = 16  # commands that wait until a session is awake
NOT_READY: Final = "the session is not ready yet"
COMMAND: Final = "a command came"
FULL: Final = "too many commands wait already"


async def fall_asleep(hub: Hub, room: Room) -> None:
    """Have a room fall asleep; its process is about to end then.

    Raises:
        NotObeyed: It cannot: why.
    """
    process = room.process
    if room.rest != "awake" or process is None or not process.ready:
        raise NotObeyed("session", NOT_READY, "wait a moment")
    if any(asked.action for asked in room.asked.values()):
        raise NotObeyed("awake", COMMAND)
    if hub.journal.problem:
        raise NotObeyed("disk", NO_DISK, DISK_HELP)
    slept = await process.sleep()
    if slept.text:
        raise NotObeyed("awake", slept.text)
    if room.process is not process or not process.ready or room.rest != "awake":
        raise NotObeyed("session", NOT_READY, "wait a moment")
    if any(asked.action for asked in room.asked.values()):  # it came meanwhile
        raise NotObeyed("awake", COMMAND)
    room.rest, room.woken = "falling", False  # from here on nothing is passed to the session
    folder = Path(process.start.folder)
    text = encode({"at_s": slept.at_s, "state": slept.sha256, "folder": folder.name}).decode()
    try:
        await hub.journal.settled()
        await log_soon(hub, stamped(room, "sleep", None, text, at_s=slept.at_s, accepted=True))
    except (NO_ROOM, asyncio.CancelledError):
        room.rest = "awake"
        raise
    if room.process is process:
        process.slept = True
        room.rest, room.resting_in = "asleep", str(folder)
        process.stop()


def hold(room: Room, held: Held) -> None:
    """Keep a command until the session has woken.

    Raises:
        NotObeyed: Too many wait.
    """
    if len(room.held) >= MOST_HELD:
        raise NotObeyed("busy", FULL, "wait a moment")
    room.held.append(held)
