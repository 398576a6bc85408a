"""What a session has forgotten, in a file of its own: states to go back to, and what was done.

While a session goes on, its process remembers ten minutes. What is older goes to `history.bin` in
the session's folder, in records:

- a state every two minutes, of which its machine goes on exactly as it did;
- the commands that the machine was given, in order, between them;
- deeds: motions, and what hand and signals did, as a saved program needs them.

Any time in it is had from the state before and the commands since. The file serves the process that
wrote it and nobody else: a session that is carried on writes it again while it repeats the log,
which holds everything, whatever becomes of this file. Before the file would exceed its quota, the
oldest states go, with all that was done before the next one.
"""

import os
import zlib
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any, Final, NamedTuple

import msgspec

from vrts.engine.code.executable import Executable
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.watcher import Watcher
from vrts.engine.memory.cells import UNDEFINED
from vrts.engine.memory.event_order import EventOrder
from vrts.engine.storage.damage import Damaged
from vrts.engine.storage.graph import GraphReader, GraphWriter
from vrts.ir.commands import TimedCommand
from vrts.live.session.growing.deeds import MOST_STEPS, Deeds
from vrts.live.session.growing.folder import FILE, OFF
from vrts.live.settings import HISTORY_QUOTA
from vrts.scene.model import Scenario, Scene

KEPT: Final = 0.75  # of the quota stays when it is reached
LOST = "nobody can go back before {:.0f} s any more: {}"
FULL = "the history of this session is full"
PURGED = "somebody who took part in it was purged"
STATE, COMMANDS, DEEDS = "state", "commands", "deeds"


class Record(NamedTuple):
    """Where a record is in the file."""

    kind: str
    time_s: float  # of a state; of the first command or deed
    at: int
    length: int
    deeds: int  # how many


class Past:
    """The file. Nothing is in it at first."""

    def __init__(self, folder: Path, quota: int = HISTORY_QUOTA) -> None:
        """Say where the file is to be; `clear` makes it.

        Args:
            folder: Of the session; it exists.
            quota: Bytes that the file may have.
        """
        self.path = folder / FILE
        self.said: list[str] = []  # what users should know
        self._quota = quota
        self._records: list[Record] = []
        self._given: dict[str, object] = {}
        self._works = True
        self._stays = False  # what is in the file is of the session that begins

    @property
    def works(self) -> bool:
        """Whether all is kept that was to be kept."""
        return self._works

    @property
    def records(self) -> tuple[Record, ...]:
        """What is in the file, for a session that goes on with it in another process."""
        return tuple(self._records)

    def go_on_with(self, records: Iterable[Record]) -> None:
        """Take over the file of a session that goes on, before it begins here."""
        self._records = list(records)
        self._stays = True

    def know(self, given: dict[str, object]) -> None:
        """Know what every state of the session shares, where none is written first."""
        self._given = given

    def begin(self) -> None:
        """Forget everything, unless what is kept is of the session that begins."""
        if not self._stays:
            self.clear()
        self._stays = False

    @property
    def known_from_s(self) -> float | None:
        """The earliest time that can be gone back to [s]; None: there is none."""
        return self._records[0].time_s if self._records else None

    @property
    def whole(self) -> bool:
        """Whether it goes back to the beginning."""
        return self.known_from_s == 0.0

    @property
    def size(self) -> int:
        """Bytes of the file."""
        return self._records[-1].at + self._records[-1].length if self._records else 0

    def clear(self) -> None:
        """Forget everything: the session begins anew. The file is made when there is need of it."""
        self._records.clear()
        self._works = True
        try:
            self.path.unlink(missing_ok=True)
        except OSError as problem:
            self._give_up(problem.strerror or "it cannot be removed")

    # --- writing ------------------------------------------------------------------------------

    def keep_state(self, time_s: float, machine: Machine) -> None:
        """Keep a machine at a time [s]; it is of no use to anybody afterwards."""
        executable = machine.executable
        del machine.executable, machine.system.programs  # written as their source
        machine.watcher = Watcher()  # where commands may come, nobody asks whether a program ends
        self._given = given_to(machine.scene, machine.scenario)
        self._add(STATE, time_s, (executable.source, machine))

    def keep_commands(self, commands: Sequence[TimedCommand]) -> None:
        """Keep commands that the machine was given after those before."""
        if commands and self._records:
            self._add(COMMANDS, commands[0].time_s, tuple(commands))

    def keep_deeds(self, deeds: Deeds) -> None:
        """Keep what was done, as far as a program has room for it."""
        count = len(deeds.motions) + len(deeds.events)
        if count and sum(record.deeds for record in self._records) <= MOST_STEPS:
            self._add(DEEDS, 0.0, tuple(deeds), count)

    def _add(self, kind: str, time_s: float, value: object, count: int = 0) -> None:
        if not self._works:
            return
        form = GraphWriter(self._given, (EventOrder,)).write(value)
        data = zlib.compress(msgspec.msgpack.encode(form), 1)
        try:
            if self.path.with_name(OFF).exists():
                self._give_up(PURGED)
                return
            full = self.size + len(data) > self._quota
            if full:
                self._drop_oldest(len(data))
            room = self.size + len(data) <= self._quota
            if room and (self._records or kind == STATE):  # without a state nothing is of use
                self._write(Record(kind, time_s, self.size, len(data), count), data)
            if full and self._records:
                self.said.append(LOST.format(self._records[0].time_s, FULL))
            elif full:
                self.said.append(f"{FULL}: you can go back only to what is in memory")
        except OSError as problem:
            self._give_up(problem.strerror or "it cannot be written")

    def _write(self, record: Record, data: bytes) -> None:
        """Add a record to the file."""
        if not self._records:
            os.close(os.open(self.path, os.O_CREAT | os.O_TRUNC | os.O_WRONLY, 0o600))
        with self.path.open("r+b") as file:
            file.seek(record.at)
            file.write(data)
        self._records.append(record)

    def _drop_oldest(self, coming: int) -> None:
        """Let the oldest states go with all that was done before the next one.

        Args:
            coming: Bytes that there has to be room for.
        """
        gone, most = 0, min(KEPT * self._quota, self._quota - coming)
        states = [k for k, record in enumerate(self._records) if record.kind == STATE]
        for number in states[1:]:
            gone = number
            if self.size - self._records[number].at <= most:
                break
        if gone == 0 or self.size - self._records[gone].at > self._quota - coming:
            gone = len(self._records)
        begin = self._records[gone].at if gone < len(self._records) else self.size
        part = self.path.with_suffix(".part")
        with self.path.open("rb") as file:
            file.seek(begin)
            left = file.read(self.size - begin)
        with open(os.open(part, os.O_CREAT | os.O_TRUNC | os.O_WRONLY, 0o600), "wb") as file:
            file.write(left)
        part.replace(self.path)
        self._records = [r._replace(at=r.at - begin) for r in self._records[gone:]]

    def _give_up(self, why: str) -> None:
        """Keep nothing any more; a session is not ended by that."""
        self._records.clear()
        with suppress(OSError):
            self.path.unlink(missing_ok=True)
        self._works = False
        self.said.append(f"the history of this session is not kept: {why}")

    # --- reading ------------------------------------------------------------------------------

    def state_before(self, time_s: float) -> "tuple[float, Machine, tuple[TimedCommand, ...]]":
        """Return the last state not after a time [s], its time, and the commands given since.

        Raises:
            ValueError: The time is not known (any more).
        """
        states = [k for k, r in enumerate(self._records) if r.kind == STATE and r.time_s <= time_s]
        if not states:
            raise ValueError(f"{time_s} s is not known")
        at = states[-1]
        record = self._records[at]
        source, machine = self._read(record)
        machine.take_over(Executable.remade(source))
        given = tuple(command for each in self._all(COMMANDS, at) for command in each)
        return record.time_s, machine.copy(), given

    def deeds(self) -> Deeds | None:
        """Return all that was kept of what was done; None: that is not all that was done."""
        try:
            kept = [Deeds(*deeds) for deeds in self._all(DEEDS, 0)]
        except ValueError:
            return None
        if not self.whole:
            return None
        return Deeds(
            tuple(motion for deeds in kept for motion in deeds.motions),
            tuple(event for deeds in kept for event in deeds.events),
        )

    def cut(self, time_s: float) -> None:
        """Forget states from a time [s] on, and what came after the first of them."""
        for number, record in enumerate(self._records):
            if record.kind == STATE and record.time_s >= time_s:
                del self._records[number:]
                return

    def _all(self, kind: str, since: int) -> Iterator[Any]:
        for record in self._records[since:]:
            if record.kind == kind:
                yield self._read(record)

    def _read(self, record: Record) -> Any:
        try:
            with self.path.open("rb") as file:
                file.seek(record.at)
                data = file.read(record.length)
            form = msgspec.msgpack.decode(zlib.decompress(data))
            return GraphReader(self._given).read(form)
        except (OSError, zlib.error, msgspec.DecodeError, Damaged) as problem:
            self._give_up("its file is missing or was changed")
            raise ValueError("the history of this session cannot be read") from problem


def given_to(scene: Scene, scenario: Scenario) -> dict[str, object]:
    """Return what every state of a session shares, by name."""
    return {
        "scene": scene,
        "scenario": scenario,
        "arm": scene.robot.arm,
        "gripper": scene.robot.gripper,
        "undefined": UNDEFINED,
    }
