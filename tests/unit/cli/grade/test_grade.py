"""`vrts grade` on a class: from the download to the list of marks, and once more."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text as vrts

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
GOOD = (EXAMPLE / "solution.v2").read_text()
POOR = (EXAMPLE / "submissions" / "hits-base.v2").read_text()
LATE = "[late]\ndue = 2026-11-01T12:00:00+01:00\nper_day = 1\n"


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """Return a folder with a task and a download of Moodle."""
    shutil.copytree(EXAMPLE, tmp_path / "task", ignore=shutil.ignore_patterns("submissions"))
    hand_in(tmp_path, "Anna Berg_101_assignsubmission_file_", "pick.v2", GOOD)
    hand_in(tmp_path, "Zoltan Kis_102_assignsubmission_file_", "mine.v2", POOR)
    hand_in(tmp_path, "Ida Lind_103_assignsubmission_file_", "report.pdf", "%PDF-1.7\n")
    return tmp_path


def hand_in(home: Path, folder: str, name: str, text: str) -> None:
    """Put a file into the download."""
    place = home / "download" / folder
    place.mkdir(parents=True, exist_ok=True)
    (place / name).write_text(text)


def rows(home: Path, out: str = "out") -> dict[str, dict[str, Any]]:
    """Return the rows of a marking by student."""
    found = json.loads((home / out / "staff" / "results.json").read_text())
    return {row["student"]["name"]: row for row in found["rows"]}


def test_a_download_is_marked_and_only_what_changed_is_marked_again(home: Path) -> None:
    first = vrts("grade", "task", "download", "-o", "out", cwd=home)
    assert first.returncode == 0, first.stderr
    found = rows(home)
    assert {name: row["final"] for name, row in found.items()} == {
        "Anna Berg": 10.0,
        "Zoltan Kis": 7.0,
        "Ida Lind": 0.0,
    }
    assert found["Ida Lind"]["result"]["kind"] == "unreadable"
    assert found["Anna Berg"]["student"]["ids"] == {"moodle": "101"}
    for row in found.values():
        assert (home / "out" / "students" / row["id"] / "report.html").is_file()
    lines = [line[:4].strip() for line in first.stdout.splitlines() if line[:4].strip()]
    assert lines == ["10.0", "0.0", "7.0"]

    places = {n: home / "out/students" / r["id"] / "report.html" for n, r in found.items()}
    before = {name: place.stat().st_mtime_ns for name, place in places.items()}
    hand_in(home, "Zoltan Kis_102_assignsubmission_file_", "mine.v2", GOOD)
    second = vrts("grade", "task", "download", "-o", "out", cwd=home)
    assert second.returncode == 0, second.stderr
    assert rows(home)["Zoltan Kis"]["final"] == 10.0
    after = {name: place.stat().st_mtime_ns for name, place in places.items()}
    assert after["Anna Berg"] == before["Anna Berg"]
    assert after["Zoltan Kis"] != before["Zoltan Kis"]


@pytest.mark.thorough
def test_what_marking_wrote_itself_does_not_hide_what_is_handed_in_later(home: Path) -> None:
    assert vrts("grade", "task", "download", "-o", "out", cwd=home).returncode == 0
    shutil.rmtree(home / "download" / "Zoltan Kis_102_assignsubmission_file_")
    hand_in(home, "Zoltan Kis_102_assignsubmission_file_", "other.v2", GOOD)
    assert vrts("grade", "task", "download", "-o", "out", cwd=home).returncode == 0
    assert rows(home)["Zoltan Kis"]["handed_in"]["file"].endswith("other.v2")


@pytest.mark.thorough
def test_a_table_that_the_teacher_edited_is_obeyed_from_then_on(home: Path) -> None:
    assert vrts("grade", "task", "download", "-o", "out", cwd=home).returncode == 0
    table = home / "out" / "staff" / "intake.csv"
    text = table.read_text()
    lines = [
        line.replace("not plain text", "excused") if "Ida Lind" in line else line
        for line in text.splitlines(keepends=True)
    ]
    assert "".join(lines) != text
    table.write_text("".join(lines))
    for _ in range(2):
        again = vrts("grade", "task", "download", "-o", "out", cwd=home)
        assert again.returncode == 0, again.stderr
        row = rows(home)["Ida Lind"]
        assert (row["result"]["kind"], row["final"]) == ("excused", None)


@pytest.mark.thorough
def test_changes_by_hand_survive_marking_again_beside_the_computed_mark(home: Path) -> None:
    assert vrts("grade", "task", "download", "-o", "out", cwd=home).returncode == 0
    identifier = rows(home)["Zoltan Kis"]["id"]
    (home / "out" / "staff" / "overrides.toml").write_text(
        f'[[change]]\nstudent = "{identifier}"\ndelta = 1.5\nreason = "shown in the lab"\n'
        'who = "jb"\ndate = "2026-11-20"\n'
    )
    for words in ((), ("--again",)):
        said = vrts("grade", "task", "download", "-o", "out", *words, cwd=home)
        assert said.returncode == 0
        assert f" 8.5  {identifier}" in said.stdout
        assert "computed 7.0; +1.5 change by hand (shown in the lab)" in said.stdout
        told = (home / "out" / "students" / identifier / "feedback.txt").read_text()
        assert "Final mark: 8.5 of 10" in told
        assert "shown in the lab" in told
        row = rows(home)["Zoltan Kis"]
        assert (row["result"]["mark"], row["final"]) == (7.0, 8.5)
        assert row["change"]["reason"] == "shown in the lab"
    (home / "out" / "staff" / "overrides.toml").write_text('[[change]]\nstudent = "x"\n')
    wrong = vrts("grade", "task", "download", "-o", "out", cwd=home)
    assert wrong.returncode == 1
    assert "V770" in wrong.stderr + wrong.stdout
    assert rows(home)["Zoltan Kis"]["final"] == 8.5, "nothing is lost"


@pytest.mark.thorough
def test_lateness_by_the_rules_of_the_task(home: Path) -> None:
    task = home / "task" / "task.toml"
    task.write_text(task.read_text() + LATE)
    assert vrts("grade", "intake", "download", "--task", "task", cwd=home).returncode == 1
    table = home / "download" / "intake.csv"
    lines = table.read_text().splitlines(keepends=True)
    column = lines[0].rstrip().lstrip("\ufeff").split(",").index("received")
    cells = next(line for line in lines if "Zoltan" in line)
    edited = cells.split(",")
    edited[column] = "2026-11-02T13:00:00+01:00"
    table.write_text("".join(lines).replace(cells, ",".join(edited)))
    assert vrts("grade", "task", "download", "-o", "out", cwd=home).returncode == 0
    row = rows(home)["Zoltan Kis"]
    assert (row["result"]["mark"], row["late"]["deduction"], row["final"]) == (7.0, "2", 5.0)
    assert row["late"]["by_s"] == 25 * 3600


@pytest.mark.thorough
def test_a_mark_that_may_lack_a_deduction_is_told_counted_and_kept_back(home: Path) -> None:
    task = home / "task" / "task.toml"
    task.write_text(task.read_text() + LATE)
    shutil.rmtree(home / "download")
    hand_in(home, ".", "berganna_LATE_31_901_pick.v2", GOOD)
    hand_in(home, ".", "kiszoltan_32_902_pick.v2", POOR)
    said = vrts("grade", "task", "download", "-o", "out", "--export", "csv", cwd=home)
    assert said.returncode == 1
    assert "      unsafe: late: late, says the platform, but not when it came" in said.stdout
    assert "warning[V753 unsafe-mark]: 1 of 2 marks is unsafe: `berganna-31` (late)" in said.stderr
    assert "so nothing is written: `berganna-31` (late)" in said.stderr
    assert not (home / "out" / "staff" / "exports").exists()
    found = json.loads((home / "out" / "staff" / "results.json").read_text())
    assert found["unsafe"] == {"late": 1}
    assert found["rows"][0]["id"] == "berganna-31"
    assert "1 unsafe mark: 1 late" in (home / "out" / "staff" / "index.html").read_text()
    told = (home / "out" / "students" / "berganna-31" / "feedback.txt").read_text()
    assert "This mark is not sure yet: late, says the platform" in told


def test_nothing_handed_in_is_a_wrong_call(home: Path) -> None:
    (home / "empty").mkdir()
    result = vrts("grade", "task", "empty", "-o", "out", cwd=home)
    assert result.returncode == 2
    assert "`empty` holds no program" in result.stderr
    assert not (home / "out").exists()


@pytest.mark.thorough
def test_what_was_not_looked_for_is_not_said_to_be_there_or_not(home: Path) -> None:
    words = ("--no-collisions", "-o", "out")
    said = vrts("grade", "task", "download", *words, cwd=home)
    assert said.returncode == 0
    assert "nothing was touched" not in said.stdout
    assert "contacts were not looked for" in said.stdout
    assert "contacts were not looked for" in (home / "out" / "staff" / "marks.csv").read_text()


@pytest.mark.thorough
def test_a_sample_marked_again_is_the_same(home: Path) -> None:
    result = vrts("grade", "task", "download", "-o", "out", "--verify", "--sample", "2", cwd=home)
    assert result.returncode == 0
    assert "none differ" in result.stdout + result.stderr


@pytest.mark.thorough
def test_marks_come_as_a_table_and_in_other_formats(home: Path) -> None:
    words = ("--export", "junit", "--export", "moodle-feedback")
    result = vrts("grade", "task", "download", "-o", "out", *words, cwd=home)
    assert result.returncode == 0, result.stderr
    table = (home / "out" / "staff" / "marks.csv").read_text("utf-8-sig").splitlines()
    assert len(table) == 4
    assert {"Anna Berg", "Zoltan Kis", "Ida Lind"} == {line.split(",")[1] for line in table[1:]}
    written = list((home / "out" / "staff" / "exports").iterdir())
    assert len(written) == 2
    for path in written:
        assert str(path.relative_to(home)) in result.stderr + result.stdout
    assert vrts("grade", "task", "download", "--export", "csv", cwd=home).returncode == 2


def test_help_names_the_further_commands(tmp_path: Path) -> None:
    said = vrts("grade", "--help", cwd=tmp_path).stdout
    for word in ("intake", "plan", "merge", "export", "evidence", "reproduce", "diff"):
        assert word in said
    assert vrts("grade", "intake", "--help", cwd=tmp_path).returncode == 0
    assert vrts("grade", cwd=tmp_path).returncode == 2
