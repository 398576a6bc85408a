"""String functions that write text, or change what they read, as closures."""

from collections.abc import Callable, Sequence

from vrts.base.numbers import round_half_away
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.values.arithmetic import integer
from vrts.engine.code.values.compiler import Compiler
from vrts.engine.code.values.formats import FREE, NUMBER_KINDS, control, number
from vrts.engine.code.values.operands import expression_of, span_of
from vrts.engine.code.values.pieces import ELEMENT, decode, spread
from vrts.engine.faults import RuntimeFault
from vrts.engine.programs.context import Context
from vrts.ir.expressions import Apply, Constant, Expression, Format, Load, Place, WholeArray
from vrts.ir.ranges import HIGHEST_SUBSCRIPT
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Value


def written(
    compiler: Compiler, items: Sequence[Expression | Format], word: str
) -> Callable[[Context], str]:
    """Return a closure that gives the text of items as TYPE writes them."""
    parts = [
        item if isinstance(item, Format) else (compiler.value(item), span_of(item))
        for item in items
    ]

    def write(c: Context) -> str:
        form, text = FREE, ""
        for part in parts:
            if isinstance(part, Format):
                if part.kind in NUMBER_KINDS:
                    form = part
                else:
                    text += control(part)
                continue
            evaluate, span = part
            found = evaluate(c)
            if isinstance(found, str):
                text += found
            elif isinstance(found, float):
                text += number(found, form)
            else:
                raise RuntimeFault(
                    RuntimeErrorKind.ARGUMENT_MISMATCH,
                    f"{word} cannot write a location",
                    span,
                    help=("write its parts with DX, DY and DZ",),
                )
        return text

    return write


def decoding(compiler: Compiler, expression: Apply) -> Evaluate:
    """Return $DECODE: it takes the piece that it returns out of its variable."""
    variable, breaks, *mode = expression.arguments
    assert isinstance(variable, Load)
    find, read = compiler.cell(variable.place), compiler.string(variable)
    characters = compiler.string(expression_of(breaks))
    how = compiler.real(expression_of(mode[0])) if mode and mode[0] is not None else None

    def decoded(c: Context) -> Value:
        text = read(c)
        chosen = 0 if how is None else round_half_away(how(c))
        piece, rest = decode(text, characters(c), chosen)
        find(c).assign(rest, c.finished)
        return piece

    return decoded


def unpacking(compiler: Compiler, expression: Apply) -> Evaluate:
    """Return $UNPACK: a piece of a string array whose elements count 128 characters."""
    place, first, length = expression.arguments
    span = expression.span
    assert isinstance(place, Place | WholeArray)
    if isinstance(place, WholeArray):
        place = Place(place.variable, (Constant(0.0),), place.span)
    elements = compiler.elements(place)
    start, many = compiler.real_argument(first), compiler.real_argument(length)

    def unpacked(c: Context) -> Value:
        at = integer(start(c), span, 1, HIGHEST_SUBSCRIPT * ELEMENT, "position")
        count = integer(many(c), span, 0, ELEMENT, "number of characters")
        pieces: list[str] = []
        for element, offset, taken in spread(at, count):
            value = elements(c, element).value
            text = value if isinstance(value, str) else ""
            pieces.append(text[offset - 1 : offset - 1 + taken])
        return "".join(pieces)

    return unpacked
