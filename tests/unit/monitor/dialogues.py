"""Dialogues with a controller whose robot stands alone."""

from pathlib import Path

from vrts.engine.controller import Controller
from vrts.ir.module import Module
from vrts.lang.dialect import VAL2, Dialect
from vrts.monitor.desk import Desk
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.folder import WorkingFolder
from vrts.monitor.monitor import Monitor
from vrts.monitor.opening import LIMITS
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

LONGEST = 60.0  # [s]


def dialogue(folder: Path, *, asks: bool = True, dialect: Dialect = VAL2) -> Dialogue:
    controller = Controller(Module({}, ()), robot_alone(), Scenario(limits=LIMITS))
    return Dialogue(controller, Monitor(Desk(WorkingFolder(folder), dialect, asks=asks)))


def said(dialogue: Dialogue, *lines: str) -> str:
    """Return what the terminal shows of some lines, each typed when the program has stopped."""
    shown: list[str] = []
    for line in lines:
        shown.append(dialogue.enter(line))
        if dialogue.monitor.at_commands:
            shown.append(dialogue.settle(LONGEST))
    return "".join(shown)
