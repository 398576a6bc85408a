"""Planted defects are found, right programs are not accused, and counterexamples reproduce.

`python -m pytest -s -m "thorough or not thorough" tests/property/test_planted.py` prints a table.
"""

import json
import re
from pathlib import Path
from time import monotonic
from typing import Any

import pytest

from tests.support_commands import vrts_text
from tests.support_planted import Planted, planted

QUICK = {"T07", "T08", "I06", "A10", "P06", "O02", "O08", "Q04", "R19", "R27", "R34"}
KINDS = {  # what `vrts prove` calls what a program of the corpus expects
    "contact": "contact",
    "error": "run-time error",
    "goal": "goal missed",
    "endless": "endless loop",
    "deadlock": "wait that nothing may end",
    "never": "property broken",
    "always": "property broken",
}
NO_LINE = ("goal missed", "property broken")  # of a whole run, or of a tick
ROWS: list[str] = []


def cases() -> list[object]:
    """Return all programs, those that are not looked at in every run marked as thorough."""
    slow = pytest.mark.thorough
    return [
        pytest.param(one, id=one.name, marks=() if one.name in QUICK else slow) for one in planted()
    ]


@pytest.mark.parametrize("one", cases())
def test_what_is_planted_is_found_and_nothing_else_is_told(one: Planted, tmp_path: Path) -> None:
    began = monotonic()
    shown = vrts_text("prove", *one.written(tmp_path), "--format", "json", cwd=tmp_path)
    took = monotonic() - began
    assert shown.returncode in (0, 1, 3), shown.stderr
    told = json.loads(shown.stdout)
    result = "missed" if not one.is_right else "accused"
    try:
        judge(one, told)
        result = "held" if one.is_right else "found"
    finally:
        states = told["covered"]["states"]
        ROWS.append(f"{one.name:5}{result:9}{took:7.1f} s {states:7} states  {one.title}")
    for wrong in told["found"]:
        assert wrong["confirmed"]
        assert reproduces(one, wrong, tmp_path), wrong["headline"]


def judge(one: Planted, told: dict[str, Any]) -> None:
    """Compare what is told of a program with what is expected of it."""
    if one.is_right:
        assert told["found"] == []
        assert one.expected == ("none",) or told["answer"] == "holds", told["open"]
        return
    if one.expected == ("unbounded",):
        assert (told["answer"], told["found"]) == ("undetermined", [])
        lines = [variable["line"] for variable in told["unbounded"]]
        assert lines == list(one.lines) or "nobody says what is typed" in told["open"][0]
        return
    assert told["answer"] == "violated", told["open"]
    assert any(is_expected(one, wrong) for wrong in told["found"]), told["found"]


def is_expected(one: Planted, wrong: dict[str, Any]) -> bool:
    """Return whether something told is what was planted: its kind, words and line."""
    kinds = [KINDS[kind] for kind in one.expected]
    where = not one.lines or wrong["wrong"] in NO_LINE or wrong["line"] in one.lines
    return wrong["wrong"] in kinds and one.words in wrong["headline"] and where


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
    return wrong["headline"].split(";")[0] in said and shown.returncode == 1


@pytest.mark.thorough
def test_the_table_of_all_planted_defects() -> None:
    wrong = [one for one in planted() if not one.is_right]
    assert len(wrong) >= 60
    assert sum(one.name.startswith("T") for one in wrong) >= 20
    assert len(planted()) - len(wrong) >= 30
    print("", *ROWS, sep="\n")
