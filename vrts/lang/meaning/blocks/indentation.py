"""Where an END is missing, as the indentation of a program tells."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.lang.meaning.blocks.pairing import ELSE_IF, OPENERS, word_of
from vrts.lang.syntax.program import Step
from vrts.lang.syntax.statements import Bad


class Missing(NamedTuple):
    """A structure without its end: indices into the steps of its program."""

    word: str
    opener: int
    last: int  # its last step
    following: int | None  # the step before which its end belongs; None: where the program ends


class _Open(NamedTuple):
    word: str
    at: int
    column: int


def missing_ends(steps: Sequence[Step], columns: Sequence[int], wanted: int) -> list[Missing]:
    """Return the structures that have no end, if there are as many as are wanted.

    Args:
        steps: Steps of a program.
        columns: Where each begins in its line.
        wanted: How many ends are missing. Where indentation tells of another number it tells
            nothing, and nothing is returned.
    """
    found: list[Missing] = []
    open_: list[_Open] = []
    last = -1
    for at, step in enumerate(steps):
        node, word = step.statement, word_of(step)
        if node is None or (isinstance(node, Bad) and word is None):
            continue
        column = columns[at]
        while open_ and _is_over(open_[-1], word, column):
            found.append(Missing(open_[-1].word, open_.pop().at, last, at))
        if word in OPENERS:
            open_.append(_Open(word or "", at, column))
        elif word in ("END", "UNTIL"):
            if not open_ or (open_[-1].word == "DO") != (word == "UNTIL"):
                return []
            open_.pop()
        last = at
        if len(found) > wanted:
            return []
    found += [Missing(block.word, block.at, last, None) for block in reversed(open_)]
    bodies = all(columns[m.last] > columns[m.opener] for m in found)
    return found if len(found) == wanted and bodies else []


def _is_over(top: _Open, word: str | None, column: int) -> bool:
    """Whether a step at a column cannot stand inside a structure, or close it."""
    if column != top.column:
        return column < top.column
    if word in ("END", "UNTIL"):
        return (top.word == "DO") != (word == "UNTIL")
    if word in ("ELSE", ELSE_IF):
        return top.word != "IF"
    if word in ("VALUE", "ANY"):
        return top.word != "CASE"
    return True
