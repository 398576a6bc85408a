"""The grade book of Canvas, filled in: one column of one assignment, all else as it was."""

import re
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.written_numbers import parsed, tells
from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.exports.grade_books.decimal_sign import full_marks, refuse_comma, sign_of
from vrts.marking.exports.grade_books.filled import Column, Slot, fill
from vrts.marking.exports.grade_books.matching import Line
from vrts.marking.exports.grade_books.refusals import file_of, no_column, no_file, no_points
from vrts.marking.exports.grade_books.sheet import Sheet, read_sheet
from vrts.marking.intake.row import Platform, plain_id

NAME = "canvas-gradebook.csv"
WHAT = "grade book of Canvas"
DECIMALS = 2  # that Canvas compares
NAMES = (("student",), ("lastname", "firstname"))
SECTION = "section"
KNOWN = frozenset(
    ("student", "lastname", "firstname", "id", "sis user id", "sis login id", SECTION)
)

_ASSIGNMENT = re.compile(r"(?P<title>.*?)\s*\((?P<id>\d+)\)", re.DOTALL)


class People(NamedTuple):
    """Which columns tell who somebody is."""

    names: tuple[int, ...]
    number: int
    sis: int | None
    login: int | None
    after: int  # the first column that may be an assignment


def canvas(given: Given, options: Options) -> Product:
    """Return the grade book with the marks of one assignment.

    Raises:
        Refused: There is none, it is none, or it does not tell where marks belong.
    """
    file = file_of(options, WHAT)
    sheet = read_sheet(file.data, lambda header: sum(t.casefold() in KNOWN for t in header))
    header = [field.text.strip() for field in sheet.rows[0]] if sheet.rows else []
    people = _people([title.casefold() for title in header])
    if people is None:
        raise no_file(f"`{file.name}` is no {WHAT}", WHAT)
    students = [
        row for row in range(1, len(sheet.rows)) if sheet.field(row, people.number).isdecimal()
    ]
    above = range(1, min(students, default=len(sheet.rows)))  # points, and what is posted how
    at = _assignment(header, people, above, sheet, given, options)
    numbers = (sheet.field(row, at) for row in above)
    text = next((text for text in numbers if parsed(text) is not None), "")
    texts = [sheet.field(row, at) for row in range(1, len(sheet.rows))]
    sign = sign_of(texts, sheet.delimiter, options, WHAT)
    refuse_comma(sign, told=any(tells(one) == "," for one in texts))
    full = full_marks(text, sign, options)
    if full is None:
        raise no_points(f"the grade book does not tell what `{header[at]}` is worth")
    column = Column(at, DECIMALS, 0, sign)
    slots = [Slot(_line(sheet, people, row), full, _left(sheet.field(row, at))) for row in students]
    return fill(NAME, sheet, column, slots, given, options)


def _people(titles: Sequence[str]) -> People | None:
    for names in NAMES:
        count = len(names)
        if tuple(titles[:count]) == names and titles[count : count + 1] == ["id"]:
            places = {title: k for k, title in reversed(list(enumerate(titles)))}
            after = places.get(SECTION, count) + 1
            return People(
                tuple(range(count)),
                count,
                places.get("sis user id"),
                places.get("sis login id"),
                after,
            )
    return None


def _assignment(
    header: Sequence[str],
    people: People,
    above: Sequence[int],
    sheet: Sheet,
    given: Given,
    options: Options,
) -> int:
    """Return the column of an assignment: the one that was named, the only one, or of its title."""
    open_to = {
        k: match
        for k in range(people.after, len(header))
        if (match := _ASSIGNMENT.fullmatch(header[k])) is not None
        and not any(sheet.field(row, k).startswith("(") for row in above)
    }
    wanted = (options.column or given.whole.title).casefold()
    named = [
        k
        for k, match in open_to.items()
        if wanted in (header[k].casefold(), match["title"].casefold(), match["id"])
    ]
    if len(named) == 1:
        return named[0]
    if not options.column and len(open_to) == 1:
        return next(iter(open_to))
    what = f"called `{options.column}`" if options.column else f"called `{given.whole.title}`"
    many = "more than one assignment is" if named else "no assignment is"
    raise no_column(f"{many} {what} in the grade book", [header[k] for k in open_to])


def _left(text: str) -> str:
    """Return why a field has to be left alone; "" where it may be filled."""
    match text.casefold():
        case "ex":
            return "excused in Canvas"
        case "n/a":
            return "the assignment is not given to this student"
        case _:
            return ""


def _line(sheet: Sheet, people: People, row: int) -> Line:
    ids = {Platform.CANVAS.value: sheet.field(row, people.number)}
    if people.sis is not None and sheet.field(row, people.sis):
        ids[Platform.SIS.value] = plain_id(sheet.field(row, people.sis))
    login = "" if people.login is None else sheet.field(row, people.login)
    name = " ".join(sheet.field(row, k) for k in people.names)
    return Line(row, name, ids, frozenset((login,)) if login else frozenset())
