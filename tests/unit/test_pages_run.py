"""The examples of run-time codes trigger them, and nothing else."""

import re
from importlib.resources import files
from typing import NamedTuple

import pytest

from tests.unit.rules import of_runs
from vrts.base.source import SourceFile
from vrts.check.verdicts.limits import check_limits
from vrts.engine.controller import execute
from vrts.engine.motion.remarks import without_forecasts
from vrts.ir.system import PARAMETERS
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.scenes import load_scene
from vrts.scene.default import robot_alone
from vrts.scene.model import Limits, Scenario, Scene
from vrts.scene.reading.scenario_file import read_scenario

PAGES = files("vrts").joinpath("pages")
EXAMPLE = re.compile(r"```(val2|vplus)\n(.*?)\n```", re.DOTALL)
SCENARIO = re.compile(r"```toml\n(.*?)\n```", re.DOTALL)
SCENE = re.compile(r"--scene ([\w-]+)`")

FEW = Scenario(limits=Limits(statements=20_000, motions=500, output_characters=20_000))
WITH_CANS = {"V310", "V311", "V312", "V313"}  # they are about what the hand meets
OF_FUTURES = {"V560", "V564"}  # no single run shows them: tests/unit/prove does
ALONG = {"V313": ["V312"]}  # what cannot but come along


class Example(NamedTuple):
    """What a page shows."""

    dialect: str
    program: str
    scenario: str | None
    scene: str | None


def examples() -> dict[str, Example]:
    found: dict[str, Example] = {}
    for page in PAGES.iterdir():
        code = page.name.removesuffix(".md")
        text = page.read_text("utf-8")
        program, scenario, scene = (p.search(text) for p in (EXAMPLE, SCENARIO, SCENE))
        if code in OF_FUTURES:
            continue
        if program and of_runs(code):
            found[code] = Example(
                program[1],
                program[2],
                scenario[1] if scenario else None,
                scene[1] if scene else None,
            )
    return found


def setting(code: str, example: Example) -> tuple[Scene, Scenario]:
    scene = robot_alone()
    if example.scene is not None or code in WITH_CANS:
        scene = load_scene(example.scene or "cans-on-bases").scene
    if example.scenario is None:
        return scene, FEW
    source = SourceFile("scenario.toml", example.scenario)
    found, problems = read_scenario(source, scene, PARAMETERS)
    assert found is not None, problems
    return scene, found.scenario


@pytest.mark.parametrize("code", sorted(examples()))
def test_example_triggers_the_code(code: str) -> None:
    example = examples()[code]
    options = Options(DIALECTS[example.dialect])
    compiled = compile_source(SourceFile("example.v2", example.program), options)
    assert compiled.module is not None, compiled.diagnostics
    run = execute(compiled.module, *setting(code, example))
    found = [*without_forecasts(run.findings), *check_limits(run).findings]
    assert [diagnostic.rule.code for diagnostic in found] == [*ALONG.get(code, []), code]
