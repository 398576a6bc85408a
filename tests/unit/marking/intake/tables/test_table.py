"""intake.csv: what is written comes back, through spreadsheets too, and edits are obeyed."""

import csv
import io
from collections.abc import Callable
from datetime import UTC, datetime, timedelta, timezone
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.unit.marking.intake.support import DOCX, OTHER, PDF, PICK, put, zipped
from tests.unit.marking.intake.test_cases import ANNA, LATER, METADATA
from vrts.base.source import SourceFile
from vrts.marking.intake.row import Attempt, Kind, Row, Student
from vrts.marking.intake.tables.edited_table import EditedTable, read_rows
from vrts.marking.intake.tables.intake_table import COLUMNS, write_rows
from vrts.marking.intake.tables.table_text import field, table
from vrts.marking.intake.take_in import take_in
from vrts.marking.intake.tree.opening import open_place

FILES = {
    f"{ANNA}/a.v2": PICK,
    f"{ANNA}/b.v2": LATER,
    "Ben Wolf_102_assignsubmission_file_/pick.docx": DOCX,
    "Ben Wolf_102_assignsubmission_file_/report.pdf": PDF,
    "=1+2_103_assignsubmission_file_/work.zip": zipped({"lab/pick.v2": PICK, "home.v2": OTHER}),
    "'t Hooft; Ö_104_assignsubmission_file_/pick.v2": PICK,
    "00123_105_assignsubmission_file_/": b"",
}
ONES = ("utf-8", "utf-8-sig", "cp1252")
CET = timezone(timedelta(hours=1))


@pytest.fixture
def place(tmp_path: Path) -> Path:
    return put(tmp_path / "download", FILES)


def read(place: Path, data: bytes) -> EditedTable:
    with open_place(place) as tree:
        return read_rows(data, "intake.csv", tree, take_in(place, program="pick"))


def edited(place: Path, change: Callable[[dict[str, dict[str, str]]], None]) -> bytes:
    """Return the table of a download after a change to its fields, by id and column."""
    data = write_rows(take_in(place, program="pick").rows)
    lines = list(csv.DictReader(io.StringIO(data.decode("utf-8-sig"), newline="")))
    change({line["id"].lstrip("'"): line for line in lines})
    text = io.StringIO(newline="")
    csv.writer(text).writerows([COLUMNS, *(line.values() for line in lines)])
    return text.getvalue().encode()


def row_of(place: Path, data: bytes, identifier: str) -> Row:
    rows, diagnostics = read(place, data)
    assert rows is not None, diagnostics
    return next(row for row in rows if row.identifier == identifier)


# what is written comes back


@pytest.mark.parametrize("delimiter", [",", ";"])
def test_a_table_that_nobody_edited_says_what_the_intake_says(place: Path, delimiter: str) -> None:
    rows = take_in(place, program="pick").rows
    assert read(place, write_rows(rows, delimiter)) == (rows, ())


def test_a_table_of_attempts_and_times_comes_back(tmp_path: Path) -> None:
    files = {"submission_metadata.yml": METADATA, "submission_8/a.v2": PICK}
    place = put(tmp_path / "d", {**files, "submission_9/b.v2": LATER, "submission_7/c.v2": PICK})
    rows = take_in(place, program="pick").rows
    assert len(rows[1].attempts) == 2
    assert read(place, write_rows(rows)) == (rows, ())


@pytest.mark.parametrize("encoding", [*ONES, "utf-16", "utf-16-le", "utf-16-be"])
@pytest.mark.parametrize("delimiter", [",", ";", "\t"])
def test_a_table_may_be_saved_by_any_spreadsheet(
    place: Path, encoding: str, delimiter: str
) -> None:
    rows = take_in(place, program="pick").rows
    text = io.StringIO(newline="")
    data = write_rows(rows).decode("utf-8-sig")
    csv.writer(text, delimiter=delimiter).writerows(csv.reader(io.StringIO(data, newline="")))
    assert read(place, text.getvalue().encode(encoding)) == (rows, ())
    named = f"sep={delimiter}\r\n{text.getvalue()}"
    assert read(place, named.encode(encoding)) == (rows, ())


def test_a_workbook_is_named_as_one(place: Path) -> None:
    rows, (found,) = read(place, zipped({"xl/workbook.xml": b"<x/>"}))
    assert rows is None
    assert found.headline == "`intake.csv` is a workbook, and no table of text"
    assert found.help == ("save it as `CSV UTF-8`",)


def test_no_field_is_a_formula_or_changed_by_a_spreadsheet(place: Path) -> None:
    data = write_rows(take_in(place, program="pick").rows).decode("utf-8-sig")
    fields = [text for line in csv.reader(io.StringIO(data, newline="")) for text in line]
    assert "'=1+2" in fields
    assert "'00123" in fields
    assert not any(text.lstrip().startswith(("=", "+", "-", "@", "\t")) for text in fields)
    assert not any(text.isdigit() for text in fields)


@given(st.lists(st.text(), min_size=1, max_size=5))
def test_any_text_comes_back(texts: list[str]) -> None:
    texts = [text.replace("\r\n", "\n").replace("\r", "\n") for text in texts]
    line = ";".join(["id", *map(field, texts)])
    assert [cell.text for cell in table(SourceFile("t", f"id;x\n{line}"), ["id", "x"])[1]] == [
        "id",
        *texts,
    ]


@given(st.from_regex(r"[ '=+@-]{0,4}[0-9a-zA-Z.:/ -]{0,8}", fullmatch=True))
def test_marks_come_back(text: str) -> None:
    (row,) = table(SourceFile("t", f"x,{field(text)}"), ["x"])
    assert row[1].text == text


@pytest.mark.parametrize(
    "text", ["3-4", "1E5", "MAR1", "1/2", "0012", "12.5", "TRUE", "5 Okt", "-7"]
)
def test_what_a_spreadsheet_would_convert_is_marked(text: str) -> None:
    assert field(text).strip('"') == f"'{text}"


# edits are obeyed


def test_another_file_settles_what_was_ambiguous(place: Path) -> None:
    def choose(lines: dict[str, dict[str, str]]) -> None:
        assert lines["Anna-Berger-101"]["problem"].startswith("ambiguous: 2 files fit")
        lines["Anna-Berger-101"]["file"] = f"{ANNA}/b.v2"

    row = row_of(place, edited(place, choose), "Anna-Berger-101")
    assert (row.file, row.problem) == (f"{ANNA}/b.v2", None)
    assert row.attempts == (Attempt(f"{ANNA}/b.v2", None),)


def test_another_member_of_a_zip(place: Path) -> None:
    zip_file = "=1+2_103_assignsubmission_file_/work.zip"

    def choose(lines: dict[str, dict[str, str]]) -> None:
        lines["1-2-103"]["file"] = f"{zip_file}!home.v2"

    assert row_of(place, edited(place, choose), "1-2-103").file == f"{zip_file}!home.v2"


def test_a_document_stays_a_problem_whatever_the_table_says(place: Path) -> None:
    def clear(lines: dict[str, dict[str, str]]) -> None:
        lines["Ben-Wolf-102"]["problem"] = ""

    row = row_of(place, edited(place, clear), "Ben-Wolf-102")
    assert row.problem is not None
    assert row.problem.kind is Kind.NOT_TEXT


@pytest.mark.parametrize("identifier", ["Anna-Berger-101", "t-Hooft-Ö-104", "00123-105"])
@pytest.mark.parametrize("word", ["excused", "Excused: in hospital"])
def test_excused_with_a_program_or_without(place: Path, word: str, identifier: str) -> None:
    def excuse(lines: dict[str, dict[str, str]]) -> None:
        lines[identifier]["problem"] = word

    problem = row_of(place, edited(place, excuse), identifier).problem
    assert problem is not None
    assert problem.kind is Kind.EXCUSED
    assert problem.sentence == ("in hospital" if ":" in word else "excused by the teacher")


def test_another_id_an_own_deadline_and_ids_of_platforms(place: Path) -> None:
    def change(lines: dict[str, dict[str, str]]) -> None:
        line = lines["t-Hooft-Ö-104"]
        line.update(id="hooft", due="2026-12-01T12:00+01:00", ids="moodle 104; sis 00017")
        line.update(received="2026-11-30 23:00:00Z", late="yes")

    row = row_of(place, edited(place, change), "hooft")
    assert row.due == datetime(2026, 12, 1, 12, tzinfo=CET)
    assert row.received == datetime(2026, 11, 30, 23, tzinfo=UTC)
    assert (row.flagged, row.late, row.called_late) == (None, True, True)
    assert row.student == Student("'t Hooft; Ö", ids={"moodle": "104", "sis": "00017"})


def test_columns_may_be_missing_or_more_and_in_any_order(place: Path) -> None:
    data = f"note;problem;FILE;id\nhm;;{ANNA}/a.v2;anna\n;;;\n".encode("cp1252")
    rows, _ = read(place, data)
    assert rows is not None
    assert (rows[0].identifier, rows[0].file) == ("anna", f"{ANNA}/a.v2")


CANVAS = {
    "bergeranna_31_901_pick.v2": PICK,
    "wolfben_LATE_32_902_pick.v2": PICK,
    "cobbcara_33_903_report.pdf": PDF,
    "mailed.v2": PICK,
}


def late_of(place: Path, **cells: str) -> tuple[bool | None, bool | None]:
    """Return what is known of the lateness of Anna after an edit: by the platform, and in all."""

    def change(lines: dict[str, dict[str, str]]) -> None:
        lines["bergeranna-31"].update(cells)

    row = row_of(place, edited(place, change), "bergeranna-31")
    return row.flagged, row.called_late


def test_what_canvas_does_not_call_late_is_on_time_if_it_came_through_canvas(
    tmp_path: Path,
) -> None:
    place = put(tmp_path / "d", CANVAS)
    rows = take_in(place, program="pick").rows
    assert [row.called_late for row in rows] == [False, False, True]
    assert read(place, write_rows(rows)) == (rows, ())
    assert late_of(place) == (False, False)
    assert late_of(place, file="mailed.v2") == (None, None)
    assert late_of(place, file="mailed.v2", late="no") == (None, False)
    assert late_of(place, file="wolfben_LATE_32_902_pick.v2") == (True, True)
    assert late_of(place, late="yes") == (False, True)


def test_no_and_yes_come_back(tmp_path: Path) -> None:
    place = put(tmp_path / "d", CANVAS)
    rows, _ = read(place, line(id="anna", file="mailed.v2", late="no", ids="canvas 31"))
    assert rows is not None
    assert rows[0].called_late is False
    assert read(place, write_rows(rows)).rows == rows


# what is wrong is told where it stands


def line(**cells: str) -> bytes:
    columns = dict.fromkeys(("id", "file", "problem", "received", "late", "due", "ids"), "")
    columns.update({"id": "anna", "file": f"{ANNA}/a.v2"}, **cells)
    return f"{','.join(columns)}\n{','.join(columns.values())}\n".encode()


FAULTS = {
    "no column": (
        b"id,problem\nanna,\n",
        "V700",
        "`intake.csv` has no column `file`",
        "id,problem",
    ),
    "nothing": (b"", "V700", "`intake.csv` has no column `id`, `file`, `problem`", ""),
    "no id": (line(id=""), "V701", "a row has no id", ""),
    "an id that is a path": (line(id="../x"), "V701", "`../x` cannot be an id", "../x"),
    "an id that is a device": (line(id="NUL"), "V701", "`NUL` cannot be an id", "NUL"),
    "an id twice": (
        line() + line(id="ANNA").split(b"\n")[1],
        "V701",
        "two rows have the id `ANNA`",
        "ANNA",
    ),
    "no such file": (
        line(file=f"{ANNA}/c.v2"),
        "V702",
        f"there is no file `{ANNA}/c.v2` in the download",
        f"{ANNA}/c.v2",
    ),
    "a file elsewhere": (
        line(file="/etc/passwd"),
        "V702",
        "there is no file `/etc/passwd` in the download",
        "/etc/passwd",
    ),
    "nothing chosen": (line(file=""), "V703", "a row names neither a file nor a problem", ""),
    "an unknown problem": (line(problem="exused"), "V704", "unknown problem `exused`", "exused"),
    "a time without zone": (
        line(received="2026-11-30 23:59"),
        "V705",
        "`received` must be a time with its offset from UTC",
        "2026-11-30 23:59",
    ),
    "a date as people write it": (
        line(due="30.11.2026"),
        "V705",
        "`due` must be a time with its offset from UTC",
        "30.11.2026",
    ),
    "perhaps late": (line(late="maybe"), "V705", "`late` must be `yes`, `no` or empty", "maybe"),
    "an id of nobody": (line(ids="17"), "V705", "`17` is no id of a platform", "17"),
}


@pytest.mark.parametrize("title", FAULTS)
def test_faults_are_told_where_they_stand(title: str, place: Path) -> None:
    data, code, headline, text = FAULTS[title]
    rows, diagnostics = read(place, data)
    assert rows is None
    (found,) = (d for d in diagnostics if d.is_error)
    assert (found.rule.code, found.headline) == (code, headline)
    assert found.help
    assert found.primary is not None
    assert found.primary.span.text == text


def test_close_names_and_lost_letters_are_told(place: Path) -> None:
    name = "'t Hooft; ?_104_assignsubmission_file_/pick.v2"
    (found,) = (d for d in read(place, line(file=name)).diagnostics if d.is_error)
    assert found.help == (
        "letters were lost: save the table as `CSV UTF-8`",
        f"did you mean `{name.replace('?', 'Ö')}`?",
    )


def test_a_table_of_another_download_is_told_once(place: Path) -> None:
    header, row = line(file="x/a.v2").decode().splitlines()
    other = row.replace("anna", "ben").replace("a.v2", "b.v2")
    rows, (found,) = read(place, f"{header}\n{row}\n{other}\n".encode())
    assert rows is None
    assert found.rule.code == "V790"
    assert found.headline == (
        "`intake.csv` is not about this download: none of its 2 files is in it"
    )
    mine = row.replace("anna", "carl").replace("x/a.v2", f"{ANNA}/a.v2")
    diagnostics = read(place, f"{header}\n{row}\n{other}\n{mine}\n".encode()).diagnostics
    assert [d.rule.code for d in diagnostics if d.is_error] == ["V702", "V702"]


def test_hand_ins_that_came_later_are_told(place: Path) -> None:
    rows, diagnostics = read(place, line(id="00123-105"))
    assert rows is not None
    assert [row.identifier for row in rows] == [
        "00123-105",
        "1-2-103",
        "Ben-Wolf-102",
        "t-Hooft-Ö-104",
    ]
    (found,) = diagnostics
    assert found.rule.code == "V706"
    assert found.headline == "3 hand-ins are in the download, but not in the table"
    assert "`Ben-Wolf-102`" in found.notes[0]
    assert "Anna" not in found.notes[0]
