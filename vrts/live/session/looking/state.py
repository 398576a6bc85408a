"""The state of a session as bytes, with which a rehearsal of somebody begins."""

import zlib
from typing import Any, Final

import msgspec

from vrts.engine.code.executable import Executable
from vrts.engine.machine.forget import forget
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.watcher import Watcher
from vrts.engine.memory.event_order import EventOrder
from vrts.engine.storage.damage import Damaged
from vrts.engine.storage.graph import GraphReader, GraphWriter
from vrts.live.session.growing.past import given_to
from vrts.live.session.live_session import Session
from vrts.live.session.marks.checker import needed_from
from vrts.live.session.setting import scene_sha256
from vrts.monitor.programs import StoredProgram
from vrts.scene.model import Scenario, Scene

MOST: Final = 64_000_000  # bytes that a state may have when it is unpacked
LEVEL: Final = 1  # of zlib


class StateLost(Exception):  # noqa: N818 -- names the situation
    """What was sent cannot be read."""


class Text(msgspec.Struct, frozen=True):
    """A program in the memory of the session."""

    name: str
    header: str
    lines: tuple[str, ...]


class State(msgspec.Struct, frozen=True):
    """A session at a time."""

    time_s: float
    busy: bool  # a program executes, or something moves
    controller: str  # model that it goes by
    scene_sha256: str  # of its scene and task
    texts: tuple[Text, ...]
    form: Any  # of the machine


def state_bytes(session: Session) -> bytes:
    """Return what a session is now; of its past only what contacts of now depend on."""
    growing = session.growing
    time_s = growing.time_s
    machine = growing.machine.copy()
    machine.write()  # part from the session's own
    forget([machine], max(min(needed_from(growing, time_s), time_s), growing.known_from_s))
    source = machine.executable.source
    del machine.executable, machine.system.programs  # written as their source
    machine.watcher = Watcher()
    form = GraphWriter(given_to(machine.scene, machine.scenario), (EventOrder,)).write(
        (source, machine)
    )
    texts = tuple(
        Text(one.name, one.header, one.lines)
        for one in session.conversation.monitor.desk.programs.values()
    )
    controller = session.setting.scene.controller.name
    scene = scene_sha256(session.setting)
    state = State(time_s, not session.at_rest, controller, scene, texts, form)
    return zlib.compress(msgspec.msgpack.encode(state), LEVEL)


def state_of(data: bytes) -> State:
    """Return a state that was sent.

    Raises:
        StateLost: It is none.
    """
    try:
        unpacking = zlib.decompressobj()
        whole = unpacking.decompress(data, MOST)
        if unpacking.unconsumed_tail:
            raise StateLost
        return msgspec.msgpack.decode(whole, type=State)
    except (zlib.error, msgspec.DecodeError) as problem:
        raise StateLost from problem


def machine_of(state: State, scene: Scene, scenario: Scenario) -> Machine:
    """Return the machine of a state, in the scene in which it was.

    Raises:
        StateLost: It is none of this scene.
    """
    try:
        source, machine = GraphReader(given_to(scene, scenario)).read(state.form)
        machine.take_over(Executable.remade(source))
    except Damaged as problem:
        raise StateLost from problem
    return machine.copy()


def stored(state: State, machine: Machine) -> dict[str, StoredProgram]:
    """Return the programs in the memory of a session, by name."""
    known = machine.executable.module.programs
    return {
        one.name: StoredProgram(one.name, one.header, one.lines, program=known.get(one.name))
        for one in state.texts
    }
