"""When something changes: a variable, a location, a signal."""

import re
from collections.abc import Iterator
from typing import NamedTuple

from vrts.debug.passages import Instant, instant_of
from vrts.engine.memory.cells import UNDEFINED, Cell, Content, Undefined, cells_of
from vrts.engine.memory.events import SignalChanged
from vrts.engine.run import Run
from vrts.lang.names import key
from vrts.monitor.listings import value_text

_SIGNAL = re.compile(r"(?:SIG|SIGNAL)?\s*\(?\s*(\d{1,5})\s*\)?", re.IGNORECASE)


class Change(NamedTuple):
    """Something has just changed."""

    instant: Instant  # right after it
    text: str  # what it was and what it is


def changes(run: Run, name: str) -> list[Change]:
    """Return every change of what a name stands for, in order.

    Args:
        run: What happened.
        name: A variable as states list it (`x`, `$s`, `a[3]`, `#safe`), an array (`a`: any of its
            elements), or a signal (`1001`, `SIG(1001)`).
    """
    signal = _SIGNAL.fullmatch(name.strip())
    if signal is not None:
        return list(_of_signal(run, int(signal[1])))
    wanted = key(name.strip().replace(" ", ""))
    found: list[Change] = []
    for bound in run.history.memory.bound:
        if bound.name == wanted or wanted.startswith(f"{bound.name}["):
            for cell in cells_of(bound):
                if wanted in (bound.name, cell.name):
                    found += _of_cell(run, cell)
    return sorted(found)


def _of_signal(run: Run, signal: int) -> Iterator[Change]:
    for event, number in zip(run.events, run.event_numbers, strict=True):
        if isinstance(event, SignalChanged) and event.signal == signal:
            state = "on" if event.on else "off"
            yield Change(Instant(event.time_s, number), f"signal {signal} is {state}")


def _of_cell(run: Run, cell: Cell) -> Iterator[Change]:
    before: Content = UNDEFINED
    for since in cell.since:
        if since > run.statements:
            return
        value = cell.at(since)
        if value != before:
            text = f"{cell.name}: {_shown(before)} -> {_shown(value)}"
            yield Change(instant_of(run, since), text)
        before = value


def _shown(value: Content) -> str:
    return "undefined" if isinstance(value, Undefined) else value_text(value)
