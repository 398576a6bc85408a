"""Decisions about many that were made at once: what one key has done, one key undoes.

Each is about one student, so that it can be undone alone.
"""

from collections.abc import Iterator, Mapping
from typing import Final

from msgspec.structs import replace

from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import ChangeMark, Comment, Decision, Give

NOBODY: Final = ("",)


def made_at_once(ledger: Ledger, undone: Mapping[str, str]) -> Iterator[tuple[str, ...]]:
    """Yield names of records that say the same of several students and were written at once.

    Args:
        ledger: The records that whoever looks may see.
        undone: By name of a record, that of the undo: what is undone is left out.
    """
    run: list[Filed] = []
    for one in ledger.records:
        if run and not _together(run[-1], one):
            yield from _left(run, undone)
            run = []
        run.append(one)
    yield from _left(run, undone)


def _left(run: list[Filed], undone: Mapping[str, str]) -> Iterator[tuple[str, ...]]:
    left = tuple(one.name for one in run if one.name not in undone)
    if len(left) > 1:
        yield left


def _together(before: Filed, one: Filed) -> bool:
    if before.grader != one.grader or before.said.at != one.said.at:
        return False
    return _words(before.said) == _words(one.said) is not None


def _words(said: Decision) -> Decision | None:
    """Return a record as if it were about nobody; None where it is not given to many like that."""
    match said:
        case Comment():
            return replace(said, number=1, student="", program="")
        case Give() | ChangeMark():
            return replace(said, number=1, students=NOBODY, programs={})
        case _:
            return None
