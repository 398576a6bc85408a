"""Variables and array elements as closures: where they are, and what they hold."""

from collections.abc import Callable
from difflib import get_close_matches

from vrts.base.source import Span
from vrts.engine.code.closures import Evaluate, Find, Real
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.arithmetic import integer
from vrts.engine.faults import RuntimeFault
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Undefined
from vrts.engine.programs.context import Context
from vrts.ir.expressions import Expression, Global, Place, Slot, Variable
from vrts.ir.ranges import HIGHEST_SUBSCRIPT
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Type, Value, type_of_value

RealOf = Callable[[Expression], Real]


class Places:
    """Compiles places; subscripts are compiled by a function for reals."""

    def __init__(self, layout: Layout, real: RealOf) -> None:
        """Share the layout of memory."""
        self.layout = layout
        self._real = real

    def bound(self, variable: Variable, *, array: bool) -> Callable[[Context], Bound]:
        """Return a closure that gives the cell or array behind a name."""
        if isinstance(variable, Slot):
            slot = variable.number
            return lambda c: c.slots[slot]
        number = self._number(variable, array=array)
        return lambda c: c.memory.bound[number]

    def _number(self, variable: Global, *, array: bool) -> int:
        if array:
            self.layout.arrays.add(variable.name)
        return self.layout.number(variable.name)

    def cell(self, place: Place) -> Find:
        """Return a closure that finds the cell of a place, making array elements as needed."""
        name, span, variable = place.variable.name, place.span, place.variable
        if not place.subscripts:
            if isinstance(variable, Slot):
                slot = variable.number

                def formal(c: Context) -> Cell:
                    found = c.slots[slot]
                    if found.__class__ is Cell:
                        return found  # type: ignore[return-value]
                    raise mismatch(f"`{name}` is an array", span)

                return formal
            number = self._number(variable, array=False)

            def scalar(c: Context) -> Cell:
                found = c.memory.bound[number]
                if found.__class__ is Cell:
                    return found  # type: ignore[return-value]
                raise mismatch(f"`{name}` is an array", span)

            return scalar
        find = self.bound(variable, array=True)
        if len(place.subscripts) == 1:
            return self._element(place)
        subscripts = tuple(self._real(subscript) for subscript in place.subscripts)

        def element(c: Context) -> Cell:
            array = _array(c, find(c), name, span)
            return array.element(
                tuple(subscript_of(s(c), name, span) for s in subscripts), c.finished
            )

        return element

    def _element(self, place: Place) -> Find:
        """Return a closure that finds an element with one subscript."""
        find = self.bound(place.variable, array=True)
        subscript = self._real(place.subscripts[0])
        name, span = place.variable.name, place.span

        def element(c: Context) -> Cell:
            found = find(c)
            if found.__class__ is not Array:
                found = _array(c, found, name, span)
            value = subscript(c)
            index = int(value)
            if index != value or not 0 <= index <= HIGHEST_SUBSCRIPT:
                index = subscript_of(value, name, span)
            cell = found.elements.get((index,))  # type: ignore[union-attr]
            return cell if cell is not None else found.element((index,), c.finished)  # type: ignore[union-attr]

        return element

    def load(self, place: Place) -> Evaluate:
        """Return a closure that reads a place."""
        find = self.cell(place)
        span, wanted = place.span, place.variable.type

        def read(c: Context) -> Value:
            cell = find(c)
            value = cell.value
            if isinstance(value, Undefined):
                raise undefined(c, cell.name, span)
            if wanted is not Type.DYNAMIC and type_of_value(value) is not wanted:
                raise mismatch(f"`{cell.name}` holds a {type_of_value(value).value} here", span)
            return value

        return self._fast(place, read) if wanted is Type.REAL else read

    def _fast(self, place: Place, read: Evaluate) -> Evaluate:
        """Return a closure that reads a real; what is no real is left to the slow one."""
        variable = place.variable
        if place.subscripts:
            find = self.cell(place)

            def element(c: Context) -> Value:
                value = find(c).value
                return value if value.__class__ is float else read(c)  # type: ignore[return-value]

            return element
        if isinstance(variable, Slot):
            slot = variable.number

            def formal(c: Context) -> Value:
                value = c.slots[slot].value
                return value if value.__class__ is float else read(c)  # type: ignore[return-value]

            return formal
        number = self.layout.number(variable.name)

        def scalar(c: Context) -> Value:
            value = c.memory.bound[number].value
            return value if value.__class__ is float else read(c)  # type: ignore[return-value]

        return scalar

    def elements(self, place: Place) -> Callable[[Context, int], Cell]:
        """Return a closure that finds the k-th cell from a place on; a scalar has only one."""
        name, span = place.variable.name, place.span
        if not place.subscripts:
            find = self.cell(place)

            def scalar(c: Context, k: int) -> Cell:
                if k:
                    raise mismatch(f"`{name}` is not an array", span)
                return find(c)

            return scalar
        bound = self.bound(place.variable, array=True)
        subscripts = tuple(self._real(subscript) for subscript in place.subscripts)

        def element(c: Context, k: int) -> Cell:
            found = bound(c)
            if isinstance(found, Cell):
                raise mismatch(f"`{name}` is not an array", span)
            *outer, last = (subscript_of(s(c), name, span) for s in subscripts)
            return found.element((*outer, subscript_of(float(last + k), name, span)), c.finished)

        return element


def subscript_of(value: float, name: str, span: Span | None) -> int:
    """Return a subscript as the integer it rounds to.

    Raises:
        RuntimeFault: It is outside the range of subscripts.
    """
    try:
        return integer(value, span, 0, HIGHEST_SUBSCRIPT, "subscript")
    except RuntimeFault as fault:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_ARRAY_INDEX, f"{fault.headline} of `{name}`", span
        ) from None


def undefined(c: Context, name: str, span: Span | None) -> RuntimeFault:
    """Return the fault of a variable without a value."""
    known = [cell.name for cell in c.memory.cells() if cell.value is not UNDEFINED]
    near = get_close_matches(name, known, 1)
    remedy = f"define `{name}` in `.LOCATIONS` or give it a value before this step"
    return RuntimeFault(
        RuntimeErrorKind.UNDEFINED_VALUE,
        f"`{name}` has no value",
        span,
        label="never given a value",
        help=(f"did you mean `{near[0]}`?" if near else remedy,),
        data={"name": name},
    )


def mismatch(headline: str, span: Span | None) -> RuntimeFault:
    """Return the fault of a value of the wrong kind."""
    return RuntimeFault(RuntimeErrorKind.ARGUMENT_MISMATCH, headline, span)


def _array(c: Context, found: Bound, name: str, span: Span | None) -> Array:
    if isinstance(found, Array):
        return found
    if found.value is not UNDEFINED:
        raise mismatch(f"`{name}` is not an array", span)
    raise undefined(c, name, span)
