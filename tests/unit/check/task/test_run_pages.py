"""The examples on the pages of scene and task codes trigger their codes."""

import re
from importlib.resources import files

import pytest

from tests.support_programs import cans
from vrts.base.source import SourceFile
from vrts.check.task.task_file import read_task
from vrts.scene.reading.scene_file import read_scene

SCENES = (
    *("V600", "V601", "V602", "V603", "V604", "V605", "V606", "V607"),
    *(f"V{number}" for number in range(610, 620)),
)
TASKS = ("V431", "V443", "V651", "V652", "V653", "V654", "V657", "V658", "V659")


def example(code: str) -> str:
    page = files("vrts").joinpath("pages", f"{code}.md").read_text("utf-8")
    (found,) = re.findall(r"```toml\n(.*?)```", page, re.DOTALL)
    return found


@pytest.mark.parametrize("code", SCENES)
def test_a_scene_is_refused(code: str) -> None:
    _, problems = read_scene(SourceFile("scene.toml", example(code)))
    assert code in {problem.rule.code for problem in problems}


@pytest.mark.parametrize("code", TASKS)
def test_a_task_is_refused(code: str) -> None:
    _, problems = read_task(SourceFile("task.toml", example(code)), cans())
    assert {problem.rule.code for problem in problems} == {code}
