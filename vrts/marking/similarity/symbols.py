"""A program as symbols in which names, numbers, comments and layout no longer count."""

import re
import zlib
from collections.abc import Sequence
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile, Span
from vrts.lang.dialect import VAL2
from vrts.lang.problems import Problems
from vrts.lang.reading.classify import classify
from vrts.lang.reading.decoding import decode
from vrts.lang.reading.sections.lines import Line, Section
from vrts.lang.reading.splitter import split
from vrts.lang.reading.tokeniser import tokenise
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.functions import applied_functions
from vrts.lang.vocabulary.lookup import reserved_words

MOST_SYMBOLS = 40_000  # of a program; what follows is not compared
MOST_REMEMBERED = 50_000  # different lines whose symbols are kept

_LABEL = re.compile(r"\d+[ \t]+(?=\S)")
_PIECE = re.compile(r"[A-Za-z][\w.]*|\d[\w.]*|\S")
_NAMES = frozenset({"NAME", "STRINGNAME", "JOINTNAME", "WORD"})
_END_OF_STEP = zlib.crc32(b"end of step")


class Part(NamedTuple):
    """One program of a file, without its first and last line."""

    symbols: tuple[int, ...]
    lines: tuple[int, ...]  # of the file, from 1, for every symbol


class Readable(NamedTuple):
    """What there is to compare of a file."""

    source: SourceFile
    sections: tuple[Section, ...]


def readable(data: bytes, name: str) -> Readable | None:
    """Return a file cut into sections; None for what is no text."""
    source = decode(data, name)
    if isinstance(source, Diagnostic):
        return None
    return Readable(source, tuple(split(Problems(source))))


class Reader:
    """Turns lines into symbols; the same line only once."""

    def __init__(self) -> None:
        """Nothing is read yet."""
        self._seen: dict[str, tuple[int, ...]] = {}
        self._functions = {name.upper() for name in applied_functions(VAL2)}
        self._reserved = reserved_words(VAL2)

    def parts(self, file: Readable) -> tuple[Part, ...]:
        """Return the programs of a file; locations and other data are no part of them."""
        found: list[Part] = []
        room = MOST_SYMBOLS
        for section in file.sections:
            if section.kind == "program" and room > 0:
                part = self._part(file.source, section.lines, room)
                found.append(part)
                room -= len(part.symbols)
        return tuple(found)

    def _part(self, source: SourceFile, lines: Sequence[Line], room: int) -> Part:
        symbols: list[int] = []
        numbers: list[int] = []
        for line in lines:
            new = self._of_line(line.text)
            symbols += new
            numbers += [Span(source, line.start, line.end).line] * len(new)
            if len(symbols) >= room:
                break
        return Part(tuple(symbols[:room]), tuple(numbers[:room]))

    def _of_line(self, text: str) -> tuple[int, ...]:
        found = self._seen.get(text)
        if found is None:
            found = self._read(text)
            if len(self._seen) < MOST_REMEMBERED:
                self._seen[text] = found
        return found

    def _read(self, text: str) -> tuple[int, ...]:
        step = _LABEL.sub("", text, count=1) if text[:1].isdecimal() else text
        tokens = tokenise(step, 0, Problems.none())
        if tokens:
            words = [self._word(token) for token in classify(tokens)[0]]
        else:  # not VAL-II: still to be compared
            words = [self._rough(piece) for piece in _PIECE.findall(step)]
        return (*(zlib.crc32(word.encode("utf-8", "replace")) for word in words), _END_OF_STEP)

    def _word(self, token: Token) -> str:
        if token.kind in ("NUMBER", "STRING"):
            return token.kind
        upper = token.text.upper()
        if token.kind in _NAMES and upper not in self._functions:
            return "NAME"
        return upper

    def _rough(self, piece: str) -> str:
        if piece[0].isdigit():
            return "NUMBER"
        upper = piece.upper()
        return "NAME" if piece[0].isalpha() and upper not in self._reserved else upper
