"""Purging: what is about persons goes, by the age of the marking; nothing else does."""

import json
import os
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.unit.marking.appeals.support import class_of, row
from vrts import __version__
from vrts.cli.main import vrts
from vrts.marking.about import About
from vrts.marking.class_files import write_class
from vrts.marking.exports.write import EXPORTS, MARKS
from vrts.marking.layout import Layout
from vrts.marking.privacy import purge
from vrts.marking.similarity.files import DATA, PAGE
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place

ROWS = class_of(row("anna-berger", 8.5), row("ben-otto", 3.0), row("cara", None))


def marked(folder: Path, days: float) -> Path:
    """Write the output of a marking of some days ago, with files of today."""
    layout = Layout(folder)
    for identifier in ("anna-berger", "ben-otto"):
        for home in (layout.student(identifier), layout.grader(identifier)):
            home.mkdir(parents=True)
            for name in ("result.json", "report.html", "run.rrd"):
                (home / name).write_text(identifier)
    (layout.staff / "exports").mkdir()
    (layout.staff / "decisions").mkdir()
    for name in (
        "exports/moodle.csv",
        "decisions/rh.jsonl",
        "decisions/.lock",
        "intake.csv",
        "names.csv",
        "index.html",
        "similarity.html",
    ):
        (layout.staff / name).write_text("Anna Berger")
    finished = datetime.now(UTC) - timedelta(days=days)
    about = About(
        "vrts.marking/1",
        "Lab 1",
        Place("lab1"),
        ("download",),
        Wanted(),
        __version__,
        ("vrts", "grade", "anna-berger.v2"),
        finished,
    )
    write_class(ROWS, about, layout)
    return folder


def call(*words: object, answer: str | None = None) -> Result:
    """Call `vrts purge`."""
    return CliRunner().invoke(vrts, ["purge", *map(str, words)], input=answer)


def everything(folder: Path) -> list[str]:
    """Return the names of all files."""
    return sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if not path.is_dir())


def test_old_markings_go_and_young_ones_stay(tmp_path: Path) -> None:
    old, young = marked(tmp_path / "old", 200), marked(tmp_path / "young", 100)
    before = everything(young)
    found = call(old, young, "--older-than", "180d", "--yes")
    assert found.exit_code == 0, found.output
    assert not old.exists()
    assert everything(young) == before
    assert "young: Lab 1, marked 100 days ago, not old enough" in found.stdout
    assert f"deleted {len(before)} files, " in found.stdout


def test_statistics_hold_nobody(tmp_path: Path) -> None:
    old = marked(tmp_path / "old", 200)
    assert call(old, "--older-than", "26w", "--yes", "--keep-statistics").exit_code == 0
    assert everything(old) == ["staff/statistics.json"]
    text = (old / "staff" / "statistics.json").read_text()
    assert "anna" not in text.casefold()
    told = json.loads(text)
    assert told["marks"] == [3.0, 8.5]
    assert told["kinds"] == {"graded": 2, "resource": 1}
    assert told["students"] == 3
    (check,) = [c for c in told["checks"] if c["id"] == ROWS.rows[0].result.checks[0].id]
    assert sum(check["answers"].values()) == 3
    again = call(old, "--older-than", "26w", "--yes", "--keep-statistics")
    assert again.exit_code == 0
    assert "purged before" in again.stdout
    assert everything(old) == ["staff/statistics.json"]


def test_statistics_that_cannot_be_made_keep_everything(tmp_path: Path) -> None:
    old = marked(tmp_path / "old", 200)
    (old / "staff" / "results.json").write_text("{")
    before = everything(old)
    found = call(old, "--older-than", "1d", "--yes", "--keep-statistics")
    assert found.exit_code == 1
    assert "V768" in found.stderr
    assert everything(old) == before


@pytest.mark.parametrize("answer", ["n\n", "", "\n"])
def test_nothing_goes_without_a_yes(tmp_path: Path, answer: str) -> None:
    old = marked(tmp_path / "old", 200)
    before = everything(old)
    found = call(old, "--older-than", "0d", answer=answer)
    assert found.exit_code == 1
    assert everything(old) == before
    assert call(old, "--older-than", "0d", answer="y\n").exit_code == 0
    assert not old.exists()


def test_what_vrts_has_not_written_stays_and_is_named(tmp_path: Path) -> None:
    old = marked(tmp_path / "old", 200)
    (old / "staff" / "notes.txt").write_text("mine")
    (old / "download").mkdir()
    (old / "download" / "anna.v2").write_text("mine")
    found = call(old, "--older-than", "1w", "--yes")
    assert everything(old) == ["download/anna.v2", "staff/notes.txt"]
    assert "stays: download, which vrts has not written" in found.stdout
    assert "stays: staff/notes.txt, which vrts has not written" in found.stdout


@pytest.mark.parametrize("link", ["", "students", "staff", "staff/students", "staff/exports"])
def test_no_link_is_followed_in_place_of_a_folder(tmp_path: Path, link: str) -> None:
    old = marked(tmp_path / "old", 200)
    away = tmp_path / "away"
    (old / link).rename(away)
    (old / link).symlink_to(away, target_is_directory=True)
    before = everything(away)
    found = call(old, "--older-than", "0d", "--yes")
    assert found.exit_code == 1
    assert "error[V769 link-in-the-way]" in found.stderr
    assert everything(away) == before


def test_links_inside_go_and_what_they_lead_to_stays(tmp_path: Path) -> None:
    old = marked(tmp_path / "old", 200)
    away = tmp_path / "away"
    away.mkdir()
    (away / "precious").write_text("mine")
    (old / "students" / "anna-berger" / "link").symlink_to(away, target_is_directory=True)
    (old / "staff" / "intake.csv").unlink()
    (old / "staff" / "intake.csv").symlink_to(away / "precious")
    assert call(old, "--older-than", "0d", "--yes").exit_code == 0
    assert not old.exists()
    assert (away / "precious").read_text() == "mine"


def test_other_folders_are_refused_and_then_nothing_is_deleted_anywhere(tmp_path: Path) -> None:
    old, other = marked(tmp_path / "old", 200), tmp_path / "other"
    (other / "students" / "anna").mkdir(parents=True)
    (other / "students" / "anna" / "work").write_text("mine")
    before = everything(tmp_path)
    for make in (lambda: None, lambda: write_marker(other, "{}"), lambda: link_marker(other, old)):
        make()
        found = call(old, other, "--older-than", "0d", "--yes")
        assert found.exit_code == 1
        assert "error[V768 not-written-by-marking]" in found.stderr
    assert [name for name in everything(tmp_path) if "marking.json" not in name] == [
        name for name in before if "marking.json" not in name
    ]
    assert call(tmp_path / "nowhere", "--older-than", "0d", "--yes").exit_code == 1


def write_marker(folder: Path, text: str) -> None:
    (folder / "staff").mkdir()
    (folder / "staff" / "marking.json").write_text(text)


def link_marker(folder: Path, other: Path) -> None:
    (folder / "staff" / "marking.json").unlink()
    (folder / "staff" / "marking.json").symlink_to(other / "staff" / "marking.json")


def test_the_age_is_that_of_the_marking_not_of_files(tmp_path: Path) -> None:
    young = marked(tmp_path / "young", 1)
    for path in young.rglob("*"):
        os.utime(path, (0, 0))
    assert "nothing is deleted" in call(young, "--older-than", "2d", "--yes").stderr
    assert (young / "students").exists()


@pytest.mark.parametrize("age", ["", "180", "d", "-1d", "1.5d", "6m", "999999d"])
def test_an_age_is_days_weeks_or_years(tmp_path: Path, age: str) -> None:
    assert call(marked(tmp_path / "old", 200), "--older-than", age, "--yes").exit_code == 2


def test_every_name_that_marking_writes_is_known() -> None:
    for name in (PAGE, DATA, MARKS):
        assert f"staff/{name}" in purge.FILES
    assert f"staff/{EXPORTS}" in purge.FOLDERS


def test_a_plan_is_told_for_what_it_is_and_stays(tmp_path: Path) -> None:
    plan = tmp_path / "plan"
    (plan / "shards").mkdir(parents=True)
    (plan / "key.json").write_text('{\n "schema": "vrts.plan/2",\n "plan": "anna-berger"\n}\n')
    refused = CliRunner().invoke(vrts, ["purge", str(plan), "--older-than", "0d", "--yes"])
    assert refused.exit_code == 1
    assert "is a plan for marking on other machines" in refused.stderr
    assert "hold the names" in refused.stderr
    assert (plan / "key.json").is_file()
    out = marked(tmp_path / "out", days=400)
    plan.rename(out / "plan")
    told = CliRunner().invoke(vrts, ["purge", str(out), "--older-than", "1d", "--yes"])
    assert told.exit_code == 0, told.output
    assert "stays: plan, a plan, which holds names" in told.stdout
    assert (out / "plan" / "key.json").is_file()
