"""Moodle's grading worksheet: marks and comments in, every other byte as it was."""

import csv
import io
from fractions import Fraction

import msgspec
import pytest
from hypothesis import given as of_any

from tests.support_exports import HOSTILE, SECRET, given, hostile, result, row, rows, secret
from vrts.base.written_numbers import parsed
from vrts.marking.exports.given import Given, Options, Page, Product
from vrts.marking.exports.grade_books.moodle import moodle
from vrts.marking.result import Kind
from vrts.marking.row import Row, Student
from vrts.pipeline.refused import Refused

HEADER = (
    'Identifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed",'
    '"Last modified (submission)","Last modified (grade)","Feedback comments"'
)
DATE = '"Monday, 2 November 2026, 10:15 AM"'


def english(*people: tuple[str, str, str], full: str = "100.00", can: str = "Yes") -> str:
    """Return a worksheet: number, name, grade of each."""
    lines = [
        f'"Participant {number}","{name}",{number}@example.org,"Submitted for grading",'
        f"{grade},{full},{can},{DATE},-,"
        for number, name, grade in people
    ]
    return "\r\n".join([HEADER, *lines, ""])


def student(number: str, mark: float | None = 8.5, name: str = "") -> Row:
    kind = Kind.GRADED if mark is not None else Kind.MISSING
    return row(f"s{number}", mark, kind=kind, student=Student(name, ids={"moodle": number}))


def filled(sheet: str | bytes, one: Given, **how: object) -> Product:
    data = sheet if isinstance(sheet, bytes) else sheet.encode()
    return moodle(one, Options(fill=Page("worksheet.csv", data))._replace(**how))


def text(product: Product, codec: str = "utf-8") -> str:
    ((name, data),) = product.files
    assert name == "moodle-worksheet.csv"
    return data.decode(codec)


def codes(product: Product) -> list[str]:
    return [d.rule.code for d in product.diagnostics]


def test_only_the_grade_changes_without_comments() -> None:
    sheet = english(("11", "Anna Ady", ""), ("12", "Ben Bär", ""))
    found = filled(sheet, given([student("12", 7.3), student("11", 10.0)]), comments=False)
    expected = sheet.replace('grading",,', 'grading",100.00,', 1).replace(
        'grading",,', 'grading",73.00,', 1
    )
    assert text(found) == expected
    assert found.diagnostics == ()


def test_comments_are_html_in_the_column_for_comments() -> None:
    found = filled(english(("11", "Anna", "")), given([student("11")]))
    (line,) = csv.DictReader(io.StringIO(text(found), newline=""))
    assert line["Grade"] == "85.00"
    assert line["Feedback comments"].startswith("<p>Final mark: 8.5 of 10</p>")
    assert "<code>can1</code>" in line["Feedback comments"]


def test_a_comment_of_the_teacher_s_is_kept_and_one_of_ours_renewed() -> None:
    sheet = english(("11", "Anna", ""), ("12", "Ben", "")).split("\r\n")
    sheet[1] += "come and see me"
    sheet[2] += "<p>Final mark: 1.0 of 10</p>"
    found = filled("\r\n".join(sheet), given([student("11"), student("12")]))
    comments = [line["Feedback comments"] for line in csv.DictReader(io.StringIO(text(found)))]
    assert comments[0] == "come and see me"
    assert comments[1].startswith("<p>Final mark: 8.5 of 10</p>")


def test_nothing_hidden_gets_into_comments() -> None:
    public = result("s11")
    one = msgspec.structs.replace(student("11", 6.0), result=secret(public, 6.0))
    found = filled(english(("11", "Anna", "")), given([one], {"s11": public}))
    assert "60.00" in text(found)
    assert SECRET not in text(found)


GERMAN = (
    "ID;Vollständiger Name;E-Mail-Adresse;Status;Bewertung;Bestwertung;"
    "Bewertung kann geändert werden;Zuletzt geändert (Abgabe);Zuletzt geändert (Bewertung);"
    "Feedback als Kommentar\n"
    "Teilnehmer/in11;Ömer Çelik;o@example.org;Abgegeben;;15,00;Ja;-;-;\n"
    "Teilnehmer/in12;Eva;e@example.org;Abgegeben;3,00;15,00;Nein;-;-;\n"
)


@pytest.mark.parametrize(
    ("codec", "mark"),
    [("utf-8", b""), ("utf-8", b"\xef\xbb\xbf"), ("utf-16-le", b"\xff\xfe"), ("cp1252", b"")],
)
def test_a_german_worksheet_keeps_its_delimiter_comma_encoding_and_line_ends(
    codec: str, mark: bytes
) -> None:
    sheet = GERMAN.replace("Ç", "C") if codec == "cp1252" else GERMAN
    found = filled(
        mark + sheet.encode(codec), given([student("11"), student("12")]), comments=False
    )
    ((_, data),) = found.files
    assert data == mark + sheet.replace("Abgegeben;;", "Abgegeben;12,75;").encode(codec)
    assert codes(found) == ["V746"]
    assert found.diagnostics[0].notes == ("`Eva`: the grade is locked in Moodle",)


def test_a_lock_is_found_behind_the_state_of_marking_too() -> None:
    sheet = (
        "Identifier,Grade,Maximum grade,Marking workflow state,Grade can be changed\n"
        "Participant 11,,100,Not marked,No\n"
        "Participant 12,,100,Not marked,Yes\n"
    )
    found = filled(sheet, given([student("11"), student("12")]))
    assert text(found) == sheet.replace("12,,", "12,85,")
    assert codes(found) == ["V746"]


def test_a_decimal_comma_between_commas_is_quoted() -> None:
    sheet = 'ID,Bewertung,Bestwertung\r\nTeilnehmer/in11,,"100,00"\r\n'
    found = filled(sheet, given([student("11", 7.3)]))
    assert text(found) == sheet.replace("11,,", '11,"73,00",')


def test_full_marks_are_those_of_each_row() -> None:
    sheet = english(("11", "Anna", "")) + english(("12", "Ben", ""), full="30").split("\r\n", 1)[1]
    lines = text(filled(sheet, given([student("11"), student("12")]))).split("\r\n")
    assert lines[1].split(",")[4] == "85.00"
    assert lines[2].split(",")[4] == "25.50"


def test_points_on_the_command_line_come_first() -> None:
    found = filled(english(("11", "Anna", "")), given([student("11")]), points=Fraction(20))
    assert ",17.00,100.00," in text(found)


@pytest.mark.parametrize("full", ["Excellent, Good", ""])
def test_a_scale_has_no_points(full: str) -> None:
    sheet = english(("11", "Anna", ""), full=f'"{full}"')
    with pytest.raises(Refused) as refused:
        filled(sheet, given([student("11")]))
    assert [d.rule.code for d in refused.value.diagnostics] == ["V742"]


def test_students_are_found_by_number_then_address_then_name() -> None:
    people = (("11", "Anna Ady", ""), ("12", "Ben Bär", ""), ("13", "Çelik Ömer", ""))
    found = filled(
        english(*people, ("14", "Nobody", "")),
        given(
            [
                student("11", 1.0, "somebody else"),
                row("x", 2.0, student=Student("Ben", "12@EXAMPLE.org")),
                row("y", 3.0, student=Student("omer celik")),
                row("z", 4.0, student=Student("Zoe")),
            ]
        ),
    )
    grades = [line["Grade"] for line in csv.DictReader(io.StringIO(text(found)))]
    assert grades == ["10.00", "20.00", "30.00", ""]
    assert codes(found) == ["V743", "V744", "V745"]
    assert [d.notes for d in found.diagnostics] == [
        ("`Zoe` (`z`)",),
        ("`Nobody`",),
        ("`Çelik Ömer` is `omer celik` (`y`)",),
    ]


def test_two_of_one_name_and_ids_that_contradict_are_nobody() -> None:
    people = (("11", "Anna Ady", ""), ("12", "Anna Ady", ""), ("13", "Ben", ""))
    found = filled(
        english(*people),
        given([row("x", 2.0, student=Student("Anna Ady")), student("99", 3.0, "Ben")]),
    )
    assert [line["Grade"] for line in csv.DictReader(io.StringIO(text(found)))] == ["", "", ""]
    assert codes(found) == ["V743", "V744"]


def test_no_mark_is_no_zero_and_another_mark_is_told() -> None:
    sheet = english(("11", "Anna", "50.00"), ("12", "Ben", "40.00"))
    found = filled(sheet, given([student("11", None), student("12")]))
    grades = [line["Grade"] for line in csv.DictReader(io.StringIO(text(found)))]
    assert grades == ["50.00", "85.00"]
    assert [(d.rule.code, d.notes) for d in found.diagnostics] == [
        ("V746", ("`Anna`: no mark: missing",)),
        ("V747", ("`Ben`: `40.00` by 85.00",)),
    ]
    assert codes(filled(text(found), given([student("12")]))) == ["V744"]


@pytest.mark.parametrize(
    ("sheet", "code"),
    [
        (None, "V740"),
        (b"", "V740"),
        (b"a,b\n1,2\n", "V740"),
        (b"PK\x03\x04" + bytes(200), "V740"),
        (b"Identifier,Punkte\nParticipant 1,\n", "V741"),
        (b"Identifier,Grade,Grade\nParticipant 1,,\n", "V741"),
    ],
)
def test_what_is_no_worksheet_is_refused(sheet: bytes | None, code: str) -> None:
    page = None if sheet is None else Page("a.csv", sheet)
    with pytest.raises(Refused) as refused:
        moodle(given([student("1")]), Options(fill=page))
    assert [d.rule.code for d in refused.value.diagnostics] == [code]


def test_a_column_of_an_unknown_title_is_named() -> None:
    sheet = "Identifiant,Punkte,Max\nParticipant 1,,20\n"
    assert text(filled(sheet, given([student("1")]), column="punkte")) == (
        "Identifiant,Punkte,Max\nParticipant 1,17,20\n"
    )


@pytest.mark.parametrize("words", HOSTILE)
def test_hostile_names_and_words_stay_in_their_fields(words: str) -> None:
    name = words.replace('"', '""').encode(errors="replace").decode()
    one = hostile(words, 11)
    found = filled(english(("11", name, ""), ("12", name, "")), given([one]))
    lines = list(csv.reader(io.StringIO(text(found), newline="")))
    assert {len(line) for line in lines} == {10}
    assert [line[4] for line in lines[1:]] == ["41.00", ""]
    assert lines[1][9].startswith("<p>")
    assert [line[1] for line in lines[1:]] == [words.encode(errors="replace").decode()] * 2


@of_any(found=rows())
def test_the_marks_of_any_class_come_back(found: tuple[Row, ...]) -> None:
    people = [(one.student.ids["moodle"], "A", "") for one in found] or [("1", "A", "")]
    sheet = english(*people, full="30")
    lines = list(csv.DictReader(io.StringIO(text(filled(sheet, given(found))), newline="")))
    for line, one in zip(lines, found, strict=bool(found)):
        final = one.exact_final
        assert parsed(line["Grade"]) == (None if final is None else final * 3)
