"""Students are told the rules of an exam, and what they get needs no network."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.assignments.handed.from_network import network_findings
from vrts.assignments.handed.task_words import task_words
from vrts.pipeline.settings import load_task

EXAM = """
[exam]
opens = 2030-12-01T09:00:00+01:00
closes = 2030-12-01T11:00:00+01:00
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    lab = tmp_path / "lab"
    lab.mkdir()
    for name in ("task.toml", "solution.v2"):
        shutil.copy(ROOT / "examples" / "01-cans-on-bases" / name, lab)
    with (lab / "task.toml").open("a") as file:
        file.write(EXAM)
    return lab


def words(folder: Path, more: str = "") -> str:
    with (folder / "task.toml").open("a") as file:
        file.write(more)
    setting = load_task(folder)
    assert setting.task is not None
    return task_words(setting.task, setting.scene)


def test_the_rules_of_an_exam_are_told(folder: Path) -> None:
    told = words(folder)
    for part in (
        "opens: 2030-12-01 09:00:00+01:00; closes: 2030-12-01 11:00:00+01:00",
        "before it opens or after it closes does not count",
        "you have one attempt",
        "without a network",
        "but not how to mend it",
    ):
        assert part in told
    assert "due:" not in told


def test_the_best_of_several_attempts_is_told(folder: Path) -> None:
    told = words(folder, "attempts = 3\noffline = false\n")
    assert "you have 3 attempts" in told
    assert "network" not in told


def addresses(folder: Path) -> list[tuple[str, int]]:
    task = load_task(folder).task
    assert task is not None
    found = network_findings(folder, task)
    return [(d.rule.code, d.primary.span.line) for d in found if d.primary]


def test_an_address_in_what_students_get_is_told(folder: Path) -> None:
    (folder / "README.md").write_text("# Exam\nsee <https://example.org/a> or www.example.org\n")
    (folder / "handout").mkdir()
    (folder / "handout" / "a.html").write_text('<svg xmlns="http://www.w3.org/2000/svg"/>\n')
    (folder / "handout" / "b.txt").write_text("\nftp://example.org\n")
    (folder / "handout" / "c.png").write_bytes(b"http://example.org")
    assert addresses(folder) == [("V817", 2), ("V817", 2), ("V817", 2)]
    words(folder, "offline = false\n")
    assert addresses(folder) == []
