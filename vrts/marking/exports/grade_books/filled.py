"""Fills marks into a teacher's file, and tells who was not found and what was left alone."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.base.safe_names import safe
from vrts.base.written_numbers import read_number
from vrts.marking.exports.feedback import FINAL, feedback_html
from vrts.marking.exports.given import Given, Options, Product, Returned
from vrts.marking.exports.grade_books.decimal_sign import Sign
from vrts.marking.exports.grade_books.matching import Line, match
from vrts.marking.exports.grade_books.sheet import Sheet
from vrts.marking.exports.numbers import decimal
from vrts.marking.row import Row
from vrts.report.plain import one_line

NOT_IN_FILE = Rule("V743", "student-without-row")
NOT_IN_CLASS = Rule("V744", "row-without-student")
BY_NAME = Rule("V745", "matched-by-name")
NOT_FILLED = Rule("V746", "row-not-filled")
REPLACED = Rule("V747", "mark-replaced")

SHOWN = 10  # names in a diagnostic


class Column(NamedTuple):
    """Where marks go, and how they are written."""

    at: int
    most: int  # decimals at most
    least: int  # decimals at least
    sign: Sign
    comments: int | None = None  # column of comments


class Slot(NamedTuple):
    """A student's place in a file."""

    line: Line
    full: Fraction  # what full marks are worth
    locked: str = ""  # why it has to be left alone


def fill(
    name: str, sheet: Sheet, column: Column, slots: Sequence[Slot], given: Given, options: Options
) -> Product:
    """Return a file with the marks of a class in it, and all else as it was."""
    places = {slot.line.row: slot for slot in slots}
    matches = match([slot.line for slot in slots], given.whole.rows)
    texts: dict[tuple[int, int], str] = {}
    skipped: list[str] = []
    replaced: list[str] = []
    for line, row in matches.pairs:
        slot = places[line.row]
        final = row.exact_final
        why = slot.locked
        if final is None:
            why = f"no mark: {row.result.kind.value}"
        elif column.at >= len(sheet.rows[line.row]):
            why = "the row is too short"
        if why or final is None:
            skipped.append(f"`{_title(line)}`: {why}")
            continue
        value = final * slot.full / row.result.exact_total
        old = sheet.field(line.row, column.at)
        new = decimal(value, least=column.least, most=column.most, point=column.sign.writes)
        if old and read_number(old, column.sign.reads) != read_number(new, column.sign.writes):
            replaced.append(f"`{_title(line)}`: `{one_line(old)}` by {new}")
        texts[line.row, column.at] = new
        if options.comments and _may_comment(sheet, line.row, column.comments):
            assert column.comments is not None
            told = Returned(row, given.public[row.id])
            texts[line.row, column.comments] = feedback_html(told)
    found = (
        *_listed(
            NOT_IN_FILE,
            [_who(row) for row in matches.rows],
            "of the class is not in the file",
            "of the class are not in the file",
            "look whether the file is of this class, and enter these marks by hand",
        ),
        *_listed(
            NOT_IN_CLASS,
            [f"`{_title(line)}`" for line in matches.lines],
            "of the file has no submission: the row is left as it is",
            "of the file have no submission: their rows are left as they are",
            "somebody who handed in nothing gets a mark from you, not from vrts",
        ),
        *_listed(
            BY_NAME,
            [f"`{_title(line)}` is {_who(row)}" for line, row in matches.by_name],
            "was found by name only",
            "were found by name only",
            "look whether this is who is meant",
        ),
        *_listed(
            NOT_FILLED,
            skipped,
            "was found, but the row is left as it is",
            "were found, but their rows are left as they are",
            "enter a mark by hand where there has to be one",
        ),
        *_listed(
            REPLACED,
            replaced,
            "had another mark in the file",
            "had other marks in the file",
            "the file that was given is unchanged: compare before you upload the new one",
        ),
    )
    return Product([(name, sheet.with_texts(texts))], found)


def _may_comment(sheet: Sheet, row: int, at: int | None) -> bool:
    """Return whether there is a place for a comment, and nothing in it but one of ours."""
    if at is None or at >= len(sheet.rows[row]):
        return False
    old = sheet.field(row, at)
    return not old or FINAL in old[:40]


def _title(line: Line) -> str:
    return one_line(line.name) or f"row {line.row + 1}"


def _who(row: Row) -> str:
    """Return the name of a student with the id; where they are the same, the id."""
    name = one_line(row.student.name)
    return f"`{row.id}`" if safe(name) == row.id or not name else f"`{name}` (`{row.id}`)"


def _listed(
    rule: Rule, who: Sequence[str], one: str, many: str, remedy: str
) -> Iterable[Diagnostic]:
    if who:
        rest = f" and {len(who) - SHOWN} more" if len(who) > SHOWN else ""
        words = f"1 student {one}" if len(who) == 1 else f"{len(who)} students {many}"
        yield warning(rule, words, notes=(", ".join(who[:SHOWN]) + rest,), help=(remedy,))
