"""Lists of a class: who is missing, what the platform knows of each, and when work came."""

from datetime import UTC, datetime, timedelta, timezone
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from tests.unit.marking.intake.support import PICK, put
from tests.unit.marking.intake.test_cases import ANNA
from vrts.marking.intake.row import Kind, Platform, Student
from vrts.marking.intake.tables.local_time import local_time
from vrts.marking.intake.tables.roster import read_roster
from vrts.marking.intake.take_in import take_in
from vrts.pipeline.files import CannotRead

CET = timezone(timedelta(hours=1))
WORKSHEET = (
    "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Grade can be changed,"
    "Last modified (submission),Last modified (grade),Feedback comments\r\n"
    'Participant 101,"Anna Berger",anna@uni.at,"Submitted for grading",,10.00,Yes,'
    '"Monday, 30 November 2026, 11:58 PM","Tuesday, 1 December 2026, 8:00 AM",\r\n'
    "Participant 102,Ben Wolf,ben@uni.at,No submission,,10.00,Yes,-,-,\r\n"
).encode("utf-8-sig")
GERMAN = (
    "ID;Vollständiger Name;E-Mail-Adresse;Status;Bewertung;Zuletzt geändert (Abgabe)\r\n"
    "Teilnehmer/in101;Anna Berger;anna@uni.at;Abgegeben;;Montag, 30. November 2026, 23:58\r\n"
).encode("cp1252")
GRADE_BOOK = (
    b"Student,ID,SIS User ID,SIS Login ID,Section,Lab 1 (77)\r\n"
    b"    Points Possible,,,,,10\r\n"
    b'"Berger, Anna",31,00123,anna,A,\r\n'
    b'"Wolf, Ben",32,00124,ben,A,\r\n'
)


def test_a_worksheet_of_moodle_tells_addresses_times_and_who_is_missing(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})
    anna, ben = take_in(place, program=None, roster=read_roster(WORKSHEET, "w.csv", CET)).rows
    assert anna.student == Student("Anna Berger", "anna@uni.at", ids={"moodle": "101"})
    assert anna.received == datetime(2026, 11, 30, 23, 58, tzinfo=CET)
    assert ben.identifier == "Ben-Wolf-102"
    assert ben.problem is not None
    assert ben.problem.kind is Kind.MISSING
    assert ben.received is None


def test_who_handed_in_by_the_list_and_has_no_file_is_told(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {"Ben Wolf_102_assignsubmission_file_/pick.v2": PICK})
    found = take_in(place, program=None, roster=read_roster(WORKSHEET, "w.csv", CET))
    (said,) = found.remarks
    assert said.startswith("`Anna Berger`: the list of the class tells when their work came, and ")
    whole = put(tmp_path / "e", {f"{ANNA}/pick.v2": PICK})  # Ben has handed in nothing
    assert not take_in(whole, program=None, roster=read_roster(WORKSHEET, "w.csv", CET)).remarks


@pytest.mark.parametrize(
    ("data", "file"),
    [(WORKSHEET, f"{ANNA}/pick.v2"), (GRADE_BOOK, "bergeranna_31_901_pick.v2")],
    ids=["Moodle", "Canvas"],
)
def test_a_list_does_not_change_identifiers(data: bytes, file: str, tmp_path: Path) -> None:
    place = put(tmp_path / "d", {file: PICK})
    (row,) = take_in(place, program=None).rows
    rows = take_in(place, program=None, roster=read_roster(data, "l.csv", CET)).rows
    assert row.identifier in [row.identifier for row in rows if row.problem is None]


def test_a_worksheet_in_another_language(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})
    (anna,) = take_in(place, program=None, roster=read_roster(GERMAN, "w.csv", CET)).rows
    assert anna.received == datetime(2026, 11, 30, 23, 58, tzinfo=CET)
    assert anna.student.email == "anna@uni.at"


@pytest.mark.parametrize(
    "status", ["Draft (not submitted)", "Entwurf (nicht abgegeben)", "Draft (not submitted) - "]
)
def test_a_draft_was_not_submitted_when_it_was_changed_last(status: str, tmp_path: Path) -> None:
    """Taken for a hand-in in time, it would get a mark that nobody had looked at."""
    place = put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})
    data = WORKSHEET.replace(b'"Submitted for grading"', f'"{status}"'.encode())
    found = take_in(place, program=None, roster=read_roster(data, "w.csv", CET))
    assert found.rows[0].received is None
    assert found.remarks == ("what `w.csv` has of `Anna Berger` is a draft and was not submitted",)


def test_a_name_or_a_comment_makes_no_draft(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})
    data = WORKSHEET.replace(b"Anna Berger", b"Draft (Anna) Berger")
    data = data.replace(b'2026, 8:00 AM",', b'2026, 8:00 AM","Draft (see page 2)"')
    anna, _ = take_in(place, program=None, roster=read_roster(data, "w.csv", CET)).rows
    assert anna.received == datetime(2026, 11, 30, 23, 58, tzinfo=CET)


def test_times_without_a_zone_do_not_count(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})
    found = take_in(place, program=None, roster=read_roster(WORKSHEET, "w.csv", None))
    assert found.rows[0].received is None
    words = "the times in `w.csv` have no zone, so they do not count: give one with `--zone`"
    assert found.remarks == (words,)


def test_a_grade_book_of_canvas_tells_names_logins_and_who_is_missing(tmp_path: Path) -> None:
    files = {"bergeranna_31_901_pick.v2": PICK, "guest_99_902_pick.v2": PICK}
    place = put(tmp_path / "d", files)
    found = take_in(place, program=None, roster=read_roster(GRADE_BOOK, "g.csv", None))
    ben, anna, guest = found.rows
    assert anna.student == Student("Berger, Anna", "", "anna", {"canvas": "31", "sis": "00123"})
    assert ben.problem is not None
    assert ben.identifier == "Wolf-Ben-32"
    assert guest.problem is None
    assert found.remarks == ("`guest 99` is not in the list of the class",)


def test_a_list_of_another_platform_is_not_used(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {f"{ANNA}/pick.v2": PICK})
    found = take_in(place, program=None, roster=read_roster(GRADE_BOOK, "g.csv", None))
    assert [row.identifier for row in found.rows] == ["Anna-Berger-101"]
    assert found.remarks[0] == (
        "the list of the class is not used: nobody whose work is here is in it"
    )


@pytest.mark.parametrize("data", [b"", b"a,b\n1,2\n", PICK])
def test_what_is_no_list_is_told(data: bytes) -> None:
    with pytest.raises(CannotRead, match=r"`x\.csv` is no list of a class"):
        read_roster(data, "x.csv", UTC)


@pytest.mark.parametrize(
    ("text", "time"),
    [
        ("Tuesday, 21 October 2025, 3:45 PM", (10, 21, 15, 45)),
        ("Tuesday, 21 October 2025, 12:05\u202fAM", (10, 21, 0, 5)),
        ("Tuesday, October 21, 2025, 12:45 PM", (10, 21, 12, 45)),
        ("Dienstag, 21. Oktober 2025, 15:45", (10, 21, 15, 45)),
        ("Sonntag, 1. März 2025, 08:01", (3, 1, 8, 1)),
        ("mardi 21 octobre 2025, 15:45", (10, 21, 15, 45)),
        ("samedi 1 juin 2025, 15:45", (6, 1, 15, 45)),
        ("samedi 1 juillet 2025, 15:45", (7, 1, 15, 45)),
        ("martes, 21 de octubre de 2025, 15:45", (10, 21, 15, 45)),
        ("martedì, 21 ottobre 2025, 15:45", (10, 21, 15, 45)),
        ("-", None),
        ("31 Nonsense 2025, 10:00", None),
        ("31 February 2025, 10:00", None),
        ("2025", None),
    ],
)
def test_local_times(text: str, time: tuple[int, int, int, int] | None) -> None:
    expected = None if time is None else datetime(2025, *time, tzinfo=CET)
    assert local_time(text, CET) == expected


def test_times_are_of_the_zone_in_its_season() -> None:
    vienna = ZoneInfo("Europe/Vienna")
    summer = local_time("Tuesday, 21 July 2026, 3:45 PM", vienna)
    winter = local_time("Tuesday, 21 January 2026, 3:45 PM", vienna)
    assert summer == datetime(2026, 7, 21, 13, 45, tzinfo=UTC)
    assert winter == datetime(2026, 1, 21, 14, 45, tzinfo=UTC)


def test_ids_of_a_plain_table_are_not_taken_for_those_of_moodle() -> None:
    found = read_roster(b"id,name,email\nm00004,Ann,ann@uni.at\nk123,Ben,ben@uni.at\n", "l", None)
    assert found.platform is Platform.SIS
    assert list(found.members) == ["m00004", "k123"]


@pytest.mark.parametrize(
    "data",
    [
        b"id,name,email\n7,Ann,ann@uni.at\n7,Ben,ben@uni.at\n",
        WORKSHEET + b"Participant 101,Ben Wolf,b@uni.at,No submission,,10.00,Yes,-,-,\r\n",
        GRADE_BOOK + b'"Wolf, Ben",31,00125,benw,A,\r\n',
        "id,name\nJ\u00f6,Ann\nJo\u0308,Ben\n".encode(),
    ],
    ids=["plain", "Moodle", "Canvas", "letters written otherwise"],
)
def test_nobody_vanishes_behind_somebody_with_the_same_id(data: bytes) -> None:
    with pytest.raises(CannotRead, match=r"more than once: `.*Ann.*` and"):
        read_roster(data.replace(b"Berger, Anna", b"Anna B"), "list.csv", None)


def test_a_line_that_is_there_twice_is_one() -> None:
    twice = GRADE_BOOK + b'"Wolf, Ben",32,00124,ben,A,\r\n'
    assert list(read_roster(twice, "list.csv", None).members) == ["31", "32"]


def test_whoever_cannot_be_told_is_not_left_out() -> None:
    with pytest.raises(CannotRead, match="`Ben` in `l` has neither an id nor an address"):
        read_roster(b"id,name,email\n7,Ann,a@uni.at\n,Ben,\n", "l", None)
    found = read_roster(b"id,name,email\n7,,a@uni.at\n,,\n", "l", None)
    assert found.members["7"].student.name == "7"


def test_a_hand_in_by_a_name_that_two_may_mean_is_nobodys(tmp_path: Path) -> None:
    place = put(tmp_path / "d", {"id-ab/pick.v2": PICK, "id-c/pick.v2": PICK})
    data = b"id,name,email\nab,Ann,\nAB,Ben,\nc,Cid,\n"
    found = take_in(place, program=None, roster=read_roster(data, "l", None))
    assert "`id-ab` is not in the list of the class" in found.remarks
    assert [row.student.name for row in found.rows if row.file] == ["id-ab", "Cid"]


def test_any_list_may_tell_when_work_came() -> None:
    head, ann = b"id,name,email,received\n", b"7,Ann,a@uni.at,"
    told = {
        b"2026-11-30T23:58:00+01:00": datetime(2026, 11, 30, 23, 58, tzinfo=CET),
        b"2026-11-30 23:58": datetime(2026, 11, 30, 23, 58, tzinfo=CET),
        b"": None,
    }
    for text, time in told.items():
        found = read_roster(head + ann + text + b"\n", "l", CET)
        assert found.members["7"].received == time
        assert found.remarks == ()
    odd = read_roster(head + ann + b"yesterday\n", "l", CET)
    assert odd.members["7"].received is None
    assert odd.remarks[0].startswith("no times in the column `received` of `l`: `yesterday`;")
    assert "have no zone" in read_roster(head + ann + b"2026-11-30 23:58\n", "l", None).remarks[0]
    book = GRADE_BOOK.replace(b"(77)\r", b"(77),received\r").replace(
        b"anna,A,", b"anna,A,,2026-11-30T23:58:00+01:00"
    )
    assert read_roster(book, "b", None).members["31"].received == told[b"2026-11-30 23:58"]


def test_the_time_of_a_list_is_that_of_the_latest_attempt(tmp_path: Path) -> None:
    files = {f"ann@uni.at/attempt-{k}/pick.v2": PICK for k in (1, 2)}
    data = b"name,email,received\nAnn,ann@uni.at,2026-11-30T23:58:00+01:00\n"
    place = put(tmp_path / "d", files)
    (row,) = take_in(place, program=None, roster=read_roster(data, "l", None)).rows
    assert [one.received is None for one in row.attempts] == [True, False]
    assert row.received is not None
