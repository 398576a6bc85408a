"""Bytes of a file as characters, and those characters as the same bytes again.

Nobody says in which code page an old program was written, so bytes that are no UTF-8 are read one
by one, as Windows' Western page has them. What that page does not know becomes a lone surrogate,
as PEP 383 does it: every byte has its character, and every character its byte.
"""

from typing import NamedTuple

MAX_CONTROL_SHARE = 0.02  # of control characters in what still counts as text
UNKNOWN = "\ufffd"  # shown for what is no character

_CONTROLS = frozenset(range(32)) - {0, 9, 10, 12, 13, 26}
_SURROGATES = dict.fromkeys(range(0xD800, 0xE000), UNKNOWN)


class Encoding(NamedTuple):
    """How characters were made of bytes."""

    codec: str  # as Python calls it
    errors: str  # what Python does with bytes that are no characters
    mark: bytes = b""  # a byte order mark before everything
    tail: bytes = b""  # half a character behind everything

    def encode(self, text: str) -> bytes:
        """Return the bytes of a text; of the text that was read, exactly those of the file.

        Raises:
            UnicodeEncodeError: The text holds a character that the encoding does not have.
        """
        return self.mark + text.encode(self.codec, self.errors) + self.tail


class Characters(NamedTuple):
    """The text of a file, with a lone surrogate for each byte that is no character."""

    text: str
    encoding: Encoding


def characters(data: bytes) -> Characters | None:
    """Return the text of bytes, with all its control characters; None where it is no text."""
    for mark, codec in ((b"\xff\xfe", "utf-16-le"), (b"\xfe\xff", "utf-16-be")):
        if data.startswith(mark):
            return _wide(data[2:], codec, mark)
    half = len(data) // 2
    odd, even = data[1::2].count(0), data[0::2].count(0)
    if odd > 0.6 * half > 2 and even < 0.1 * half:
        return _wide(data, "utf-16-le", b"")
    if even > 0.6 * half > 2 and odd < 0.1 * half:
        return _wide(data, "utf-16-be", b"")
    if data.count(0) > 0.3 * len(data):
        return None
    mark = b"\xef\xbb\xbf" if data.startswith(b"\xef\xbb\xbf") else b""
    try:
        text, found = data[len(mark) :].decode("utf-8"), Encoding("utf-8", "strict", mark)
    except UnicodeDecodeError:
        found = Encoding("cp1252", "surrogateescape")
        text = data.decode(found.codec, found.errors)
    return _if_printable(Characters(text, found))


def shown(text: str) -> str:
    """Return text as it can be printed: as long, with a sign for what is no character."""
    return text if text.isascii() else text.translate(_SURROGATES)


def _wide(data: bytes, codec: str, mark: bytes) -> Characters | None:
    tail = data[len(data) // 2 * 2 :]
    found = Encoding(codec, "surrogatepass", mark, tail)
    text = data[: len(data) - len(tail)].decode(codec, found.errors)
    return _if_printable(Characters(text, found))


def _if_printable(found: Characters) -> Characters | None:
    controls = sum(found.text.count(chr(code)) for code in _CONTROLS)
    return None if controls > MAX_CONTROL_SHARE * len(found.text) else found
