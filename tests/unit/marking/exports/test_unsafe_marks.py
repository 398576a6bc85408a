"""What is offered about unsafe marks can be typed, and leads where it says."""

import re
import shlex
from fractions import Fraction
from pathlib import Path

import click
import pytest
from click.testing import CliRunner, Result
from msgspec.structs import replace

from tests.support_rows import plain_result, plain_row
from vrts.cli.grade import change_command, export_command
from vrts.marking.exports.unsafe_marks import after_marking, refusal, without_lateness
from vrts.marking.lateness import UNTIMED
from vrts.marking.layout import Layout
from vrts.marking.result import Kind, to_bytes
from vrts.marking.row import (
    OF_SESSION,
    Class,
    HandedIn,
    Lateness,
    Row,
    Student,
    class_to_bytes,
    counted,
    row_of,
)
from vrts.marking.unsafe import Reason

LATE = Lateness(0, "0", UNTIMED, review=True, untimed=True)
COMMANDS = {"change": change_command.command, "export": export_command.command}
ABOUT = (
    '{"schema":"vrts.marking/1","title":"Lab","place":{"task":"task.toml"},"submissions":[],'
    '"wanted":{},"vrts":"0.1","command":[],"finished":"2026-11-20T12:00:00Z"}'
)


def late_row(identifier: str, why: str = "", **changed: object) -> Row:
    result = replace(plain_result(identifier), **changed)
    return row_of(result, Student(identifier.title()), HandedIn("a.v2", why), LATE)


def of(*rows: Row) -> Class:
    return counted(Class("vrts.class/1", "Lab", rows))


def written(folder: Path, whole: Class) -> Path:
    """Write what a marking leaves, as far as exports of tables need it."""
    layout = Layout(folder)
    layout.staff.mkdir(parents=True)
    layout.results.write_bytes(class_to_bytes(whole))
    (layout.staff / "marking.json").write_text(ABOUT)
    for row in whole.rows:
        home = layout.student(row.id)
        home.mkdir(parents=True)
        (home / "result.json").write_bytes(to_bytes(row.result))
    return folder


def typed(words: str, **put: str) -> Result:
    """Type a command of `vrts grade` as it was offered, with words put in."""
    _, _, name, *rest = (put.get(word, word) for word in shlex.split(words))
    return CliRunner().invoke(COMMANDS[name], rest)


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Return a marking with two marks that are unsafe for different reasons."""
    whole = of(late_row("anna", lowest=8.5), plain_row("ben", "Ben", more=2), plain_row("cem"))
    return written(tmp_path / "my out", whole)


def test_what_is_offered_decides_marks_one_by_one(out: Path) -> None:
    asked = f"vrts grade export {shlex.quote(str(out))} --to csv"
    said = typed(asked)
    assert said.exit_code == 1
    for expected in ("`anna` (undetermined, late)", "`ben` (hidden)"):
        assert expected in said.output
    change, instead = re.findall(r"`([^`]*)`", said.output.split("by hand: ")[1])[:2]
    assert instead == "--delta 0 --settles undetermined --settles late"
    kept = typed(change.replace("--mark N", instead), WHY="seen", YOU="RH")
    assert kept.exit_code == 0, kept.output
    said = typed(asked)
    assert "1 of 3 marks is unsafe, so nothing is written: `ben` (hidden)" in said.output
    (change, *_) = re.findall(r"`([^`]*)`", said.output.split("by hand: ")[1])
    decided = typed(change, N="7.5", WHY="seen", YOU="RH")
    assert decided.exit_code == 0, decided.output
    done = typed(asked)
    assert done.exit_code == 0, done.output


@pytest.mark.parametrize("more", ["", " --despite late"])
def test_what_is_offered_accepts_all_of_them(out: Path, more: str) -> None:
    asked = f"vrts grade export {shlex.quote(str(out))} --to csv{more}"
    said = typed(asked)
    assert said.exit_code == 1
    (offered,) = re.findall(r"as they are: `([^`]*)`", said.output)
    assert offered == "--despite hidden --despite undetermined --despite late"
    done = typed(f"{asked} {offered}")
    assert done.exit_code == 0, done.output


def test_a_mark_that_is_not_there_is_only_given(tmp_path: Path) -> None:
    (told,) = refusal(of(plain_row("a b", kind=Kind.FAULT, mark=None)), (), tmp_path)
    by_hand = told.help[1]
    assert f"vrts grade change 'a b' --from {tmp_path} --mark N" in by_hand
    assert "--delta" not in by_hand


def test_sessions_are_not_asked_for_files_and_times() -> None:
    ambiguous = replace(plain_result("b"), kind=Kind.AMBIGUOUS, mark=None, cause="log changed")
    rows = (
        late_row("a", OF_SESSION),
        row_of(ambiguous, Student("b"), HandedIn("log", OF_SESSION)),
    )
    for (told,) in (after_marking(of(*rows)), refusal(of(*rows), ())):
        assert [line.split(":")[0] for line in told.help[:2]] == ["ambiguous (1)", "late (1)"]
        assert "--roster" not in " ".join(told.help)
        assert "intake.csv" not in " ".join(told.help)
    (told,) = after_marking(of(*rows, late_row("c")))
    assert "--roster" in told.help[1]


def test_formats_that_are_written_anyway_are_written_before_the_rest_is_refused(
    out: Path,
) -> None:
    words = ("--to", "csv", "--to", "junit", "--to", "json")
    said = CliRunner().invoke(export_command.command, [str(out), *words])
    assert said.exit_code == 1
    assert "2 of 3 marks are unsafe, so `csv` is not written" in said.output
    home = out / "staff" / "exports"
    assert {place.name for place in home.iterdir()} == {"junit.xml", "class.json"}
    for place in home.iterdir():
        assert f"wrote {place}" in said.output


def test_platforms_that_judge_lateness_are_asked_for_no_time(out: Path) -> None:
    words = ("--to", "gradescope", "--to", "prairielearn")
    said = CliRunner().invoke(export_command.command, [str(out), *words])
    assert said.exit_code == 1
    assert "`anna` (undetermined), `ben` (hidden)" in said.output
    accepted = ("--despite", "undetermined", "--despite", "hidden")
    said = CliRunner().invoke(export_command.command, [str(out), *words, *accepted])
    assert said.exit_code == 0, said.output
    for name in ("gradescope", "prairielearn"):
        text = (out / "staff" / "exports" / name / "anna.json").read_text("utf-8")
        assert UNTIMED not in text
    said = CliRunner().invoke(export_command.command, [str(out), *words, "--to", "csv", *accepted])
    assert said.exit_code == 1
    assert "so `csv` is not written: `anna` (late)" in said.output
    assert without_lateness(of(late_row("anna"))).unsafe == {}
    assert [d.reason for d in without_lateness(of(plain_row(more=1))).rows[0].unsafe] == [
        Reason.HIDDEN
    ]


def test_classroom50_has_its_result(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("CLASSROOM", "ASSIGNMENT", "SUBMISSION_TAG", "COMMIT_URL", "RELEASE_URL"):
        monkeypatch.setenv(name, "https://example.org")
    out = written(tmp_path / "out", of(late_row("anna")))
    target = tmp_path / "result.json"
    words = [str(out), "--to", "classroom50", "-o", str(target)]
    said = CliRunner().invoke(export_command.command, words)
    assert said.exit_code == 0, said.output
    assert target.exists()


@pytest.mark.parametrize(
    ("text", "points"), [("7,5", "7.5"), ("-0.5", "-0.5"), ("+.5", "0.5"), ("1,000.00", "1000")]
)
def test_points_are_typed_as_people_write_them(text: str, points: str) -> None:
    assert change_command.Points().convert(text, None, None) == Fraction(points)


@pytest.mark.parametrize("text", ["1,234", "many", "1001", "0.0001"])
def test_points_that_are_none_are_refused(text: str) -> None:
    with pytest.raises(click.BadParameter):
        change_command.Points().convert(text, None, None)
