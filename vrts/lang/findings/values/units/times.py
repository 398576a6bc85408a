"""Times that look like milliseconds: the language has seconds."""

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.meaning.constants import constant
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Application, Infix, Item, Name, Number
from vrts.lang.syntax.statements import Give, Put, Simple

TIME_UNIT = Rule("V169", "time-unit")

LONG = 120.0  # [s] what is longer is meant, or measured in milliseconds
MINUTE = 60.0  # [s] people write long times as whole minutes,
HOUR = 3600.0  # [s]
_QUARTER = HOUR / 4  # [s] and longer ones as quarters of an hour


def in_milliseconds(seconds: float) -> bool:
    """Return whether a time is hardly meant in seconds: 500 is not, 60 and 600 may be."""
    size = abs(seconds)
    if size <= LONG or size != int(size):
        return False
    return bool(size % (MINUTE if size <= _QUARTER else _QUARTER))


def check_times(types: NameUses, asked: Asked) -> bool:
    """Warn of times in milliseconds: DELAY, TIMER n = t, HAND.TIME, and TIMER(n) compared."""
    match asked.node:
        case Simple("DELAY", (operand,)):
            return _time(types, asked, operand, "DELAY takes")
        case Give("PARAMETER", Name(text), (value,)) if text.upper() == "HAND.TIME":
            return _time(types, asked, value, "HAND.TIME holds")
        case Put("TIMER", _, _, value):
            return _time(types, asked, value, "TIMER takes")
        case Infix(_, left, right):
            for side, other in ((left, right), (right, left)):
                if _is_timer(types, asked, side):
                    return _time(types, asked, other, "TIMER counts")
        case _:
            pass
    return False


def _is_timer(types: NameUses, asked: Asked, node: Item) -> bool:
    """Return whether something is what a timer shows, or a variable that only ever is."""
    if isinstance(node, Application):
        return node.name.text.lower() == "timer"
    if not isinstance(node, Name) or node.text[0] in "$#" or asked.program is None:
        return False
    if node.text.lower() in types.predefined:
        return False
    values = types.scope.entry(asked.program, key(node.text)).values
    return bool(values) and all(
        isinstance(value, Application) and value.name.text.lower() == "timer" for value in values
    )


def _time(types: NameUses, asked: Asked, node: Item | None, does: str) -> bool:
    seconds = None if asked.program is None else constant(types.scope, asked.program, node)
    if node is None or seconds is None or not in_milliseconds(seconds):
        return False
    problems = types.problems
    written = f"{seconds / 1000.0:g}"
    fix: Fix | None = None
    if isinstance(node, Number):
        help_ = f"write `{written}`: a time in seconds"
        fix = problems.replace(node.start, node.end, written)
    else:
        help_ = f"give it the time in seconds: `{written}`"
    problems.warning(
        TIME_UNIT,
        f"{seconds:g} looks like milliseconds: {does} seconds",
        node.start,
        node.end,
        f"this is {_in_words(abs(seconds))}",
        help=(help_,),
        fix=fix,
        data={"seconds": seconds},
    )
    return True


def _in_words(seconds: float) -> str:
    if seconds >= HOUR:
        return f"{seconds / HOUR:.3g} hours"
    return f"{seconds / MINUTE:.2g} minutes"
