"""How the numbers of a teacher's file are written: with decimal points or commas, as it tells.

A number that can be read in two ways, such as 1,234, is refused where nothing tells which is meant.
"""

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.base.written_numbers import Doubtful, parsed, read_number, tells
from vrts.marking.exports.given import Options
from vrts.marking.exports.numbers import decimal
from vrts.pipeline.refused import Refused

AMBIGUOUS = Rule("V757", "ambiguous-number")
MISREAD = Rule("V758", "decimal-sign-misread")

COMMA, POINT = ",", "."
NAMES = {COMMA: "decimal commas", POINT: "decimal points"}


class Sign(NamedTuple):
    """The decimal sign of a file."""

    reads: str  # "" where nothing tells
    writes: str
    delimiter: str


def sign_of(texts: Iterable[str], delimiter: str, options: Options, what: str) -> Sign:
    """Return the decimal sign of a file: as asked for, else as its numbers tell, or its delimiter.

    Args:
        texts: Fields that may be numbers.
        delimiter: Between fields.
        options: What was asked for.
        what: What the file is.

    Raises:
        Refused: What was asked for is not how the file writes numbers.
    """
    fields = tuple(texts)
    told = {sign for text in fields if (sign := tells(text))}
    known = told.pop() if len(told) == 1 else ""
    if options.decimal and known and known != options.decimal:
        seen = next(text for text in fields if tells(text) == known)
        headline = f"the {what} has {NAMES[known]}, as in `{seen}`, not {NAMES[options.decimal]}"
        notes = ("the platform would misread the other sign: 8,5 could become 8 or 85",)
        remedy = "leave out `--decimal`: what is filled in is written as the file writes it"
        raise Refused((error(MISREAD, headline, notes=notes, help=(remedy,)),))
    reads = options.decimal or known
    usual = COMMA if delimiter == ";" or any(COMMA in text for text in _numbers(fields)) else POINT
    return Sign(reads, reads or usual, delimiter)


def refuse_comma(sign: Sign, told: bool, options: Options) -> None:
    """Refuse decimal commas in a grade book of Canvas that has none itself.

    Raises:
        Refused: They were asked for.
    """
    if options.decimal == COMMA and not told and sign.delimiter != ";":
        headline = "this grade book of Canvas has commas between its fields, and no decimal comma"
        notes = ("Canvas reads decimal points in every language, commas not in every version",)
        remedy = "leave out `--decimal comma`"
        raise Refused((error(MISREAD, headline, notes=notes, help=(remedy,)),))


def full_marks(text: str, sign: Sign, options: Options) -> Fraction | None:
    """Return what full marks are worth: as asked for, else as the file tells; None: neither.

    Raises:
        Refused: The number of the file can be read in two ways.
    """
    if options.points is not None:
        return options.points
    try:
        found = read_number(text, sign.reads, COMMA + (POINT if sign.delimiter == ";" else ""))
    except Doubtful as doubt:
        a, b = (decimal(value) for value in doubt.values)
        headline = f"`{text}` may be {a} or {b}: nothing in the file tells which"
        remedy = "say how it is written: `--decimal comma` or `--decimal point`; or give `--points`"
        raise Refused((error(AMBIGUOUS, headline, help=(remedy,)),)) from doubt
    return found if found is not None and found > 0 else None


def decimals(texts: Iterable[str]) -> int:
    """Return how many decimals the numbers of a file have."""
    numbers = (text.strip().replace(COMMA, POINT) for text in _numbers(texts))
    return max((len(text.rpartition(POINT)[2]) for text in numbers if POINT in text), default=0)


def _numbers(texts: Iterable[str]) -> list[str]:
    return [text for text in texts if parsed(text) is not None]
