"""Runs the chapter about chains of causes: `why.md`.

A ```val2 block (or one of another dialect) is a program, run in the scene `cans-on-bases` without
looking for contacts; a ```submission block is a file of the examples, marked by its task; a
```marked block is a program, marked by the task of the first example. What follows belongs to it:

- ```asked is `at T`, `of NAME`, or both on lines of their own; without it all losses are told;
- ```scenario is what happens from outside;
- ```why is what is told. Chains that are left out there are not looked at; no others are.
"""

import re
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.base.source import SourceFile
from vrts.check.rules.hints import Hints
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.ir.system import PARAMETERS
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.report.because import because
from vrts.scene.model import Scenario, Scene
from vrts.scene.reading.scenario_file import read_scenario
from vrts.why.asking import why_at, why_of
from vrts.why.chain import MOST, Chain, line

PAGE = Path(__file__).parent / "why.md"
EXAMPLES = Path(__file__).parents[2] / "examples"
BLOCK = re.compile(r"^```([\w+]+)\n(.*?)^```$", re.M | re.S)
FIRST = "01-cans-on-bases/program.v2"
PARTS = ("asked", "scenario", "why")
MARKED = ("submission", "marked")
QUICK = 1  # of either, in the quick run


class Case(NamedTuple):
    """One program, and what is told of it."""

    name: str
    kind: str  # a dialect, or "submission"
    text: str
    expected: dict[str, str]


def cases() -> list[Case]:
    found: list[Case] = []
    text = PAGE.read_text(encoding="utf-8")
    for block in BLOCK.finditer(text):
        number = text[: block.start()].count("\n") + 1
        if block[1] in PARTS:
            found[-1].expected[block[1]] = block[2]
        else:
            found.append(Case(f"why.md:{number}", block[1], block[2], {}))
    return found


def parameters() -> list[object]:
    given: list[object] = []
    marked = dict.fromkeys(MARKED, 0)
    for case in cases():
        slow = False
        if case.kind in MARKED:
            marked[case.kind] += 1
            slow = marked[case.kind] > QUICK
        marks = [pytest.mark.thorough] if slow else []
        given.append(pytest.param(case, id=case.name, marks=marks))
    return given


@cache
def scene() -> Scene:
    return load_scene("cans-on-bases").scene


def ran(case: Case) -> Run:
    text = case.text if ".PROGRAM" in case.text else f".PROGRAM main()\n{case.text}.END\n"
    compilation = compile_source(SourceFile(case.name, text), Options(DIALECTS[case.kind]))
    assert compilation.module is not None, [d.headline for d in compilation.diagnostics]
    assert compilation.module.main is not None
    scenario = Scenario()
    if "scenario" in case.expected:
        source = SourceFile("scenario.toml", case.expected["scenario"])
        found, problems = read_scenario(source, scene(), PARAMETERS)
        assert found is not None, problems
        scenario = found.scenario
    return execute(compilation.module, scene(), scenario)


def told(case: Case) -> tuple[Chain, ...]:
    if case.kind in MARKED:
        submission = case.kind == "submission"
        path = EXAMPLES / (case.text.strip() if submission else FIRST)
        setting = setting_for(path, Where())
        assert setting is not None
        checks = Checks(causes=True)
        file = ProgramFile(path.read_bytes() if submission else case.text.encode(), path.name)
        return because(assess(Request(file, setting, checks=checks)))
    asked = dict(each.split(" ", 1) for each in case.expected["asked"].splitlines())
    run = ran(case)
    at = float(asked["at"]) if "at" in asked else None
    return (why_of(run, asked["of"], at),) if "of" in asked else (why_at(run, at or 0.0),)


def as_text(chain: Chain) -> str:
    lines = [chain.effect, *(f"  ← {line(link, Hints.EDIT)}" for link in chain.links)]
    return "\n".join(lines)


@pytest.mark.parametrize("case", parameters())
def test_a_chain_is_as_it_is_written_here(case: Case) -> None:
    wanted = case.expected["why"].strip().split("\n\n")
    chains = told(case)
    assert all(len(chain.links) <= MOST for chain in chains)
    found = {as_text(chain) for chain in chains}
    for each in wanted:
        first = each.split("\n", 1)[0]
        same = next((text for text in found if text.split("\n", 1)[0] == first), "\n".join(found))
        assert same == each
