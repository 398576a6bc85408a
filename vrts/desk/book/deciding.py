"""A class with all decisions of all graders, from the files as they are."""

from typing import NamedTuple

from vrts.desk.book.decided import Decided, told_of
from vrts.desk.book.opened import Opened
from vrts.marking.by_hand.decisions.files import read_decisions
from vrts.marking.by_hand.decisions.state import state_of
from vrts.marking.by_hand.overrides import program_of
from vrts.marking.row import Class


class Deciding(NamedTuple):
    """A class, what graders decided, and what could not be read of it."""

    rows: Class
    decided: Decided
    problems: tuple[str, ...]


def decide(opened: Opened, me: str) -> Deciding:
    """Return a class with all decisions.

    Args:
        opened: What marking wrote.
        me: Id of whoever looks.

    Raises:
        CannotRead: A file cannot be read.
        Refused: A file has errors.
    """
    ledger = read_decisions(opened.layout.decisions)
    programs = {row.id: program_of(row.result) for row in opened.rows.rows}
    state = state_of(ledger, programs)
    problems = tuple(one.headline for one in ledger.diagnostics)
    return Deciding(opened.rows, told_of(ledger, state, programs, me), problems)
