"""What every word of a text is, for colours: by its shape, and by what it names."""

import re
from collections.abc import Iterator
from enum import Enum
from functools import cache, lru_cache
from typing import NamedTuple

from vrts.editors.patterns import patterns
from vrts.lsp.documents.documents import Document
from vrts.lsp.documents.names import Occurrence, Target
from vrts.lsp.documents.uses import Kind, Role


class Colour(Enum):
    """Classes of words, named as the protocol names its types."""

    COMMENT = "comment"
    KEYWORD = "keyword"
    MACRO = "macro"  # .PROGRAM and its like
    STRING = "string"
    NUMBER = "number"
    OPERATOR = "operator"
    FUNCTION = "function"
    LABEL = "enumMember"
    LOCATION = "property"
    VARIABLE = "variable"
    PARAMETER = "parameter"


class Coloured(NamedTuple):
    """A word of one line; offsets into the text."""

    start: int
    end: int
    colour: Colour
    is_definition: bool = False
    is_built_in: bool = False


_SHAPES = {
    "comment": Colour.COMMENT,
    "section": Colour.MACRO,
    "string": Colour.STRING,
    "character": Colour.STRING,
    "label": Colour.LABEL,
    "structure": Colour.KEYWORD,
    "instruction": Colour.KEYWORD,
    "qualifier": Colour.KEYWORD,
    "number": Colour.NUMBER,
    "format": Colour.STRING,
    "function": Colour.FUNCTION,
    "constant": Colour.NUMBER,
    "word operator": Colour.OPERATOR,
    "string variable": Colour.VARIABLE,
    "precision point": Colour.LOCATION,
    "name": Colour.VARIABLE,
    "operator": Colour.OPERATOR,
}
_NAMES = frozenset({Kind.PROGRAM, Kind.LABEL, Kind.VARIABLE, Kind.LOCATION})


def coloured(document: Document, first: int = 0, last: int | None = None) -> Iterator[Coloured]:
    """Return the words of some lines in their order.

    Args:
        document: The buffer.
        first: First line, from 0.
        last: Last line; None: to the end of the text.
    """
    named = {o.start: o for o in document.names.occurrences}
    kinds: dict[Target, Kind | None] = {}
    starts = document.source.line_starts
    lines = document.source.text.split("\n")
    for number in range(first, len(lines) if last is None else min(last + 1, len(lines))):
        for start, end, colour in _shapes(lines[number]):
            at = starts[number] + start
            occurrence = named.get(at)
            if occurrence is not None and occurrence.end == starts[number] + end:
                yield _named(document, occurrence, colour, kinds)
            else:
                built_in = colour is Colour.FUNCTION
                yield Coloured(at, starts[number] + end, colour, False, built_in)


def _named(
    document: Document, o: Occurrence, colour: Colour, kinds: dict[Target, Kind | None]
) -> Coloured:
    if o.kind not in _NAMES:
        return Coloured(o.start, o.end, colour, False, o.kind is Kind.FUNCTION)
    target = o.target
    if target not in kinds:
        kinds[target] = document.names.kind_of(target)
    if target.family == "program":
        colour = Colour.FUNCTION
    elif target.family == "label":
        colour = Colour.LABEL
    elif target.program:
        colour = Colour.PARAMETER
    else:
        colour = Colour.LOCATION if kinds[target] is Kind.LOCATION else Colour.VARIABLE
    return Coloured(o.start, o.end, colour, o.role is Role.WRITE, False)


@lru_cache(1 << 15)
def _shapes(line: str) -> tuple[tuple[int, int, Colour], ...]:
    """Return what the shapes of a line tell: columns and class of its words."""
    found: list[tuple[int, int, Colour]] = []
    at = 0
    while at < len(line):
        for expression, parts in _expressions():
            match = expression.match(line, at)
            if match is None or match.end() == at:
                continue
            for number, part in enumerate(parts, 1 if len(parts) > 1 else 0):
                start, end = match.span(number)
                if part in _SHAPES and start < end:
                    start += len(line[start:end]) - len(line[start:end].lstrip())
                    found.append((start, end, _SHAPES[part]))
            at = match.end()
            break
        else:
            at += 1
    return tuple(found)


@cache
def _expressions() -> tuple[tuple[re.Pattern[str], tuple[str, ...]], ...]:
    flags = re.IGNORECASE | re.MULTILINE
    return tuple((re.compile(p.expression, flags), p.parts) for p in patterns())
