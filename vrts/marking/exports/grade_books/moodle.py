"""Moodle's grading worksheet, filled in.

Moodle looks for columns by their titles in the teacher's language, so what stands in a column
counts where a title is not known. Rows are found by the number in "Participant 123456".
"""

import re
from collections.abc import Sequence
from fractions import Fraction

from vrts.base.written_numbers import parsed
from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.exports.grade_books.decimal_sign import Sign, decimals, full_marks, sign_of
from vrts.marking.exports.grade_books.filled import Column, Slot, fill
from vrts.marking.exports.grade_books.matching import Line
from vrts.marking.exports.grade_books.moodle_titles import COMMENTS, FULL_NAME, GRADE, KNOWN, NO
from vrts.marking.exports.grade_books.refusals import file_of, no_column, no_file, no_points
from vrts.marking.exports.grade_books.sheet import Sheet, read_sheet
from vrts.marking.intake.row import Platform

NAME = "moodle-worksheet.csv"
WHAT = "grading worksheet of Moodle"
MOST_DECIMALS = 5  # that Moodle keeps

_PARTICIPANT = re.compile(r"[^\d@]+?(\d+)$")
_ADDRESS = re.compile(r"[^@\s]+@[^@\s]+$")


def moodle(given: Given, options: Options) -> Product:
    """Return the worksheet with marks and comments.

    Raises:
        Refused: There is none, it is none, or it does not tell where marks belong.
    """
    file = file_of(options, WHAT)
    sheet = read_sheet(file.data, lambda header: sum(t.casefold() in KNOWN for t in header))
    header = [field.text.strip() for field in sheet.rows[0]] if sheet.rows else []
    people = [
        (row, number[1])
        for row in range(1, len(sheet.rows))
        if (number := _PARTICIPANT.match(sheet.field(row, 0))) is not None
    ]
    if not people:
        raise no_file(f"`{file.name}` is no {WHAT}", WHAT)
    grade = _grade(header, options)
    rows = [row for row, _ in people]
    full = _full_marks_column(sheet, grade, rows)
    texts = [sheet.field(row, at) for row in rows for at in (grade, full or grade)]
    sign = sign_of(texts, sheet.delimiter, options, WHAT)
    least = decimals(texts, sign)
    comments = next((k for k, title in enumerate(header) if title.casefold() in COMMENTS), None)
    before = grade if full is None else full
    slots = [
        Slot(
            _line(sheet, header, row, number),
            _points(sheet, row, full, sign, options),
            _locked(sheet, row, before),
        )
        for row, number in people
    ]
    column = Column(grade, MOST_DECIMALS, min(least, MOST_DECIMALS), sign, comments)
    return fill(NAME, sheet, column, slots, given, options)


def _grade(header: Sequence[str], options: Options) -> int:
    wanted = {options.column.casefold()} if options.column else GRADE
    found = [k for k, title in enumerate(header) if title.casefold() in wanted]
    if len(found) != 1:
        what = f"called `{options.column}`" if options.column else "for the grade"
        many = "more than one column is" if found else "no column is"
        raise no_column(f"{many} {what} in the worksheet", header)
    return found[0]


def _full_marks_column(sheet: Sheet, grade: int, rows: Sequence[int]) -> int | None:
    """Return the column of the greatest grade: behind that of the grade, numbers in all rows."""
    numbers = {parsed(sheet.field(row, grade + 1)) for row in rows}
    return None if None in numbers else grade + 1


def _locked(sheet: Sheet, row: int, before: int) -> str:
    """Return why a grade has to be left alone; "" where it may be filled in.

    "Grade can be changed" is behind the greatest grade, or one further where work flow is marked.
    """
    words = (sheet.field(row, before + k).casefold() for k in (1, 2))
    return "the grade is locked in Moodle" if any(word in NO for word in words) else ""


def _points(sheet: Sheet, row: int, full: int | None, sign: Sign, options: Options) -> Fraction:
    text = "" if full is None else sheet.field(row, full)
    points = full_marks(text, sign, options)
    if points is None:
        raise no_points("the worksheet does not tell the greatest grade: it may be a scale")
    return points


def _line(sheet: Sheet, header: Sequence[str], row: int, number: str) -> Line:
    titles = [title.casefold() for title in header]
    named = next((k for k, title in enumerate(titles) if title in FULL_NAME), None)
    logins = (field.text.strip() for field in sheet.rows[row][1:4])
    return Line(
        row,
        sheet.field(row, 0) if named is None else sheet.field(row, named),
        {Platform.MOODLE.value: number},
        frozenset(text for text in logins if _ADDRESS.match(text)),
    )
