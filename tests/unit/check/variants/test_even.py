"""`even` in `[variants]`: how much harder one variant may be than another."""

import pytest

from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.task.staff import read_whole_task
from vrts.check.variants.even import Even
from vrts.check.variants.model import Variants
from vrts.check.variants.section import read_variants
from vrts.pipeline.scenes import load_scene

SECTION = """[variants]
assignment = "x"
{}
[[variants.vary]]
name = "a"
set = "scene.objects.can1.at_mm.x"
choices = [700, 800]
"""
TASK = """[task]
scene = "cans-on-bases"
[time]
reference_s = 9
[[goal]]
object = "can1"
on = "base1"
"""


def read(even: str) -> tuple[Variants | None, list[tuple[str, str]]]:
    top, problems = read_toml(SourceFile("task.toml", SECTION.format(even)))
    assert top is not None
    found = read_variants(top, problems)
    places = [(d.rule.code, d.primary.span.text if d.primary else "") for d in problems.found]
    return found, places


def test_bounds_have_usual_values_and_others_in_the_units_of_their_names() -> None:
    usual, _ = read("")
    assert usual is not None
    assert usual.even == Even(time=0.15, clearance=0.010, accuracy=0.2)
    other, _ = read("even = { time = 0.3, clearance_mm = 25 }")
    assert other is not None
    assert other.even == Even(time=0.3, clearance=0.025, accuracy=0.2)


@pytest.mark.parametrize(
    ("even", "code", "place"),
    [
        ("even = 0.1", "V604", "0.1"),
        ("even = { time = 0 }", "V605", "0"),
        ("even = { clearance_mm = -1 }", "V605", "-1"),
        ("even = { speed = 1 }", "V602", "speed"),
    ],
)
def test_what_is_wrong_is_told_where_it_stands(even: str, code: str, place: str) -> None:
    assert read(even) == (None, [(code, place)])


def test_a_hidden_part_leaves_variants_as_they_are() -> None:
    scene = load_scene("cans-on-bases").scene
    public = SourceFile("task.toml", TASK + SECTION.format(""))
    hidden = SourceFile("staff/task.toml", "[[rule]]\nmost_steps = 99\n")
    task = read_whole_task(public, hidden, scene).task
    assert task is not None
    assert isinstance(task.variants, Variants)
    assert [vary.name for vary in task.variants.varies] == ["a"]
