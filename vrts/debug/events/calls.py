"""The table of calls: every time a program was executed, by whom, with what, and for how long."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.debug.events.columns import Column, Columns
from vrts.debug.passages import Instant, instant_of, last_instant
from vrts.debug.stops.stop import Stop, Why
from vrts.engine.history import ProgramHistory
from vrts.engine.memory.cells import Array, Bound, Undefined
from vrts.engine.memory.events import Cause
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.monitor.listings import value_text
from vrts.report.plain import one_line

MOST_SHOWN = 200  # characters of arguments


class Call(NamedTuple):
    """A row: one execution of a program."""

    run: Run
    activation: Activation
    process: bool
    depth: int  # programs that call each other then; 1: nothing called it
    begin: Instant
    end: Instant
    over: bool  # otherwise it went on to the end of the run

    @property
    def program(self) -> str:
        """The name of the program."""
        return self.run.history.code.programs[self.activation.program].name

    @property
    def cause(self) -> Cause | None:
        """The step that called it; None: somebody executed it."""
        called = self.activation.called_from
        return None if called is None else self.run.history.code.causes[called]

    @property
    def took_s(self) -> float:
        """How long it went on [s]."""
        return self.end.time_s - self.begin.time_s

    @property
    def arguments(self) -> str:
        """What it was called with: names and values."""
        formals = self.run.history.code.programs[self.activation.program].formals
        slots = self.activation.slots
        given = zip(formals, slots[: len(formals)], strict=True)
        text = ", ".join(_given(slot.name, bound, self.begin.finished) for slot, bound in given)
        return text if len(text) <= MOST_SHOWN else f"{text[:MOST_SHOWN]} …"


def _given(name: str, bound: Bound, finished: int) -> str:
    if isinstance(bound, Array):
        known = (cell.at(finished) for cell in bound.elements.values())
        return f"{name}[]: {sum(not isinstance(value, Undefined) for value in known)} elements"
    value = bound.at(finished)
    text = "undefined" if isinstance(value, Undefined) else value_text(value)
    return f"{name} = {' '.join(text.split())}"


COLUMNS: Columns[Call] = {
    "program": Column("which was called", lambda c: c.program),
    "from": Column(
        "when it began; `here` is where you stand", lambda c: c.begin.time_s, "s", number=True
    ),
    "to": Column("when it was over, or the run was", lambda c: c.end.time_s, "s", number=True),
    "took": Column("how long that is", lambda c: c.took_s, "s", number=True),
    "depth": Column(
        "programs that call each other then; 1: the first", lambda c: c.depth, number=True
    ),
    "caller": Column(
        "program that called it", lambda c: None if c.cause is None else c.cause.program
    ),
    "line": Column(
        "of the call", lambda c: None if c.cause is None else c.cause.span.line, number=True
    ),
    "arguments": Column("names and values that it was called with", lambda c: c.arguments),
    "thread": Column(
        "of which it is", lambda c: "process" if c.process else "robot", only=("robot", "process")
    ),
}


def calls_of(run: Run) -> list[Call]:
    """Return every call of a run, by the time at which it began."""
    found = [
        call
        for history, process in ((run.history.robot, False), (run.history.process, True))
        for call in _of_thread(run, history, process=process)
    ]
    return sorted(found, key=lambda call: call.begin)


def _of_thread(run: Run, history: ProgramHistory, *, process: bool) -> Iterator[Call]:
    last = last_instant(run)
    open_: list[tuple[Activation, int]] = []  # under way, each with when it began
    at: dict[int, int] = {}  # place of each in it

    def closed(length: int, end: Instant, *, over: bool) -> Iterator[Call]:
        while len(open_) > length:
            activation, since = open_.pop()
            del at[id(activation)]
            begin = instant_of(run, since)
            yield Call(run, activation, process, len(open_) + 1, begin, end, over)

    for since, innermost in zip(history.trace.changed, history.trace.activations, strict=True):
        if since > run.statements:
            break
        new: list[Activation] = []
        inside = innermost
        while inside is not None and id(inside) not in at:
            new.append(inside)
            inside = inside.caller
        kept = 0 if inside is None else at[id(inside)] + 1
        if kept < len(open_):
            yield from closed(kept, instant_of(run, since), over=True)
        for activation in reversed(new):
            at[id(activation)] = len(open_)
            open_.append((activation, since))
    yield from closed(0, last, over=False)


def text_of(call: Call) -> str:
    """Return a call in one line."""
    by = call.cause
    where = "" if by is None else f", called by {by.program}, line {by.span.line}"
    ends = f"took {call.took_s:.3f} s" if call.over else "not over"
    inside = f"({call.arguments})" if call.arguments else ""
    return one_line(f"{call.program}{inside}, {ends}{where}")


def stop_at(call: Call) -> Stop:
    """Return where to stand to see a call: before its first step."""
    return Stop(call.begin, Why.GO, f"{call.program} begins", process=call.process)
