"""The grade book of Canvas: one column filled in, every other byte as it was."""

import csv
import io

import pytest
from hypothesis import given as of_any

from tests.support_exports import HOSTILE, given, hostile, row, rows
from vrts.base.written_numbers import parsed
from vrts.marking.exports.given import Given, Options, Page, Product
from vrts.marking.exports.grade_books.canvas import canvas
from vrts.marking.result import Kind
from vrts.marking.row import Row, Student
from vrts.pipeline.refused import Refused

BOOK = (
    "Student,ID,SIS User ID,SIS Login ID,Section,Notes,Lab 1 (4711),Lab 2 (4712),"
    "Labs Current Score,Final Score\r\n"
    ",,,,,,Manual Posting,,,\r\n"
    "    Points Possible,,,,,,15.00,20.00,(read only),(read only)\r\n"
    '"Ady, Anna",501,M100,anna1,"A, B",,,3.5,70.1,70.1\r\n'
    '"Bär, Ben",502,M101,ben2,A,n,EX,,,\r\n'
    '"Celik, Omer",503,M102,omer3,A,,N/A,,,\r\n'
    '"Student, Test",504,,e9,A,,,,,\r\n'
)


def student(number: str, mark: float | None = 8.5) -> Row:
    kind = Kind.GRADED if mark is not None else Kind.MISSING
    return row(f"s{number}", mark, kind=kind, student=Student("", ids={"canvas": number}))


def filled(book: str | bytes, one: Given, **how: object) -> Product:
    data = book if isinstance(book, bytes) else book.encode()
    return canvas(one, Options(fill=Page("book.csv", data))._replace(**how))


def text(product: Product) -> str:
    ((name, data),) = product.files
    assert name == "canvas-gradebook.csv"
    return data.decode()


def code_of(book: str, **how: object) -> str:
    with pytest.raises(Refused) as refused:
        filled(book, given([student("501")], title="Robots"), **how)
    (found,) = refused.value.diagnostics
    return found.rule.code


def test_only_one_field_changes() -> None:
    found = filled(BOOK, given([student("501")]))
    assert text(found) == BOOK.replace('"A, B",,,', '"A, B",,12.75,')


def test_excused_and_not_assigned_are_left_alone() -> None:
    found = filled(BOOK, given([student("502"), student("503"), student("504", None)]))
    assert text(found) == BOOK
    assert [(d.rule.code, d.notes) for d in found.diagnostics] == [
        ("V744", ("`Ady, Anna`",)),
        (
            "V746",
            (
                (
                    "`Bär, Ben`: excused in Canvas, "
                    "`Celik, Omer`: the assignment is not given to this student, "
                    "`Student, Test`: no mark: missing"
                ),
            ),
        ),
    ]


def test_marks_are_scaled_and_have_two_decimals() -> None:
    book = BOOK.replace("15.00", "3.33")
    assert '"A, B",,2.83,' in text(filled(book, given([student("501")])))


def test_an_assignment_is_the_one_of_the_title_or_the_one_that_is_named() -> None:
    one = given([student("501")], title="Lab 2")
    for how in ({}, {"column": "Lab 2 (4712)"}, {"column": "lab 2"}, {"column": "4712"}):
        assert '"A, B",,,17,70.1' in text(filled(BOOK, one, **how))
    assert code_of(BOOK) == "V741"
    assert code_of(BOOK, column="Lab 3") == "V741"
    assert code_of(BOOK, column="Final Score") == "V741"


def test_the_only_assignment_needs_no_name() -> None:
    book = "Student,ID,Section,Quiz (1)\nPoints Possible,,,10\nAnna,501,A,\n"
    assert text(filled(book, given([student("501")], title="Robots"))).endswith("501,A,8.5\n")


def test_an_assignment_without_points_is_refused() -> None:
    book = BOOK.replace("15.00", "0.00")
    assert code_of(book, column="4711") == "V742"
    assert code_of(BOOK.replace("15.00", ""), column="4711") == "V742"


@pytest.mark.parametrize(
    "book", ["", "a,b\n", "Student,Name,Lab (1)\nx,y,z\n", "Identifier,Grade\nParticipant 1,\n"]
)
def test_what_is_no_grade_book_is_refused(book: str) -> None:
    assert code_of(book) == "V740"


def test_first_and_last_names_semicolons_and_a_mark() -> None:
    book = (
        "\ufeffLastName;FirstName;ID;SIS Login ID;Section;Lab 1 (7)\n"
        "    Points Possible;;;;;10,00\n"
        "Ady;Anna;501;anna1;A;\n"
        "Bär;Ben;502;ben2;A;\n"
    )
    ben = row("b", 7.3, student=Student("Somebody", login="BEN2"))
    found = filled(book, given([row("a", 8.5, student=Student("Anna Ady")), ben]))
    assert text(found) == book.replace("anna1;A;", "anna1;A;8,5").replace("ben2;A;", "ben2;A;7,3")
    assert [(d.rule.code, d.notes) for d in found.diagnostics] == [
        ("V745", ("`Ady Anna` is `Anna Ady` (`a`)",))
    ]


def test_ids_of_the_student_information_system_count() -> None:
    by_sis = row("a", 10.0, student=Student("", ids={"sis": "M100"}))
    found = filled(BOOK, given([by_sis]))
    assert '"A, B",,15,' in text(found)


@pytest.mark.parametrize("words", HOSTILE)
def test_hostile_names_stay_in_their_fields(words: str) -> None:
    name = '"' + words.replace('"', '""').encode(errors="replace").decode() + '"'
    book = f"Student,ID,Section,Lab 1 (7)\nPoints Possible,,,10\n{name},1011,A,\n{name},2,A,\n"
    found = filled(book, given([hostile(words, 11)]))
    lines = list(csv.reader(io.StringIO(text(found), newline="")))
    assert [line[3] for line in lines[2:]] == ["4.1", ""]
    assert text(found) == book.replace("1011,A,", "1011,A,4.1")


@of_any(found=rows())
def test_the_marks_of_any_class_come_back(found: tuple[Row, ...]) -> None:
    lines = [f"A,{one.student.ids['canvas']},A," for one in found]
    book = "\n".join(["Student,ID,Section,Lab 1 (7)", "Points Possible,,,10", *lines, ""])
    back = list(csv.reader(io.StringIO(text(filled(book, given(found))), newline="")))[2:]
    assert [parsed(line[3]) for line in back] == [one.exact_final for one in found]
