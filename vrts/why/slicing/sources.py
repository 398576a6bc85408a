"""Where a value came from: written by which step, passed by which CALL, in which line of data."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.source import Span
from vrts.engine.memory.cells import Cell
from vrts.engine.memory.trace import Activation
from vrts.ir.control import BeginFor, Call, CallNamed, NextFor
from vrts.ir.expressions import Compose, Place, Slot, WholeArray
from vrts.ir.instructions import Assign
from vrts.why.chain import Link
from vrts.why.shown import value, where_of
from vrts.why.slicing.entered import reacted
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.given import is_given
from vrts.why.slicing.read import (
    Reading,
    constants_in,
    element,
    only_place,
    places_in,
    reading,
    readings,
)

DEEPEST = 12  # values that a chain is followed through


class Source(NamedTuple):
    """Where a value was written."""

    step: Executed | None
    span: Span | None  # of data
    time_s: float | None


def written(steps: Steps, cell: Cell, before: int) -> Source | None:
    """Return where the value was written that a cell had; None where it had none."""
    since = [n for n in cell.since if n <= before]
    if not since:
        return None
    step = steps.step(since[-1])
    if since[-1] == 0 or step is None:
        datum = steps.data.get(cell.name)
        return Source(None, datum.span if datum else None, None)
    return Source(step, None, steps.time_of(step))


def chain_of(steps: Steps, first: Reading, depth: int = 0) -> Iterator[Link]:
    """Yield where a value came from, step by step, to data or to numbers of the source."""
    if depth > DEEPEST:
        return
    alias = _alias(steps, first)
    source = None
    if first.cell is not None and first.known:
        source = written(steps, first.cell, first.before)
    by = None if source is None else source.step
    inside = alias is not None and by is not None and by.number > alias.number
    if inside and by is not None:
        yield from _of_step(steps, by, first, _named(first), depth)
    yield from _subscripts(steps, first, depth)
    if alias is not None:
        yield alias.link
        if alias.inner is not None:
            yield from _subscripts(steps, alias.inner, depth + 1)
    if source is None or inside:
        return
    if by is not None:
        yield from _of_step(steps, by, first, _named(first), depth)
    elif source.span is not None and first.cell is not None:
        yield Link(None, source.span, f"`{first.cell.name}` is {where_of(first.value)}")


def chosen(steps: Steps, first: Reading) -> Iterator[Link]:
    """Yield by what a variable was chosen whose value is right: its CALL, its subscripts."""
    yield from _subscripts(steps, first, 0)
    alias = _alias(steps, first)
    if alias is not None:
        yield alias.link
        if alias.inner is not None:
            yield from _subscripts(steps, alias.inner, 1)


def _of_step(steps: Steps, step: Executed, first: Reading, name: str, depth: int) -> Iterator[Link]:
    """Yield how a step came to the value that it wrote, and where that came from."""
    cell = first.cell
    assert cell is not None
    time_s = steps.time_of(step)
    who = " by the other program" if step.process else ""
    instruction = step.instruction
    if isinstance(instruction, Call | CallNamed) and cell.name == "argument":
        argument = _argument(first)
        says = f"`{name}` is {where_of(first.value)}, passed here{who}"
        yield Link(time_s, step.cause.span, says)
        yield from _read_by(steps, step, argument, depth)
        return
    shown = name if cell.name == "argument" else cell.name
    if isinstance(instruction, BeginFor | NextFor):
        begun = _begun(steps, step)
        at = begun or step
        says = f"this loop{who} gives `{shown}` the value {where_of(first.value)}"
        yield Link(time_s, at.cause.span, says, minor=True)
        yield from _counted(steps, step, cell, depth)
        return
    target = getattr(instruction, "place", None)
    known_as = element_text(target) if isinstance(target, Place) else ""
    other = f" as `{known_as}`" if known_as and known_as != shown and "[" not in known_as else ""
    yield Link(time_s, step.cause.span, f"`{shown}` is set to {where_of(first.value)}{other}{who}")
    if isinstance(instruction, Assign) and not any(True for _ in constants_in(instruction.value)):
        yield from _read_by(steps, step, None, depth)
    else:
        yield from reacted(steps, step)


def _counted(steps: Steps, step: Executed, cell: Cell, depth: int) -> Iterator[Link]:
    """Yield what a loop counted on from, where another step had set its variable meanwhile."""
    place = getattr(step.instruction, "place", None)
    earlier = [n for n in cell.since if n < step.number]
    by = steps.step(earlier[-1]) if earlier else None
    if not isinstance(step.instruction, NextFor) or by is None or not isinstance(place, Place):
        return
    if isinstance(by.instruction, BeginFor | NextFor):
        return
    target = getattr(by.instruction, "place", None)
    if isinstance(target, Place):
        yield from chain_of(steps, reading(steps, target, by.number, by.activation), depth + 1)


def _read_by(steps: Steps, step: Executed, only: object, depth: int) -> Iterator[Link]:
    """Yield where the values came from that a step read: of the one that was written last."""
    found = [r for r in readings(steps, step) if r.known]
    if only is not None:
        index = only if isinstance(only, int) else None
        arguments = getattr(step.instruction, "arguments", ())
        if index is not None and index < len(arguments):
            given = arguments[index]
            if isinstance(given, Compose) and len(given.parts) > 1:
                parts = set(places_in(given))
                yield from _parts(steps, [r for r in found if r.place in parts], depth)
                return
            inside = only_place(given)
            found = [r for r in found if inside is not None and r.place == inside]
    made = getattr(step.instruction, "value", None)
    if isinstance(made, Compose) and len(made.parts) > 1 and only is None:
        yield from _parts(steps, found, depth)
        return
    for each in telling(steps, found):
        yield from chain_of(steps, each, depth + 1)
        return


def _parts(steps: Steps, found: list[Reading], depth: int) -> Iterator[Link]:
    """Yield where the parts of a compound location came from: those that the scene does not give.

    Where a step wrote one of them, or the scene gives all, only one is followed.
    """
    parts = found[1::-1]  # what is nearest the tool first
    newest = telling(steps, found)[:1]
    doubtful = [each for each in parts if not is_given(steps, each)]
    if not doubtful or _set_by_step(steps, newest[0]):
        doubtful = newest
    for each in doubtful:
        yield from chain_of(steps, each, depth + 1)


def _set_by_step(steps: Steps, each: Reading) -> bool:
    source = None if each.cell is None else written(steps, each.cell, each.before)
    return source is not None and source.step is not None


def telling(steps: Steps, found: list[Reading]) -> list[Reading]:
    """Return values by what they tell: those that steps wrote, the last first; then data."""

    def late(r: Reading) -> int:
        assert r.cell is not None
        source = written(steps, r.cell, r.before)
        return source.step.number if source is not None and source.step is not None else 0

    return sorted(found, key=late, reverse=True)


class _Alias(NamedTuple):
    """An argument by reference: which variable it is, and the CALL that passed it."""

    link: Link
    inner: Reading | None
    number: int  # of the CALL's statement


def _alias(steps: Steps, first: Reading) -> _Alias | None:
    """Return the CALL that passed a variable by reference under another name."""
    variable, activation = first.place.variable, first.activation
    if not isinstance(variable, Slot):
        return None
    if first.cell is not None and first.cell.name == "argument":
        return None
    return passed(steps, variable.number, variable.name, activation)


def passed(steps: Steps, index: int, name: str, activation: Activation | None) -> _Alias | None:
    """Return which variable an argument is, by the CALL that passed it."""
    call = steps.entered(activation)
    if call is None or not isinstance(call.instruction, Call | CallNamed):
        return None
    arguments = call.instruction.arguments
    given = arguments[index] if index < len(arguments) else None
    time_s = steps.time_of(call)
    if isinstance(given, WholeArray):
        says = f"`{name}[]` is `{given.variable.name}[]`, passed here"
        return _Alias(Link(time_s, call.cause.span, says), None, call.number)
    if not isinstance(given, Place):
        return None
    inner = reading(steps, given, call.number - 1, call.activation)
    real = element(steps, given, call.number - 1, call.activation)
    says = f"`{name}` is `{real}`, passed here"
    return _Alias(Link(time_s, call.cause.span, says), inner, call.number)


def _subscripts(steps: Steps, first: Reading, depth: int) -> Iterator[Link]:
    """Yield where the subscripts of an element came from, where they are computed."""
    for each in first.place.subscripts:
        for place in places_in(each):
            inner = reading(steps, place, first.before, first.activation)
            if inner.known:  # which element it was: first to be left out of a chain too long
                found = chain_of(steps, inner, depth + 1)
                yield from (link._replace(minor=True) for link in found)
            return


def _begun(steps: Steps, step: Executed) -> Executed | None:
    """Return the FOR of the loop whose variable a step counted on."""
    if isinstance(step.instruction, BeginFor):
        return step
    loop = getattr(step.instruction, "loop", None)
    program, _ = steps.program_of(step.at)
    base = steps.base_of(step.at)
    for index, instruction in enumerate(program.instructions):
        if isinstance(instruction, BeginFor) and instruction.loop == loop:
            numbers = [
                n for n in steps.times(base + index, process=step.process) if n < step.number
            ]
            return steps.step(numbers[-1]) if numbers else None
    return None


def _argument(first: Reading) -> int | None:
    variable = first.place.variable
    return variable.number if isinstance(variable, Slot) else None


def _named(first: Reading) -> str:
    return element_text(first.place)


def element_text(place: Place) -> str:
    """Return a place as its program writes it."""
    text = place.span.text if place.span is not None else ""
    return " ".join(text.split()) or place.variable.name


def telling_value(reading: Reading) -> str:
    """Return the name and the value of what was read."""
    return f"`{element_text(reading.place)}` is {value(reading.value)}"
