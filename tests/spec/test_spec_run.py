"""Runs the execution chapters of this folder: `run-*.md`.

A ```val2 block, or one named after another dialect, is compiled and run with the robot alone. What follows it is expected: ```output is
what the program types; ```error is the code and VAL's words of the error that stops it. A program
without `.PROGRAM` is wrapped in one. The prose says why.
"""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS, Dialect
from vrts.scene.default import robot_alone

FOLDER = Path(__file__).parent
BLOCK = re.compile(r"^```([\w+]+)\n(.*?)^```$", re.M | re.S)


class Case(NamedTuple):
    """One program and what it is expected to do."""

    name: str
    dialect: Dialect
    program: str
    output: str | None
    error: str | None


def cases() -> list[Case]:
    found: list[Case] = []
    for page in sorted(FOLDER.glob("run-*.md")):
        text = page.read_text(encoding="utf-8")
        for block in BLOCK.finditer(text):
            line = text[: block.start()].count("\n") + 1
            if block[1] in DIALECTS:
                dialect = DIALECTS[block[1]]
                found.append(Case(f"{page.stem}:{line}", dialect, block[2], None, None))
            elif block[1] == "output":
                found[-1] = found[-1]._replace(output=block[2])
            else:
                assert block[1] == "error", block[1]
                found[-1] = found[-1]._replace(error=block[2].strip())
    return found


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_the_program_does_what_the_page_says(case: Case) -> None:
    text = case.program
    if ".PROGRAM" not in text:
        text = f".PROGRAM main()\n{text}.END\n"
    compiled = compile_source(SourceFile("case.v2", text), Options(case.dialect))
    assert compiled.module is not None, compiled.diagnostics
    run = execute(compiled.module, robot_alone())
    errors = [d for d in run.findings if d.is_error]
    said = "".join(f"{d.rule.code} {d.notes[-1].removeprefix('VAL-II says ')}" for d in errors)
    assert said == (case.error or "")
    if case.output is not None:
        assert run.output.replace("\r\n", "\n") == case.output
