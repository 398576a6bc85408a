"""Exports on the command line, of a class that was really marked."""

import csv
import io
import json
import shutil
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from msgspec.structs import replace

from tests.places import ROOT
from vrts.cli.grade import change_command, export_command, mark_command
from vrts.cli.grade.export_command import NAMES
from vrts.marking.exports.formats import FORMATS
from vrts.marking.exports.given import Options
from vrts.marking.exports.write import is_name, write_exports, write_marks_table
from vrts.marking.lateness import UNTIMED
from vrts.marking.layout import Layout
from vrts.marking.row import Lateness, class_from_bytes, class_to_bytes, row_of
from vrts.pipeline.refused import Refused

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
PEOPLE = {"Anna Ady_11": "solution.v2", "Ben_12": "submissions/syntax-error.v2"}


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the output of a marking of two students of Moodle."""
    home = tmp_path_factory.mktemp("class")
    download = home / "download.zip"
    with zipfile.ZipFile(download, "w") as archive:
        for who, file in PEOPLE.items():
            name = f"{who}_assignsubmission_file_/pick.v2"
            archive.writestr(name, (EXAMPLE / file).read_bytes())
    called = CliRunner().invoke(
        mark_command.command,
        [str(EXAMPLE / "task.toml"), str(download), "-o", str(home / "out"), "--no-pages"],
    )
    assert called.exit_code == 0, called.output
    return home / "out"


def export(*words: object) -> Result:
    return CliRunner().invoke(export_command.command, [str(word) for word in words])


def change(out: Path, who: str, *words: str) -> Result:
    return CliRunner().invoke(change_command.command, [who, "--from", str(out), *words])


def test_the_command_knows_every_format() -> None:
    assert tuple(FORMATS) == NAMES
    described = export_command.EPILOG
    assert all(f"\n  {name} " in described for name in NAMES)


def test_a_class_is_written_in_every_format_that_needs_no_file(marked: Path) -> None:
    names = [name for name, form in FORMATS.items() if not form.fills and name != "classroom50"]
    called = export(marked, *(word for name in names for word in ("--to", name)))
    assert called.exit_code == 0, called.output
    folder = marked / "staff" / "exports"
    assert {place.name for place in folder.iterdir()} == {
        "marks.csv", "class.json", "moodle-feedback.zip", "folders", "gradescope", "prairielearn",
        "junit.xml", "findings.sarif",
    }  # fmt: skip
    lines = list(csv.DictReader(io.StringIO((folder / "marks.csv").read_text("utf-8-sig"))))
    rows = class_from_bytes((marked / "staff" / "results.json").read_bytes()).rows
    assert [line["final"] for line in lines] == [f"{row.final:.1f}" for row in rows]
    assert lines[0]["final"] == "10.0"
    told = (folder / "folders" / rows[1].id / "feedback.txt").read_text("utf-8")
    assert "Final mark: 0.0 of 10" in told
    assert "Hint: " in told


def test_a_worksheet_is_filled_in(marked: Path, tmp_path: Path) -> None:
    sheet = tmp_path / "worksheet.csv"
    text = "Identifier,Full name,Grade,Maximum Grade\nParticipant 11,Anna Ady,,20\n"
    sheet.write_text(text, "utf-8")
    called = export(marked, "--to", "moodle", "--fill", sheet, "-o", tmp_path / "new.csv")
    assert called.exit_code == 0, called.output
    assert (tmp_path / "new.csv").read_text("utf-8") == text.replace("Ady,,", "Ady,20,")
    assert sheet.read_text("utf-8") == text
    assert "V743" in called.output


@pytest.mark.parametrize(("decimal", "mark"), [("comma", "1,234"), ("point", "1234")])
def test_points_are_read_with_the_sign_that_was_named(
    marked: Path, tmp_path: Path, decimal: str, mark: str
) -> None:
    sheet = tmp_path / "worksheet.csv"
    text = "Identifier;Full name;Grade;Maximum Grade\nParticipant 11;Anna Ady;;10\n"
    sheet.write_text(text, "utf-8")
    words = ("--to", "moodle", "--fill", sheet, "-o", tmp_path / "new.csv", "--points", "1,234")
    assert export(marked, *words).exit_code == 2
    called = export(marked, *words, "--decimal", decimal)
    assert called.exit_code == 0, called.output
    assert f"Ady;{mark};10" in (tmp_path / "new.csv").read_text("utf-8")


def test_one_submission_is_one_file(marked: Path, tmp_path: Path) -> None:
    layout = Layout(marked)
    rows = class_from_bytes(layout.results.read_bytes())
    one = type(rows)(rows.schema, rows.title, rows.rows[:1])
    target = tmp_path / "results" / "results.json"
    told: list[object] = []
    paths = write_exports(["gradescope"], one, layout, Options(), tell=told.extend, target=target)
    assert paths == [target]
    assert json.loads(target.read_bytes())["score"] == 10


def test_changes_by_hand_count_as_they_are_now(marked: Path, tmp_path: Path) -> None:
    layout = Layout(marked)
    rows = class_from_bytes(layout.results.read_bytes()).rows
    layout.overrides.write_text(
        f'[[change]]\nstudent = "{rows[1].id}"\nmark = 4\nreason = "a comma"\nwho = "H"\n'
        'date = "2026-11-20"\n',
        "utf-8",
    )
    try:
        called = export(marked, "--to", "csv", "-o", tmp_path / "m.csv")
    finally:
        layout.overrides.unlink()
    assert called.exit_code == 0, called.output
    lines = list(csv.DictReader(io.StringIO((tmp_path / "m.csv").read_text("utf-8-sig"))))
    assert [(line["mark"], line["change"], line["final"]) for line in lines] == [
        ("10.0", "", "10.0"),
        ("0.0", "4", "4.0"),
    ]


def test_every_marking_may_have_its_table(marked: Path) -> None:
    layout = Layout(marked)
    path = write_marks_table(class_from_bytes(layout.results.read_bytes()), layout)
    assert path == marked / "staff" / "marks.csv"
    assert path.read_bytes().startswith(b"\xef\xbb\xbfid,name,")


def test_unsafe_marks_are_kept_back_until_somebody_accepts_them(
    marked: Path, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    shutil.copytree(marked, out)
    whole = class_from_bytes(Layout(out).results.read_bytes())
    late = Lateness(0, "0", UNTIMED, review=True, untimed=True)
    anna, ben = whole.rows
    unsafe = row_of(anna.result, anna.student, anna.handed_in, late)
    Layout(out).results.write_bytes(class_to_bytes(replace(whole, rows=(ben, unsafe))))
    places = {"csv": "m.csv", "folders": "f", "moodle": "w.csv", "canvas": "c.csv"}
    for name, place in places.items():
        called = export(out, "--to", name, "-o", tmp_path / place)
        assert called.exit_code == 1
        assert f"1 of 2 marks is unsafe, so nothing is written: `{anna.id}` (late)" in called.output
        assert not (tmp_path / place).exists()
    assert export(out, "--to", "csv", "--despite", "hidden").exit_code == 1
    for name in ("json", "junit", "sarif"):
        assert export(out, "--to", name).exit_code == 0
    assert "late" in (out / "staff" / "exports" / "junit.xml").read_text()

    sheet = tmp_path / "worksheet.csv"
    sheet.write_text(
        "Identifier,Grade,Maximum Grade,Feedback comments\nParticipant 11,,10,\n", "utf-8"
    )
    words = ("--to", "moodle", "--fill", sheet, "-o", tmp_path / "w.csv")
    called = export(out, *words, "--despite", "late")
    assert called.exit_code == 0, called.output
    assert "the export was made despite that" in called.output
    assert f"This mark is not sure yet: {UNTIMED}." in (tmp_path / "w.csv").read_text("utf-8")

    said = ("--reason", "came in time", "--who", "H", "--delta", "0")
    assert change(out, anna.id, *said, "--settles", "hidden").exit_code == 2
    assert change(out, ben.id, *said, "--settles", "all").exit_code == 2
    assert not Layout(out).overrides.exists()
    called = change(out, anna.id, *said)
    assert f"still unsafe: late: {UNTIMED}" in called.output
    called = change(out, anna.id, "--reason", "by mail", *said[2:], "--settles", "all")
    assert called.exit_code == 0, called.output
    assert "still unsafe" not in called.output
    assert 'settles = ["late"]\nprogram = "' in Layout(out).overrides.read_text("utf-8")
    called = export(out, *words)
    assert called.exit_code == 0, called.output
    assert "despite" not in called.output
    assert "not sure" not in (tmp_path / "w.csv").read_text("utf-8")


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (("--to", "moodle"), 1, "V740"),
        (("--to", "csv", "--points", "many"), 2, "no number of points"),
        (("--to", "moodle", "--fill", "nothing.csv"), 2, "cannot read `nothing.csv`"),
        (("--to", "pdf"), 2, "pdf"),
    ],
)
def test_a_wrong_call_says_why(
    marked: Path, words: tuple[str, ...], status: int, said: str
) -> None:
    called = export(marked, *words)
    assert called.exit_code == status
    assert said in called.output


def test_feedback_is_never_made_of_the_staff_s_result(marked: Path) -> None:
    layout = Layout(marked)
    name = class_from_bytes(layout.results.read_bytes()).rows[0].id
    own = layout.student(name) / "result.json"
    data = own.read_bytes()
    own.unlink()
    try:
        called = export(marked, "--to", "folders")
    finally:
        own.write_bytes(data)
    assert called.exit_code == 1
    assert "V749" in called.output


WITH_NAMES = ("marks.csv", "moodle-feedback.zip")


def test_pseudonyms_are_told_to_platforms_only_in_their_own_numbers(tmp_path: Path) -> None:
    download = tmp_path / "download.zip"
    with zipfile.ZipFile(download, "w") as archive:
        name = "Anna Ady_11_assignsubmission_file_/pick.v2"
        archive.writestr(name, (EXAMPLE / "solution.v2").read_bytes())
    out = tmp_path / "out"
    called = CliRunner().invoke(
        mark_command.command,
        [str(EXAMPLE / "task.toml"), str(download), "-o", str(out), "--no-pages", "--pseudonyms"],
    )
    assert called.exit_code == 0, called.output
    sheet = tmp_path / "w.csv"
    sheet.write_text("Identifier,Grade,Maximum Grade\nParticipant 11,,100\n", "utf-8")
    formats = ("moodle", "moodle-feedback", "csv", "gradescope", "junit", "folders")
    called = export(out, "--fill", sheet, *(word for name in formats for word in ("--to", name)))
    assert called.exit_code == 0, called.output
    folder = out / "staff" / "exports"
    assert "Participant 11,100,100" in (folder / "moodle-worksheet.csv").read_text("utf-8")
    with zipfile.ZipFile(folder / "moodle-feedback.zip") as archive:
        assert archive.namelist() == ["Anna Ady_11_assignsubmission_file_/feedback.txt"]
        assert b"Anna" not in archive.read(archive.namelist()[0])
    for path in folder.rglob("*"):
        if path.is_file():
            assert (b"Anna" in path.read_bytes()) == (path.name in WITH_NAMES)


@pytest.mark.parametrize("name", ["..", "../students", "a/b", "a\\b", "C:", ""])
def test_an_id_leads_nowhere_else(marked: Path, name: str) -> None:
    assert not is_name(name)
    rows = class_from_bytes((marked / "staff" / "results.json").read_bytes())
    changed = replace(rows, rows=(replace(rows.rows[0], id=name),))
    with pytest.raises(Refused):
        write_exports(["folders"], changed, Layout(marked), Options(), tell=list[object]().extend)
