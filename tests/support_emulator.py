"""Emulated controllers for tests: vrts' own monitor behind a line that may have faults."""

import io
import threading
import time
from collections.abc import Callable, Generator, Iterable
from contextlib import contextmanager, suppress
from datetime import datetime
from pathlib import Path
from typing import NamedTuple

from tests.unit.monitor.dialogues import dialogue
from vrts.dispatch.bundle import Bundle
from vrts.dispatch.manifest import WITHOUT_PROOFS, Manifest, Reads, Thing
from vrts.dispatch.profile import Profile, find_profile
from vrts.dispatch.profile_parts import Patience
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.emulator import Emulator, GoodLine, Line, Machine
from vrts.dispatch.transfer.held.looking import Options
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.port import Port
from vrts.dispatch.transfer.problems import LINE_LOST, stop
from vrts.dispatch.transfer.send import Sending
from vrts.dispatch.transfer.talk import Talk
from vrts.dispatch.transfer.transcript import Transcript
from vrts.lang.dialect import DIALECTS
from vrts.monitor.listings import location_row

NOON = datetime(2026, 1, 1, 12)
IMPATIENT = Patience(echo_s=0.4, reply_s=0.6, hold_s=0.5, quiet_s=0.03)

PICK = Steps(
    "pick",
    "",
    (
        "; fetch one part",
        "SPEED 30 ALWAYS",
        "d = 5",
        "",
        "100 APPRO part, d*10  ; above it",
        "MOVES part",
        "CLOSEI",
        'TYPE "a  b;c", /I2, d',
        "IF d > 3 THEN",
        "d = d-1",
        "GOTO 100",
        "END",
        "CALL put(d, tray[2])",
    ),
)
PUT = Steps("put", "(n,at)", ("MOVE at:TRANS(0, 0, 10*n, 90, -90, 0)", "OPENI", "RETURN"))
PLACES = (
    Place("part", ("500.00", "200.00", "-100.50", "90.000", "90.000", "0.000")),
    Place("tray[2]", ("300.00", "350.25", "-60.00", "90.000", "-30.000", "12.345")),
    Place("#safe", ("0.000", "-90.000", "90.000", "0.000", "0.000", "0.000")),
)
CARGO = Cargo((PICK, PUT), PLACES, ())


def profile(name: str = "mark2-val2") -> Profile:
    """Return a profile that does not wait long."""
    return find_profile(name)._replace(patience=IMPATIENT)


class Watched(Machine):
    """A machine that keeps each line with the prompt at which RETURN was pressed."""

    def __init__(self, folder: Path, known: Profile) -> None:
        super().__init__(dialogue(folder, dialect=DIALECTS[known.dialect]))
        self.known = known
        self.lines: list[tuple[str, str]] = []

    def receive(self, character: int) -> bytes:
        if character == 0x0D:
            self.lines.append((self.dialogue.prompt, self._line.decode()))
        return super().receive(character)

    def type(self, *lines: str) -> None:
        """Type lines at the controller itself."""
        for line in lines:
            self.dialogue.enter(line)

    def programs(self) -> dict[str, tuple[str, ...]]:
        """Leave what is open, and return all steps that the controller holds, by program."""
        for _ in range(4):
            self.dialogue.interrupt()
        return {name: each.lines for name, each in self.dialogue.monitor.desk.programs.items()}

    def places(self) -> dict[str, list[float]]:
        """Return all locations that the controller holds, as it prints them."""
        values = self.dialogue.state.variables
        angles = self.known.language.angles
        return {
            name: [float(number) for number in location_row(value, angles).split()]
            for name, value in values.items()
            if isinstance(value, tuple)
        }


class Wire:
    """A line without time: silence is where nothing is under way."""

    def __init__(self, machine: Machine, line: Line | None = None) -> None:
        self._machine = machine
        self._line = GoodLine() if line is None else line
        self._pending = b""
        self.sent = b""

    def write(self, data: bytes) -> None:
        self.sent += data
        for byte in data:
            for character in self._line.heard(byte):
                for shown in self._machine.receive(character):
                    self._pending += self._line.told(shown)

    def read(self, wait_s: float) -> bytes:
        data, self._pending = self._pending, b""
        return data

    def close(self) -> None:
        self._pending = b""


class Fault(NamedTuple):
    """What becomes of the nth character in one direction."""

    direction: str  # "heard" or "told"
    at: int
    kind: str  # "dropped", "doubled", "garbled" or "unplugged"
    bits: int = 1  # flipped in a garbled one


class Faulty:
    """A line with faults."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self._faults = {(fault.direction, fault.at): fault for fault in faults}
        self._counts = {"heard": 0, "told": 0}
        self.happened = 0

    def heard(self, character: int) -> bytes:
        return self._passed("heard", character)

    def told(self, character: int) -> bytes:
        return self._passed("told", character)

    def _passed(self, direction: str, character: int) -> bytes:
        fault = self._faults.get((direction, self._counts[direction]))
        self._counts[direction] += 1
        if fault is None:
            return bytes((character,))
        self.happened += 1
        match fault.kind:
            case "dropped":
                return b""
            case "doubled":
                return bytes((character, character))
            case "garbled":
                return bytes((character ^ fault.bits,))
            case _:
                raise stop(LINE_LOST, "the line is broken")


@contextmanager
def port_talk(name: str, known: Profile, log: io.StringIO | None = None) -> Generator[Talk]:
    """Open a serial port for a conversation."""
    port = Port(name, known.serial, known.patience.hold_s)
    try:
        yield Talk(port, known, Transcript(log or io.StringIO(), datetime.now), time.sleep)
    finally:
        port.close()


def bundle_of(cargo: Cargo, known: Profile) -> Bundle:
    """Return a bundle with programs and locations that nobody has verified."""
    places = "".join(f"{place.name} {' '.join(place.values)}\n" for place in cargo.places)
    digest = "0" * 64
    manifest = Manifest(
        schema=WITHOUT_PROOFS,
        vrts="0",
        title="test",
        entry=cargo.programs[0].name,
        program=Thing("test", digest),
        scene=Thing("test", digest),
        robot=Thing("test", digest),
        task=None,
        profile=known.name,
        profile_sha256=known.digest,
        dialect=known.dialect,
        scenarios=(),
        executed=(),
        reads=Reads((), (), ()),
        clearance_asked_mm=10.0,
        margins=(),
        first_to_fail="",
        waivers=(),
        files=(),
    )
    return Bundle(
        manifest,
        {program.name: program.text for program in cargo.programs},
        f".LOCATIONS\n{places}.END\n" if places else "",
        "".join([".REALS\n", *(f"{n} {v}\n" for n, v in cargo.values), ".END\n"])
        if cargo.values
        else "",
        "",
        "<html></html>\n",
    )


def talk_over(wire: "Wire", known: Profile) -> Talk:
    """Return a conversation over a line without time."""
    return Talk(wire, known, Transcript(io.StringIO(), lambda: NOON), lambda _: None)


def sending(
    talk: Talk,
    known: Profile,
    cargo: Cargo = CARGO,
    options: Options | None = None,
    kept: Callable[[str], None] | None = None,
) -> Sending:
    """Return a transfer that is ready to run."""
    return Sending(talk, known, cargo, options or Options(), _told, kept or _kept)


def _told(done: int, total: int, doing: str) -> None:
    assert 0 <= done <= total, doing


def _kept(text: str) -> None:
    assert text


class Unplugged(Exception):  # noqa: N818 -- names the situation
    """Somebody has pulled the plug."""


@contextmanager
def at_a_port(machine: Machine, baud: float, line: Line | None = None) -> Generator[Emulator]:
    """Run an emulated controller at a pseudo-terminal."""
    emulator = Emulator(machine, baud, time.monotonic)
    ended = threading.Event()

    def serve() -> None:
        with suppress(Unplugged):
            emulator.serve(lambda: not ended.is_set(), line)

    thread = threading.Thread(target=serve)
    thread.start()
    try:
        yield emulator
    finally:
        ended.set()
        thread.join()
        emulator.close()
