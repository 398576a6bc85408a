"""When timers of a run were set, and to what: by the steps that did it."""

from bisect import bisect_right
from collections.abc import Mapping

import numpy as np

from vrts.debug.conditions.columns import Reals, Wholes
from vrts.debug.passages import Passages
from vrts.engine.run import Run
from vrts.ir.data import SetTimer
from vrts.ir.expressions import Constant


class Timers:
    """The times at which timers stood at zero [s], as they were after each step that set one."""

    def __init__(self, since: list[int], zeros: list[Mapping[int, float]]) -> None:
        """Take how many statements were finished after each, and all timers then."""
        self._since, self._zeros = since, zeros

    def at(self, finished: int) -> Mapping[int, float]:
        """Return the timers that were set, after so many statements."""
        k = bisect_right(self._since, finished)
        return self._zeros[k - 1] if k else {}

    def zeros_of(self, number: int) -> tuple[Wholes, Reals]:
        """Return when timers were set, and what a timer stood at before and after each [s]."""
        zeros = [0.0, *(known.get(number, 0.0) for known in self._zeros)]
        return np.array(self._since, np.int64), np.array(zeros)


def timers_of(run: Run) -> Timers | None:
    """Return when timers were set; None where a step works out which one, or to what."""
    code = run.history.code
    sets: dict[int, tuple[int, float]] = {}  # instruction: which timer, and to what
    for program, base in zip(code.programs, code.bases, strict=True):
        for k, instruction in enumerate(program.instructions):
            if not isinstance(instruction, SetTimer):
                continue
            number, value = instruction.number, instruction.value
            if not isinstance(number, Constant) or not isinstance(value, Constant):
                return None
            if not isinstance(number.value, float) or not isinstance(value.value, float):
                return None
            sets[base + k] = round(number.value), value.value
    found = sorted(
        (int(passages.before[k]) + 1, int(passages.instructions[k]))
        for passages in (Passages(run, process=of) for of in (False, True) if sets)
        for k in np.flatnonzero(np.isin(passages.instructions, [*sets])).tolist()
    )
    zeros: list[Mapping[int, float]] = []
    known: dict[int, float] = {}
    for finished, instruction in found:
        which, value = sets[instruction]
        known = {**known, which: run.history.time_of(finished) - value}
        zeros.append(known)
    return Timers([finished for finished, _ in found], zeros)
