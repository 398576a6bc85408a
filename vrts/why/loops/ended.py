"""Loops that ended too soon: what led out of them, and by which values."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.engine.memory.cells import Cell
from vrts.ir.control import BeginFor, Jump, JumpIf, NextFor, TestFor
from vrts.ir.expressions import Place
from vrts.ir.instructions import Instruction
from vrts.why.chain import Link
from vrts.why.shown import value
from vrts.why.slicing.conditions import asked_for, with_values
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.read import Reading, places_in, reading
from vrts.why.slicing.sources import chain_of, element_text, written


class Loop(NamedTuple):
    """A loop of a program: from its first instruction to the one that leads back."""

    first: int
    last: int


def loop_left(steps: Steps, last: Executed) -> Iterator[Link]:
    """Yield why the loop round a step ended after it: round the step, or round a CALL to it.

    Args:
        steps: Of the run.
        last: The last time that the step was executed.
    """
    step: Executed | None = last
    while step is not None:
        program, within = steps.program_of(step.at)
        test, loop = _test_round(program.instructions, within), _round(program.instructions, within)
        if test is not None and (loop is None or test >= loop.first):
            yield from _counted_out(steps, step, test)
            return
        if loop is not None:
            yield from _led_out(steps, step, loop)
            return
        entered = steps.entered(step.activation)
        step = entered if entered is not None and steps.calls(entered) else None


def _counted_out(steps: Steps, inside: Executed, test: int) -> Iterator[Link]:
    """Yield how a FOR ended, and who set its variable or its limit."""
    program, _ = steps.program_of(inside.at)
    base = steps.base_of(inside.at)
    instruction = program.instructions[test]
    assert isinstance(instruction, TestFor)
    tests = [n for n in steps.times(base + test) if n > inside.number]
    if not tests:
        return
    over = steps.step(tests[0])
    assert over is not None
    begun = _begin_of(program.instructions, instruction.loop)
    was = reading(steps, instruction.place, over.number - 1, over.activation)
    ended = f"the loop ends here with `{element_text(instruction.place)}` at {value(was.value)}"
    span = program.origins[begun].span if begun is not None else over.cause.span
    yield Link(steps.time_of(over), span, ended)
    writer = _written_inside(steps, was.cell, over.number - 1)
    if writer is not None:
        yield from writer
    elif begun is not None:
        limits = program.instructions[begun]
        times = [n for n in steps.times(base + begun) if n < over.number]
        if isinstance(limits, BeginFor) and times:
            yield from _first_of(steps, limits.last, times[-1], over)


def _first_of(steps: Steps, expression: object, number: int, of: Executed) -> Iterator[Link]:
    """Yield where the first variable of a limit came from, as a loop began."""
    for place in places_in(expression):
        was = reading(steps, place, number - 1, of.activation)
        if was.known:
            yield from chain_of(steps, was)
            return


def _led_out(steps: Steps, inside: Executed, loop: Loop) -> Iterator[Link]:
    """Yield which step led out of a loop that goes by a condition, and what it went by."""
    program, _ = steps.program_of(inside.at)
    base = steps.base_of(inside.at)
    exits = [k for k in range(loop.first, loop.last + 1) if _leaves(program.instructions[k], loop)]
    numbers = [n for k in exits for n in steps.times(base + k)[-1:] if n > inside.number]
    step = steps.step(max(numbers)) if numbers else None
    if step is None:
        return
    condition = getattr(step.instruction, "condition", None)
    says = f"the loop ends here{with_values(steps, condition, step)}"
    yield Link(steps.time_of(step), step.cause.span, says)
    asked = asked_for(steps, condition, step)
    still = [r for r in asked if not _changed_in(steps, r, base + loop.first, base + loop.last)]
    for each in (still or asked)[:1]:
        yield from chain_of(steps, each)


def _leaves(instruction: Instruction, loop: Loop) -> bool:
    """Return whether an instruction can lead out of a loop; the last one does if it only may."""
    if not isinstance(instruction, Jump | JumpIf):
        return False
    outside = not loop.first <= instruction.target <= loop.last
    return outside or (isinstance(instruction, JumpIf) and instruction.target == loop.first)


def _changed_in(steps: Steps, each: Reading, first: int, last: int) -> bool:
    """Return whether an instruction of a loop gave a variable its value."""
    source = None if each.cell is None else written(steps, each.cell, each.before)
    return source is not None and source.step is not None and first <= source.step.at <= last


def _written_inside(steps: Steps, cell: Cell | None, before: int) -> Iterator[Link] | None:
    """Return where another step than FOR and its END wrote a loop's variable, if one did last."""
    if cell is None:
        return None
    for since in reversed([n for n in cell.since if n <= before]):
        step = steps.step(since)
        if step is None or isinstance(step.instruction, BeginFor):
            return None
        if isinstance(step.instruction, NextFor):
            continue
        return _wrote(steps, step)
    return None


def _wrote(steps: Steps, step: Executed) -> Iterator[Link]:
    place = getattr(step.instruction, "place", None)
    if not isinstance(place, Place):
        return
    after = reading(steps, place, step.number, step.activation)
    yield from chain_of(steps, after)


def _test_round(instructions: tuple[Instruction, ...], index: int) -> int | None:
    """Return the test of the innermost FOR round an instruction."""
    for k in range(index, -1, -1):
        one = instructions[k]
        if isinstance(one, TestFor) and one.leave > index:
            return k
    return None


def _round(instructions: tuple[Instruction, ...], index: int) -> Loop | None:
    """Return the innermost loop round an instruction that a jump back makes."""
    found: Loop | None = None
    for k in range(index, len(instructions)):
        one = instructions[k]
        if isinstance(one, Jump | JumpIf) and one.target <= index:
            inner = Loop(one.target, k)
            if found is None or inner.first > found.first:
                found = inner
    return found


def _begin_of(instructions: tuple[Instruction, ...], loop: int) -> int | None:
    for k, one in enumerate(instructions):
        if isinstance(one, BeginFor) and one.loop == loop:
            return k
    return None
