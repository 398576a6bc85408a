"""Operands whose value is known without a run."""

from vrts.lang.meaning.scope import Scope
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Item, Name, Number, Parenthesised, Prefix
from vrts.lang.vocabulary.functions import CONSTANTS


def constant(scope: Scope, program: str, node: Item | None) -> float | None:
    """Return the value of an operand that is a number, or a variable only ever given one."""
    sign, node = _unsigned(node)
    if isinstance(node, Number):
        return sign * node.value
    if isinstance(node, Name) and node.text.lower() not in CONSTANTS:
        entry = scope.entry(program, key(node.text))
        if entry.slot is None and not entry.passed and len(entry.values) == 1:
            value = entry.values[0]
            inner = value.operand if isinstance(value, Prefix) else value
            if isinstance(inner, Number) and len(entry.writes) == 1:
                found = constant(scope, program, value)
                return None if found is None else sign * found
    return None


def number_of(node: Item | None) -> float | None:
    """Return the value of an operand that is a number, with or without sign."""
    sign, node = _unsigned(node)
    return sign * node.value if isinstance(node, Number) else None


def _unsigned(node: Item | None) -> tuple[float, Item | None]:
    sign = 1.0
    while isinstance(node, Prefix | Parenthesised):
        if isinstance(node, Parenthesised):
            node = node.inner
        elif node.operator in "+-":
            sign = -sign if node.operator == "-" else sign
            node = node.operand
        else:
            break
    return sign, node
