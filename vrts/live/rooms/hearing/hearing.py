"""Hands on what sessions say: news to everybody, answers to who asked, and deeds to the log."""

import asyncio
import hashlib
from pathlib import Path
from typing import Final

import msgspec

from vrts import __version__
from vrts.live.logs.logged_sessions import JUMPS
from vrts.live.notices.stopping import is_panic, moves
from vrts.live.protocol.coding import encode
from vrts.live.protocol.from_server import (
    Happened,
    NoSession,
    Program,
    Reach,
    Refused,
    Result,
    State,
)
from vrts.live.rooms.again.folders import empty_earlier
from vrts.live.rooms.again.words import command_words
from vrts.live.rooms.entering import settle
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.keeping import (
    announce,
    end_stopped,
    log_soon,
    record,
    show_stopped,
    stamped,
)
from vrts.live.rooms.noting import forget_notes, remember_notes
from vrts.live.rooms.process import ENDED, Head, SessionProcess
from vrts.live.rooms.resting.last_seen import last_seen
from vrts.live.rooms.room import Asked, Room
from vrts.live.rooms.telling.audience import Audience
from vrts.live.rooms.wall import learn_bodies
from vrts.live.store.waiting.journal import NO_ROOM

NOT_LOGGED: Final = "this was done, but could not be recorded yet: tell the supervisor"

_RAW = msgspec.Raw


class Hearing:
    """Hears the sessions of a hub's rooms."""

    def __init__(self, hub: Hub) -> None:
        """Hear for the people of a hub."""
        self._hub = hub

    def take(self, room: Room, process: SessionProcess, head: Head, message: bytes) -> None:
        """Take a message that is no pose frame; `head` is what was read of it."""
        match head.type:
            case "status":
                room.show_status(message)
                if room.stopped is not None and not room.stop_lasts and moves(message):
                    end_stopped(self._hub, room)
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
                self._ready(room, process, head)
            case "failed" | "exported":
                pass  # `SessionProcess.failure` has it; nobody asked for an export
            case _:
                if head.type == "began":
                    room.blocks.forget()
                if head.type == "moved":
                    learn_bodies(room, message, whole=False)
                number = room.next_number()
                room.tell(Happened(number, _RAW(message)), number)

    def _ready(self, room: Room, process: SessionProcess, head: Head) -> None:
        """Begin to show a session: one that begins, or one that goes on where it was."""
        room.task = msgspec.json.decode(head.task, type=str) if head.task else ""
        slept = process.start.slept
        room.rest, room.resting_in, room.woken = "awake", "", False
        if head.carried_s is None:
            end_stopped(self._hub, room)
            room.logged = 0
            room.recorded.clear()
            room.notes.clear()
            room.came = {member.account.id for member in room.members.values()}
            begun: dict[str, object] = {
                "scene": room.kept.scene,
                "scene_sha256": hashlib.sha256(process.scene).hexdigest(),
                "controller": head.controller,
                "controller_sha256": head.controller_sha256,
                "vrts": __version__,
            }
            record(self._hub, room, "begin", None, begun)
        else:
            room.stop_lasts = room.stopped is not None
            carried: dict[str, object] = {"at_s": head.carried_s, "vrts": __version__}
            record(self._hub, room, "wake" if slept else "carry_on", None, carried)
            if not room.notes:
                self._hub.spawn(remember_notes(self._hub, room))
        own = Path(process.start.folder)
        self._hub.spawn(asyncio.to_thread(empty_earlier, own, room.id))
        if head.anew:
            self._hub.spawn(announce_anew(self._hub, room, head.anew))
        self._hub.rooms_changed(room)
        process.first_snapshot = process.ask_snapshot()
        if slept:
            room.show(NoSession())
        self._give_held(room, process)

    def _give_held(self, room: Room, process: SessionProcess) -> None:
        """Give the commands that came while the room was asleep, as their people gave them."""
        held, room.held = room.held, []
        for kind, member, of, action in held:
            if member.id in room.members:
                ref = process.act(f"p{member.account.id}", action)
                room.ask(ref, kind, member, of, encode(action))

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
        if head.accepted and is_panic(asked.action):
            show_stopped(self._hub, room, asked)
        elif head.accepted:
            room.stop_lasts = False
        if asked.kind in JUMPS:
            room.frame = b""
            if head.accepted:
                forget_notes(room, asked)
        if asked.kind == "keep":
            member = room.members.get(asked.person)
            if member is not None and not head.accepted:
                member.tell(Refused(asked.of, "keep", head.text))
            if not head.counts:
                return  # a replay needs those that kept the arm moving
        text = b'{"action":' + asked.action + b',"result":' + message + b"}"
        entry = stamped(
            room, asked.kind, None, text.decode(), at_s=head.at_s, accepted=head.accepted
        )._replace(account=asked.account, name=asked.name)
        written = log_soon(self._hub, entry)
        self._hub.spawn(self._acknowledge(room, asked, head, message, written))

    async def _acknowledge(
        self,
        room: Room,
        asked: Asked,
        head: Head,
        message: bytes,
        written: "asyncio.Future[None]",
    ) -> None:
        """Tell who gave a command what became of it, when that is recorded."""
        try:
            await written
        except NO_ROOM:  # such as a full disk: it was done, but cannot be acknowledged
            member = room.members.get(asked.person)
            if member is not None:
                member.tell(Refused(asked.of, "log", NOT_LOGGED))
            return
        if head.row and self._hub.settings.recorded is not None:
            self._hub.settings.recorded(head.row)
        if asked.kind == "keep":
            return
        number = room.next_number()
        result = Result(number, asked.of, _RAW(message))
        room.tell(result, number, Audience(frozenset((asked.person,))))

    def lost(self, room: Room) -> None:
        """Tell that there is no session now, and those who wait for answers that none will come."""
        asked, room.asked = room.asked, {}
        room.halting = False
        room.blocks.forget()
        process = room.process
        sleeps = process is not None and (process.slept or process.unfit != "")
        if not sleeps:
            for held in room.held:
                held.member.tell(Refused(held.of, "session", ENDED))
            room.held.clear()
            room.status = room.frame = b""
            room.placed.clear()
        for one in asked.values():
            member = room.members.get(one.person)
            if member is not None:
                member.tell(Refused(one.of, "session", ENDED))
            if one.action:
                room.unheard = command_words(one.action)
                text = encode({"action": _RAW(one.action), "result": None}).decode()
                entry = stamped(room, one.kind, None, text, at_s=0.0, accepted=False)
                log_soon(self._hub, entry._replace(account=one.account, name=one.name))
        settle(self._hub, room, bytes(last_seen(room).state))
        if not sleeps:
            room.show(State(room.session, "", _RAW(b"null")))


async def announce_anew(hub: Hub, room: Room, why: str) -> None:
    """Tell everybody in a room that its session begins again."""
    await announce(hub, room, f"the session cannot go on, and begins again: {why}")
