"""A text file out of which pieces are cut; every other byte stays as it was."""

from collections.abc import Iterable

from vrts.base.source import SourceFile

WIDE = {b"\xff\xfe": "utf-16-le", b"\xfe\xff": "utf-16-be"}
BOM = b"\xef\xbb\xbf"


class RawText:
    """The bytes of a text, and the text as tables and TOML are read: each line end is one."""

    def __init__(self, data: bytes, name: str) -> None:
        """Decode a text: UTF-8, UTF-16 with its mark, else one byte a character."""
        self._mark = data[:2] if data[:2] in WIDE else BOM if data.startswith(BOM) else b""
        body = data[len(self._mark) :]
        self._codec = WIDE.get(self._mark, "utf-8")
        try:
            self._raw = body.decode(self._codec)
        except UnicodeDecodeError:
            self._codec = "latin-1"
            self._raw = body.decode(self._codec)
        self._places: list[int] = []  # in the bytes' text, by offset in the other
        at = 0
        while at < len(self._raw):
            self._places.append(at)
            at += 2 if self._raw.startswith("\r\n", at) else 1
        self._places.append(len(self._raw))
        text = self._raw.replace("\r\n", "\n").replace("\r", "\n")
        self.source = SourceFile(name, text)

    def without(self, pieces: Iterable[tuple[int, int]]) -> bytes:
        """Return the bytes without half-open ranges of the text, which do not overlap."""
        kept: list[str] = []
        end = 0
        for first, last in sorted(pieces):
            kept.append(self._raw[end : self._places[first]])
            end = self._places[last]
        kept.append(self._raw[end:])
        return self._mark + "".join(kept).encode(self._codec)
