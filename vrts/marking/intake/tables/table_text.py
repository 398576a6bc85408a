"""Tables as text: cells with their places, as spreadsheets of any language save them."""

import re
from collections.abc import Collection, Iterable
from typing import NamedTuple

from vrts.base.source import SourceFile, Span
from vrts.report.formats.csv_field import FORMULA, FULL_WIDTH, TEXT_MARK, text_field

DELIMITERS = (",", ";", "\t")
BOM = b"\xef\xbb\xbf"  # without it Excel takes UTF-8 for the code page of the machine

LOOK = 200  # bytes, to tell the encoding

STARTS = (*FORMULA, *FULL_WIDTH)
_MONTH = r"(?:jan|feb|m[aä]r|apr|ma[iy]|jun|jul|aug|sep|o[ck]t|nov|de[cz])[a-z.]*"
_CONVERTED = re.compile(  # what a spreadsheet makes a number, a date or a truth value of
    rf"[\d.,:/%\s-]*\d[\d.,:/%\s-]*|\d+e[+-]?\d+|{_MONTH}[-. ]*\d+|\d+[-. ]*{_MONTH}"
    r"|true|false|wahr|falsch|vrai|faux",
    re.IGNORECASE,
)
_SEPARATOR = re.compile(r'"?sep=([,;\t|])"?\n', re.IGNORECASE)


class Cell(NamedTuple):
    """One field of a table."""

    text: str
    span: Span  # with its quotation marks


def read_text(data: bytes, name: str) -> SourceFile:
    """Return the text of a table: UTF-8, UTF-16, else the code page of Windows."""
    wide = _utf16(data)
    if wide is not None:
        text = data.decode(wide, errors="replace")
    else:
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = data.decode("cp1252", errors="replace")
    return SourceFile(name, text.replace("\r\n", "\n").replace("\r", "\n"))


def _utf16(data: bytes) -> str | None:
    """Return which UTF-16 a text is in, by its mark or by the zeros of Latin letters."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return "utf-16"
    start = data[:LOOK]
    low, high = start[::2].count(0), start[1::2].count(0)
    if max(low, high) * 4 < len(start):
        return None
    return "utf-16-le" if high > low else "utf-16-be"


def table(source: SourceFile, columns: Collection[str]) -> list[list[Cell]]:
    """Return the rows of a table, separated by whatever finds most of the columns, in lower case.

    Where none finds any, by whatever finds most columns at all. A line that names the delimiter
    for Excel, as `sep=;`, is obeyed.
    """
    named = _SEPARATOR.match(source.text)
    if named is not None:
        rows = _rows(source, named[1], start=named.end())
        return [row for row in rows if any(cell.text.strip() for cell in row)]

    def found(delimiter: str) -> tuple[int, int]:
        cells = [cell for row in _rows(source, delimiter, most=1) for cell in row]
        return sum(cell.text.strip().casefold() in columns for cell in cells), len(cells)

    best = max(DELIMITERS, key=found)
    return [row for row in _rows(source, best) if any(cell.text.strip() for cell in row)]


def _rows(
    source: SourceFile, delimiter: str, most: int = 1_000_000, start: int = 0
) -> list[list[Cell]]:
    text, at = source.text, start
    rows: list[list[Cell]] = []
    while at < len(text) and len(rows) < most:
        row: list[Cell] = []
        ends = False
        while not ends:
            cell, at = _cell(source, at, delimiter)
            row.append(cell)
            ends = at >= len(text) or text[at] == "\n"
            at += 1
        rows.append(row)
    return rows


def _cell(source: SourceFile, start: int, delimiter: str) -> tuple[Cell, int]:
    """Return the cell that begins at an offset, and the offset of what ends it."""
    text = source.text
    end = start
    if text[start : start + 1] == '"':
        end = start + 1
        while end < len(text):
            if text[end] == '"':
                if text[end + 1 : end + 2] != '"':
                    break
                end += 1
            end += 1
        content = text[start + 1 : end].replace('""', '"')
        end += 1
    else:
        content = ""
    rest = re.compile(rf"[^\n{re.escape(delimiter)}]*").match(text, min(end, len(text)))
    assert rest is not None
    return Cell(_unmarked(content + rest[0]), Span(source, start, rest.end())), rest.end()


def field(text: str) -> str:
    """Return a text as a field that comes back as it was, also from a spreadsheet."""
    return text_field(TEXT_MARK + text if _changed(text) else text)


def table_bytes(rows: Iterable[Iterable[str]]) -> bytes:
    """Return rows of texts as a file that a spreadsheet reads, and that comes back as it was."""
    return BOM + "".join(f"{','.join(map(field, row))}\r\n" for row in rows).encode()


def _unmarked(text: str) -> str:
    """Return the text of a field without the mark that keeps a spreadsheet from changing it."""
    return text[1:] if text.startswith(TEXT_MARK) and _changed(text) else text


def _changed(text: str) -> bool:
    """Return whether a spreadsheet would take a text for more than text, marks apart."""
    bare = text.lstrip(TEXT_MARK)
    if not bare:
        return bool(text)
    return bare.lstrip(" ").startswith(STARTS) or bool(_CONVERTED.fullmatch(bare.strip()))
