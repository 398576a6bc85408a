"""Which structure words of a program belong together, and which have no partner."""

from bisect import bisect_left
from collections.abc import Sequence
from itertools import product
from typing import NamedTuple

from vrts.lang.steps.one_line import ONE_LINE
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
OPENED = {line: word for word, line in ONE_LINE.items()}  # `IF x THEN READY` and its like
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


class Crossed(NamedTuple):
    """An UNTIL, a VALUE or an ANY of a structure while others inside it are open."""

    mark: Mark
    open: list[Block]  # the innermost first
    end: Mark | None  # an END behind it


class Pairing(NamedTuple):
    """Structures, and what is wrong with them."""

    blocks: list[Block]
    unmatched: list[Unmatched]
    late: list[Late]
    open: list[Block]
    crossed: list[Crossed]

    @property
    def faults(self) -> int:
        """How many words have no partner."""
        return len(self.unmatched) + len(self.late) + len(self.open) + len(self.crossed)


class Reading(NamedTuple):
    """How the forms of other languages are taken."""

    else_if_opens: bool = False  # ELSEIF has an END of its own
    one_line_opens: bool = False  # `IF x THEN step` and its like have an END below
    while_closes: bool = False  # `WHILE x` without DO ends a DO, as in C
    group_closes: bool = False  # VALUE and ANY end what is open inside their CASE


READINGS = tuple(Reading(*ways) for ways in product((False, True), repeat=4))
_MARKING = frozenset({*_WORDS, Structure, Bad})  # statements that may be structure words
BARE_WHILE = "WHILE x"  # a WHILE without its DO


def word_of(step: Step) -> str | None:
    """Return the structure word of a step, also of one that did not parse."""
    node = step.statement
    if isinstance(node, Structure | Bad):
        return node.word
    return _WORDS.get(type(node)) if node is not None else None


def marks(steps: Sequence[Step]) -> list[Mark]:
    """Return the structure words of a program in their order."""
    structural = [at for at, step in enumerate(steps) if type(step.statement) in _MARKING]
    found = ((word_of(steps[at]), at) for at in structural)
    return [Mark(_told_apart(word, steps[at]), at) for word, at in found if word is not None]


def _told_apart(word: str, step: Step) -> str:
    return BARE_WHILE if word == "WHILE" and isinstance(step.statement, Bad) else word


def pair(found: Sequence[Mark], reading: Reading = READINGS[0]) -> Pairing:
    """Return which words belong together, each END to what was opened last."""
    pairing = Pairing([], [], [], [], [])
    open_ = pairing.open
    owed: Mark | None = None  # an UNTIL that left structures open
    for number, mark in enumerate(found):
        word = mark.word
        behind, owed = owed, None
        if word == BARE_WHILE:
            closes = reading.while_closes and bool(open_) and open_[-1].word == "DO"
            word = "UNTIL" if closes else "WHILE"
        if word == ELSE_IF:
            if open_ and open_[-1].word == "IF":
                if reading.else_if_opens:
                    open_.append(Block("IF", mark.at, [], -1))
            else:
                pairing.unmatched.append(Unmatched(mark, open_[-1] if open_ else None))
        elif word in OPENERS or (word in OPENED and reading.one_line_opens):
            open_.append(Block(OPENED.get(word, word), mark.at, [], -1))
        elif word in ("ELSE", "VALUE", "ANY"):
            if reading.group_closes and word != "ELSE":
                _end_inside(pairing, mark, "CASE")
            _group(pairing, mark, found)
        elif word in ("END", "UNTIL"):
            top = open_[-1] if open_ else None
            if word == "END" and behind is not None and mark.at == behind.at + 1:
                pairing.crossed[-1] = pairing.crossed[-1]._replace(end=mark)
            elif top is not None and (top.word == "DO") == (word == "UNTIL"):
                pairing.blocks.append(open_.pop()._replace(end=mark.at))
            elif word == "UNTIL" and any(block.word == "DO" for block in open_):
                _end_inside(pairing, mark, "DO")
                pairing.blocks.append(open_.pop()._replace(end=mark.at))
                owed = mark
            elif top is not None and found[number + 1 : number + 2] == [Mark("UNTIL", mark.at + 1)]:
                pairing.unmatched.append(Unmatched(mark, None))  # `END` above the UNTIL of a DO
            else:
                pairing.unmatched.append(Unmatched(mark, top))
                if top is not None:
                    open_.pop()  # a DO closed by END, a FOR by UNTIL: said once
    return pairing


def _end_inside(pairing: Pairing, mark: Mark, word: str) -> None:
    """End what is open inside the innermost structure of a word, to which a mark belongs."""
    open_ = pairing.open
    if not any(block.word == word for block in open_):
        return
    inside: list[Block] = []
    while open_[-1].word != word:
        inside.append(open_.pop())
    if inside:
        pairing.crossed.append(Crossed(mark, inside, None))


def _group(pairing: Pairing, mark: Mark, found: Sequence[Mark]) -> None:
    top = pairing.open[-1] if pairing.open else None
    if top is None or top.word != ("IF" if mark.word == "ELSE" else "CASE"):
        pairing.unmatched.append(Unmatched(mark, top))
        return
    last = found[bisect_left(found, top.middles[-1], key=_step_of)] if top.middles else None
    if last is not None and last.word in _LAST:
        pairing.late.append(Late(mark, last))
    else:
        top.middles.append(mark.at)


def _step_of(mark: Mark) -> int:
    return mark.at
