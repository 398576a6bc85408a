"""Which robots of their own are awake: woken when they are needed, put to sleep when they are not.

A robot sleeps only while its arm rests and no program runs. A program that runs on where nobody
does anything has its time, and is stopped then.
"""

from collections.abc import Iterable
from typing import Final

import msgspec

from vrts.live.lasting.clock import steady
from vrts.live.limits import Buckets
from vrts.live.protocol.from_server import NoSession
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import announce, control_changed
from vrts.live.rooms.own.hands import lower_gone, show_hands, shown
from vrts.live.rooms.own.limits import WOKEN, OwnLimits
from vrts.live.rooms.room import PANIC, Asked, Room
from vrts.live.rooms.sessions import Sessions
from vrts.live.store.accounts import Account

FRESH_S: Final = 60.0  # a robot that was used so lately makes room for no other one
ASLEEP: Final = NoSession(
    "this robot is asleep", "it goes on where it was as soon as you wake it", ("wake",)
)
STOPPED: Final = "a program ran on for {} minutes and nobody did anything: it was stopped"
ALL_BUSY: Final = "all {} robots that may be awake at once are in use"
OWN_BUSY: Final = "your other robots still work, and only {} of yours may be awake at once"
COMES: Final = "this one wakes by itself as soon as it can"


class _Mode(msgspec.Struct, frozen=True):
    mode: str = ""


class Sleeper:
    """Keeps as few robots awake as are needed."""

    def __init__(self, hub: Hub, sessions: Sessions, limits: OwnLimits | None = None) -> None:
        """Serve a hub."""
        self.limits = limits or OwnLimits()
        self._hub = hub
        self._sessions = sessions
        self._woken = Buckets(*WOKEN)
        self._waiting: dict[str, None] = {}  # rooms that are to wake when they can, in order
        self._falling: set[str] = set()  # rooms that are about to sleep
        self._shown: object = None  # what was told of hands last
        self._stopped: dict[str, float] = {}  # rooms whose program was stopped, and when [s]

    @property
    def awake(self) -> list[Room]:
        """The robots of their own that are awake."""
        own = (room for room in self._hub.rooms.values() if room.own is not None)
        can = (room for room in own if not room.asleep and room.waits is None)
        return [room for room in can if room.id not in self._falling]

    def entered(self, room: Room, account: Account) -> None:
        """Wake a room into which somebody has come, if it sleeps."""
        if room.own is None:
            return
        room.used = max(room.used, steady())
        try:
            self.wake(room, account)
        except NotObeyed as problem:
            room.show_waits(NoSession(problem.text, problem.help, ASLEEP.choices))

    def wake(self, room: Room, account: Account) -> None:
        """Have a robot go on now, or as soon as there is room for it.

        Raises:
            NotObeyed: Somebody asks for that too often.
        """
        if not room.asleep or room.id in self._waiting:
            return
        if not self._woken.take(account.id, steady()):
            help_ = "wait a few seconds, then wake it"
            raise NotObeyed("rate", "you wake many robots at once", help_)
        self._wake_or_wait(room)

    async def beat(self) -> None:
        """Put to sleep who needs nothing, and wake who waits; called about once a second."""
        now = steady()
        for room in self.awake:
            self._give_control(room)
            self._look_at(room, now)
        for room in self._hub.rooms.values():
            if room.own is not None and room.asleep:
                empty = room.empty_since or now
                room.empty_since = None if _present(room) else empty
        await lower_gone(self._hub, now)
        self._show_changes()
        for id_ in list(self._waiting):
            room = self._hub.rooms.get(id_)
            del self._waiting[id_]
            if room is not None and room.asleep and _present(room):
                self._wake_or_wait(room)
        for id_ in [one for one in self._stopped if one not in self._hub.rooms]:
            del self._stopped[id_]

    def _show_changes(self) -> None:
        """Tell of hands again where it has changed who helps, or how many are awake."""
        told = shown(self._hub)
        if told != self._shown:
            self._shown = told
            show_hands(self._hub)

    def _wake_or_wait(self, room: Room) -> None:
        why = self._no_place(room)
        if why:
            self._waiting[room.id] = None
            waits = NoSession(why, COMES)
            if room.waits != waits:
                room.show_waits(waits)
            return
        room.used = steady()
        room.show_waits(None)
        self._sessions.wake(room)

    def _no_place(self, room: Room) -> str:
        """Make place for one more that is awake; return why there is none."""
        awake, limits = self.awake, self.limits
        whose = None if room.own is None else room.own.whose
        theirs = [one for one in awake if one.own is not None and one.own.whose == whose]
        if len(theirs) >= limits.each_awake and not self._free(theirs):
            return OWN_BUSY.format(limits.each_awake)
        if len(self.awake) >= limits.awake and not self._free(awake):
            return ALL_BUSY.format(limits.awake)
        return ""

    def _free(self, rooms: Iterable[Room]) -> bool:
        """Put the one to sleep that was used longest ago, if one can be."""
        now = steady()
        can = [
            room
            for room in rooms
            if at_rest(room) and (not _present(room) or now - room.used > FRESH_S)
        ]
        oldest = min(can, key=lambda room: room.used, default=None)
        if oldest is not None:
            self._sleep(oldest)
        return oldest is not None

    def _sleep(self, room: Room) -> None:
        self._falling.add(room.id)
        self._hub.spawn(self._fall(room))

    async def _fall(self, room: Room) -> None:
        try:
            await self._sessions.sleep(room)
        except NotObeyed:  # somebody came, or did something: it is looked again before long
            return
        finally:
            self._falling.discard(room.id)
        if room.asleep and room.waits is None:
            room.show_waits(ASLEEP)

    def _look_at(self, room: Room, now: float) -> None:
        """Put a robot to sleep that nobody needs, or stop what runs on in it."""
        limits = self.limits
        if _present(room):
            room.empty_since = None
            unused = now - room.used - limits.idle_s
        else:
            room.empty_since = now if room.empty_since is None else room.empty_since
            unused = now - max(room.used, room.empty_since) - limits.empty_s
        if unused < 0.0:
            return
        if at_rest(room):
            self._sleep(room)
        elif unused > limits.program_s and now - self._stopped.get(room.id, 0.0) > FRESH_S:
            self._stop(room, now)

    def _stop(self, room: Room, now: float) -> None:
        """Stop what runs on; that is recorded, and said to who comes back."""
        process = room.process
        if process is None or not process.ready or room.halting:
            return
        self._stopped[room.id] = now
        room.halting = True
        room.asked[process.halt()] = Asked("panic", "", 0, None, "", PANIC)
        minutes = round((now - room.used) / 60.0)
        self._hub.spawn(announce(self._hub, room, STOPPED.format(minutes)))

    def _give_control(self, room: Room) -> None:
        """Let control be with who is alone in a room of their own."""
        if room.control.holder or room.control.locked:
            return
        here = [m for m in room.members.values() if m.door is not None and m.settled]
        owners = [m for m in here if m.account.id in room.owners]
        if owners and len({member.account.id for member in owners}) == 1:
            first = min(owners, key=lambda member: member.since)
            if room.control.request(first.id, steady()):
                control_changed(self._hub, room)


def at_rest(room: Room) -> bool:
    """Return whether a robot can sleep: its arm rests, no program runs, nothing is on its way."""
    process = room.process
    ready = process is not None and process.ready
    return ready and bool(room.status) and not room.asked and _rests(room.status)


def _rests(status: bytes) -> bool:
    """Return whether a session's `Status`, as JSON, says that nothing goes on."""
    return msgspec.json.decode(status, type=_Mode).mode in ("idle", "stopped")


def _present(room: Room) -> bool:
    return any(member.door is not None for member in room.members.values())
