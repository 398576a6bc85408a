"""The examples on the pages of the collision codes trigger them, in the cans scene."""

import re
from importlib.resources import files

import pytest

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.in_words import verdict
from vrts.engine.controller import execute
from vrts.lang.compiler import compile_source
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene


@pytest.fixture(scope="module")
def cans() -> Scene:
    path = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    scene, problems = read_scene(SourceFile("scene.toml", path.read_text(encoding="utf-8")))
    assert scene is not None, problems
    return scene


def codes(text: str, scene: Scene) -> list[str]:
    compiled = compile_source(SourceFile("main.v2", text))
    assert compiled.module is not None, compiled.diagnostics
    run = execute(compiled.module, scene)
    return [found.rule.code for found in verdict(check_collisions(scene, run), run).findings]


@pytest.mark.parametrize("code", ["V400", "V401", "V410", "V411", "V420"])
def test_the_example_of_a_page_triggers_its_code(code: str, cans: Scene) -> None:
    page = files("vrts").joinpath("pages", f"{code}.md").read_text(encoding="utf-8")
    (example,) = re.findall(r"```val2\n(.*?)```", page, re.DOTALL)
    assert set(codes(example, cans)) == {code}


@pytest.mark.parametrize("body", ["", "  TYPE 1\n", "  DELAY 1\n", "  OPENI\n"])
def test_a_program_that_moves_nothing_is_certified(body: str, cans: Scene) -> None:
    assert codes(f".PROGRAM main\n{body}.END\n", cans) == []
