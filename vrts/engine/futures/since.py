"""Variables that hold a reading of a timer, where all that is asked of it is how long ago that was.

`t0 = TIMER(1)` and then `UNTIL TIMER(1)-t0 > 2`: no two rounds read alike, but how long there is to
wait is the same. Readings are of single precision: up to `OLD_S` they are off by less than
`LITTLE_S`. So a comparison comes out as if they were exact, unless it is with just so many ticks.
"""

import math
from collections.abc import Iterator, Mapping
from typing import NamedTuple, TypeGuard

from vrts.engine.code.values.operands import number_of
from vrts.engine.futures.regions import COMPARISONS, Numbers, compared_only, number, variable
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.engine.machine.machine import Machine
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Binary, BinaryOperator, Function, Load
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Module

OLD_S = 2048.0  # readings beyond are too coarse
LITTLE_S = 5e-4  # and up to there two of them are together off by less
DIGITS = 4  # of what has passed [s]: what is less apart goes on alike, being so far from a border
BEYOND_S = 1.0  # what is longer ago than all that is asked, by more than this, is alike


class Asked(NamedTuple):
    """A reading that stands in an instruction together with a variable that holds an older one."""

    name: str  # of the variable
    timer: Apply
    held_s: float | None = None  # how much more than the reading it is given
    borders: tuple[float, ...] = ()  # [s], with which what has passed is compared


class Held(NamedTuple):
    """A variable that holds readings of a timer."""

    timer: int
    most_s: float  # what is longer ago is alike

    def passed(self, machine: Machine, value: float) -> object:
        """Return what stands for its value: how long ago it was, as far as that matters."""
        reading = machine.now - machine.system.timers.get(self.timer, 0.0)
        if abs(reading) > OLD_S or abs(value) > OLD_S:
            return value, reading
        return "ago", round(max(min(reading - value, self.most_s), -self.most_s), DIGITS)


def since(module: Module, tick_s: float, entry: str | None, *, once: bool) -> dict[str, Held]:
    """Return the variables that hold readings, of which only the time that has passed is asked.

    Args:
        module: The programs.
        tick_s: How often a controller reads [s].
        entry: The program that is executed.
        once: Whether it is executed once only.
    """
    held = compared_only(module)
    asked: dict[str, list[Asked]] = {}
    met: dict[str, int] = {}
    for program in module.programs.values():
        for instruction in program.instructions:
            for one in readings(instruction, held):
                asked.setdefault(one.name, []).append(one)
            for top in tops(instruction):
                for node in all_nodes(top):
                    for name in variable(node):
                        met[name] = met.get(name, 0) + 1
    found: dict[str, Held] = {}
    for name, uses in asked.items():
        timers = {number_of(one.timer.arguments[0]) for one in uses}
        given = {one.held_s for one in uses if one.held_s is not None}
        borders = {border for one in uses for border in one.borders}
        timer = next(iter(timers))
        if (
            met[name] == len(uses)
            and len(timers) == 1
            and timer is not None
            and given
            and not any(_is_near(border + more, tick_s) for border in borders for more in given)
            and _runs_on(module, timer, entry if once else None, frozenset(asked))
        ):
            most_s = max((abs(border) for border in borders), default=0.0) + BEYOND_S
            found[name] = Held(timer, most_s + max(map(abs, given)))
    return found


def readings(instruction: ir.Instruction, held: Mapping[str, Numbers]) -> Iterator[Asked]:
    """Yield readings that variables are given, or that are compared with what they hold.

    Args:
        instruction: Where they stand.
        held: Variables that are only compared with numbers.
    """
    match instruction:
        case ir.Assign(place=place, value=value):
            kept = variable(place)
            for timer, more in _reading(value):
                for name in kept:
                    yield Asked(name, timer, held_s=more)
            for name, timer in _passed(value):
                for own in kept:
                    if own in held:
                        yield Asked(name, timer, borders=held[own])
        case _:
            pass
    for top in tops(instruction):
        for node in all_nodes(top):
            if isinstance(node, Binary) and node.operator in COMPARISONS:
                for one, other in ((node.left, node.right), (node.right, node.left)):
                    yield from _compared(one, other)


def _compared(one: object, other: object) -> Iterator[Asked]:
    border = number(other)
    if border is not None:
        for name, timer in _passed(one):
            yield Asked(name, timer, borders=(border,))
    elif _is_timer(one):
        for name, more in _more(other):
            yield Asked(name, one, borders=(more,))


def _passed(node: object) -> Iterator[tuple[str, Apply]]:
    """Yield variable and timer of `TIMER(1)-t0`."""
    match node:
        case Binary(operator=BinaryOperator.SUBTRACT, left=timer, right=Load(place=place)):
            if _is_timer(timer):
                yield from ((name, timer) for name in variable(place))
        case _:
            pass


def _reading(node: object) -> Iterator[tuple[Apply, float]]:
    """Yield timer and number of `TIMER(1)`, `TIMER(1)+2`, `2+TIMER(1)` and `TIMER(1)-2`."""
    if _is_timer(node):
        yield node, 0.0
    match node:
        case Binary(operator=BinaryOperator.ADD, left=left, right=right):
            for one, other in ((left, right), (right, left)):
                more = number(other)
                if _is_timer(one) and more is not None:
                    yield one, more
        case Binary(operator=BinaryOperator.SUBTRACT, left=left, right=right):
            more = number(right)
            if _is_timer(left) and more is not None:
                yield left, -more
        case _:
            pass


def _more(node: object) -> Iterator[tuple[str, float]]:
    """Yield variable and number of `t0`, `t0+2`, `2+t0` and `t0-2`."""
    match node:
        case Load(place=place):
            yield from ((name, 0.0) for name in variable(place))
        case Binary(operator=BinaryOperator.ADD, left=left, right=right):
            for one, other in ((left, right), (right, left)):
                more = number(other)
                if isinstance(one, Load) and more is not None:
                    yield from ((name, more) for name in variable(one.place))
        case Binary(operator=BinaryOperator.SUBTRACT, left=Load(place=place), right=right):
            more = number(right)
            if more is not None:
                yield from ((name, -more) for name in variable(place))
        case _:
            pass


def _is_timer(node: object) -> TypeGuard[Apply]:
    return isinstance(node, Apply) and node.function is Function.TIMER


def _is_near(border_s: float, tick_s: float) -> bool:
    """Return whether a border is so near to a whole number of ticks that rounding may decide."""
    return abs(math.remainder(border_s, tick_s)) <= LITTLE_S


def _runs_on(module: Module, timer: int, once: str | None, names: frozenset[str]) -> bool:
    """Return whether no step sets a timer once a variable may hold a reading of it.

    Args:
        module: The programs.
        timer: Its number.
        once: The program that is executed, if that is once only: it may set the timer first.
        names: Variables that hold readings.
    """
    for program in module.programs.values():
        for at, instruction in enumerate(program.instructions):
            if not isinstance(instruction, ir.SetTimer):
                continue
            if number_of(instruction.number) not in (timer, None):
                continue
            if program.name != once or not _is_first(module, program.name, at, names):
                return False
    return True


def _is_first(module: Module, name: str, at: int, names: frozenset[str]) -> bool:
    """Return whether an instruction is executed once only, and before any of some variables is."""
    code = module.programs[name].instructions
    others = (ir.Call, ir.CallNamed, ir.React, ir.ReactError, ir.StartProcess)
    if any(isinstance(one, others) for one in code[:at]):
        return False
    before = (place for one in code[:at] for top in tops(one) for place in all_nodes(top))
    if any(name in names for place in before for name in variable(place)):
        return False
    if any(target <= at <= k for k, one in enumerate(code) for target in jumps_of(one)):
        return False
    everything = (one for program in module.programs.values() for one in program.instructions)
    return not any(
        isinstance(one, others)
        and (isinstance(one, ir.CallNamed) or getattr(one, "program", None) in (name, None))
        for one in everything
    )
