"""Expressions of the IR as closures over the plain state of the machine.

Every closure takes the context and returns a value; a value that is missing or of the wrong type is
a run-time fault at its place in the text.
"""

from vrts.base.source import Span
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.arithmetic import COMPARISONS, binary, joined, logical, rounded
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.functions import PURE, bad
from vrts.engine.code.values.known_functions import evaluates
from vrts.engine.code.values.places import mismatch
from vrts.engine.code.values.real_expressions import real_binary, real_unary
from vrts.engine.code.values.state_functions import state_function
from vrts.engine.code.values.static_types import of_reals
from vrts.engine.faults import RuntimeFault
from vrts.engine.programs.context import Context
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
from vrts.ir.values import Value, type_of_value


def compiler(layout: Layout) -> Compiler:
    """Return what compiles the expressions of one module."""
    return Compiler(layout, compiled)


def compiled(compiler: Compiler, expression: Expression) -> Evaluate:
    """Return a closure that gives the value of any expression."""
    match expression:
        case Constant(value=value, span=span):
            constant = rounded(value, span) if isinstance(value, float) else value
            return lambda c: constant
        case Load(place=place):
            return compiler.load(place)
        case Unary():
            return real_unary(compiler, expression)
        case Binary():
            return (
                real_binary(compiler, expression)
                if of_reals(expression)
                else _binary(compiler, expression)
            )
        case Compose(parts=parts):
            poses = tuple(compiler.pose(part) for part in parts)

            def compound(c: Context) -> Value:
                result = poses[0](c)
                for pose in poses[1:]:
                    result = result @ pose(c)
                return result

            return compound
        case Apply():
            return _function(compiler, expression)


def _binary(compiler: Compiler, expression: Binary) -> Evaluate:
    operator, span = expression.operator, expression.span
    left, right = compiler.value(expression.left), compiler.value(expression.right)
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


def _function(compiler: Compiler, expression: Apply) -> Evaluate:
    function, span = expression.function, expression.span
    if function is Function.OPAQUE:
        named = expression.arguments[0]
        words = str(named.value) if isinstance(named, Constant) else "this function"
        return _refusal(f"{words} is not simulated", span)
    if not evaluates(function):
        return _refusal(f"{function.value.upper()} is not simulated yet", span)
    pure = PURE.get(function)
    if pure is not None:
        arguments = tuple(_argument(compiler, a) for a in expression.arguments)
        apply = pure

        def call(c: Context) -> Value:
            values = [None if a is None else a(c) for a in arguments]
            try:
                return apply(values, span)
            except (AssertionError, TypeError, AttributeError) as error:
                raise bad(f"argument of the wrong kind for {function.value}", span) from error

        return call
    return state_function(compiler, expression)


def _argument(compiler: Compiler, argument: Argument) -> Evaluate | None:
    if argument is None or isinstance(argument, WholeArray | Format):
        return None
    return compiler.load(argument) if isinstance(argument, Place) else compiler.value(argument)


def _refusal(headline: str, span: Span | None) -> Evaluate:
    def refuse(c: Context) -> Value:
        raise RuntimeFault(RuntimeErrorKind.NOT_INSTALLED, headline, span)

    return refuse
