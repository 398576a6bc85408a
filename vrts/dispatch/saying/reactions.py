"""Which signals a program watches, and the programs that are called when one changes."""

from typing import NamedTuple

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import constant, parts
from vrts.dispatch.saying.signals import FIRST_INPUT, FIRST_INTERNAL, signal_of
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function, Global, Place
from vrts.ir.module import Module


class Reaction(NamedTuple):
    """What a REACT or REACTI asks for."""

    signal: int  # an input
    on: bool  # whether it waits for the signal to come on
    program: str | None
    immediate: bool  # the motion is given up
    always: bool  # it stays armed
    priority: float


def executed(module: Module, entries: tuple[str, ...]) -> list[str]:
    """Return the programs that are executed, by calls and as reactions, from some on."""
    seen: list[str] = []
    waiting = list(entries)
    while waiting:
        name = waiting.pop()
        if name in seen or name not in module.programs:
            continue
        seen.append(name)
        for step in module.programs[name].instructions:
            begun = isinstance(step, ir.Call | ir.React | ir.StartProcess)
            if begun and step.program is not None:
                waiting.append(step.program)
    return seen


def called(module: Module, programs: tuple[str, ...]) -> list[str]:
    """Return programs and those that they call."""
    seen: list[str] = []
    waiting = list(programs)
    while waiting:
        name = waiting.pop()
        if name not in seen:
            seen.append(name)
            steps = module.programs[name].instructions
            waiting += [step.program for step in steps if isinstance(step, ir.Call)]
    return seen


def reaction_of(step: ir.React) -> Reaction:
    """Return what a step asks for.

    Raises:
        CannotSay: It is worked out in the run, or no input is watched.
    """
    signal, on = signal_of(step.signal)
    if not FIRST_INPUT <= signal < FIRST_INTERNAL:
        raise CannotSay(f"signal {signal} is watched and is no input", "watch an input")
    priority = 1.0 if step.priority is None else constant(step.priority)
    if priority is None:
        raise CannotSay("a priority is worked out in the run", "write a number")
    if step.after_motion:
        raise CannotSay("ON waits for the end of the motion", "use ONI")
    return Reaction(signal, on, step.program, step.immediate, step.always, priority)


def reacts(module: Module, entry: str) -> list[ir.React]:
    """Return the steps that begin to watch a signal."""
    programs = executed(module, (entry,))
    steps = (step for name in programs for step in module.programs[name].instructions)
    return [step for step in steps if isinstance(step, ir.React)]


class Shared(NamedTuple):
    """What reactions and the other programs both know: names of variables, numbers of signals."""

    written: frozenset[str]  # by reactions
    named: frozenset[str]  # in reactions

    def disturbs(self, step: ir.Instruction) -> str | None:
        """Return what a step and a reaction both know, if one of them changes it."""
        written, named = names_of(step)
        found = sorted((written & self.named) | (named & self.written))
        return found[0] if found else None


def shared(module: Module, programs: list[str]) -> Shared:
    """Return what the programs of reactions write and name."""
    found = [names_of(step) for name in programs for step in module.programs[name].instructions]
    written = (name for one, _ in found for name in one)
    named = (name for one, other in found for name in (*one, *other))
    return Shared(frozenset(written), frozenset(named))


def names_of(step: ir.Instruction) -> tuple[set[str], set[str]]:
    """Return the variables and internal signals that a step writes, and those that it names."""
    written: set[str] = set()
    named: set[str] = set()
    for part in parts(step):
        if isinstance(part, Place) and isinstance(part.variable, Global):
            named.add(part.variable.name)
        if isinstance(part, Apply) and part.function is Function.SIG:
            named |= _internal(part.arguments)
        if isinstance(part, Apply) and part.function is Function.TIMER:
            named.add(f"TIMER {constant(part.arguments[0])}")
    if isinstance(step, ir.Assign | ir.AssignHere | ir.BeginFor) and isinstance(
        step.place.variable, Global
    ):
        written.add(step.place.variable.name)
    if isinstance(step, ir.Call):
        places = (a for a in step.arguments if isinstance(a, Place))
        written |= {a.variable.name for a in places if isinstance(a.variable, Global)}
    if isinstance(step, ir.Signal):
        written |= _internal(step.signals)
    if isinstance(step, ir.SetTimer):
        written.add(f"TIMER {constant(step.number)}")
    return written, named


def _internal(arguments: tuple[object, ...]) -> set[str]:
    numbers = (signal_of(argument)[0] for argument in arguments)
    return {f"signal {number}" for number in numbers if number >= FIRST_INTERNAL}
