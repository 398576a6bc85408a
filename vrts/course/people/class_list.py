"""Reads the list of a class: Moodle's grading worksheet, Canvas' grade book, or a plain table."""

from pathlib import Path
from typing import Final

from vrts.base.diagnostic import Diagnostic, Label, error
from vrts.course.course import EMAIL
from vrts.course.people.listed import CLASS_LIST, Listed
from vrts.marking.intake.row import Student
from vrts.marking.intake.tables.roster import CANVAS_HEADER, read_roster
from vrts.marking.intake.tables.table_text import Cell, read_text, table
from vrts.pipeline.files import CannotRead, read_bytes

LARGEST: Final = 16_000_000  # bytes
NAMES: Final = ("name", "full name")
EMAILS: Final = ("email", "e-mail", "email address", "mail")
IDS: Final = ("id",)
TEAMS: Final = ("team", "group")
COLUMNS: Final = (*NAMES, *EMAILS, *IDS, *TEAMS)

_HELP: Final = (
    "columns of a plain table: name, email, and if you like id and team",
    "or export Moodle's grading worksheet, or the grade book of Canvas",
)


def open_class_list(path: Path) -> tuple[tuple[Listed, ...], tuple[Diagnostic, ...]]:
    """Return the students of a list, and what is wrong with it.

    Raises:
        CannotRead: There is no such file.
    """
    return read_class_list(read_bytes(path), path.name)


def read_class_list(data: bytes, name: str) -> tuple[tuple[Listed, ...], tuple[Diagnostic, ...]]:
    """Return the students of a list, and what is wrong with it.

    Args:
        data: Content of the list.
        name: As shown.
    """
    if len(data) > LARGEST:
        return (), (error(CLASS_LIST, f"`{name}` is larger than {LARGEST} bytes"),)
    source = read_text(data, name)
    lines = table(source, COLUMNS)
    header = [cell.text.strip().casefold() for cell in lines[0]] if lines else []
    plain = "name" in header or (_column(header, EMAILS) is not None and "identifier" not in header)
    if plain and tuple(header[:2]) != CANVAS_HEADER:
        found, faults = _plain(header, lines)
    else:
        try:
            roster = read_roster(data, name, None)
        except CannotRead as problem:
            return (), (error(CLASS_LIST, problem.message, help=_HELP),)
        platform = roster.platform.value
        found = tuple(_of(platform, key, one.student) for key, one in roster.members.items())
        faults = ()
    if not found and not faults:  # such as a file that is just being written
        faults = (error(CLASS_LIST, f"there is nobody in `{name}`", help=_HELP),)
    return found, faults


def _of(platform: str, number: str, student: Student) -> Listed:
    """Return a student of a platform."""
    email = student.email or (student.login if EMAIL.match(student.login) else "")
    last, comma, first = student.name.partition(",")
    name = f"{first.strip()} {last.strip()}" if comma and platform == "canvas" else student.name
    return Listed(f"{platform} {number}", name, email.casefold(), dict(student.ids))


def _plain(
    header: list[str], lines: list[list[Cell]]
) -> tuple[tuple[Listed, ...], tuple[Diagnostic, ...]]:
    columns = [_column(header, known) for known in (NAMES, EMAILS, IDS, TEAMS)]
    if columns[0] is None or (columns[1] is None and columns[2] is None):
        text = "the table has no column `name`, or neither `email` nor `id`"
        return (), (error(CLASS_LIST, text, Label(lines[0][0].span), help=_HELP),)
    found: list[Listed] = []
    faults: list[Diagnostic] = []
    for line in lines[1:]:
        label = Label(line[0].span)
        name, email, number, team = (_cell(line, column) for column in columns)
        if not name:
            faults.append(error(CLASS_LIST, "this line has no name", label))
        elif email and not EMAIL.match(email):
            faults.append(error(CLASS_LIST, f"`{email}` is no e-mail address", label))
        elif not email and not number:
            faults.append(error(CLASS_LIST, f"`{name}` has neither e-mail address nor id", label))
        else:
            key = f"id {number}" if number else email.casefold()
            ids = {"id": number} if number else {}
            found.append(Listed(key, name, email.casefold(), ids, team=team, label=label))
    return tuple(found), tuple(faults)


def _column(header: list[str], known: tuple[str, ...]) -> int | None:
    return next((number for number, title in enumerate(header) if title in known), None)


def _cell(line: list[Cell], column: int | None) -> str:
    return "" if column is None or column >= len(line) else " ".join(line[column].text.split())
