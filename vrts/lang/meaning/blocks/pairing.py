"""Which structure words of a program belong together, and which have no partner."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.lang.syntax.program import Step
from vrts.lang.syntax.statements import (
    Bad,
    Case,
    For,
    If,
    Structure,
    Until,
    ValueGroup,
    While,
)

ELSE_IF = "ELSEIF"  # `ELSEIF x THEN`, which VAL-II does not have
ONE_LINE_IF = "IF THEN"  # `IF x THEN READY`, which it does not have either
OPENERS = frozenset({"IF", "WHILE", "FOR", "CASE", "DO"})
_LAST = frozenset({"ELSE", "ANY"})  # nothing but the end follows their group
_WORDS: dict[type, str] = {
    If: "IF",
    While: "WHILE",
    For: "FOR",
    Case: "CASE",
    Until: "UNTIL",
    ValueGroup: "VALUE",
}


class Block(NamedTuple):
    """One structure: indices into the steps of its program."""

    word: str  # IF, WHILE, FOR, CASE, DO
    opener: int
    middles: list[int]  # ELSE, or VALUE and ANY
    end: int


class Mark(NamedTuple):
    """A structure word of a program."""

    word: str
    at: int  # index of its step


class Unmatched(NamedTuple):
    """A word that belongs to no structure."""

    mark: Mark
    top: Block | None  # what is open there


class Late(NamedTuple):
    """A group behind the last one of its structure."""

    mark: Mark
    last: Mark


class Pairing(NamedTuple):
    """Structures, and what is wrong with them."""

    blocks: list[Block]
    unmatched: list[Unmatched]
    late: list[Late]
    open: list[Block]

    @property
    def faults(self) -> int:
        """How many words have no partner."""
        return len(self.unmatched) + len(self.late) + len(self.open)


class Reading(NamedTuple):
    """How the forms of other languages are taken."""

    else_if_opens: bool = False  # ELSEIF has an END of its own
    one_line_opens: bool = False  # `IF x THEN step` has an END below


READINGS = (Reading(), Reading(True), Reading(False, True), Reading(True, True))


def word_of(step: Step) -> str | None:
    """Return the structure word of a step, also of one that did not parse."""
    node = step.statement
    if isinstance(node, Structure | Bad):
        return node.word
    return _WORDS.get(type(node)) if node is not None else None


def marks(steps: Sequence[Step]) -> list[Mark]:
    """Return the structure words of a program in their order."""
    found = ((word_of(step), at) for at, step in enumerate(steps))
    return [Mark(word, at) for word, at in found if word is not None]


def pair(found: Sequence[Mark], reading: Reading = READINGS[0]) -> Pairing:
    """Return which words belong together, each END to what was opened last."""
    pairing = Pairing([], [], [], [])
    open_ = pairing.open
    for mark in found:
        word = mark.word
        if word == ELSE_IF:
            if open_ and open_[-1].word == "IF":
                if reading.else_if_opens:
                    open_.append(Block("IF", mark.at, [], -1))
            else:
                pairing.unmatched.append(Unmatched(mark, open_[-1] if open_ else None))
        elif word in OPENERS or (word == ONE_LINE_IF and reading.one_line_opens):
            open_.append(Block("IF" if word == ONE_LINE_IF else word, mark.at, [], -1))
        elif word in ("ELSE", "VALUE", "ANY"):
            _group(pairing, mark, found)
        elif word in ("END", "UNTIL"):
            top = open_[-1] if open_ else None
            if top is not None and (top.word == "DO") == (word == "UNTIL"):
                pairing.blocks.append(open_.pop()._replace(end=mark.at))
                continue
            pairing.unmatched.append(Unmatched(mark, top))
            if top is not None and word == "END":
                open_.pop()  # a DO closed by END: said once
    return pairing


def _group(pairing: Pairing, mark: Mark, found: Sequence[Mark]) -> None:
    top = pairing.open[-1] if pairing.open else None
    if top is None or top.word != ("IF" if mark.word == "ELSE" else "CASE"):
        pairing.unmatched.append(Unmatched(mark, top))
        return
    last = next((m for m in found if top.middles and m.at == top.middles[-1]), None)
    if last is not None and last.word in _LAST:
        pairing.late.append(Late(mark, last))
    else:
        top.middles.append(mark.at)
