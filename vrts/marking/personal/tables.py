"""Tables with a line for each student, without the lines of one."""

from collections.abc import Collection

from vrts.marking.intake.tables.intake_table import COLUMNS
from vrts.marking.intake.tables.table_text import table
from vrts.marking.personal.raw_text import RawText
from vrts.marking.privacy.pseudonyms import COLUMN

WHO = ("id", COLUMN)  # columns that say whose a line is


def without_lines(data: bytes, name: str, ids: Collection[str]) -> bytes:
    """Return a table without the lines of a student; the bytes of all others stay.

    Args:
        data: Of a table of hand-ins or of names, as marking wrote it or somebody has saved it.
        name: Of the file.
        ids: Id and pseudonym of the student.
    """
    raw = RawText(data, name)
    rows = table(raw.source, (*COLUMNS, COLUMN))
    heads = [cell.text.strip().casefold() for cell in rows[0]] if rows else []
    places = [heads.index(column) for column in WHO if column in heads]
    text = raw.source.text
    cut: list[tuple[int, int]] = []
    for row in rows[1:]:
        if any(at < len(row) and row[at].text.strip() in ids for at in places):
            end = row[-1].span.end
            cut.append((row[0].span.start, end + (text[end : end + 1] == "\n")))
    return raw.without(cut)
