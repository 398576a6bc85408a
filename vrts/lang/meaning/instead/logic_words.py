"""`ok == "TRUE"`, `SIG(1001) == "ON"`: a condition compared with a word for it."""

from collections.abc import Sequence

from vrts.base.diagnostic import Fix
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Expression, Infix, Name, Prefix, Text

_TRUE = {"TRUE": True, "FALSE": False}
_SWITCHED = {"ON": True, "OFF": False, "HIGH": True, "LOW": False, "1": True, "0": False}
_LOGICAL = frozenset({"==", "<>", "<", "<=", ">", ">=", "AND", "OR", "XOR"})
_CONSTANTS = frozenset({"TRUE", "FALSE", "ON", "OFF"})


def compared_with_word(
    problems: Problems, around: Infix, node: Expression, word: Text, values: Sequence[Expression]
) -> tuple[tuple[str, ...], Fix] | None:
    """Return help and edit where a number is compared with a word for true or false.

    Args:
        problems: Where the text is.
        around: The comparison.
        node: The number in it.
        word: The text in it.
        values: What the number is given anywhere, if it is a variable.
    """
    signal = isinstance(node, Application) and node.name.text.upper() == "SIG"
    known = _TRUE | _SWITCHED if signal else _TRUE
    meant = known.get(word.value.strip().upper())
    if meant is None or around.operator not in ("==", "<>") or not (signal or values):
        return None
    written = problems.source.text[node.start : node.end]
    instead = written if meant is (around.operator == "==") else f"NOT {written}"
    sure = signal or all(_is_logical(value) for value in values)
    help_ = f"a number is true or false by itself: write `{instead}`"
    return (help_,), problems.replace(around.start, around.end, instead, sure=sure)


def _is_logical(value: Expression) -> bool:
    """Whether a value is true or false by its form."""
    if isinstance(value, Name):
        return value.text.upper() in _CONSTANTS
    if isinstance(value, Application):
        return value.name.text.upper() == "SIG"
    if isinstance(value, Infix):
        return value.operator in _LOGICAL
    return isinstance(value, Prefix) and value.operator == "NOT"
