"""Functions that ask where the arm and the hand are, for signals, and about variables."""

from typing import cast

from vrts.base.numbers import round_half_away
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.values.arithmetic import (
    FALSE,
    TRUE,
    checked_string,
    integer,
    logical,
    rounded,
)
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.controller_functions import (
    controller_function,
    hand_state,
    read_timer,
    speed,
)
from vrts.engine.code.values.operands import expression_of
from vrts.engine.code.values.real_expressions import one_signal, truth
from vrts.engine.code.values.string_functions import decoding, unpacking, written
from vrts.engine.memory.cells import UNDEFINED, Bound, Cell
from vrts.engine.motion.requests import half_turns
from vrts.engine.programs.context import Context
from vrts.ir.expressions import (
    Apply,
    Argument,
    Expression,
    Format,
    Function,
    Load,
    Place,
    WholeArray,
)
from vrts.ir.ranges import MOST_BITS
from vrts.ir.values import Value
from vrts.robots.kinematics.choice import OutOfLimits, OutOfReach, choose
from vrts.robots.kinematics.kinematics import forward, limit_violations
from vrts.robots.model import Configuration

TOO_CLOSE, TOO_FAR = 8192.0, 16384.0  # bits of INRANGE
RANDOM_MULTIPLIER, RANDOM_INCREMENT = 1664525, 1013904223  # linear congruential, 32 bits
DRAWN_OF = float(1 << 24)  # numbers that RANDOM may draw


def state_function(compiler: Compiler, expression: Apply) -> Evaluate:
    """Return a closure that asks for the state of arm, hand, signals or variables."""
    span = expression.span
    match expression.function:
        case Function.HERE:
            return lambda c: c.planner.base @ _tool_now(c)
        case Function.DEST:
            return lambda c: c.planner.destination
        case Function.HERE_JOINTS:
            return lambda c: c.planner.configuration_at(c.now)
        case Function.DEST_JOINTS:
            return lambda c: c.planner.dest
        case Function.BASE:
            return lambda c: c.planner.base
        case Function.TOOL:
            return lambda c: c.planner.tool
        case Function.HAND:
            return hand_state
        case Function.RANDOM:
            return _random
        case Function.SIG if one_signal(expression) is not None:
            holds = truth(compiler, expression)
            return lambda c: TRUE if holds(c) else FALSE
        case Function.SIG:
            signals = tuple(compiler.real_argument(a) for a in expression.arguments)
            return lambda c: logical(
                all(c.signals.holds(round_half_away(s(c)), span) for s in signals)
            )
        case Function.BITS:
            first, count = (compiler.real_argument(a) for a in expression.arguments[:2])
            return lambda c: _bits(c, round_half_away(first(c)), count(c), span)
        case Function.TIMER:
            timer = compiler.real_argument(expression.arguments[0])
            return lambda c: rounded(read_timer(c, round_half_away(timer(c))), span)
        case Function.SPEED:
            which = compiler.real_argument(expression.arguments[0])
            return lambda c: speed(c, integer(which(c), span, 1, 3, "selector"))
        case Function.DEFINED:
            return _defined(compiler, expression.arguments[0])
        case Function.INRANGE:
            location = compiler.location(expression_of(expression.arguments[0]))
            return lambda c: in_range(c, location(c))
        case Function.ENCODE:
            items = tuple(_item(a) for a in expression.arguments)
            text = written(compiler, items, "$ENCODE")
            return lambda c: checked_string(text(c), span)
        case Function.DECODE:
            return decoding(compiler, expression)
        case Function.UNPACK:
            return unpacking(compiler, expression)
        case Function.LAST:
            whole = expression.arguments[0]
            assert isinstance(whole, Place | WholeArray)
            find = compiler.bound(whole.variable, array=True)
            return lambda c: _last(find(c))
        case Function.TAS:
            return _test_and_set(compiler, expression)
        case Function.CAS:
            return _compare_and_set(compiler, expression)
        case _:
            return controller_function(compiler, expression)


def _test_and_set(compiler: Compiler, expression: Apply) -> Evaluate:
    place, new = expression.arguments
    assert isinstance(place, Place)
    find, value = compiler.cell(place), compiler.real_argument(new)

    def swapped(c: Context) -> Value:
        cell, wanted = find(c), value(c)
        old = cell.value
        cell.assign(wanted, c.finished)
        return old if isinstance(old, float) else 0.0

    return swapped


def _compare_and_set(compiler: Compiler, expression: Apply) -> Evaluate:
    place, test, new = expression.arguments
    assert isinstance(place, Place)
    find = compiler.cell(place)
    compared, value = compiler.real_argument(test), compiler.real_argument(new)

    def swapped(c: Context) -> Value:
        cell, wanted, then = find(c), compared(c), value(c)
        old = cell.value if isinstance(cell.value, float) else 0.0
        if old == wanted:
            cell.assign(then, c.finished)
        return old

    return swapped


def _defined(compiler: Compiler, argument: Argument) -> Evaluate:
    if isinstance(argument, Load):
        argument = argument.place
    if isinstance(argument, WholeArray):
        find = compiler.bound(argument.variable, array=True)
        return lambda c: logical(_has_value(find(c)))
    if isinstance(argument, Place):
        cell = compiler.cell(argument)
        return lambda c: logical(cell(c).value is not UNDEFINED)
    raise ValueError("DEFINED of something that is no variable")


def _item(argument: Argument) -> Expression | Format:
    return argument if isinstance(argument, Format) else expression_of(argument)


def _last(found: Bound) -> float:
    """LAST: the highest index that has a value, -1 when none has."""
    if isinstance(found, Cell):
        return -1.0
    indices = [
        subscripts[-1] for subscripts, cell in found.elements.items() if cell.value is not UNDEFINED
    ]
    return float(max(indices, default=-1))


def _has_value(found: Bound) -> bool:
    if isinstance(found, Cell):
        return found.value is not UNDEFINED
    return any(cell.value is not UNDEFINED for cell in found.elements.values())


def _tool_now(c: Context) -> Pose:
    planner = c.planner
    return forward(planner.arm, planner.configuration_at(c.now)) @ planner.tool


def _random(c: Context) -> float:
    system = c.system
    system.clock_reads += 1
    if system.outside is not None and system.outside.random:
        return system.outside.draw()
    facts = system.facts
    if system.draws:
        drawn, system.draws = system.draws[0], system.draws[1:]
        if facts is not None:
            facts.left.note(*facts.now(), len(system.draws))
        return drawn
    state = (RANDOM_MULTIPLIER * system.random_state + RANDOM_INCREMENT) & 0xFFFFFFFF
    system.random_state = state
    if facts is not None:
        track = facts.drawn
        track.times.append(c.now)
        track.numbers.append(c.finished)
        track.values.append(state)
    return (state >> 8) / DRAWN_OF


def _bits(c: Context, first: int, count: float, span: Span | None) -> float:
    number = integer(count, span, 1, MOST_BITS, "number of signals")
    return float(sum(1 << k for k in range(number) if c.signals.holds(first + k, span)))


def in_range(c: Context, location: Value) -> float:
    """INRANGE: 0 where a location can be reached, else bits that say why not."""
    planner = c.planner
    if not isinstance(location, Pose):
        joints = cast("Configuration", location)
        return float(sum(1 << (k - 1) for k, *_ in limit_violations(planner.arm, joints)))
    X_BF = planner.base.inverse() @ location @ planner.tool.inverse()
    arm = planner.arm if planner.settings.always.multiple else half_turns(planner.arm)
    found = choose(arm, X_BF, planner.branch, planner.configuration, planner.request)
    if isinstance(found, OutOfReach):
        return TOO_FAR if found.kind == "too far" else TOO_CLOSE
    if isinstance(found, OutOfLimits):
        return float(sum(1 << (joint - 1) for joint, *_ in found.violations))
    return 0.0
