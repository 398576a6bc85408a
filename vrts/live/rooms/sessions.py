"""Keeps a session going in every room."""

import asyncio
import contextlib
import logging
import time
from collections import Counter
from pathlib import Path
from typing import Final

import msgspec

from vrts.live.logs.logged_sessions import LogFault
from vrts.live.logs.unfinished import Sleeping, Unfinished, asleep, unfinished
from vrts.live.nursery.nursery import Nursery
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import (
    NoSession,
)
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.again.deaths import Deaths
from vrts.live.rooms.again.folders import BEFORE, remove_closed
from vrts.live.rooms.again.words import command_words, died_too_often, not_offered
from vrts.live.rooms.entering import settle
from vrts.live.rooms.hearing.hearing import Hearing, announce_anew
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import (
    announce,
    keep_soon,
    log_soon,
    stamped,
)
from vrts.live.rooms.member import FULL_RATE, Member
from vrts.live.rooms.process import Head, SessionProcess
from vrts.live.rooms.resting.falling import fall_asleep
from vrts.live.rooms.room import PANIC, Room
from vrts.live.session.channel.entries import Entry, write_entries
from vrts.live.session.channel.messages import Act, Halt, Start
from vrts.live.settings import SESSIONS
from vrts.live.store import log as store_log
from vrts.live.store.progress import keep_reached
from vrts.live.store.rooms import next_number
from vrts.live.store.waiting.journal import NO_ROOM, RETRY_S

STARTING: Final = 2  # sessions that begin at the same time
CANNOT_BEGIN: Final = "the server cannot begin the session"
DOUBLED: Final = 6  # how often the pause before it is tried again grows
WAKING: Final = "this robot is waking up"
UNFIT: Final = "room %s wakes from its log, not from its state: %s"
_log = logging.getLogger("vrts.live")
_NUMBERS: Final = 65_535


class Sessions:
    """Starts, restarts and reads the processes."""

    def __init__(self, hub: Hub) -> None:
        """Serve a hub."""
        self._hub = hub
        self._starting = asyncio.Semaphore(STARTING)
        self._folder = hub.settings.folder / SESSIONS
        self._going: set[str] = set()  # rooms that are kept going
        self._nursery = Nursery()
        self._unfit: set[str] = set()  # digests of states that no session can wake with
        self._hearing = Hearing(hub)

    def begin(self, room: Room) -> None:
        """Keep a session going in a room until it is closed: as its log says, or a new one."""
        room.offered = self._hub.settings.place(room.kept.scene) is not None
        if room.asleep:
            self._hub.spawn(self._learn(room))
        else:
            self._going.add(room.id)
            self._hub.spawn(self._keep_going(room))

    def stop(self) -> None:
        """Have no room wait for its supervisor any more: the server ends."""
        self._nursery.stop()
        self._hub.spawn(self._nursery.ended())
        for room in self._hub.rooms.values():
            room.wake.set()

    def begin_anew(self, room: Room) -> None:
        """End the session of a room, of which the log says that another begins."""
        self.wake(room)
        room.wake.set()
        if room.process is not None:
            room.process.stop()

    async def prepare(self) -> None:
        """Load what sessions need, so that the first that wakes need not wait for that."""
        await self._nursery.prepare()

    async def sleep(self, room: Room) -> None:
        """End the process of a room in which nothing is under way; it wakes exactly as it was.

        Raises:
            NotObeyed: It cannot sleep now: why.
        """
        if room.rest == "asleep":
            return
        await fall_asleep(self._hub, room)
        if room.woken:
            self.wake(room)

    def wake(self, room: Room) -> None:
        """Have a room that is asleep go on; one that is awake is left alone."""
        room.woken = True
        if room.asleep:
            room.rest = "waking"
            room.show(NoSession(WAKING))
            if room.id not in self._going:  # else what kept it going has not ended yet
                self.begin(room)

    async def go_on(self, room: Room, member: Member, *, without_last: bool) -> None:
        """Try again with a session that has died too often.

        Raises:
            NotObeyed: It does not wait for that.
        """
        if room.waits is None or not room.offered:
            raise NotObeyed("session", "this room does not wait for a session to go on")
        if without_last:
            before = await self._hub.database.do(lambda c: unfinished(c, room.id, room.kept.scene))
            if before is None or before.last is None:
                raise NotObeyed("session", "there is no command that could be left out")
            text = encode({"seq": before.last.order.ref}).decode()
            taken = stamped(room, "without", member.account, text, at_s=0.0, accepted=True)
            await log_soon(self._hub, taken)
        room.wake.set()

    async def _keep_going(self, room: Room) -> None:
        deaths, failed = Deaths(), 0
        while not (self._hub.stopping or room.asleep) and room.id in self._hub.rooms:
            try:
                await self._go_a_round(room, deaths)
                failed = 0
            except NO_ROOM:  # such as a full disk: nothing begins that cannot be kept
                await asyncio.sleep(RETRY_S)
            except OSError as problem:  # such as too many processes or open files
                failed += 1
                if failed == 1:
                    why = problem.strerror or str(problem)
                    await announce(self._hub, room, f"{CANNOT_BEGIN}: {why}; it is tried again")
                pause_s = RETRY_S * 2.0 ** min(failed - 1, DOUBLED)
                with contextlib.suppress(TimeoutError):
                    await asyncio.wait_for(room.wake.wait(), pause_s)
        self._going.discard(room.id)
        if room.id not in self._hub.rooms:
            await asyncio.to_thread(remove_closed, self._folder, room.id)

    async def _go_a_round(self, room: Room, deaths: Deaths) -> None:
        """Let a session go on or begin, and tell how it ended or why there is none."""
        hub, wake = self._hub, room.wake
        wake.clear()
        room.offered = hub.settings.place(room.kept.scene) is not None
        if not room.offered:
            await self._wait(room, not_offered(room.kept.scene))
            return
        sleeping = await self._asleep(room)
        if sleeping is not None:
            room.session = sleeping.session
            if room.rest != "waking":
                self._rest(room, sleeping)
                return
        if room.rest != "awake":
            room.rest = "waking"
        if sleeping is None or not sleeping.state or sleeping.state in self._unfit:
            process = await self._one(room, await self._before(room))
        else:
            process = await self._one(room, None, sleeping)
        if process.unfit and sleeping is not None:
            self._unfit.add(sleeping.state)
            _log.warning(UNFIT, room.id, process.unfit)
            room.rest = "waking"
            return
        if wake.is_set() or process.slept or hub.stopping or room.id not in hub.rooms:
            deaths.forget()
            return
        last = await self._last(room)
        too_often = deaths.died(0 if last is None else last.order.ref, process.went_on_s())
        if not too_often:
            text = f"the session ended: {process.failure}; it goes on from its log"
            await announce(hub, room, text)
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(wake.wait(), deaths.pause_s)
            return
        unheard, words = room.unheard, "" if last is None else _words(last.order)
        text = unheard or words
        await self._wait(
            room, died_too_often(process.failure, deaths.row, text, recorded=not unheard)
        )
        deaths.forget()

    async def _asleep(self, room: Room) -> Sleeping | None:
        """Return how a room fell asleep; None: it is awake."""
        await self._hub.journal.settled()
        try:
            return await self._hub.database.do(lambda c: asleep(c, room.id))
        except LogFault:  # as `_before` will say
            return None

    def _rest(self, room: Room, sleeping: Sleeping) -> None:
        """Let a room sleep until somebody wakes it."""
        room.rest, room.session = "asleep", sleeping.session
        room.resting_in = str(self._folder / Path(sleeping.folder).name)
        if room.woken:
            self.wake(room)

    async def _learn(self, room: Room) -> None:
        """Learn how a room fell asleep before the server was started."""
        sleeping = await self._asleep(room)
        if sleeping is not None and room.asleep:
            self._rest(room, sleeping)

    async def _wait(self, room: Room, waits: NoSession) -> None:
        """Wait for a room's supervisor."""
        room.show_waits(waits)
        self._hub.rooms_changed()
        settle(self._hub, room, b"null")
        await room.wake.wait()
        if not room.asleep:
            room.show_waits(None)
        self._hub.rooms_changed()

    async def _before(self, room: Room) -> Unfinished | None:
        """Return the session that a room had; where it cannot go on, say so."""
        await self._hub.journal.settled()  # what was done and not written yet would be missed
        try:
            return await self._hub.database.do(lambda c: unfinished(c, room.id, room.kept.scene))
        except LogFault as problem:
            await announce_anew(self._hub, room, str(problem))
            return None

    async def _last(self, room: Room) -> Entry | None:
        """Return the last command that is in the log of a room's session."""
        await self._hub.journal.settled()
        try:
            before = await self._hub.database.do(lambda c: unfinished(c, room.id, room.kept.scene))
        except LogFault:  # which is told before the next one begins
            return None
        return None if before is None else before.last

    async def _one(
        self, room: Room, before: Unfinished | None, sleeping: Sleeping | None = None
    ) -> SessionProcess:
        """Run a session to its end, one that goes on where there was one before.

        Args:
            room: Whose.
            before: What was done in it.
            sleeping: How it fell asleep, where it wakes from its state.
        """
        hub = self._hub
        if sleeping is None:
            number = await hub.database.do(lambda connection: next_number(connection, "session"))
            folder = self._folder / f"{room.id}-{number}"
            slept = before is not None and before.slept
            room.session = room.session if slept else number % _NUMBERS + 1
        else:
            folder = self._folder / Path(sleeping.folder).name
        room.pace = FULL_RATE
        place = hub.place(room)
        assert place is not None
        begun = False

        def on_pose(payload: bytes) -> None:
            room.pose(payload, time.monotonic())

        def on_message(head: Head, message: bytes) -> None:
            nonlocal begun
            if head.type == "ready" and not begun:
                begun = True
                self._starting.release()
            self._hearing.take(room, process, head, message)

        start = Start(
            room.session,
            str(folder),
            place.scene,
            place.task,
            place.lab,
            history=hub.settings.history_quota,
            slept=sleeping is not None,
            asleep_sha256="" if sleeping is None else sleeping.state,
        )
        logged = await hub.database.do(lambda connection: store_log.size(connection, room.id))
        counts = await hub.database.do(lambda connection: store_log.counts(connection, room.id))
        goes_on = before is not None or sleeping is not None
        room.logged, room.log_full = logged if goes_on else 0, False
        room.recorded = Counter(counts if goes_on else {})
        if before is not None:
            start = await asyncio.to_thread(_with_before, start, folder / BEFORE, before)
        process = SessionProcess(start, on_pose, on_message, self._nursery)
        await self._starting.acquire()
        try:
            room.process = process
            room.unheard = ""
            if not (room.wake.is_set() or room.asleep) and room.id in hub.rooms:
                await process.run()
        finally:
            if not begun:
                self._starting.release()
            reached = room.reached
            self._hearing.lost(room)
            if reached is not None:  # later than what the pulse has kept
                await keep_soon(hub, lambda c: keep_reached(c, (reached,)))
        return process


def _words(order: Act | Halt) -> str:
    return command_words(encode(order.action) if isinstance(order, Act) else PANIC)


def _with_before(start: Start, file: Path, before: Unfinished) -> Start:
    """Return the first message to a session that goes on, with what was done in it written."""
    file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    write_entries(file, before.session.entries)
    return msgspec.structs.replace(
        start,
        before=str(file),
        until_s=before.until_s,
        exact=before.session.exact,
        slept=before.slept,
        scene_sha256=before.session.scene_sha256,
        controller=before.session.controller,
        controller_sha256=before.session.controller_sha256,
    )
