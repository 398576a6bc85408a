"""Runs the execution chapters of this folder: `run-*.md`.

A ```val2 block, or one named after another dialect, is compiled and run with the robot alone. What
follows it is expected: ```output is what the program types; ```error is the code and VAL's words of
the error that stops it. A program without `.PROGRAM` is wrapped in one. The prose says why.
"""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.base.source import SourceFile
from vrts.engine.controller import advance, execute, start
from vrts.engine.run import Run
from vrts.ir.commands import TimedCommand
from vrts.ir.module import Module
from vrts.lang.command import parse_command
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS, Dialect
from vrts.scene.default import robot_alone

FOLDER = Path(__file__).parent
BLOCK = re.compile(r"^```([\w+]+)\n(.*?)^```$", re.M | re.S)
LONG_ENOUGH = 60.0  # [s] for what a command starts


class Case(NamedTuple):
    """One program and what it is expected to do."""

    name: str
    dialect: Dialect
    program: str
    expected: dict[str, str]


def cases() -> list[Case]:
    found: list[Case] = []
    for page in sorted(FOLDER.glob("run-*.md")):
        text = page.read_text(encoding="utf-8")
        for block in BLOCK.finditer(text):
            line = text[: block.start()].count("\n") + 1
            if block[1] in DIALECTS:
                found.append(Case(f"{page.stem}:{line}", DIALECTS[block[1]], block[2], {}))
            else:
                assert block[1] in ("command", "output", "error"), block[1]
                found[-1].expected[block[1]] = block[2]
    return found


def compiled(case: Case) -> Module:
    text = case.program
    if ".PROGRAM" not in text:
        text = f".PROGRAM main()\n{text}.END\n"
    compilation = compile_source(SourceFile("case.v2", text), Options(case.dialect))
    assert compilation.module is not None, compilation.diagnostics
    return compilation.module


def ran(case: Case) -> Run:
    module = compiled(case)
    if "command" not in case.expected:
        return execute(module, robot_alone())
    command, _ = parse_command(SourceFile("monitor", case.expected["command"].strip()))
    assert command is not None
    return advance(start(module, robot_alone()), LONG_ENOUGH, [TimedCommand(0.0, command)])


def stopped_by(run: Run) -> str:
    errors = [d for d in run.findings if d.is_error]
    return "".join(f"{d.rule.code} {d.notes[-1].removeprefix('VAL-II says ')}\n" for d in errors)


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_the_program_does_what_the_page_says(case: Case) -> None:
    run = ran(case)
    assert stopped_by(run) == case.expected.get("error", "")
    assert run.output.replace("\r\n", "\n") == case.expected.get("output", "")
