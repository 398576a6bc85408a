"""An export that is refused takes nothing else away: JSON, `--verify`, the status of a fault."""

import json
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from msgspec.structs import replace

from tests.places import ROOT
from vrts.cli.grade import mark_command
from vrts.cli.shared.console import FAULT, WRONG
from vrts.marking import whole_class
from vrts.marking.result import Kind

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SHEET = "Identifier;Full name;Grade;Maximum Grade\nParticipant 11;Anna;;10,000\n"


def mark(tmp_path: Path, *words: object) -> Result:
    program = tmp_path / "anna.v2"
    program.write_bytes((EXAMPLE / "submissions" / "syntax-error.v2").read_bytes())
    out = ("-o", tmp_path / "my out", "--no-pages")
    asked = [str(word) for word in (EXAMPLE / "task.toml", program, *out, *words)]
    return CliRunner().invoke(mark_command.command, asked)


def test_json_and_verify_come_before_an_export_that_is_refused(tmp_path: Path) -> None:
    sheet = tmp_path / "sheet.csv"
    sheet.write_text(SHEET, "utf-8")
    words = ("--format", "json", "--verify", "--export", "moodle", "--fill", sheet)
    said = mark(tmp_path, *words, "--export", "junit")
    assert said.exit_code == WRONG
    assert [row["id"] for row in json.loads(said.stdout)["rows"]] == ["anna"]
    assert "marked 1 again" in said.stderr
    assert "V757" in said.stderr
    assert f"`vrts grade export {shlex.quote(str(tmp_path / 'my out'))}`" in said.stderr
    assert (tmp_path / "my out" / "staff" / "exports" / "junit.xml").exists()


def test_a_fault_is_told_also_where_an_export_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    original = whole_class.mark_whole_class

    def faulty(*given: object, **named: object) -> object:
        marked = original(*given, **named)  # type: ignore[arg-type]
        (done,) = marked.done
        failed = replace(done.result, kind=Kind.FAULT, mark=None)
        return marked._replace(done=(done._replace(result=failed),))

    monkeypatch.setattr(whole_class, "mark_whole_class", faulty)
    said = mark(tmp_path, "--export", "moodle")
    assert "V740" in said.stderr
    assert said.exit_code == FAULT


def test_a_file_to_fill_that_is_not_there_is_told_before_marking(tmp_path: Path) -> None:
    said = mark(tmp_path, "--export", "moodle", "--fill", tmp_path / "nothing.csv")
    assert said.exit_code == 2
    assert not (tmp_path / "my out").exists()
