"""A program with one token dropped, doubled or replaced by a token of another kind."""

import random
from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.source import SourceFile
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems
from vrts.lang.reading.splitter import split
from vrts.lang.reading.tokeniser import tokenise
from vrts.lang.syntax.token import Token
from vrts.lang.vocabulary.lookup import never_names, spellings
from vrts.lang.vocabulary.words import OPERATORS

DROPPED, DOUBLED, REPLACED = KINDS = ("dropped", "doubled", "replaced")

_OPERANDS = frozenset({"NUMBER", "STRING", "NAME", "STRINGNAME", "JOINTNAME", "FORMAT"})
_SIGNS = frozenset({"+", "-", "NOT", "COM"})
_MAY_BE_MISSING = frozenset({"ALWAYS", "MMPS", "IPS", "MONITOR", "REAL", "DOUBLE", "LOC"})
_JOINS = frozenset({"operator", *_SIGNS, "*", "/", "MOD", "AND", "OR", "==", "<>", "<", ">", ":"})
_BLOCKS = frozenset({"IF", "ELSE", "END", "WHILE", "DO", "UNTIL", "FOR", "CASE", "VALUE", "ANY"})
_OPENING = frozenset({"(", "[", ","})
_CLOSING = frozenset({")", "]", ",", ""})


class Damage(NamedTuple):
    """What was done to a program."""

    kind: str
    token: str
    by: str  # what stands there instead
    line: int  # from 1
    text: str  # of the damaged program
    anywhere: bool  # whether its error may stand at another line: a block is open, or closed twice
    right: bool  # whether a right step is left, so that nobody could see the damage


class _Place(NamedTuple):
    """A token of a step, and what it is there."""

    line: list[Token]
    at: int
    written: str
    role: str  # "operand", "instruction", "keyword", or the sign itself


def damages(text: str, dialect: Dialect, chance: random.Random, count: int) -> Iterator[Damage]:
    """Yield a program with one damage each, at places and of kinds that chance chooses."""
    source = SourceFile("damaged.v2", text)
    places = list(_places(source, dialect))
    for _ in range(count if places else 0):
        place, kind = chance.choice(places), chance.choice(KINDS)
        others = [other.written for other in places if other.role != place.role]
        if kind == REPLACED and not others:
            continue
        by = {
            DROPPED: "",
            DOUBLED: f"{place.written} {place.written}",
            REPLACED: chance.choice(others) if others else "",
        }[kind]
        token = place.line[place.at]
        yield Damage(
            kind,
            place.written,
            by,
            source.line_of(token.start),
            f"{text[: token.start]} {by} {text[token.end :]}",
            place.line[0].text.upper() in _BLOCKS,
            _still_right(place, kind, by),
        )


def _places(source: SourceFile, dialect: Dialect) -> Iterator[_Place]:
    """Yield every token of every step."""
    for section in split(Problems(source, dialect)):
        if section.kind != "program":
            continue
        for line in section.lines:
            tokens = tokenise(line.text, line.start, Problems(source, dialect)) or []
            for index, token in enumerate(tokens):
                written = source.text[token.start : token.end]
                yield _Place(tokens, index, written, _role(tokens, index, dialect))


def _role(line: list[Token], index: int, dialect: Dialect) -> str:
    token = line[index]
    if token.kind in _OPERANDS:
        return "operand"
    upper = token.text.upper()
    if token.kind != "WORD":
        return "operator" if token.kind == "INFIX" and upper not in _SIGNS else token.text
    if upper in OPERATORS:
        return upper if upper in _SIGNS else "operator"
    after = _text(line, index + 1)
    if index == 0 and upper in spellings(dialect) and after not in ("=", "["):
        return "instruction"
    applied = after == "(" and upper not in _BLOCKS
    return "keyword" if upper in never_names(dialect) and not applied else "operand"


def _still_right(place: _Place, kind: str, by: str) -> bool:
    """Whether the step may have this form too.

    A sign before an operand may be there or not, as often as one likes; so may words that say how
    long a setting holds, and in which unit. An operand between commas may be left out, and a step
    as a whole.
    """
    line, index = place.line, place.at
    before = _text(line, index - 1)
    after = _text(line, index + 1)
    if kind == DOUBLED:
        return place.role in _SIGNS or (place.role == "," and "," not in (before, after))
    if kind == REPLACED:
        listed = by == "," and before in _OPENING and after in _CLOSING
        signed = by in _SIGNS and (after in _SIGNS or after == "(")
        merged = place.role == "," and by.upper() in _JOINS
        return len(line) == 1 or listed or signed or merged or {by, place.role} <= _JOINS
    if place.written.upper() in _MAY_BE_MISSING or place.role in _SIGNS:
        return True
    if place.role == "instruction":
        return _step_is_left(line[1:])
    if place.role == ",":
        return after in _SIGNS or after in ("", ",") or after[:1] == "/" or index == 1
    if place.role != "operand":
        return False
    if after in _SIGNS:
        return True  # the sign behind it becomes the sign of the next operand
    if after == "(":
        return _commas(line, index + 1) == 0  # `SIN(x)` to `(x)`
    bounded = before in _OPENING or before in (")", "BY") or index <= 1
    return bounded and (after in _CLOSING or index == 1)


def _step_is_left(line: list[Token]) -> bool:
    """Whether what stands behind an instruction is a step too: nothing, a label, an assignment."""
    texts = [token.text for token in line]
    return not texts or (len(texts) == 1 and line[0].kind == "NUMBER") or "=" in texts


def _text(line: list[Token], index: int) -> str:
    return line[index].text.upper() if 0 <= index < len(line) else ""


def _commas(line: list[Token], opening: int) -> int:
    """Return how many commas stand in the parentheses that a token opens."""
    depth = commas = 0
    for token in line[opening:]:
        depth += (token.text in "([") - (token.text in ")]")
        commas += token.text == "," and depth == 1
        if not depth:
            break
    return commas
