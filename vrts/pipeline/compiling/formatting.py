"""Programs laid out anew."""

from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.lang.dialect import DIALECTS
from vrts.lang.reading.decoding import decode
from vrts.lang.reading.detection import detect
from vrts.lang.writing.layout import layout


class Formatted(NamedTuple):
    """A program in canonical layout."""

    before: str
    after: str
    data: bytes  # of the file as it should be
    changed: bool  # whether that is another than it is
    diagnostic: Diagnostic | None = None  # why the file cannot be read


def format_bytes(data: bytes, name: str, dialect: str | None) -> Formatted:
    """Return the canonical layout of a program, with LF line ends."""
    source = decode(data, name)
    if isinstance(source, Diagnostic):
        return Formatted("", "", data, False, source)
    chosen = DIALECTS[dialect] if dialect is not None else detect(source)[0]
    after = layout(source, chosen)
    if not after.endswith("\n"):
        after += "\n"
    encoded = _encoded_like(after, data)
    return Formatted(source.text, after, encoded, encoded != data)


def _encoded_like(text: str, data: bytes) -> bytes:
    """Return text as UTF-8, or in the 8-bit code page of a file that is no UTF-8."""
    try:
        data.decode("utf-8")
    except UnicodeDecodeError:
        try:
            return text.encode("cp1252")
        except UnicodeEncodeError:
            return text.encode()
    return text.encode()
