"""The folder in which LinuxCNC rehearses: a copy of what was exported, and what records it."""

import json
import os
import shutil
from collections.abc import Iterable
from importlib.resources import files
from pathlib import Path

from vrts.dispatch.linuxcnc.export import ACCELERATION, INI, PROGRAM, SETUP
from vrts.dispatch.rehearsing.played import Change

SAMPLES, OUTCOME = "samples.txt", "outcome.json"
PATIENCE_S = 600  # in LinuxCNC's time: its own processes wait for one another on busy machines
DEPTH = 20_000  # samples that may wait to be written
ENTER, PLACE = "enter", "place"
NOBODY = 65534  # as whom LinuxCNC runs where root starts it
TO_PASS, TO_RUN, OWN = 0o711, 0o755, 0o700
GATE_OFF, GATE_ON = "#<_v_gate> = 0", "#<_v_gate> = 1"
PINS = (
    *(f"net c{k} joint.{k}.pos-cmd => sampler.0.pin.{k}" for k in range(6)),
    "net rehearse-motion motion.analog-out-01 => sampler.0.pin.6",
)


def laid_out(exported: Path, room: Path, inputs: Iterable[Change], *, root: bool) -> Path:
    """Copy an exported folder into a room and add what a rehearsal needs; return the copy.

    What starts LinuxCNC lies beside the copy, where only its owner writes.

    Args:
        exported: The folder.
        room: An empty folder.
        inputs: What changes when.
        root: Whether LinuxCNC is to run as nobody, whose the copy becomes.
    """
    place = room / PLACE
    shutil.copytree(exported, place, dirs_exist_ok=True)
    for name in ("home", "tmp"):
        (place / name).mkdir(exist_ok=True)
    setup = place / SETUP
    setup.write_text(setup.read_text("utf-8").replace(GATE_OFF, GATE_ON), "utf-8")
    (place / "rehearsal.ini").write_text(_ini((place / INI).read_text("utf-8")), "utf-8")
    (place / "rehearsal.hal").write_text("\n".join((*_recorder(), "")), "utf-8")
    changes = [tuple(change) for change in inputs]
    plan = {
        "program": str(place / PROGRAM),
        "acceleration": ACCELERATION,
        "inputs": changes,
        "signals": sorted({signal for _, _, signal, _ in changes}),
    }
    (place / "rehearsal.json").write_text(json.dumps(plan), "utf-8")
    for path in (room / ENTER, place / "display"):
        source = files("vrts.dispatch.rehearsing").joinpath("files", path.name)
        path.write_bytes(source.read_bytes())
        path.chmod(TO_RUN)
    if root:
        room.chmod(TO_PASS)
        for path in (place, *place.rglob("*")):
            os.chown(path, NOBODY, NOBODY, follow_symlinks=False)
    place.chmod(OWN)
    return place


def _ini(text: str) -> str:
    rows: list[str] = []
    for row in text.splitlines():
        key = row.partition("=")[0].strip()
        if key == "DISPLAY":
            rows.append("DISPLAY = ./display")
        elif key == "COMM_TIMEOUT":
            rows.append(f"COMM_TIMEOUT = {PATIENCE_S}")
        elif key == "OPEN_FILE" or key == "POSTGUI_HALFILE":
            continue
        else:
            rows.append(row)
        if key == "HALFILE":
            rows.append("HALFILE = rehearsal.hal")
    return "\n".join(rows) + "\n"


def _recorder() -> tuple[str, ...]:
    return (
        f"loadrt sampler depth={DEPTH} cfg=fffffff",
        "addf sampler.0 servo-thread",
        *PINS,
    )
