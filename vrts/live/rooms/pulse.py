"""What time alone brings about in the rooms of a server."""

import asyncio
import contextlib
import logging
from collections.abc import Generator
from typing import Final, Protocol

from vrts.live.lasting.clock import steady
from vrts.live.rooms.entering import remove, send_away
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import control_changed, keep_notices, keep_soon
from vrts.live.rooms.opening import forget_purged
from vrts.live.rooms.private.branching import end_empty
from vrts.live.rooms.room import Room
from vrts.live.rooms.wall import show_wall
from vrts.live.store.accounts import existing
from vrts.live.store.links import sent_away
from vrts.live.store.progress import keep_reached
from vrts.live.store.waiting.journal import NO_ROOM

AWAY_S: Final = 300.0  # how long the place of somebody whose connection dropped is kept
PULSE: Final = 0.1  # [s]
LOGGED_S: Final = 60.0  # how long a fault in a part of it is not logged again
AWAY: Final = "the supervisor has ended the link or code that you came in by"
_log = logging.getLogger("vrts.live")


class _Parts:
    """Has the others go on where a part of a round fails; that is logged, once a while."""

    def __init__(self) -> None:
        """Begin with nothing logged."""
        self._due: dict[str, float] = {}

    @contextlib.contextmanager
    def part(self, name: str) -> Generator[None]:
        """Do a part."""
        try:
            yield
        except NO_ROOM:  # of the disk, which is told elsewhere: it is looked again in a second
            pass
        except Exception:
            now = steady()
            if now >= self._due.get(name, 0.0):
                self._due[name] = now + LOGGED_S
                _log.exception(f"a fault in vrts, in what is done again and again: {name}")


class Beats(Protocol):
    """Something else that time brings about, about once a second."""

    async def beat(self) -> None:
        """Do it."""
        ...


async def pulse(hub: Hub, *beside: Beats) -> None:
    """Do what time alone brings about: flush slots, end turns, forget who is gone.

    Args:
        hub: The rooms.
        beside: Each is called once a second, too.
    """
    wall_due, parts = 0.0, _Parts()
    while not hub.stopping:
        await asyncio.sleep(PULSE)
        now = steady()
        for room in list(hub.rooms.values()):
            with parts.part("rooms"):
                _pulse_room(hub, room, now)
        if now >= wall_due:
            wall_due = now + 1.0
            with parts.part("wall"):
                show_wall(hub)
            with parts.part("announcement"):
                _show_who_has_seen(hub)
            with parts.part("progress"):
                _keep_reached(hub)
                if hub.unkept:
                    hub.spawn(keep_notices(hub))
            with parts.part("people sent away"):
                await _send_purged_away(hub)
            with parts.part("purges"):
                await forget_purged(hub)
            with parts.part("empty rooms"):
                await end_empty(hub)
            with parts.part("ways in"):
                await hub.ways.look()
            for one in beside:
                with parts.part("what is added"):
                    await one.beat()


def _show_who_has_seen(hub: Hub) -> None:
    """Tell supervisors how many have seen what is announced, if that has changed."""
    if hub.announcement is not None and hub.announcement.changed:
        hub.announcement.changed = False
        hub.show_announcement(only=lambda member: member.account.supervisor)


def _pulse_room(hub: Hub, room: Room, now: float) -> None:
    for member in list(room.members.values()):
        if member.door is not None:
            member.door.flush()
        elif now - member.away_since > AWAY_S:
            remove(hub, room, member)
    if room.control.pass_time(now):
        control_changed(hub, room)
    room.set_pace()
    room.sent.forget_old(now)
    # a crowd is told less often: everybody is told about everybody
    if room.crowd_changed and now - room.crowd_changed > 0.004 * len(room.members):
        room.show_people(hub.muted)


async def _send_purged_away(hub: Hub) -> None:
    """End the places of accounts that were purged meanwhile, or whose way in was ended."""
    known = {member.account.id for member in hub.everybody()} | hub.muted.keys()
    known.update(*(room.barred for room in hub.rooms.values()))
    if not known:
        return
    there = await hub.database.do(lambda connection: existing(connection, known))
    away = await hub.database.do(lambda connection: sent_away(connection, there))
    for member in [m for m in hub.everybody() if m.account.id in away]:
        send_away(hub, member, "kicked", AWAY)
    for account in known - there:
        for kept in (hub.muted, *(room.barred for room in hub.rooms.values())):
            kept.pop(account, None)
        for member in [m for m in hub.everybody() if m.account.id == account]:
            for room in hub.rooms.values():
                room.forget(member.account.name)
            send_away(hub, member, "kicked", "your account was removed")


def _keep_reached(hub: Hub) -> None:
    """Keep how far sessions have come: after a restart they go on from there."""
    known = [room.reached for room in hub.rooms.values() if room.rest == "awake"]
    found = [reached for reached in known if reached is not None]
    if found:
        hub.spawn(keep_soon(hub, lambda connection: keep_reached(connection, found)))
