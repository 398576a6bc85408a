"""Where everything stands in a TOML text.

`tomllib` gives values without places; this scanner gives places without values. It walks the text
by itself and never fails: on text that is not TOML it stops where it gets lost. `base.toml`
compares the two shapes, so that they cannot disagree in silence.
"""

from typing import NamedTuple, TypeAlias

Range: TypeAlias = tuple[int, int]  # half-open range of offsets

_BARE_KEY = frozenset("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-")
_ESCAPES = {
    "b": "\b",
    "t": "\t",
    "n": "\n",
    "f": "\f",
    "r": "\r",
    "e": "\x1b",
    '"': '"',
    "\\": "\\",
}
_CODE_POINTS = {"x": 2, "u": 4, "U": 8}
_DEEPEST = 16  # nested arrays and inline tables
_LONGEST_KEY = 8  # parts of a dotted key


class Place:
    """Where one value stands. Built while scanning, read only afterwards."""

    __slots__ = ("declared", "fields", "items", "key", "value")

    def __init__(self, key: Range, value: Range) -> None:
        self.key = key  # of the key's last part; of the element itself in an array
        self.value = value  # of a table: its header or, inline, its braces
        self.fields: dict[str, Place] | None = None  # of a table
        self.items: list[Place] | None = None  # of an array
        self.declared = False  # a table with a header of its own


class Twice(NamedTuple):
    """A key or table given twice."""

    name: str
    first: Range
    second: Range


class Layout(NamedTuple):
    """The result of a scan."""

    root: Place
    lost_at: int | None  # where the scanner no longer understood the text
    open_at: int | None  # the innermost bracket, brace or quote still open there
    twice: Twice | None  # the first key or table given twice
    too_deep: bool  # brackets or dots nested beyond reason; lost there


class _LostError(Exception):
    """The scanner does not understand the text."""


def places(text: str) -> Layout:
    """Return where every key, table and value of a TOML text stands."""
    scanner = _Scanner(text)
    try:
        scanner.document()
    except _LostError:
        open_at = scanner.openings[-1] if scanner.openings else None
        return Layout(scanner.root, scanner.at, open_at, scanner.twice, scanner.too_deep)
    return Layout(scanner.root, None, None, scanner.twice, too_deep=False)


class _Scanner:
    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0
        self.openings: list[int] = []
        self.twice: Twice | None = None
        self.too_deep = False
        self.root = Place((0, 0), (0, 0))
        self.root.fields = {}

    def document(self) -> None:
        table = self.root
        while True:
            self.blanks_and_lines()
            if self.at >= len(self.text):
                return
            if self.text.startswith("[[", self.at):
                table = self.header(2)
            elif self.text[self.at] == "[":
                table = self.header(1)
            else:
                self.key_and_value(table)
            self.end_of_line()

    # blanks

    def blanks(self) -> None:
        while self.text[self.at : self.at + 1] in (" ", "\t"):
            self.at += 1

    def comment(self) -> None:
        if self.text[self.at : self.at + 1] == "#":
            end = self.text.find("\n", self.at)
            self.at = len(self.text) if end < 0 else end

    def blanks_and_lines(self) -> None:
        while self.text[self.at : self.at + 1] in (" ", "\t", "\n", "\r", "#"):
            if self.text[self.at] == "#":
                self.comment()
            else:
                self.at += 1

    def end_of_line(self) -> None:
        self.blanks()
        self.comment()
        if self.text.startswith("\r\n", self.at):
            self.at += 2
        elif self.text.startswith("\n", self.at):
            self.at += 1
        elif self.at < len(self.text):
            raise _LostError

    # keys and tables

    def key(self) -> list[tuple[str, Range]]:
        parts = [self.key_part()]
        self.blanks()
        while self.text.startswith(".", self.at):
            self.at += 1
            self.blanks()
            parts.append(self.key_part())
            self.blanks()
            if len(parts) > _LONGEST_KEY:
                self.too_deep = True
                raise _LostError
        return parts

    def key_part(self) -> tuple[str, Range]:
        start = self.at
        quote = self.text[start : start + 1]
        if quote in ('"', "'"):
            return (self.quoted_key(quote), (start, self.at))
        while self.at < len(self.text) and self.text[self.at] in _BARE_KEY:
            self.at += 1
        if self.at == start:
            raise _LostError
        return (self.text[start : self.at], (start, self.at))

    def quoted_key(self, quote: str) -> str:
        start = self.at
        self.string(quote)
        inner = self.text[start + 1 : self.at - 1]
        return unescaped(inner) if quote == '"' else inner

    def header(self, brackets: int) -> Place:
        start = self.at
        self.openings.append(start)
        self.at += brackets
        self.blanks()
        parts = self.key()
        if not self.text.startswith("]" * brackets, self.at):
            raise _LostError
        self.at += brackets
        self.openings.pop()
        whole = (start, self.at)
        parent = self.walk(self.root, parts[:-1], whole)
        name, key = parts[-1]
        fields = self.fields_of(parent)
        known = fields.get(name)
        if brackets == 2:
            if known is None:
                known = Place(key, whole)
                known.items = []
                fields[name] = known
            elif known.items is None:
                self.note_twice(name, known.key, key)
                known.items = []
            element = Place(key, whole)
            element.fields = {}
            known.items.append(element)
            return element
        if known is None:
            known = Place(key, whole)
            known.fields = {}
            fields[name] = known
        elif known.declared or known.fields is None:
            self.note_twice(".".join(part for part, _ in parts), known.key, key)
            known.fields = known.fields or {}
        known.key, known.value, known.declared = key, whole, True
        return known

    def walk(self, table: Place, parts: list[tuple[str, Range]], whole: Range) -> Place:
        for name, key in parts:
            fields = self.fields_of(table)
            following = fields.get(name)
            if following is None:
                following = Place(key, whole)
                following.fields = {}
                fields[name] = following
            if following.items:
                following = following.items[-1]
            table = following
        return table

    def fields_of(self, table: Place) -> "dict[str, Place]":
        if table.fields is None:  # not TOML: a plain value used as a table
            raise _LostError
        return table.fields

    def key_and_value(self, table: Place) -> None:
        parts = self.key()
        if not self.text.startswith("=", self.at):
            raise _LostError
        self.at += 1
        self.blanks()
        name, key = parts[-1]
        parent = self.walk(table, parts[:-1], (parts[0][1][0], key[1]))
        place = self.value(key)
        fields = self.fields_of(parent)
        if name in fields:
            self.note_twice(name, fields[name].key, key)
        fields[name] = place

    def note_twice(self, name: str, first: Range, second: Range) -> None:
        if self.twice is None:
            self.twice = Twice(name, first, second)

    # values

    def value(self, key: Range | None = None) -> Place:
        start = self.at
        place = Place((start, start), (start, start))
        first = self.text[start : start + 1]
        if len(self.openings) > _DEEPEST:
            self.too_deep = True
            raise _LostError
        if first in ('"', "'"):
            self.string(first)
        elif first == "[":
            place.items = self.array()
        elif first == "{":
            place.fields = self.inline_table()
        else:
            while self.at < len(self.text) and self.text[self.at] not in ",]}#\r\n":
                self.at += 1
            length = len(self.text[start : self.at].rstrip())
            if not length:
                raise _LostError
            self.at = start + length
        place.value = (start, self.at)
        place.key = key or place.value
        return place

    def string(self, quote: str) -> None:
        self.openings.append(self.at)
        if self.text.startswith(quote * 3, self.at):
            self.at += 3
            self.until(quote, quote * 3)
            for _ in range(2):  # the text itself may end in one or two quotes
                if self.text.startswith(quote, self.at):
                    self.at += 1
        else:
            self.at += 1
            self.until(quote, quote)
        self.openings.pop()

    def until(self, quote: str, closing: str) -> None:
        while not self.text.startswith(closing, self.at):
            if self.at >= len(self.text) or (len(closing) == 1 and self.text[self.at] == "\n"):
                raise _LostError
            self.at += 2 if quote == '"' and self.text[self.at] == "\\" else 1
        self.at += len(closing)

    def array(self) -> list[Place]:
        self.openings.append(self.at)
        self.at += 1
        items: list[Place] = []
        self.blanks_and_lines()
        while not self.text.startswith("]", self.at):
            items.append(self.value())
            self.blanks_and_lines()
            self.comma_unless("]")
        self.at += 1
        self.openings.pop()
        return items

    def inline_table(self) -> dict[str, Place]:
        self.openings.append(self.at)
        table = Place((self.at, self.at), (self.at, self.at))
        table.fields = {}
        self.at += 1
        self.blanks_and_lines()
        while not self.text.startswith("}", self.at):
            self.key_and_value(table)
            self.blanks_and_lines()
            self.comma_unless("}")
        self.at += 1
        self.openings.pop()
        return table.fields

    def comma_unless(self, closing: str) -> None:
        if self.text.startswith(",", self.at):
            self.at += 1
            self.blanks_and_lines()
        elif not self.text.startswith(closing, self.at):
            raise _LostError


def unescaped(text: str) -> str:
    r"""Return the characters that a basic TOML string stands for; unknown escapes stay."""
    if "\\" not in text:
        return text
    parts: list[str] = []
    at = 0
    while at < len(text):
        if text[at] != "\\":
            parts.append(text[at])
            at += 1
            continue
        letter = text[at + 1 : at + 2]
        digits = _CODE_POINTS.get(letter, 0)
        code = text[at + 2 : at + 2 + digits]
        if letter in _ESCAPES:
            parts.append(_ESCAPES[letter])
            at += 2
        elif digits and len(code) == digits and all(c in "0123456789abcdefABCDEF" for c in code):
            number = int(code, 16)
            parts.append(chr(number) if number <= 0x10FFFF else "\ufffd")
            at += 2 + digits
        else:
            parts.append("\\")
            at += 1
    return "".join(parts)
