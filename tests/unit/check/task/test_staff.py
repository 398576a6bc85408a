"""The hidden part of a task: what it adds, what it may not say, and where its faults are told."""

from pathlib import Path

import pytest

from vrts.base.source import SourceFile
from vrts.check.task.staff import read_whole_task
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.settings import load_task

SCENE = load_scene("cans-on-bases").scene
PUBLIC = SourceFile(
    "lab/task.toml",
    """[task]
scene = "cans-on-bases"

[[goal]]
object = "can1"
on = "base2"

[time]
reference_s = 10.6
""",
)
HIDDEN_GOAL = '[[goal]]\nobject = "can2"\non = "base1"\n'
HIDDEN_VIA = '[[via]]\nname = "over there"\nat_mm = [900, 0, 100]\n'


def staff(text: str) -> SourceFile:
    return SourceFile("lab/staff/task.toml", text)


def test_hidden_goals_and_via_points_are_added_for_marking() -> None:
    whole = read_whole_task(PUBLIC, staff(HIDDEN_GOAL + HIDDEN_VIA), SCENE)
    assert whole.diagnostics == ()
    assert whole.task is not None
    assert [goal.body for goal in whole.task.goals] == ["can1", "can2"]
    assert [via.name for via in whole.task.vias] == ["over there"]
    assert whole.hidden == {"goal": 1, "via": 1}
    assert whole.task.name == "lab"


def test_other_demands_can_be_hidden_too() -> None:
    rule = '[[rule]]\nmust_use = "MOVES"\n'
    whole = read_whole_task(PUBLIC, staff(rule), SCENE)
    assert whole.task is not None, whole.diagnostics
    (demand,) = whole.task.demands
    assert demand.span is not None
    assert (demand.word, demand.span.source.name) == ("MOVES", "lab/staff/task.toml")
    assert whole.hidden == {"rule": 1}


def test_every_goal_points_into_the_file_that_asks_for_it() -> None:
    whole = read_whole_task(PUBLIC, staff(f"# hidden\n{HIDDEN_GOAL}"), SCENE)
    assert whole.task is not None
    spans = [goal.span for goal in whole.task.goals]
    places = [(span.source.name, span.line, span.text) for span in spans if span is not None]
    assert places == [("lab/task.toml", 4, "[[goal]]"), ("lab/staff/task.toml", 2, "[[goal]]")]


@pytest.mark.parametrize(
    "text",
    ["[time]\nt_par_s = 3\n", '[task]\nscene = "x"\n', "[mark]\nvias = 1\n", "ordered = 1\n"],
)
def test_what_students_must_know_cannot_be_hidden(text: str) -> None:
    whole = read_whole_task(PUBLIC, staff(text), SCENE)
    assert whole.task is None
    assert [d.rule.code for d in whole.diagnostics] == ["V664"]


def test_a_hidden_goal_must_not_contradict_a_public_one() -> None:
    whole = read_whole_task(PUBLIC, staff('[[goal]]\nobject = "can1"\non = "base1"\n'), SCENE)
    assert whole.task is None
    (finding,) = whole.diagnostics
    assert finding.rule.code == "V653"
    assert finding.primary is not None
    span = finding.primary.span
    assert (span.source.name, span.line, span.text) == ("lab/staff/task.toml", 2, '"can1"')


def test_faults_of_the_public_part_stay_in_its_file() -> None:
    broken = SourceFile("lab/task.toml", PUBLIC.text.replace("base2", "base9"))
    whole = read_whole_task(broken, staff(HIDDEN_VIA), SCENE)
    assert whole.task is None
    assert {d.primary.span.source.name for d in whole.diagnostics if d.primary} == {"lab/task.toml"}


def test_an_empty_hidden_part_changes_nothing_but_the_hash(tmp_path: Path) -> None:
    whole = read_whole_task(PUBLIC, staff("# nothing yet\n"), SCENE)
    assert whole.task is not None
    assert whole.hidden == {}
    (tmp_path / "task.toml").write_text(PUBLIC.text)
    (tmp_path / "staff").mkdir()
    (tmp_path / "staff" / "task.toml").write_text(HIDDEN_VIA)
    assert load_task(tmp_path).hidden == 0, "hidden checks count only where they are asked for"
    assert load_task(tmp_path, staff=True).hidden == 1
