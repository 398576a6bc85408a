"""Begins private rooms, within limits, and ends those that stay empty."""

from typing import Final

from vrts.live.lasting.clock import steady
from vrts.live.logs.branching import begin_branch
from vrts.live.logs.logged_sessions import LogFault
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.keeping import say
from vrts.live.rooms.member import Member
from vrts.live.rooms.opening import close, open_room
from vrts.live.rooms.room import Room
from vrts.live.rooms.sessions import Sessions
from vrts.live.rooms.telling.audience import EVERYBODY
from vrts.live.store.accounts import Account
from vrts.live.store.branches import Branch, branch_of
from vrts.live.store.database import Failed
from vrts.live.store.rooms import KeptRoom, next_number
from vrts.live.tokens import new_id

EMPTY_S: Final = 300.0  # how long a private room stays where nobody is in it
LONGEST_NAME: Final = 64  # characters
SLACK_S: Final = 1.0  # by which a moment may lie after the last frame that was heard of


async def branch(hub: Hub, sessions: Sessions, member: Member, at_s: float) -> Room:
    """Begin a room for somebody that goes on from a moment of the room they are in.

    It takes the place of the one that they had, which `end_earlier` ends.

    Raises:
        NotObeyed: There are too many, or what was done until then cannot be done again.
    """
    origin, account = hub.rooms[member.room], member.account
    reached = origin.reached
    if reached is None:
        raise NotObeyed("session", "the session is not ready yet", "wait a moment")
    if at_s > reached.time_s + SLACK_S:
        raise NotObeyed("past", "this has not happened yet")
    if account.id in hub.branching:
        raise NotObeyed("busy", "the server is making your room already")
    if hub.branching:  # much work for the disk; and none is made that is not counted below
        text = "the server is making a private room for somebody else"
        raise NotObeyed("busy", text, "try again in a moment")
    if hub.journal.problem:
        raise NotObeyed("disk", NO_DISK, DISK_HELP)
    private = [room for room in hub.rooms.values() if room.branch is not None]
    own = [room for room in private if room.is_own(account)]
    if len(private) - len(own) >= hub.settings.private_rooms:
        most = hub.settings.private_rooms
        text = f"there are {most} private rooms already" if most else "there are no private rooms"
        raise NotObeyed("limit", text, "try again later" if most else "")
    if not hub.branches.take(account.id, steady()):
        text = "you have begun many private rooms already"
        raise NotObeyed("rate", text, "wait two minutes, then try again")
    end = f" from {_clock(at_s)}, {account.name}"  # whole: a purge has to find the name
    name = (origin.kept.name[: max(LONGEST_NAME - len(end), 0)] + end).strip()
    place = max(room.kept.place for room in hub.rooms.values()) + 1
    kept = KeptRoom(new_id(), name, origin.kept.scene, place, *origin.kept[4:])
    made = Branch(kept.id, account.id, origin.id, min(at_s, reached.time_s), origin.variant)
    hub.branching.add(account.id)
    try:
        await hub.journal.settled()  # what was done and not written yet would be missed
        number = await hub.database.do(lambda connection: next_number(connection, "session"))
        await hub.database.do(lambda c: begin_branch(c, kept, made, number % 65_535 + 1))
        room = await open_room(hub, kept)
    except LogFault as problem:
        raise NotObeyed("past", str(problem)) from problem
    except Failed as problem:
        raise NotObeyed("log", "the room cannot be written: tell the supervisor") from problem
    finally:
        hub.branching.discard(account.id)
    sessions.begin(room)
    hub.rooms_changed()
    words = f"this room goes on from {_clock(at_s)} of {origin.kept.name}, for {account.name} alone"
    await say(hub, room, None, f"{words}; arm and programs were stopped there", EVERYBODY, None)
    return room


async def end_earlier(hub: Hub, account: Account, kept: Room) -> None:
    """End the private rooms that somebody has besides one."""
    for room in list(hub.rooms.values()):
        if room is not kept and room.is_own(account):
            await close(hub, room)


async def end_empty(hub: Hub, now: float | None = None) -> None:
    """Close private rooms that nobody was in for a while; `now` only goes forward [s]."""
    now = steady() if now is None else now
    for room in list(hub.rooms.values()):
        if room.branch is None:
            continue
        id_ = room.id
        room.branch = await hub.database.do(lambda c, id_=id_: branch_of(c, id_)) or room.branch
        if any(member.door is not None for member in room.members.values()):
            room.empty_since = None
        elif room.empty_since is None:
            room.empty_since = now
        elif now - room.empty_since > EMPTY_S:
            await close(hub, room)


def _clock(at_s: float) -> str:
    """Return a session time as people read it."""
    minutes, seconds = divmod(at_s, 60.0)
    return f"{int(minutes):02d}:{seconds:04.1f}"
