"""Planted defects are found, right programs are not accused, and counterexamples reproduce.

`tests/bench/test_bench_planted.py` prints the figures of all of them.
"""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.support_commands import vrts_text
from tests.support_planted import UNBOUNDED, Planted, outcome, planted

QUICK = {"T07", "T08", "I06", "A10", "P06", "O02", "O08", "Q04", "R19", "R27", "R34"}


def cases() -> list[object]:
    """Return all programs, those that are not looked at in every run marked as thorough."""
    slow = pytest.mark.thorough
    return [
        pytest.param(one, id=one.name, marks=() if one.name in QUICK else slow) for one in planted()
    ]


@pytest.mark.thorough
@pytest.mark.parametrize("one", cases())
def test_what_is_planted_is_found_and_nothing_else_is_told(one: Planted, tmp_path: Path) -> None:
    shown = vrts_text("prove", *one.written(tmp_path), "--format", "json", cwd=tmp_path)
    assert shown.returncode in (0, 1, 3), shown.stderr
    told = json.loads(shown.stdout)
    wanted = "held" if one.is_right else "open" if one.expected == UNBOUNDED else "found"
    assert outcome(one, told) == wanted, (told["answer"], told["found"], told["open"])
    assert not any("not confirmed" in left for left in told["open"])
    for wrong in told["found"]:
        assert wrong["confirmed"]
        assert reproduces(one, wrong, tmp_path), wrong["headline"]


@pytest.mark.parametrize("name", ["P02", "P04", "P06"])
def test_the_second_half_of_a_budget_goes_where_few_have_been(name: str, tmp_path: Path) -> None:
    one = next(one for one in planted() if one.name == name)
    few = ("--states", "500")
    shown = vrts_text("prove", *one.written(tmp_path), *few, "--format", "json", cwd=tmp_path)
    assert outcome(one, json.loads(shown.stdout)) == "found"


def reproduces(one: Planted, wrong: dict[str, Any], folder: Path) -> bool:
    """Return whether the ordinary commands show the same in the scenario that was written."""
    if wrong["wrong"] == "property broken":
        return True  # no other command knows properties
    (folder / "bad.toml").write_text(wrong["scenario"])
    arguments: list[str] = []
    if one.task is not None:
        arguments = ["--task", "task.toml"]
    elif one.scene is not None:
        arguments = ["--scene", one.scene]
    command = "verify" if arguments else "run"
    shown = vrts_text(command, f"{one.name}.v2", *arguments, "--scenario", "bad.toml", cwd=folder)
    said = shown.stdout + shown.stderr
    if wrong["wrong"] == "contact":
        second = re.fullmatch(r".+ touches (.+), .+", wrong["headline"])
        assert second is not None
        return f"hits `{second[1]}`" in said and "error[V400" in said and shown.returncode == 1
    if wrong["wrong"] == "goal missed":
        return "error[V660" in said and shown.returncode == 1
    if wrong["wrong"] == "endless loop" and "error[V511" in said:
        return shown.returncode == 1  # one that reads a clock: a run ends at its time
    return wrong["headline"].split(";")[0] in said and shown.returncode == 1


def test_there_are_as_many_programs_as_are_asked_for() -> None:
    wrong = [one for one in planted() if not one.is_right]
    assert sum(one.expected != UNBOUNDED for one in wrong) >= 60
    assert sum(one.name.startswith("T") for one in wrong) >= 20
    assert len(planted()) - len(wrong) >= 30


def test_what_is_told_is_judged_by_kind_words_and_line() -> None:
    programs = {one.name: one for one in planted()}
    wrong, right = programs["I03"], programs["R19"]
    assert wrong.words
    nothing: dict[str, Any] = {"answer": "holds", "found": [], "unbounded": [], "open": []}
    shown: dict[str, Any] = {"wrong": "run-time error", "headline": f"x {wrong.words} y"}
    shown |= {"line": wrong.lines[0], "confirmed": True}
    assert (outcome(wrong, nothing), outcome(right, nothing)) == ("missed", "held")
    left = {**nothing, "answer": "undetermined", "open": ["1 future was left"]}
    assert (outcome(wrong, left), outcome(right, left)) == ("undetermined", "undetermined")
    told = {**nothing, "answer": "violated", "found": [shown]}
    assert (outcome(wrong, told), outcome(right, told)) == ("found", "accused")
    for other in (
        {"wrong": "contact"},
        {"headline": "x"},
        {"line": wrong.lines[0] + 1},
        {"confirmed": False},
    ):
        assert outcome(wrong, {**told, "found": [{**shown, **other}]}) == "missed"
