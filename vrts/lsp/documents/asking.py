"""Where in a line a cursor stands: the statement before it, and the call that is open there."""

import re
from typing import NamedTuple

from vrts.lang.reading.sections.lines import comment_start
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.lookup import look_up
from vrts.lang.vocabulary.word import Word
from vrts.lsp.documents.documents import Document

_LABEL = re.compile(r"[ \t]*(?:\d+(?:[ \t]+|$))?")
_PREFIX = re.compile(r"(?:[$#.]?[A-Za-z][\w.]*|[$#.])$", re.ASCII)
_FIRST = re.compile(r"[A-Za-z][\w.]*", re.ASCII)
_BEFORE_PARENTHESIS = re.compile(r"([$#]?[A-Za-z][\w.]*)[ \t]*$", re.ASCII)


class OpenCall(NamedTuple):
    """A call whose parenthesis is open."""

    name: str  # as written
    argument: int  # that the cursor stands in, from 0
    inside: str = ""  # what stands in it before the cursor


class Asked(NamedTuple):
    """What stands before a cursor on its line."""

    before: str  # the statement up to the cursor, without label
    prefix: str  # the word that is being typed; may be empty
    start: int  # offset of the prefix in the text
    word: Word | None  # the instruction of the statement, where it is complete
    call: OpenCall | None
    silent: bool  # inside a comment or a string

    @property
    def is_first(self) -> bool:
        """Whether the word that is typed is the first of the statement."""
        return not self.before[: len(self.before) - len(self.prefix)].strip()

    @property
    def operand(self) -> int:
        """Which operand of the instruction the cursor stands in, from 0."""
        return _commas(self.before)


def asked_at(document: Document, offset: int) -> Asked:
    """Return what stands before an offset on its line."""
    source = document.source
    line_start = source.line_starts[source.line_of(offset) - 1]
    line = source.text[line_start:offset]
    whole = source.line_text(source.line_of(offset))
    cut = comment_start(whole)
    silent = 0 <= cut < len(line) or line.count('"') % 2 == 1
    label = _LABEL.match(line)
    before = line[label.end() :] if label is not None else line
    found = _PREFIX.search(before)
    prefix = found.group() if found is not None else ""
    first = _FIRST.match(before)
    word = None
    if first is not None and first.end() < len(before):
        word = look_up(first.group(), document.dialect).word
    return Asked(before, prefix, offset - len(prefix), word, _open_call(before), silent)


def instruction_at(document: Document, offset: int) -> tuple[Word, int, int] | None:
    """Return the instruction whose word stands at an offset, and its range."""
    source = document.source
    number = source.line_of(offset)
    start, line = source.line_starts[number - 1], source.line_text(number)
    label = _LABEL.match(line)
    at = label.end() if label is not None else 0
    first = _FIRST.match(line, at)
    if first is None or not start + first.start() <= offset <= start + first.end():
        return None
    after = line[first.end() :].lstrip()
    if after.startswith("=") and not after.startswith("=="):
        return None
    word = look_up(first.group(), document.dialect).word or INSTRUCTIONS.get(first.group().upper())
    return None if word is None else (word, start + first.start(), start + first.end())


def _open_call(before: str) -> OpenCall | None:
    open_: list[int] = []
    quoted = False
    for at, sign in enumerate(before):
        quoted ^= sign == '"'
        if quoted:
            continue
        if sign in "([":
            open_.append(at)
        elif sign in ")]" and open_:
            open_.pop()
    while open_:
        at = open_.pop()
        name = _BEFORE_PARENTHESIS.search(before[:at])
        if before[at] == "(" and name is not None:
            return OpenCall(name.group(1), _commas(before[at + 1 :]), before[at + 1 :])
    return None


def _commas(text: str) -> int:
    """Return how many commas stand outside of parentheses and strings."""
    depth = count = 0
    quoted = False
    for sign in text:
        quoted ^= sign == '"'
        if quoted:
            continue
        depth += (sign in "([") - (sign in ")]")
        count += sign == "," and depth == 0
    return count
