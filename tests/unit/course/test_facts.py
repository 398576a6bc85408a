"""What the server knows of an assignment without reading its scene."""

from pathlib import Path

from vrts.check.task.late_rules import Keep
from vrts.course.course import Assignment
from vrts.course.facts import facts_of

LATE = """
[task]
title = "Pick one can"
description = "Put it on its base."
scene = "cans-on-bases"

[late]
due = 2026-11-30T12:00:00+01:00
per_day = 1

[submissions]
keep = "best"
"""
EXAM = """
[task]
scene = "cans-on-bases"

[exam]
opens = 2026-12-01T09:00:00+01:00
closes = 2026-12-01T11:00:00+01:00
"""


def of(text: str, tmp_path: Path) -> Assignment:
    (tmp_path / "task.toml").write_text(text)
    return Assignment("pick", tmp_path)


def test_title_deadline_and_what_counts_are_known(tmp_path: Path) -> None:
    found = facts_of(of(LATE, tmp_path))
    assert (found.title, found.keep, found.text) == (
        "Pick one can",
        Keep.BEST,
        "Put it on its base.",
    )
    assert found.due is not None
    assert found.due.isoformat() == "2026-11-30T12:00:00+01:00"
    assert found.opens is None


def test_an_exam_opens_and_closes(tmp_path: Path) -> None:
    found = facts_of(of(EXAM, tmp_path))
    assert found.title == "pick"
    assert found.opens is not None
    assert found.due is not None
    assert (found.opens.hour, found.due.hour) == (9, 11)


def test_a_task_with_faults_is_still_there(tmp_path: Path) -> None:
    assert facts_of(of("[task\n", tmp_path)).title == "pick"
