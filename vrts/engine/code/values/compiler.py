"""What compiles the parts of an expression: handed to each function that compiles a whole one.

So the functions for strings, for places, for the controller know the kinds of closures that they
need, not one another.
"""

from collections.abc import Callable

from vrts.base.pose import Pose
from vrts.engine.code.closures import Evaluate, Real
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.operands import expression_of, span_of
from vrts.engine.code.values.places import Places, mismatch
from vrts.engine.code.values.static_types import static_type
from vrts.engine.programs.context import Context
from vrts.ir.expressions import Argument, Expression
from vrts.ir.values import Type, Value, type_of_value


class Compiler:
    """Compiles expressions of one module, by a function that compiles any of them."""

    def __init__(
        self, layout: Layout, compiled: Callable[["Compiler", Expression], Evaluate]
    ) -> None:
        """Share the layout of memory."""
        self._compiled = compiled
        places = Places(layout, self.real)
        self.bound, self.cell = places.bound, places.cell
        self.load, self.elements = places.load, places.elements

    def value(self, expression: Expression) -> Evaluate:
        """Return a closure that gives the value of any expression."""
        return self._compiled(self, expression)

    def real(self, expression: Expression) -> Real:
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

    def real_argument(self, argument: Argument) -> Real:
        """Return a closure that gives a real operand that must be there."""
        return self.real(expression_of(argument))

    def string_argument(self, argument: Argument) -> Callable[[Context], str]:
        """Return a closure that gives a string operand that must be there."""
        return self.string(expression_of(argument))
