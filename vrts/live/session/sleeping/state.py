"""The whole state of a session at rest as a file, and the session again of it.

All that is past goes into the file of its history first, as what is older than ten minutes does; so
the state itself is small, however long the log is, and waking repeats nothing.
"""

import hashlib
import os
import sys
import zlib
from pathlib import Path
from typing import Any, Final

import msgspec

from vrts import __version__
from vrts.controllers.values import digest
from vrts.engine.code.executable import Executable
from vrts.engine.machine.watcher import Watcher
from vrts.engine.memory.event_order import EventOrder
from vrts.engine.storage.damage import Damaged
from vrts.engine.storage.graph import GraphReader, GraphWriter
from vrts.live.session.channel.messages import Json, Start
from vrts.live.session.growing.away import Away, Heard
from vrts.live.session.growing.folder import ASLEEP, FILE, SHOWN
from vrts.live.session.growing.past import Past, Record, given_to
from vrts.live.session.live_session import Clock, Send, Session
from vrts.live.session.operator.conversation import Talked
from vrts.live.session.setting import scene_sha256
from vrts.live.session.views.showing import Shown
from vrts.pipeline.setting import Setting

MOST: Final = 64_000_000  # bytes that a state may have when it is unpacked
LEVEL: Final = 1  # of zlib
VERSION: Final = f"{__version__} {sys.version_info.major}.{sys.version_info.minor}"


class Unfit(Exception):  # noqa: N818 -- names the situation
    """A state is none that a session can wake with; the text says why."""


class State(msgspec.Struct, frozen=True):
    """A session at rest."""

    version: str
    scene_sha256: str
    controller_sha256: str
    records: tuple[Record, ...]  # of the file of its history
    history_sha256: str  # of that file; empty: there is none
    shown: Shown
    form: Any  # of the machine, and what goes by its objects


def put_away(session: Session, drawn: Json) -> str:
    """Write the state of a session at rest into its folder; return its digest.

    The session may go on all the same: it has only forgotten what is in the file of its history.

    Args:
        session: Nothing is under way in it.
        drawn: What the viewer draws.

    Returns:
        SHA-256 of the file; empty: the session can only wake from its log.

    Raises:
        OSError: It cannot be written.
    """
    folder = Path(session.start.folder)
    shown = {"state": session.showing.snapshot(0), "scene": drawn}
    _write(folder / SHOWN, msgspec.json.encode(shown))
    talked = session.conversation.put_away()
    away = None if talked is None else session.growing.put_away()
    past = session.past
    if talked is None or away is None or past is None or not past.works:
        return ""
    machine = away.machine
    source = machine.executable.source
    del machine.executable, machine.system.programs  # written as their source
    machine.watcher = Watcher()
    given = given_to(machine.scene, machine.scenario)
    rest = (away.time_s, *away[2:7], tuple(away.heard))
    form = GraphWriter(given, (EventOrder,)).write((source, machine, rest, tuple(talked)))
    state = State(
        VERSION,
        scene_sha256(session.setting),
        digest(session.setting.scene.controller),
        past.records,
        _digest_of(folder / FILE),
        session.showing.put_away(),
        form,
    )
    data = zlib.compress(msgspec.msgpack.encode(state), LEVEL)
    _write(folder / ASLEEP, data)
    return hashlib.sha256(data).hexdigest()


def woken(start: Start, setting: Setting, send: Send, clock: Clock) -> Session:
    """Return the session whose state is in a folder, as it was.

    Raises:
        Unfit: There is no such state, or it is of something else.
    """
    folder = Path(start.folder)
    state = _state_in(folder, start.asleep_sha256)
    if state.version != VERSION:
        raise Unfit("it is of another version of vrts")
    if state.scene_sha256 != scene_sha256(setting):
        raise Unfit("its scene or task is another one now")
    if state.controller_sha256 != digest(setting.scene.controller):
        raise Unfit("its controller model is another one now")
    if state.history_sha256 != _digest_of(folder / FILE):
        raise Unfit("the file of its history is another one")
    past = Past(folder, start.history)
    past.go_on_with(state.records)
    session = Session(start, setting, send, clock, past=past)
    begun = session.growing.machine
    given = given_to(begun.scene, begun.scenario)
    past.know(given)
    try:
        source, machine, rest, talked = GraphReader(given).read(state.form)
        time_s, handed_on, done, crowd, forgotten, uncrowded, heard = rest
        machine.take_over(Executable.remade(source))
        told = (handed_on, done, crowd, forgotten, uncrowded)
        away = Away(time_s, machine.copy(), *told, Heard._make(heard))
        session.growing.take_back(away)
        session.conversation.take_back(Talked._make(talked))
    except (Damaged, TypeError, ValueError, AttributeError, LookupError) as problem:
        raise Unfit(f"it cannot be read: {problem}") from problem
    session.showing.take_back(state.shown)
    session.go_on_from_here()
    return session


def _state_in(folder: Path, sha256: str) -> State:
    try:
        data = (folder / ASLEEP).read_bytes()
    except OSError as problem:
        raise Unfit("it is not there") from problem
    if hashlib.sha256(data).hexdigest() != sha256:
        raise Unfit("it was changed")
    try:
        unpacking = zlib.decompressobj()
        whole = unpacking.decompress(data, MOST)
        if unpacking.unconsumed_tail:
            raise Unfit("it is too large")
        return msgspec.msgpack.decode(whole, type=State)
    except (zlib.error, msgspec.DecodeError) as problem:
        raise Unfit(f"it cannot be read: {problem}") from problem


def _digest_of(file: Path) -> str:
    try:
        with file.open("rb") as opened:
            return hashlib.file_digest(opened, "sha256").hexdigest()
    except FileNotFoundError:
        return ""


def _write(file: Path, data: bytes) -> None:
    """Write a file whole or not at all."""
    part = file.with_suffix(".part")
    with open(os.open(part, os.O_CREAT | os.O_TRUNC | os.O_WRONLY, 0o600), "wb") as opened:
        opened.write(data)
        opened.flush()
        os.fsync(opened.fileno())
    part.replace(file)
