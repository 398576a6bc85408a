"""marks.csv: a line for every submission, for spreadsheets and scripts."""

from collections.abc import Iterator
from fractions import Fraction

from vrts.marking.exports.feedback import place_of
from vrts.marking.exports.given import Given, Options, Product
from vrts.marking.exports.numbers import decimal
from vrts.marking.intake.tables.table_text import BOM, field
from vrts.marking.row import Class, Row, unsafe_first
from vrts.report.plain import one_line

NAME = "marks.csv"
COLUMNS = (
    "id",
    "name",
    "email",
    "login",
    "ids",
    "file",
    "received",
    "status",
    "mark",
    "deduction",
    "change",
    "final",
    "lowest",
    "late",
    "reason",
    "changed by",
    "changed on",
    "review",
    "ready",
    "cause",
    "line",
    "duration_s",
    "contacts",
    "key",
    "unsafe",  # behind all else: some read the columns by place
    "items",
    "comments",
    "variant",
    "why",
)


def marks_table(given: Given, options: Options) -> Product:
    """Return the table as an export."""
    return Product([(NAME, marks_csv(given.whole, options.delimiter, options.decimal))])


def marks_csv(whole: Class, delimiter: str = ",", decimal_sign: str = "") -> bytes:
    """Return the table of a class: UTF-8 with its mark, RFC 4180, no field a formula.

    Unsafe marks come first.

    Args:
        whole: Its rows.
        delimiter: `,` with decimal points, or `;` with decimal commas.
        decimal_sign: Another decimal sign than these.
    """
    point = decimal_sign or ("," if delimiter == ";" else ".")
    lines = [delimiter.join(COLUMNS)]
    for row in unsafe_first(whole.rows):
        lines.append(delimiter.join(_fields(row, point, delimiter)))
    return BOM + "".join(f"{line}\r\n" for line in lines).encode()


def _fields(row: Row, point: str, delimiter: str) -> Iterator[str]:
    """Yield the fields of a row: foreign text guarded, numbers as they are."""

    def number(value: Fraction | None, least: int = 0) -> str:
        text = "" if value is None else decimal(value, least=least, point=point)
        return f'"{text}"' if delimiter in text else text

    def text(value: str) -> str:
        return field(one_line(value))

    def measured(value: float | None) -> str:
        return number(None if value is None else Fraction(repr(value)))

    result, student, late, change = row.result, row.student, row.late, row.change
    yield text(row.id)
    yield text(student.name)
    yield text(student.email)
    yield text(student.login)
    yield text("; ".join(f"{platform} {value}" for platform, value in student.ids.items()))
    yield text(row.handed_in.file)
    yield text(row.handed_in.received or "")
    yield result.kind.value
    yield number(result.exact_mark, 1)
    yield number(None if late is None or late.review else Fraction(late.deduction))
    yield number(None if change is None else Fraction(change.delta))
    yield number(row.exact_final, 1)
    yield measured(result.lowest)
    yield text("" if late is None else late.sentence)
    yield text("" if change is None else change.reason)
    yield text("" if change is None else change.who)
    yield "" if change is None else text(change.date)
    yield text("; ".join(result.review))
    yield "yes" if result.ready else "no"
    yield text(result.cause)
    yield "" if result.line is None else str(result.line)
    yield measured(result.metrics.duration_s)
    yield "" if result.metrics.contacts is None else str(result.metrics.contacts)
    yield result.key
    yield text("; ".join(f"{doubt.reason.value}: {doubt.sentence}" for doubt in row.unsafe))
    items = () if row.decided is None else row.decided.items
    told = () if row.decided is None else row.decided.comments
    yield text("; ".join(f"{item.title} {number(Fraction(item.points))}" for item in items))
    yield text("; ".join(f"{place_of(c.line, c.time_s)}{c.text}" for c in told))
    yield "" if result.variant is None else text(result.variant.tag)
    yield text(row.handed_in.why)
