"""LinuxCNC started, and what came of it."""

import json
import os
import signal
import subprocess
import tempfile
from pathlib import Path
from typing import NamedTuple

from vrts.dispatch.rehearsing.installed import Installed
from vrts.dispatch.rehearsing.place import ENTER, OUTCOME, SAMPLES, laid_out
from vrts.dispatch.rehearsing.played import changes
from vrts.engine.run import Run

WHERE = "/var/tmp"  # noqa: S108 - not /tmp, over which each rehearsal lays its own
ROOMS = ("--ipc", "--net", "--pid", "--mount", "--fork", "--mount-proc", "--kill-child")
OWN_USER = ("--user", "--map-current-user", "--keep-caps")
PATIENCE_S = 240.0  # beside what the program takes: a machine may be busy
PAUSES = 4.0  # at most so many times the run's time, in LinuxCNC's time


class Outcome(NamedTuple):
    """What LinuxCNC did."""

    samples: str  # text, a line for each millisecond
    errors: tuple[str, ...]  # what LinuxCNC said; empty: it came to the end
    words: tuple[str, ...]  # other messages
    log: str  # of LinuxCNC's own processes


def rehearsed(exported: Path, run: Run, what: Installed, speed: float) -> Outcome:
    """Carry out an exported folder.

    Args:
        exported: The folder.
        run: The run with the inputs that are played.
        what: LinuxCNC.
        speed: How many times faster than the clock.
    """
    with tempfile.TemporaryDirectory(prefix="vrts-rehearsal-", dir=WHERE) as name:
        room = Path(name)
        place = laid_out(exported, room, changes(run), root=what.root)
        patience = PATIENCE_S + PAUSES * run.horizon_s / speed
        log = _started(room, place, what, speed, patience)
        samples, outcome = place / SAMPLES, place / OUTCOME
        text = samples.read_text("utf-8") if samples.exists() else ""
        if not outcome.exists():
            return Outcome(text, (_last(log),), (), log)
        told = json.loads(outcome.read_text("utf-8"))
        return Outcome(text, tuple(told["errors"]), tuple(told["words"]), log)


def _started(room: Path, place: Path, what: Installed, speed: float, patience_s: float) -> str:
    command = [
        *("unshare", *ROOMS, *(() if what.root else OWN_USER)),
        *(str(room / ENTER), str(place), f"{speed:g}", what.faketime, "1"),
    ]
    process = subprocess.Popen(  # noqa: S603 - our own command, on names of our own
        command,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
        text=True,
        errors="replace",
    )
    try:
        log, _ = process.communicate(timeout=patience_s)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        log, _ = process.communicate()
        log += f"\nLinuxCNC did not come to an end within {patience_s:.0f} s\n"
    return log


def _last(log: str) -> str:
    """Return what LinuxCNC's processes said last, of what is more than a blank."""
    rows = [row.strip() for row in log.splitlines() if row.strip()]
    return rows[-1] if rows else "LinuxCNC ended without a word"
