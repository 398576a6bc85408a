"""Runs the transcripts of this folder: `monitor-*.md`.

A ```monitor block is a dialogue with a controller whose robot stands alone: prompts, what is typed
behind them, and what the terminal shows. Nothing marks what is typed: at each prompt the rest of
the line is. A line `;@ 2.5` lets time pass to 2.5 s; without one it passes until the program has
stopped. The ```val2 blocks of a section are files: `cell.v2`, or as the fence names them.
"""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.engine.controller import Controller
from vrts.ir.module import Module
from vrts.lang.dialect import DIALECTS
from vrts.monitor.desk import Desk
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.folder import WorkingFolder
from vrts.monitor.monitor import Monitor
from vrts.monitor.opening import LIMITS
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

FOLDER = Path(__file__).parent
HEADING = re.compile(r"^## .*$", re.M)
BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)
AT = re.compile(r";@ (\d+(?:\.\d+)?)\n")
LONGEST = 3600.0  # [s]


class Case(NamedTuple):
    """One transcript, and the files it finds."""

    name: str
    files: dict[str, str]
    transcript: str
    dialect: str


def cases() -> list[Case]:
    found: list[Case] = []
    for page in sorted(FOLDER.glob("monitor-*.md")):
        text = page.read_text(encoding="utf-8")
        starts = [match.start() for match in HEADING.finditer(text)]
        for start, end in zip(starts, [*starts[1:], len(text)], strict=True):
            files: dict[str, str] = {}
            for block in BLOCK.finditer(text, start, end):
                kind, name, body = block.groups()
                line = text[: block.start()].count("\n") + 1
                if kind == "val2":
                    files[name or "cell.v2"] = body
                else:
                    assert kind == "monitor", kind
                    case = Case(f"{page.stem}:{line}", dict(files), body, name or "val2")
                    found.append(case)
    return found


class Follower:
    """Types what a transcript types, and compares what it shows."""

    def __init__(self, dialogue: Dialogue, transcript: str) -> None:
        self.dialogue = dialogue
        self.rest = transcript
        self.shown = ""

    def follow(self) -> None:
        timed = False
        while self.rest:
            at = AT.match(self.rest)
            if at is not None:
                timed = True
                self.rest = self.rest[at.end() :]
                self._expect(self.dialogue.advance(float(at[1])))
                continue
            if not timed and self.dialogue.monitor.at_commands:
                self._expect(self.dialogue.settle(LONGEST))
                if not self.rest:
                    return
            timed = False
            self._expect(self.dialogue.prompt)
            line, _, self.rest = self.rest.partition("\n")
            self.shown += f"{line}\n"
            self._expect(self.dialogue.enter(line))

    def _expect(self, text: str) -> None:
        self.shown += text
        if not self.rest.startswith(text):
            pytest.fail(f"the terminal shows\n{self.shown}\n--- and not\n{self.rest}")
        self.rest = self.rest[len(text) :]


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_the_terminal_shows_what_the_page_says(case: Case, tmp_path: Path) -> None:
    for name, text in case.files.items():
        (tmp_path / name).write_text(text, "utf-8")
    controller = Controller(Module({}, ()), robot_alone(), Scenario(limits=LIMITS))
    desk = Desk(WorkingFolder(tmp_path), DIALECTS[case.dialect])
    Follower(Dialogue(controller, Monitor(desk)), case.transcript).follow()
