"""A table that is not ours: read with the place of every field, so that all else stays as it is."""

import codecs
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

DELIMITERS = (",", ";", "\t")
LARGEST = 16_000_000  # bytes
NEEDS_QUOTES = '"\r\n'


class Field(NamedTuple):
    """One field, and where it stands with its quotation marks."""

    text: str
    start: int
    end: int


class Sheet(NamedTuple):
    """A table, and how it is written."""

    text: str
    codec: str
    mark: bytes  # in front of the text, if any
    delimiter: str
    rows: tuple[tuple[Field, ...], ...]

    def field(self, row: int, column: int) -> str:
        """Return the text of a field without blanks around it; "" where a row is too short."""
        fields = self.rows[row]
        return fields[column].text.strip() if 0 <= column < len(fields) else ""

    def with_texts(self, texts: Mapping[tuple[int, int], str]) -> bytes:
        """Return the bytes of the table with other texts in some fields, by row and column.

        Every other character stays. What the encoding of the table does not have becomes `?`.
        """
        parts: list[str] = []
        at = 0
        for row, column in sorted(texts):
            old = self.rows[row][column]
            parts += [self.text[at : old.start], self._written(texts[row, column], old)]
            at = old.end
        parts.append(self.text[at:])
        return self.mark + "".join(parts).encode(self.codec)

    def _written(self, text: str, old: Field) -> str:
        able = text.encode(self.codec, "replace").decode(self.codec)
        quoted = self.text[old.start : old.start + 1] == '"'
        if quoted or any(c in able for c in (*NEEDS_QUOTES, self.delimiter)):
            return '"' + able.replace('"', '""') + '"'
        return able


def read_sheet(data: bytes, known: Callable[[Sequence[str]], int]) -> Sheet:
    """Return a table.

    Args:
        data: The file: UTF-8, UTF-16 with its mark, or of the code page of Windows.
        known: Tells how many columns of a header it knows, which shows the delimiter.
    """
    text, codec, mark = _decoded(data)
    best = max(DELIMITERS, key=lambda delimiter: known(_header(text, delimiter)))
    return Sheet(text, codec, mark, best, _rows(text, best))


def _decoded(data: bytes) -> tuple[str, str, bytes]:
    for mark, codec in (
        (codecs.BOM_UTF8, "utf-8"),
        (codecs.BOM_UTF16_LE, "utf-16-le"),
        (codecs.BOM_UTF16_BE, "utf-16-be"),
        (b"", "utf-8"),
        (b"", "cp1252"),
    ):
        if data.startswith(mark):
            try:
                return data[len(mark) :].decode(codec), codec, mark
            except UnicodeDecodeError:
                continue
    return data.decode("latin-1"), "latin-1", b""


def _header(text: str, delimiter: str) -> list[str]:
    rows = _rows(text, delimiter, most=1)
    return [field.text.strip() for field in rows[0]] if rows else []


def _rows(text: str, delimiter: str, most: int = 1_000_000) -> tuple[tuple[Field, ...], ...]:
    rows: list[tuple[Field, ...]] = []
    at = 0
    while at < len(text) and len(rows) < most:
        row: list[Field] = []
        while True:
            field = _field(text, at, delimiter)
            row.append(field)
            at = field.end
            if at >= len(text) or text[at] != delimiter:
                break
            at += 1
        at += 2 if text[at : at + 2] == "\r\n" else 1
        rows.append(tuple(row))
    return tuple(rows)


def _field(text: str, start: int, delimiter: str) -> Field:
    """Return the field that begins at an offset: up to a delimiter or the end of its line."""
    end, content = start, ""
    if text[start : start + 1] == '"':
        end = start + 1
        while end < len(text):
            close = text.find('"', end)
            if close < 0:
                end = len(text)
            elif text[close + 1 : close + 2] == '"':
                end = close + 2
                continue
            else:
                end = close
            break
        content = text[start + 1 : end].replace('""', '"')
        end = min(end + 1, len(text))
    begin = end
    while end < len(text) and text[end] not in (delimiter, "\r", "\n"):
        end += 1
    return Field(content + text[begin:end], start, end)
