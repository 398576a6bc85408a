"""Keeps a session going in every room, and hands on what the sessions say."""

import asyncio
import hashlib
import time
from pathlib import Path
from typing import Final

import msgspec

from vrts import __version__
from vrts.live.logs.logged_sessions import JUMPS, LogFault
from vrts.live.logs.unfinished import Unfinished, unfinished
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import Happened, Program, Reach, Refused, Result, State
from vrts.live.rooms.audience import EVERYBODY, Audience
from vrts.live.rooms.entering import settle
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import log, log_soon, record, say, stamped
from vrts.live.rooms.member import FULL_RATE
from vrts.live.rooms.process import Head, SessionProcess
from vrts.live.rooms.room import Asked, Room
from vrts.live.rooms.wall import learn_bodies
from vrts.live.session.channel.entries import write_entries
from vrts.live.session.channel.messages import Start
from vrts.live.session.growing.folder import empty
from vrts.live.settings import SESSIONS
from vrts.live.store import log as store_log
from vrts.live.store.database import Failed
from vrts.live.store.rooms import next_number

BEFORE: Final = "before.jsonl"  # in a session's folder: what was done before the server ended
STARTING: Final = 2  # sessions that begin at the same time
MOST_FAILURES: Final = 4  # in a row, after which a room waits for its supervisor
WELL_S: Final = 60.0  # a session that went on for so long ends the row
NOT_LOGGED: Final = "this was done, but could not be recorded: tell the supervisor"
_NUMBERS: Final = 65_535

_RAW = msgspec.Raw


class Sessions:
    """Starts, restarts and reads the processes."""

    def __init__(self, hub: Hub) -> None:
        """Serve a hub."""
        self._hub = hub
        self._starting = asyncio.Semaphore(STARTING)
        self._wake: dict[str, asyncio.Event] = {}

    def begin(self, room: Room, *, carries_on: bool = False) -> None:
        """Keep a session going in a room until it is closed, the one it had or another."""
        self._wake[room.id] = asyncio.Event()
        self._hub.spawn(self._keep_going(room, carries_on=carries_on))

    def stop(self) -> None:
        """Have no room wait for its supervisor any more: the server ends."""
        for wake in self._wake.values():
            wake.set()

    def begin_anew(self, room: Room) -> None:
        """End the session of a room, so that another begins."""
        self._wake[room.id].set()
        if room.process is not None:
            room.process.stop()

    async def _keep_going(self, room: Room, *, carries_on: bool) -> None:
        hub, wake = self._hub, self._wake[room.id]
        failures = 0
        while not hub.stopping and room.id in hub.rooms:
            wake.clear()
            began = time.monotonic()
            before = await self._before(room) if carries_on else None
            carries_on = False
            process = await self._one(room, before)
            if wake.is_set() or hub.stopping or room.id not in hub.rooms:
                failures = 0
                continue
            failures = 1 if time.monotonic() - began > WELL_S else failures + 1
            text = f"the session ended: {process.failure}"
            if failures < MOST_FAILURES:
                await say(hub, room, None, f"{text}; it begins again", EVERYBODY, None)
                await asyncio.sleep(0.5 * 2**failures)
            else:
                help_ = "the supervisor can begin it again"
                await say(hub, room, None, f"{text}; {help_}", EVERYBODY, None)
                await wake.wait()
                failures = 0
        self._wake.pop(room.id, None)

    async def _before(self, room: Room) -> Unfinished | None:
        """Return the session that a room had; where it cannot go on, say so."""
        try:
            return await self._hub.database.do(lambda c: unfinished(c, room.id, room.kept.scene))
        except LogFault as problem:
            await self._say_anew(room, str(problem))
            return None

    async def _say_anew(self, room: Room, why: str) -> None:
        text = f"the server was started again, and the session begins again: {why}"
        await say(self._hub, room, None, text, EVERYBODY, None)

    async def _one(self, room: Room, before: Unfinished | None) -> SessionProcess:
        """Run a session to its end, one that goes on where there was one before."""
        hub = self._hub
        number = await hub.database.do(lambda connection: next_number(connection, "session"))
        room.session = number % _NUMBERS + 1
        room.pace = FULL_RATE
        place = hub.settings.place(room.kept.scene) or hub.settings.places[0]
        folder = hub.settings.folder / SESSIONS / f"{room.id}-{number}"
        begun = False

        def on_pose(payload: bytes) -> None:
            room.pose(payload, time.monotonic())

        def on_message(head: Head, message: bytes) -> None:
            nonlocal begun
            if head.type == "ready" and not begun:
                begun = True
                self._starting.release()
            self._take(room, process, head, message)

        start = Start(
            room.session,
            str(folder),
            place.scene,
            place.task,
            place.lab,
            history=hub.settings.history_quota,
        )
        logged = await hub.database.do(lambda connection: store_log.size(connection, room.id))
        room.logged, room.log_full = logged if before is not None else 0, False
        if before is not None:
            start = await asyncio.to_thread(_with_before, start, folder / BEFORE, before)
        process = SessionProcess(start, on_pose, on_message)
        await self._starting.acquire()
        try:
            room.process = process
            await process.run()
        finally:
            if not begun:
                self._starting.release()
            self._lost(room)
        return process

    # --- what a session says ----------------------------------------------------------------------

    def _take(self, room: Room, process: SessionProcess, head: Head, message: bytes) -> None:
        match head.type:
            case "status":
                room.show_status(message)
            case "done":
                self._done(room, head, message)
            case "reached":
                self._answer(room, head, Reach(self._of(room, head), _RAW(message)))
            case "looked":
                room.blocks.answered(head.ref, message)
            case "program_text":
                self._answer(room, head, Program(self._of(room, head), _RAW(message)))
            case "snapshot":
                settle(self._hub, room, message)
                if head.ref in (0, process.first_snapshot):
                    learn_bodies(room, message, whole=True)
                    room.show(State(room.session, room.scene_url, _RAW(message)))
            case "ready":
                room.task = msgspec.json.decode(head.task, type=str) if head.task else ""
                scene = hashlib.sha256(process.scene).hexdigest()
                if head.carried_s is None:
                    room.logged = 0
                    what: dict[str, object] = {"scene": room.kept.scene, "scene_sha256": scene}
                    what |= {"controller": head.controller}
                    what |= {"controller_sha256": head.controller_sha256}
                    record(self._hub, room, "begin", None, {**what, "vrts": __version__})
                else:
                    what = {"at_s": head.carried_s, "vrts": __version__}
                    record(self._hub, room, "carry_on", None, what)
                    self._hub.spawn(_empty_earlier(Path(process.start.folder), room.id))
                if head.anew:
                    self._hub.spawn(self._say_anew(room, head.anew))
                self._hub.rooms_changed()
                process.first_snapshot = process.ask_snapshot()
            case "failed" | "exported":
                pass  # `SessionProcess.failure` has it; nobody asked for an export
            case _:
                if head.type == "began":
                    room.blocks.forget()
                if head.type == "moved":
                    learn_bodies(room, message, whole=False)
                number = room.next_number()
                room.tell(Happened(number, _RAW(message)), number)

    def _of(self, room: Room, head: Head) -> int:
        asked = room.asked.get(head.ref)
        return 0 if asked is None else asked.of

    def _answer(self, room: Room, head: Head, message: Reach | Program) -> None:
        """Answer a question, if who asked is still there."""
        asked = room.asked.pop(head.ref, None)
        member = None if asked is None else room.members.get(asked.person)
        if member is not None:
            member.tell(message)

    def _done(self, room: Room, head: Head, message: bytes) -> None:
        asked = room.asked.pop(head.ref, None)
        if asked is None:
            return
        if asked.kind == "panic":
            room.halting = False
        if asked.kind in JUMPS:
            room.frame = b""
        if asked.kind == "keep":
            member = room.members.get(asked.person)
            if member is not None and not head.accepted:
                member.tell(Refused(asked.of, "keep", head.text))
            if not head.counts:
                return  # a replay needs those that kept the arm moving
        self._hub.spawn(self._acknowledge(room, asked, head, message))

    async def _acknowledge(self, room: Room, asked: Asked, head: Head, message: bytes) -> None:
        """Record a command with what became of it, then tell who gave it."""
        text = b'{"action":' + asked.action + b',"result":' + message + b"}"
        entry = stamped(
            room, asked.kind, None, text.decode(), at_s=head.at_s, accepted=head.accepted
        )._replace(account=asked.account, name=asked.name)
        try:
            await log(self._hub, entry)
        except Failed:  # such as a full disk: it was done, but cannot be acknowledged
            member = room.members.get(asked.person)
            if member is not None:
                member.tell(Refused(asked.of, "log", NOT_LOGGED))
            raise
        if head.row and self._hub.settings.recorded is not None:
            self._hub.settings.recorded(head.row)
        if asked.kind == "keep":
            return
        number = room.next_number()
        result = Result(number, asked.of, _RAW(message))
        room.tell(result, number, Audience(frozenset((asked.person,))))

    def _lost(self, room: Room) -> None:
        """Tell that there is no session now, and those who wait for answers that none will come."""
        asked, room.asked = room.asked, {}
        room.halting = False
        room.status = room.frame = b""
        room.placed.clear()
        room.blocks.forget()
        for one in asked.values():
            member = room.members.get(one.person)
            if member is not None:
                refused = Refused(one.of, "session", "the session ended before it answered")
                member.tell(refused)
            if one.action:
                text = encode({"action": _RAW(one.action), "result": None}).decode()
                entry = stamped(room, one.kind, None, text, at_s=0.0, accepted=False)
                log_soon(self._hub, entry._replace(account=one.account, name=one.name))
        settle(self._hub, room, b"null")
        room.show(State(room.session, "", _RAW(b"null")))


def _with_before(start: Start, file: Path, before: Unfinished) -> Start:
    """Return the first message to a session that goes on, with what was done in it written."""
    file.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    write_entries(file, before.session.entries)
    return msgspec.structs.replace(
        start,
        before=str(file),
        until_s=before.until_s,
        scene_sha256=before.session.scene_sha256,
        controller=before.session.controller,
        controller_sha256=before.session.controller_sha256,
    )


async def _empty_earlier(own: Path, room: str) -> None:
    """Remove users' files from the earlier folders of a room; its session has made them again."""

    def work() -> None:
        for folder in own.parent.glob(f"{room}-*"):
            if folder != own:
                empty(folder)

    await asyncio.to_thread(work)
