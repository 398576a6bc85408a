"""Which statements both programs executed, one after the other."""

from bisect import bisect_right
from collections.abc import Iterator
from typing import NamedTuple

from vrts.engine.history import History, ProgramHistory
from vrts.engine.memory.events import Cause


class Statement(NamedTuple):
    """One statement as it was executed."""

    number: int  # statements finished with it
    cause: Cause
    process: bool  # of the process control program


def statements(history: History, first: int, last: int) -> list[Statement]:
    """Return the statements after the first so many, up to the last so many."""
    both = [*_of(history, history.robot, first, last), *_of(history, history.process, first, last)]
    return sorted(both, key=lambda statement: statement.number)


def _of(history: History, program: ProgramHistory, first: int, last: int) -> Iterator[Statement]:
    trace, causes = program.trace, history.code.causes
    last = min(last, history.finished)
    k = max(bisect_right(trace.begun, first) - 1, 0)
    while k < len(trace.begun) and trace.begun[k] < last:
        begin = trace.counts[k]
        following = k + 1 < len(trace.counts)
        end = trace.counts[k + 1] if following else len(trace.instructions)
        for at in range(begin, end):
            number = trace.begun[k] + at - begin + 1
            if first < number <= last:
                yield Statement(number, causes[trace.instructions[at]], not program.is_robot)
        k += 1
