"""Decimal commas are read and written; a number with two readings is refused, never guessed."""

from fractions import Fraction

import pytest

from tests.support_exports import given, row
from vrts.base.written_numbers import Doubtful, parsed, read_number, tells
from vrts.marking.exports.given import Options, Page
from vrts.marking.exports.grade_books.canvas import canvas
from vrts.marking.exports.grade_books.moodle import moodle
from vrts.marking.exports.marks_table import marks_table
from vrts.marking.row import Row, Student
from vrts.pipeline.refused import Refused

GERMAN = "ID;Vollständiger Name;E-Mail-Adresse;Status;Bewertung;Bestwertung;Bewertung änderbar\r\n"
ENGLISH = GERMAN.replace(";", ",")
BOOK = "Student;ID;SIS User ID;SIS Login ID;Section;Lab 1 (1)\n    Points Possible;;;;;{}\n"


def student() -> Row:
    return row("s11", 8.5, student=Student("Anna", ids={"moodle": "11", "canvas": "11"}))


def worksheet(
    full: str,
    grade: str = "",
    delimiter: str = ";",
    decimal: str = "",
    points: Fraction | None = None,
) -> str:
    head = GERMAN if delimiter == ";" else ENGLISH
    fields = ["Teilnehmer/in11", "Anna", "a@b.at", "Abgegeben", grade, f'"{full}"', "Ja"]
    data = (head + delimiter.join(fields) + "\r\n").encode()
    how = Options(fill=Page("w.csv", data), comments=False, decimal=decimal, points=points)
    ((_, filled),) = moodle(given([student()]), how).files
    return filled.decode().splitlines()[1].split("Abgegeben" + delimiter)[1]


def refused(what: object, *words: object, **more: object) -> str:
    with pytest.raises(Refused) as problem:
        what(*words, **more)  # type: ignore[operator]
    (found,) = problem.value.diagnostics
    return f"{found.rule.code} {found.headline}"


@pytest.mark.parametrize(
    ("text", "point", "value"),
    [
        ("1,5", "", "1.5"),
        ("0,125", "", "0.125"),
        ("1,2345", "", "1.2345"),
        ("1,234", ",", "1.234"),
        ("1,234", ".", "1234"),
        ("1.234", ",", "1234"),
        ("1.234", "", "1.234"),
        ("1.234,50", "", "1234.5"),
        ("1,234.50", "", "1234.5"),
        ("1.234.567,5", ",", "1234567.5"),
        ("100.00", ",", "100"),
        ("-1,5", "", "-1.5"),
    ],
)
def test_numbers_are_read_as_they_are_written(text: str, point: str, value: str) -> None:
    assert read_number(text, point) == Fraction(value)


def test_a_number_with_two_readings_is_doubtful_and_tells_no_sign() -> None:
    with pytest.raises(Doubtful) as doubt:
        read_number("1,234")
    assert doubt.value.values == (1234, Fraction("1.234"))
    assert [tells(t) for t in ("1,234", "8,5", "8.50", "1.234,5", "EX", "7")] == [
        *("", ",", ".", ","),
        *("", ""),
    ]
    assert parsed("1,2,3") is None


def test_worksheets_keep_their_sign_and_whole_numbers_go_by_delimiter_or_wish() -> None:
    assert worksheet("10,00") == '8,50;"10,00";Ja'
    assert worksheet("10") == '8,5;"10";Ja'
    assert worksheet("10", decimal=".") == '8.5;"10";Ja'
    assert worksheet("10", delimiter=",") == '8.5,"10",Ja'
    assert worksheet("10", delimiter=",", decimal=",") == '"8,5","10",Ja'
    assert worksheet("1.000,00") == '850,00;"1.000,00";Ja'
    assert worksheet("10,000", grade="7,25") == '8,500;"10,000";Ja'


def test_full_marks_with_two_readings_are_refused_until_somebody_tells() -> None:
    assert refused(worksheet, "10,000").startswith("V757 `10,000` may be 10000 or 10: nothing")
    assert refused(worksheet, "10.000").startswith("V757")
    assert worksheet("10,000", decimal=",") == '8,500;"10,000";Ja'
    assert worksheet("10,000", delimiter=",", decimal=".") == '8500,"10,000",Ja'


def test_points_alone_do_not_tell_how_a_file_is_written() -> None:
    """Where `1,250` is all that stands there, 1062.5 could become 1062,5 in an English file."""
    for full in ("1,250", "1.250"):
        assert refused(worksheet, full, points=Fraction(1250)).startswith("V757")
    english = worksheet("1,250", delimiter=",", decimal=".", points=Fraction(1250))
    assert english == '1062.5,"1,250",Ja'
    assert worksheet("1,250", decimal=",", points=Fraction(100)) == '85,000;"1,250";Ja'
    book = (BOOK.format('"1,250"') + "Ady;11;;;A;\n").replace(";", ",")
    how = Options(fill=Page("g.csv", book.encode()), points=Fraction(1250))
    assert refused(canvas, given([student()]), how).startswith("V757 `1,250` may be 1250 or 1.25")
    ((_, data),) = canvas(given([student()]), how._replace(decimal=".")).files
    assert data.decode().endswith("Ady,11,,,A,1062.5\n")
    assert refused(canvas, given([student()]), how._replace(decimal=",")).startswith("V758")


def test_a_file_with_both_signs_is_refused_until_somebody_tells() -> None:
    said = refused(worksheet, "100.00", grade="7,5", points=Fraction(100))
    assert said.startswith("V757 the grading worksheet of Moodle has `7,5` and `100.00`: nothing")
    assert worksheet("100.00", grade="7,5", decimal=",").startswith("85,00;")
    assert worksheet("100.00", grade="7,5", decimal=".").startswith("85.00;")


def test_what_stood_there_is_read_as_the_file_writes_it() -> None:
    """1.234 is a thousand in a file with decimal commas: it is replaced by another number."""

    def replaced(grade: str, mark: float) -> list[str]:
        text = GERMAN + f"Teilnehmer/in11;Anna;a@b.at;x;{grade};10,00;Ja\r\n"
        how = Options(fill=Page("w.csv", text.encode()), comments=False)
        one = row("s11", mark, student=Student("Anna", ids={"moodle": "11"}))
        return [d.rule.code for d in moodle(given([one]), how).diagnostics]

    assert replaced("8,50", 8.5) == []
    assert replaced("1.200", 1.2) == ["V747"]


def test_a_wish_against_the_file_is_refused_with_the_reason() -> None:
    said = refused(worksheet, "100.00", delimiter=",", decimal=",")
    assert said.startswith(
        "V758 the grading worksheet of Moodle has decimal points, as in `100.00`"
    )
    assert refused(worksheet, "100,00", decimal=".").startswith("V758")


def test_canvas_gets_commas_only_where_its_book_has_them() -> None:
    def filled(points: str, delimiter: str, decimal: str = "") -> str:
        text = (BOOK.format(points) + "Ady;11;;;A;\n").replace(";", delimiter)
        how = Options(fill=Page("g.csv", text.encode()), decimal=decimal)
        ((_, data),) = canvas(given([student()]), how).files
        return data.decode().splitlines()[2]

    assert filled("10", ",") == "Ady,11,,,A,8.5"
    assert filled("10,0", ";") == filled("10", ";", ",") == "Ady;11;;;A;8,5"
    assert refused(filled, "10", ",", ",").startswith("V758 this grade book of Canvas")
    assert refused(filled, "10.0", ",", ",").startswith("V758")


def test_the_table_takes_any_sign() -> None:
    ((_, data),) = marks_table(given([student()]), Options(decimal=",", delimiter=";")).files
    assert b";8,5;" in data
    ((_, data),) = marks_table(given([student()]), Options(decimal=",")).files
    assert b',"8,5",' in data
    ((_, data),) = marks_table(given([student()]), Options(decimal=".", delimiter=";")).files
    assert b";8.5;" in data
