"""`vrts grade intake` from the outside."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.unit.marking.intake.support import DOCX, PICK, put, zipped
from tests.unit.marking.intake.tables.test_roster import WORKSHEET
from tests.unit.marking.intake.test_cases import METADATA
from vrts.cli.main import vrts

FILES = {
    "Anna Berger_1_assignsubmission_file_/pick.v2": PICK,
    "Ben\x1b[31m_2_assignsubmission_file_/pick.docx": DOCX,
    "list.txt": b"names",
}

TASK = """[task]
scene = "cans-on-bases"
program = "pick"
[[goal]]
object = "can1"
on = "base2"
[time]
reference_s = 10
"""


def call(*arguments: object) -> Result:
    return CliRunner().invoke(vrts, ["grade", "intake", *map(str, arguments)])


def test_rows_are_shown_and_the_table_is_written(tmp_path: Path) -> None:
    place = tmp_path / "download.zip"
    place.write_bytes(zipped({name: FILES[name] for name in list(FILES)[::2]}))
    result = call(place)
    assert result.exit_code == 0
    assert result.stdout == (
        "id             file     why, or what is wrong\n"
        "Anna-Berger-1  pick.v2  the only file\n"
        "\n"
        "Moodle: 1 hand-in, none with a problem\n"
    )
    assert result.stderr.splitlines()[0] == "note: `list.txt` is not of a student"
    assert (tmp_path / "intake.csv").read_bytes().startswith(b"\xef\xbb\xbfid,name,file,problem,")


def test_problems_are_an_exit_status_and_names_steer_no_terminal(tmp_path: Path) -> None:
    result = call(put(tmp_path / "d", FILES))
    assert result.exit_code == 1
    assert "not plain text: `pick.docx` is a Word document" in result.stdout
    assert "\x1b" not in result.stdout + result.stderr
    shown = [line.split()[0] for line in result.stdout.splitlines() if line]
    assert shown == ["id", "Ben-31m-2", "Anna-Berger-1", "Moodle:"], "what is wrong comes first"
    assert result.stdout.endswith("2 hand-ins, 1 with a problem, shown first\n")
    assert (tmp_path / "d" / "intake.csv").is_file()


def test_a_table_is_not_overwritten_unasked(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {"anna.v2": PICK, "intake.csv": b"mine"})
    result = call(place)
    assert result.exit_code == 2
    assert "is there already" in result.stderr
    assert (place / "intake.csv").read_bytes() == b"mine"
    assert call(place, "--force", "--delimiter", ";").exit_code == 0
    assert (place / "intake.csv").read_bytes().startswith(b"\xef\xbb\xbfid;name;file")


def test_the_program_is_that_of_the_task(tmp_path: Path) -> None:
    other = PICK.replace(b"pick", b"place")
    place = put(tmp_path / "d", {"anna/a.v2": PICK, "anna/b.v2": other})
    table = tmp_path / "out.csv"
    assert "ambiguous" in call(place, "-o", table).stdout
    assert "`.PROGRAM place`" in call(place, "-o", table, "--force", "--program", "place").stdout
    task = tmp_path / "task.toml"
    task.write_text(TASK)
    result = call(place, "-o", table, "--force", "--task", task)
    assert "anna  a.v2  the only file that has `.PROGRAM pick`" in result.stdout


@pytest.mark.parametrize("zone", ["Europe/Vienna", "+01:00"])
def test_a_list_of_the_class_tells_who_is_missing_and_when_work_came(
    zone: str, tmp_path: Path
) -> None:
    place = put(tmp_path / "d", {"Anna Berger_101_assignsubmission_file_/pick.v2": PICK})
    worksheet = tmp_path / "worksheet.csv"
    worksheet.write_bytes(WORKSHEET)
    result = call(place, "--roster", worksheet, "--zone", zone)
    assert "Ben-Wolf-102     -        missing: nothing was handed in" in result.stdout
    assert b"2026-11-30T23:58:00+01:00" in (place / "intake.csv").read_bytes()


def test_a_zone_that_nobody_knows(tmp_path: Path) -> None:
    result = call(put(tmp_path / "d", FILES), "--zone", "Mars/Olympus")
    assert result.exit_code == 2
    assert result.stderr.startswith("error: there is no zone `Mars/Olympus`")


def test_the_zone_is_that_of_the_deadline(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {"anna/2026-03-01-10-00-00/pick.v2": PICK})
    task = tmp_path / "task.toml"
    task.write_text(TASK + "[late]\ndue = 2026-03-01T12:00:00+02:00\nper_day = 1\n")
    assert call(place, "--task", task).exit_code == 0
    assert b"2026-03-01T10:00:00+02:00" in (place / "intake.csv").read_bytes()


def test_metadata_that_are_damaged_are_a_wrong_call(tmp_path: Path) -> None:
    files = {"submission_metadata.yml": METADATA[:60] + b"'", "submission_7/pick.v2": PICK}
    result = call(put(tmp_path / "d", files))
    assert result.exit_code == 2
    assert result.stderr == "error: `submission_metadata.yml` is damaged\n"


@pytest.mark.parametrize("name", ["nothing", "nothing.zip"])
def test_nothing_there(name: str, tmp_path: Path) -> None:
    result = call(tmp_path / name)
    assert result.exit_code == 2
    assert "there is no" in result.stderr
