"""Expressions of the IR as closures over the plain state of the machine.

Every closure takes the context and returns a value; a value that is missing or of the wrong type is
a run-time fault at its place in the text.
"""

from collections.abc import Callable
from typing import cast

from vrts.base.numbers import round_half_away
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.engine.code.values.arithmetic import (
    COMPARISONS,
    binary,
    checked_string,
    integer,
    joined,
    logical,
    rounded,
)
from vrts.engine.code.values.controller_functions import (
    controller_function,
    hand_state,
    read_timer,
    speed,
)
from vrts.engine.code.values.evaluate_strings import decoding, unpacking, written
from vrts.engine.code.values.extent import evaluates
from vrts.engine.code.values.functions import PURE, bad
from vrts.engine.code.values.operands import expression_of, span_of
from vrts.engine.code.values.places import Numbering, Places, mismatch
from vrts.engine.code.values.real_expressions import of_reals, real_binary, real_unary, static_type
from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.context import Context
from vrts.engine.memory.cells import UNDEFINED, Bound, Cell
from vrts.engine.motion.requests import half_turns
from vrts.ir.expressions import (
    Apply,
    Argument,
    Binary,
    BinaryOperator,
    Compose,
    Constant,
    Expression,
    Format,
    Function,
    Load,
    Place,
    Unary,
    WholeArray,
)
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, Value, type_of_value
from vrts.robots.kinematics.choice import OutOfLimits, OutOfReach, choose
from vrts.robots.kinematics.kinematics import forward, limit_violations
from vrts.robots.model import Configuration

Evaluate = Callable[[Context], Value]
Find = Callable[[Context], Cell]

TOO_CLOSE, TOO_FAR = 8192.0, 16384.0  # bits of INRANGE
RANDOM_MULTIPLIER, RANDOM_INCREMENT = 1664525, 1013904223  # linear congruential, 32 bits


class Compiler:
    """Compiles expressions of one module."""

    def __init__(self, numbering: Numbering) -> None:
        """Share the numbering of global variables."""
        self.numbering = numbering
        places = Places(numbering, self.real)
        self.bound, self.cell = places.bound, places.cell
        self.load, self.elements = places.load, places.elements

    # --- typed expressions --------------------------------------------------------------------

    def real(self, expression: Expression) -> Callable[[Context], float]:
        """Return a closure that gives a real."""
        return self._of_type(expression, float, "a number")  # type: ignore[return-value]

    def string(self, expression: Expression) -> Callable[[Context], str]:
        """Return a closure that gives a string."""
        return self._of_type(expression, str, "a string")  # type: ignore[return-value]

    def pose(self, expression: Expression) -> Callable[[Context], Pose]:
        """Return a closure that gives a pose."""
        return self._of_type(expression, Pose, "a location")  # type: ignore[return-value]

    def location(self, expression: Expression) -> Evaluate:
        """Return a closure that gives a pose or joints."""
        return self._of_type(expression, tuple, "a location")

    def _of_type(self, expression: Expression, wanted: type, words: str) -> Evaluate:
        evaluate = self.value(expression)
        if wanted is float and static_type(expression) is Type.REAL:
            return evaluate
        span = span_of(expression)

        def checked(c: Context) -> Value:
            value = evaluate(c)
            if not isinstance(value, wanted):
                raise mismatch(f"{type_of_value(value).value} where {words} is needed", span)
            return value

        return checked

    def value(self, expression: Expression) -> Evaluate:
        """Return a closure that gives the value of any expression."""
        match expression:
            case Constant(value=value, span=span):
                constant = rounded(value, span) if isinstance(value, float) else value
                return lambda c: constant
            case Load(place=place):
                return self.load(place)
            case Unary():
                return real_unary(self, expression)
            case Binary():
                return (
                    real_binary(self, expression)
                    if of_reals(expression)
                    else self._binary(expression)
                )
            case Compose(parts=parts):
                poses = tuple(self.pose(part) for part in parts)

                def compound(c: Context) -> Value:
                    result = poses[0](c)
                    for pose in poses[1:]:
                        result = result @ pose(c)
                    return result

                return compound
            case Apply():
                return self._function(expression)

    def _binary(self, expression: Binary) -> Evaluate:
        operator, span = expression.operator, expression.span
        left, right = self.value(expression.left), self.value(expression.right)
        numeric = binary(operator, span)
        compare = COMPARISONS.get(operator)

        def apply_two(c: Context) -> Value:
            a, b = left(c), right(c)
            if isinstance(a, float) and isinstance(b, float):
                return numeric(a, b)
            if isinstance(a, str) and isinstance(b, str):
                if compare is not None:
                    if c.system.is_on("UPPER"):
                        a, b = a.upper(), b.upper()
                    return logical(compare(a, b))
                if operator is BinaryOperator.ADD:
                    return joined(a, b, span)
            words = f"{type_of_value(a).value} and {type_of_value(b).value}"
            raise mismatch(f"`{operator.value}` cannot join {words}", span)

        return apply_two

    # --- functions ----------------------------------------------------------------------------

    def _function(self, expression: Apply) -> Evaluate:
        function, span = expression.function, expression.span
        if function is Function.OPAQUE:
            named = expression.arguments[0]
            words = str(named.value) if isinstance(named, Constant) else "this function"
            return _refusal(f"{words} is not simulated", span)
        if not evaluates(function):
            return _refusal(f"{function.value.upper()} is not simulated yet", span)
        pure = PURE.get(function)
        if pure is not None:
            arguments = tuple(self._argument(a) for a in expression.arguments)
            apply = pure

            def call(c: Context) -> Value:
                values = [None if a is None else a(c) for a in arguments]
                try:
                    return apply(values, span)
                except (AssertionError, TypeError, AttributeError) as error:
                    raise bad(f"argument of the wrong kind for {function.value}", span) from error

            return call
        return self._stateful(expression)

    def _argument(self, argument: Argument) -> Evaluate | None:
        if argument is None or isinstance(argument, WholeArray | Format):
            return None
        return self.load(argument) if isinstance(argument, Place) else self.value(argument)

    def _stateful(self, expression: Apply) -> Evaluate:
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
            case Function.SIG:
                signals = tuple(self.real_argument(a) for a in expression.arguments)
                return lambda c: logical(
                    all(c.signals.holds(round_half_away(s(c)), span) for s in signals)
                )
            case Function.BITS:
                first, count = (self.real_argument(a) for a in expression.arguments[:2])
                return lambda c: _bits(c, round_half_away(first(c)), count(c), span)
            case Function.TIMER:
                timer = self.real_argument(expression.arguments[0])
                return lambda c: rounded(read_timer(c, round_half_away(timer(c))), span)
            case Function.SPEED:
                which = self.real_argument(expression.arguments[0])
                return lambda c: speed(c, integer(which(c), span, 1, 3, "selector"))
            case Function.DEFINED:
                return self._defined(expression.arguments[0])
            case Function.INRANGE:
                location = self.location(expression_of(expression.arguments[0]))
                return lambda c: _in_range(c, location(c))
            case Function.ENCODE:
                items = tuple(_item(a) for a in expression.arguments)
                text = written(self, items, "$ENCODE")
                return lambda c: checked_string(text(c), span)
            case Function.DECODE:
                return decoding(self, expression)
            case Function.UNPACK:
                return unpacking(self, expression)
            case Function.LAST:
                whole = expression.arguments[0]
                assert isinstance(whole, Place | WholeArray)
                find = self.bound(whole.variable, array=True)
                return lambda c: _last(find(c))
            case Function.TAS:
                return self._test_and_set(expression)
            case _:
                return controller_function(self, expression)

    def _test_and_set(self, expression: Apply) -> Evaluate:
        place, new = expression.arguments
        assert isinstance(place, Place)
        find, value = self.cell(place), self.real_argument(new)

        def swapped(c: Context) -> Value:
            cell, wanted = find(c), value(c)
            old = cell.value
            cell.assign(wanted, c.finished)
            return old if isinstance(old, float) else 0.0

        return swapped

    def real_argument(self, argument: Argument) -> Callable[[Context], float]:
        """Return a closure that gives a real operand that must be there."""
        return self.real(expression_of(argument))

    def string_argument(self, argument: Argument) -> Callable[[Context], str]:
        """Return a closure that gives a string operand that must be there."""
        return self.string(expression_of(argument))

    def _defined(self, argument: Argument) -> Evaluate:
        if isinstance(argument, Load):
            argument = argument.place
        if isinstance(argument, WholeArray):
            find = self.bound(argument.variable, array=True)
            return lambda c: logical(_has_value(find(c)))
        if isinstance(argument, Place):
            cell = self.cell(argument)
            return lambda c: logical(cell(c).value is not UNDEFINED)
        raise ValueError("DEFINED of something that is no variable")


def _item(argument: Argument) -> "Expression | Format":
    return argument if isinstance(argument, Format) else expression_of(argument)


def _refusal(headline: str, span: Span | None) -> Evaluate:
    def refuse(c: Context) -> Value:
        raise RuntimeFault(RuntimeErrorKind.NOT_INSTALLED, headline, span)

    return refuse


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
    system.random_state = (RANDOM_MULTIPLIER * system.random_state + RANDOM_INCREMENT) & 0xFFFFFFFF
    return (system.random_state >> 8) / float(1 << 24)


def _bits(c: Context, first: int, count: float, span: Span | None) -> float:
    number = integer(count, span, 1, 16, "number of signals")
    return float(sum(1 << k for k in range(number) if c.signals.holds(first + k, span)))


def _in_range(c: Context, location: Value) -> float:
    planner = c.planner
    if not isinstance(location, Pose):
        joints = cast("Configuration", location)
        return float(sum(1 << (k - 1) for k, *_ in limit_violations(planner.arm, joints)))
    X_BF = planner.base.inverse() @ location @ planner.tool.inverse()
    arm = planner.arm if planner.always.multiple else half_turns(planner.arm)
    found = choose(arm, X_BF, planner.branch, planner.configuration, planner.request)
    if isinstance(found, OutOfReach):
        return TOO_FAR if found.kind == "too far" else TOO_CLOSE
    if isinstance(found, OutOfLimits):
        return float(sum(1 << (joint - 1) for joint, *_ in found.violations))
    return 0.0
