"""Dispatch: 500 lines sent to an emulated controller at 9600 baud, and read back; planning."""

import io
import subprocess
import sys
import time
from collections.abc import Generator
from contextlib import contextmanager
from datetime import datetime

import pytest

from tests.bench.test_bench_compile import realistic
from tests.support_emulator import PLACES, sending
from vrts.dispatch.bundle import bundle_bytes
from vrts.dispatch.planning.plan import plan
from vrts.dispatch.planning.wish import Wish
from vrts.dispatch.profile import find_profile
from vrts.dispatch.steps import steps_of
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.emulator import BITS
from vrts.dispatch.transfer.port import Port
from vrts.dispatch.transfer.talk import Talk
from vrts.dispatch.transfer.transcript import Transcript
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task

LINES, BAUD = 500, 9600
EXAMPLES = sorted((CHECKOUT / "examples").glob("0[1-4]*"))


class Counted(Port):
    """A port that counts."""

    sent = received = 0

    def write(self, data: bytes) -> None:
        self.sent += len(data)
        super().write(data)

    def read(self, wait_s: float) -> bytes:
        data = super().read(wait_s)
        self.received += len(data)
        return data


def whole_parts(lines: int) -> str:
    """Return so many lines of a realistic program, cut where all structures are closed."""
    rows = [line for line in realistic(lines).splitlines() if not line.startswith(".")][:lines]
    end = max(at for at, row in enumerate(rows) if not row)  # a blank line between parts
    padding = ["        SPEED 50"] * (lines - end)
    return "".join(f"{row}\n" for row in rows[:end] + padding)


@contextmanager
def emulated(baud: int) -> Generator[str]:
    """Return the port of an emulated controller, a process of its own."""
    command = [sys.executable, "-m", "vrts.cli.main", "dispatch", "emulate", "--baud", str(baud)]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    ) as process:
        assert process.stdout is not None
        try:
            yield process.stdout.readline().strip()
        finally:
            process.terminate()


@pytest.mark.parametrize("baud", [BAUD, 38_400])
def test_500_lines_are_sent_and_verified(baud: int) -> None:
    known = find_profile("mark2-val2")
    program = steps_of(f".PROGRAM main\n{whole_parts(LINES)}.END\n")
    assert len(program.rows) == LINES
    cargo = Cargo((program,), PLACES, ())
    with emulated(baud) as name:
        port = Counted(name, known.serial, known.patience.hold_s)
        talk = Talk(port, known, Transcript(io.StringIO(), datetime.now), time.sleep)
        began, busy = time.monotonic(), time.process_time()
        found = sending(talk, known, cargo)
        found.run()
        took, busy = time.monotonic() - began, time.process_time() - busy
        port.close()
    assert set(found.states.values()) == {"verified"}
    least = port.received * BITS / baud
    print(
        f"\n{LINES} lines and {len(PLACES)} locations at {baud} baud: {took:.1f} s, "
        f"{busy:.1f} s of processor time; {port.sent:,} characters sent, {port.received:,} "
        f"received, which alone take {least:.1f} s: {least / took:.0%} of what the line can carry"
    )


@pytest.mark.parametrize("name", [path.name for path in EXAMPLES])
def test_the_solution_of_every_example_is_planned(name: str) -> None:
    folder = CHECKOUT / "examples" / name
    data = (folder / "solution.v2").read_bytes()
    setting, known = load_task(folder), find_profile("mark2-val2")
    began = time.process_time()
    found = plan(Wish(Request(ProgramFile(data, "solution.v2"), setting), known))
    busy = time.process_time() - began
    assert found.bundle is not None, [d.headline for d in found.refused]
    manifest = found.bundle.manifest
    runs = sum(int(m.sentence.split()[-2]) for m in manifest.margins if m.method == "sampled")
    print(
        f"\n{name}: planned in {busy:.1f} s of processor time, {runs} other worlds, and "
        f"stopped in every tick; clearance {manifest.scenarios[0].clearance_mm} mm; "
        f"bundle {len(bundle_bytes(found.bundle)):,} bytes"
    )
