"""Programs laid out anew, in the bytes that they came in.

A line that keeps its words keeps its bytes. A line that changes is written in the encoding of the
file, with the line end that it had; form feeds and the like stay before and behind it.
"""

import re
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.dialect import DIALECTS
from vrts.lang.reading.decoding import DROPPED, decode
from vrts.lang.reading.detection import detect
from vrts.lang.reading.encodings import characters, shown
from vrts.lang.writing.layout import laid_out

_LINE_END = re.compile("(\r\n|\r|\n)")
_NOT_READ = str.maketrans("", "", DROPPED)


class Formatted(NamedTuple):
    """A program in canonical layout."""

    before: str
    after: str
    data: bytes  # of the file as it should be
    changed: bool  # whether that is another than it is
    unread: tuple[int, ...] = ()  # lines that cannot be read and stay as they are
    diagnostic: Diagnostic | None = None  # why the file cannot be read


def format_bytes(data: bytes, name: str, dialect: str | None) -> Formatted:
    """Return the canonical layout of a program; what is no part of it keeps its bytes."""
    source = decode(data, name)
    if isinstance(source, Diagnostic):
        return Formatted("", "", data, False, diagnostic=source)
    found = characters(data)
    assert found is not None, "it was decoded"
    chosen = DIALECTS[dialect] if dialect is not None else detect(source)[0]
    *lines, last = _LINE_END.split(found.text)
    read = [line.translate(_NOT_READ) for line in (*lines[::2], last)]
    laid = laid_out(SourceFile(name, "\n".join(read)), chosen)
    rows = [
        raw if row == line else _put(row, raw)
        for raw, line, row in zip((*lines[::2], last), read, laid.rows, strict=True)
    ]
    text = "".join(row + end for row, end in zip(rows, (*lines[1::2], ""), strict=True))
    after = "\n".join(row.translate(_NOT_READ) for row in rows)
    encoded = found.encoding.encode(text)
    return Formatted(source.text, shown(after), encoded, encoded != data, laid.unread)


def _put(row: str, raw: str) -> str:
    """Return a line with other words; what is not ours stays round them, or all as it was."""
    behind = raw.lstrip(DROPPED)
    words = behind.rstrip(DROPPED)
    if words.translate(_NOT_READ) != words or _foreign(words) != _foreign(row):
        return raw
    return raw[: len(raw) - len(behind)] + row + behind[len(words) :]


def _foreign(text: str) -> str:
    """Return the characters that no word of the language has."""
    return "" if text.isascii() else "".join(sign for sign in text if not sign.isascii())
