"""Goals and via points that nobody could meet are found before a program runs; see the pages."""

import math
import re
from dataclasses import replace
from importlib.resources import files

import pytest

from vrts.base.pose import dot
from vrts.base.source import SourceFile
from vrts.check.task.feasible import task_findings
from vrts.check.task.staff import read_whole_task
from vrts.check.task.task_file import read_task
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.settings import load_task
from vrts.scene.checks import scene_findings
from vrts.scene.handling.holds import holds
from vrts.scene.reading.scene_file import read_scene
from vrts.scene.things.forms import upright_box, upright_cylinder

CANS = load_scene("cans-on-bases").scene


def example(code: str) -> SourceFile:
    page = files("vrts").joinpath("pages", f"{code}.md").read_text("utf-8")
    found = re.search(r"```toml\n(.*?)\n```", page, re.DOTALL)
    assert found is not None
    return SourceFile("example/task.toml", found[1] + "\n")


@pytest.mark.parametrize("code", ["V667", "V668", "V669", "V670"])
def test_example_of_a_page_triggers_its_code_alone(code: str) -> None:
    task, problems = read_task(example(code), CANS)
    assert task is not None, problems
    found = task_findings(CANS, task)
    assert [d.rule.code for d in found] == [code]
    assert found[0].primary is not None


@pytest.mark.parametrize("code", ["V665", "V666"])
def test_example_of_a_scene_page_triggers_its_code_alone(code: str) -> None:
    scene, problems = read_scene(example(code))
    assert scene is not None, problems
    assert problems == ()
    assert [d.rule.code for d in scene_findings(scene)] == [code]


def test_example_of_the_page_on_hidden_parts_triggers_its_code() -> None:
    public = SourceFile("task.toml", example("V668").text.replace("at_mm = [900, 0, -100]", ""))
    public = SourceFile("task.toml", public.text.replace('"can1"', '"can1"\non = "base1"'))
    whole = read_whole_task(public, example("V664"), CANS)
    assert [d.rule.code for d in whole.diagnostics] == ["V664"]


@pytest.mark.parametrize(("height", "codes"), [(-149.9, []), (-150.3, ["V667"])])
def test_a_goal_counts_as_inside_from_two_tenths_of_a_millimetre(
    height: float, codes: list[str]
) -> None:
    text = f"""[task]
scene = "cans-on-bases"
[[goal]]
object = "can1"
at_mm = [950, -130, {height}]
[time]
reference_s = 9
"""
    task, _ = read_task(SourceFile("task.toml", text), CANS)
    assert task is not None
    assert [d.rule.code for d in task_findings(CANS, task)] == codes


def test_what_is_carried_away_is_not_in_the_way() -> None:
    """Where can1 starts is free at the end, when can1 has its goal elsewhere."""
    text = """[task]
scene = "cans-on-bases"
[[goal]]
object = "can2"
at_mm = [800, -450]
on = "table"
{}
[time]
reference_s = 9
"""
    other = '[[goal]]\nobject = "can1"\non = "base1"\n'
    for more, codes in ((other, []), ("", ["V667"])):
        task, _ = read_task(SourceFile("task.toml", text.format(more)), CANS)
        assert task is not None
        assert [d.rule.code for d in task_findings(CANS, task)] == codes


def test_nothing_speaks_against_the_tasks_that_come_with_vrts() -> None:
    for path in sorted((CHECKOUT / "examples").glob("01-*/task.toml")):
        setting = load_task(path)
        assert setting.task is not None
        assert scene_findings(setting.scene) == ()
        assert task_findings(setting.scene, setting.task) == (), path


@pytest.mark.parametrize(
    ("approach", "codes"), [("", []), ("[1, 0, 0.2]", []), ("[0, 0, -1]", ["V670"])]
)
def test_a_via_point_is_tried_in_the_direction_that_it_asks_for(
    approach: str, codes: list[str]
) -> None:
    wish = f"approach = {approach}\ncone_deg = 2\n" if approach else ""
    text = f"""[task]
scene = "cans-on-bases"
[[goal]]
object = "can1"
on = "base1"
[[via]]
at_mm = [1500, 0, 0]
{wish}
[time]
reference_s = 9
"""
    task, _ = read_task(SourceFile("task.toml", text), CANS)
    assert task is not None
    assert [d.rule.code for d in task_findings(CANS, task)] == codes


DISH = 'object = "dish"\non = "stand"'
LONG_TABLE = (
    "at_mm = [1000, 0]\nsize_mm = [800, 1400]",
    "at_mm = [1300, 0]\nsize_mm = [1500, 1400]",
)


@pytest.mark.parametrize(
    ("scene", "change", "goal", "codes"),
    [
        # beyond reach with the hand straight down; the hand leans as the plate does
        ("dish-on-stand", "at_mm = [1650, 0]", DISH, []),
        # leaning the other way, away from the robot: nobody gets there
        ("dish-on-stand", "at_mm = [1650, 0]\nturn_deg = 180", DISH, ["V669"]),
        # a can may be held from the side
        ("cans-on-bases", "", 'object = "can1"\nat_mm = [1600, 0, -300]', []),
        ("cans-on-bases", "", 'object = "can1"\nat_mm = [1850, 0, -300]', ["V669"]),
    ],
)
def test_every_way_to_hold_an_object_is_tried(
    scene: str, change: str, goal: str, codes: list[str]
) -> None:
    text = (CHECKOUT / "scenes" / scene / "scene.toml").read_text().replace(*LONG_TABLE)
    text = text.replace("at_mm = [980, 330]", change)
    found, problems = read_scene(SourceFile("scene.toml", text))
    assert found is not None, problems
    task_text = f'[task]\nscene = "s"\n[[goal]]\n{goal}\n[time]\nreference_s = 9\n'
    task, _ = read_task(SourceFile("task.toml", task_text), found)
    assert task is not None
    assert [d.rule.code for d in task_findings(found, task)] == codes


def test_the_ways_to_hold_an_object_suit_its_kind() -> None:
    """A dish has the pads at its wall, closing toward its middle; a box only where it fits."""
    dish = load_scene("dish-on-stand").scene
    for pose in holds(dish.robot.gripper, dish.body("dish")):
        x, y, _ = pose.translation
        assert 0.097 < math.hypot(x, y) < 0.110
        assert abs(dot(pose.normal, (x, y, 0.0))) < 1e-9
    hand = CANS.robot.gripper
    can = CANS.body("can1")
    assert len(list(holds(hand, can))) == 120
    plank = replace(can, pieces=upright_box(0.06, 0.3, 0.1).pieces, kind="box")
    closing = {round(abs(pose.orientation[1]), 3) for pose in holds(hand, plank)}
    assert closing == {0.0}, "across the narrow side"
    assert list(holds(hand, replace(can, pieces=upright_cylinder(0.05, 0.1).pieces))) == []
    assert list(holds(hand, replace(can, pieces=upright_cylinder(0.03, 0.01).pieces))) == []
