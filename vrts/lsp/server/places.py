"""Offsets of a text to positions of the protocol and back."""

from lsprotocol import types

from vrts.base.source import SourceFile


class Places:
    """The positions of one text, in the units that the client counts in."""

    def __init__(self, source: SourceFile, encoding: str) -> None:
        """Take the text and a position encoding of the protocol: utf-8, utf-16 or utf-32."""
        self.source = source
        self.encoding = encoding

    def position(self, offset: int) -> types.Position:
        """Return the position of an offset; one beyond the text is its end."""
        source = self.source
        offset = max(0, min(offset, len(source.text)))
        line = source.line_of(offset)
        before = source.text[source.line_starts[line - 1] : offset]
        return types.Position(line - 1, self._units(before))

    def range(self, start: int, end: int) -> types.Range:
        """Return a range of offsets."""
        return types.Range(self.position(start), self.position(end))

    def offset(self, position: types.Position) -> int:
        """Return the offset of a position; one beyond a line is the line's end."""
        starts = self.source.line_starts
        if position.line < 0:
            return 0
        if position.line >= len(starts):
            return len(self.source.text)
        start = starts[position.line]
        line = self.source.line_text(position.line + 1)
        if line.isascii() or self.encoding == "utf-32":
            return start + max(0, min(position.character, len(line)))
        units = 0
        for at, character in enumerate(line):
            if units >= position.character:
                return start + at
            units += self._units(character)
        return start + len(line)

    def length(self, start: int, end: int) -> int:
        """Return how many units a range of offsets of one line has."""
        return self._units(self.source.text[start:end])

    def _units(self, text: str) -> int:
        if text.isascii() or self.encoding == "utf-32":
            return len(text)
        if self.encoding == "utf-8":
            return len(text.encode("utf-8", "replace"))
        return len(text) + sum(ord(character) > 0xFFFF for character in text)
