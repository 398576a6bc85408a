"""How the numbers of a teacher's file are written: with decimal points or commas, as it tells.

A number that can be read in two ways, such as 1,234, is refused where nothing tells which is meant.
"""

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.base.written_numbers import Doubtful, read_number, tells
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
        Refused: What was asked for is not how the file writes numbers; or nothing was asked for,
            and its numbers tell both signs, or can all be read in two ways.
    """
    fields = tuple(texts)
    told = {shown: text for text in reversed(fields) if (shown := tells(text))}
    known = next(iter(told)) if len(told) == 1 else ""
    if options.decimal and known and known != options.decimal:
        headline = (
            f"the {what} has {NAMES[known]}, as in `{told[known]}`, not {NAMES[options.decimal]}"
        )
        notes = ("the platform would misread the other sign: 8,5 could become 8 or 85",)
        remedy = "leave out `--decimal`: what is filled in is written as the file writes it"
        raise Refused((error(MISREAD, headline, notes=notes, help=(remedy,)),))
    if not options.decimal and len(told) > 1:
        both = " and ".join(f"`{told[one]}`" for one in sorted(told))
        raise _ambiguous(f"the {what} has {both}: nothing tells which sign parts decimals")
    reads = options.decimal or known
    usual = COMMA if delimiter == ";" else POINT
    sign = Sign(reads, reads or usual, delimiter)
    for text in fields:
        _number(text, sign)
    return sign


def refuse_comma(sign: Sign, *, told: bool) -> None:
    """Refuse to write decimal commas into a grade book of Canvas that has none itself.

    Args:
        sign: Of the grade book.
        told: Whether it has some.

    Raises:
        Refused: They would be written.
    """
    if sign.writes == COMMA and not told and sign.delimiter != ";":
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
    found = _number(text, sign)
    return found if found is not None and found > 0 else None


def decimals(texts: Iterable[str], sign: Sign) -> int:
    """Return how many decimals the numbers of a file have; what parts thousands tells none."""
    return max((_decimals(text.strip(), sign) for text in texts), default=0)


def _decimals(text: str, sign: Sign) -> int:
    value = _number(text, sign)
    parts_thousands = value is not None and not tells(text) and abs(value) >= 1000
    if value is None or parts_thousands or not {COMMA, POINT} & set(text):
        return 0
    return len(text.replace(COMMA, POINT).rpartition(POINT)[2])


def _number(text: str, sign: Sign) -> Fraction | None:
    """Return the number that a field holds; None: it holds none.

    Raises:
        Refused: It can be read in two ways.
    """
    try:
        return read_number(text, sign.reads, COMMA + (POINT if sign.delimiter == ";" else ""))
    except Doubtful as doubt:
        a, b = (decimal(value) for value in doubt.values)
        headline = f"`{text}` may be {a} or {b}: nothing in the file tells which"
        raise _ambiguous(headline) from doubt


def _ambiguous(headline: str) -> Refused:
    remedy = "say how it writes decimals: `--decimal comma` or `--decimal point`"
    return Refused((error(AMBIGUOUS, headline, help=(remedy,)),))
