"""Programs that are being executed: the step that each is at, and whose arguments are whose."""

from collections.abc import Mapping
from typing import NamedTuple

from vrts.debug.passages import Instant
from vrts.engine.memory.cells import Cell
from vrts.engine.memory.events import Cause
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.ir.values import Value


class Frame(NamedTuple):
    """A program that is being executed."""

    cause: Cause  # the step that it is at
    activation: Activation | None
    process: bool  # called, maybe indirectly, by the process control program
    innermost: bool

    def locals(self, run: Run, at: Instant) -> Mapping[str, Value]:
        """Return its arguments and automatic variables that have a value at an instant."""
        return run.at_moment(at.time_s, at.finished).locals_of(self.activation)

    def seen(self, run: Run, at: Instant) -> Mapping[str, Value | None]:
        """Return the same, with those that have no value then: they hide what is global."""
        return seen_by(run, at, self.activation)

    def declared(self, run: Run) -> tuple[str, ...]:
        """Return the names of its arguments and automatic variables."""
        if self.activation is None:
            return ()
        program = run.history.code.programs[self.activation.program]
        return tuple(slot.name for slot in (*program.formals, *program.autos))


def frames(run: Run, at: Instant, *, process: bool) -> tuple[Frame, ...]:
    """Return what is being executed at an instant, the innermost program first."""
    state = run.at_moment(at.time_s, at.finished)
    stack = state.process_stack if process else state.call_stack
    program = run.history.process if process else run.history.robot
    activation = program.trace.activation(at.finished)
    found: list[Frame] = []
    for cause in reversed(stack):
        found.append(Frame(cause, activation, process, innermost=not found))
        activation = activation.caller if activation is not None else None
    return tuple(found)


def seen_by(run: Run, at: Instant, activation: Activation | None) -> Mapping[str, Value | None]:
    """Return arguments and automatic variables of a program; None for those without a value."""
    if activation is None:
        return {}
    program = run.history.code.programs[activation.program]
    slots = zip((*program.formals, *program.autos), activation.slots, strict=True)
    found: dict[str, Value | None] = {s.name: None for s, bound in slots if isinstance(bound, Cell)}
    found.update(run.at_moment(at.time_s, at.finished).locals_of(activation))
    return found
