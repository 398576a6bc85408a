"""`BASE TRANS(100, 0, 0)`, `DRAW TRANS(0, 0, 50)`: a location where lengths belong."""

from collections.abc import Callable

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Item
from vrts.lang.syntax.statements import Simple

_LENGTHS = 3
_SAYS = "VAL-II says *Illegal operator*"


def base_of_location(
    problems: Problems, rule: Rule, node: Simple, is_location: Callable[[Item], bool]
) -> tuple[Item | None, ...] | None:
    """Report BASE or DRAW with a location; return the numbers in it, None where it has none."""
    operand = node.operands[0] if len(node.operands) == 1 else None
    if operand is None or not is_location(operand):
        return None
    text = problems.source.text
    written = text[operand.start : operand.end]
    parts = f"DX({written}), DY({written}), DZ({written})"
    base = node.word == "BASE"
    help_, fix = f"write `BASE {parts}`, and behind them an angle about Z if it is turned", None
    if not base:
        help_ = f"to go to the location in a straight line write `MOVES {written}`"
    given: tuple[Item | None, ...] = ()
    if isinstance(operand, Application) and operand.name.text.upper() == "TRANS":
        given = operand.arguments
        lengths = [text[a.start : a.end] if a is not None else "0" for a in given[:_LENGTHS]]
        lengths += ["0"] * (_LENGTHS - len(lengths))
        numbers = ", ".join(lengths)
        help_ = f"write `{node.word} {numbers}`"
        help_ += ", and behind them an angle about Z if it is turned" if base else ""
        if len(given) <= _LENGTHS or not base:
            fix = problems.replace(operand.start, operand.end, numbers)
    problems.error(
        rule,
        f"{node.word} takes three lengths{' and an angle' if base else ''}, not a location",
        operand.start,
        operand.end,
        "this is a location",
        notes=(_SAYS,),
        help=(help_,),
        fix=fix,
    )
    return given
