"""What the names of a line stand for where the debugger stands, in short: drawn behind the line.

A program's lines up to the one at which it stands, as the rest has not come yet. It is ours, so the
name begins with `vrts.`.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import cast

from vrts.base.oat import components
from vrts.base.pose import Pose
from vrts.base.units import deg
from vrts.debug.dap.arguments import Fields
from vrts.debug.dap.session import Answer, Session
from vrts.engine.memory.cells import UNDEFINED
from vrts.engine.memory.trace import Activation
from vrts.ir.control import React
from vrts.ir.data import DelayedSignal, Pulse, Signal
from vrts.ir.expressions import Apply, Function
from vrts.ir.instructions import Instruction
from vrts.ir.module import Program
from vrts.ir.values import Value
from vrts.monitor.listings import value_text
from vrts.report.plain import one_line
from vrts.why.slicing.executed import Steps
from vrts.why.slicing.read import element, number, places_in, reading

MOST_LINES = 2_000  # that are looked at
MOST_NAMES = 8  # of a line
_LONGEST = 24  # letters of a string


def _inline(session: Session, a: Fields) -> Answer:
    """Return a text for each line that uses a name with a value, of the program of a frame."""
    debugger, path = session.debugger, a.optional("path")
    first, last = a.whole("first", 1), a.whole("last", MOST_LINES)
    last = min(last, first + MOST_LINES)
    frame = session.frame(a)
    stack = session.stack(process=frame.process if frame else debugger.stop.process)
    cause = frame.cause if frame is not None else next(iter(stack), None)
    code = debugger.run.history.code
    program = next(
        (
            p
            for p in code.programs
            if cause and p.span.source is cause.span.source and p.name == cause.program
        ),
        None,
    )
    if cause is None or program is None or (path and program.span.source.name != path):
        return Answer({"values": []})
    if frame is not None:
        last = min(last, cause.span.line)
    activation = None if frame is None else frame.activation
    look = _Look(session, activation)
    rows = look.lines(program, first, last)
    return Answer({"values": [{"line": line, "text": text} for line, text in rows]})


class _Look:
    """The values of one moment."""

    def __init__(self, session: Session, activation: Activation | None) -> None:
        debugger = session.debugger
        self._steps = Steps(debugger.run)
        self._before = debugger.at.finished
        self._on = debugger.state.signals
        self._activation = activation

    def lines(self, program: Program, first: int, last: int) -> Iterator[tuple[int, str]]:
        """Yield lines with what their names stand for."""
        found: dict[int, dict[str, str]] = {}
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            if first <= origin.span.line <= last:
                named = found.setdefault(origin.span.line, {})
                for name, text in (*self._variables(instruction), *self._signals(instruction)):
                    named.setdefault(name, text)
        for line, named in sorted(found.items()):
            if named:
                texts = list(named.values())
                more = ", …" if len(texts) > MOST_NAMES else ""
                yield line, ", ".join(texts[:MOST_NAMES]) + more

    def _variables(self, instruction: Instruction) -> Iterator[tuple[str, str]]:
        steps, before, activation = self._steps, self._before, self._activation
        for place in places_in(instruction):
            read = reading(steps, place, before, activation)
            if read.cell is None or read.value is UNDEFINED:
                continue
            _, bracket, inside = element(steps, place, before, activation).partition("[")
            name = f"{place.variable.name}{bracket}{inside}"
            yield name, f"{name} = {short(cast('Value', read.value))}"

    def _signals(self, instruction: Instruction) -> Iterator[tuple[str, str]]:
        for expression in _of_signals(instruction):
            value = number(self._steps, expression, self._before, self._activation)
            if value is not None and round(value):
                signal = abs(round(value))
                name = f"SIG({signal})"
                yield name, f"{name} {'on' if signal in self._on else 'off'}"


def short(value: Value) -> str:
    """Return a value in a few letters: x, y and z of a location [mm], the beginning of a text."""
    if isinstance(value, Pose):
        return _numbers(components(value)[:3])
    if isinstance(value, tuple):
        return _numbers([deg(joint) for joint in value])
    if isinstance(value, str) and len(value) > _LONGEST:
        value = value[: _LONGEST - 1] + "…"
    return one_line(value_text(value)).strip()


def _numbers(values: Sequence[float]) -> str:
    return " ".join(f"{round(value, 1) + 0.0:g}".replace("-", "−") for value in values)


def _of_signals(node: object) -> Iterator[object]:
    """Yield the expressions that number signals."""
    if isinstance(node, Signal):
        yield from node.signals
    elif isinstance(node, Pulse | DelayedSignal | React):
        yield node.signal
    elif isinstance(node, Apply) and node.function is Function.SIG:
        yield from node.arguments
    elif isinstance(node, tuple):
        for part in cast("tuple[object, ...]", node):
            yield from _of_signals(part)


INLINE: Mapping[str, Callable[[Session, Fields], Answer]] = {"vrts.inline": _inline}
