"""Comparisons that are not read as they look: `10 < x < 20`, and `NOT x == 3`."""

from collections.abc import Iterator

from vrts.base.diagnostic import Fix
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.findings.values.intervals import truth
from vrts.lang.grammar.build import PRECEDENCE
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Expression,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
)

COMPARISONS = frozenset({"==", "<>", "<", "<=", ">", ">="})

_RANGES = (frozenset({"<", "<="}), frozenset({">", ">="}), frozenset({"=="}))  # one way each


def is_comparison(node: Item | None) -> bool:
    """Return whether an expression compares, without parentheses round it."""
    return isinstance(node, Infix) and node.operator in COMPARISONS


def bare(node: Expression) -> Expression:
    """Return an expression without the parentheses round it."""
    while isinstance(node, Parenthesised):
        node = node.inner
    return node


def operands_of(node: Infix) -> list[Expression]:
    """Return what a chain of one AND or OR joins, from left to right, parentheses taken off."""
    waiting: list[Expression] = [node]
    found: list[Expression] = []
    while waiting:
        part = waiting.pop()
        inner = bare(part)
        if isinstance(inner, Infix) and inner.operator == node.operator:
            waiting += [inner.right, inner.left]
        else:
            found.append(part)
    return found


def inner_of(node: Infix) -> Iterator[Infix]:
    """Yield the comparisons of a chain of comparisons, the ANDs of a chain of ANDs, but for it."""
    waiting: list[Expression] = [node.left, node.right]
    while waiting:
        part = bare(waiting.pop())
        if not isinstance(part, Infix):
            continue
        if part.operator == node.operator or {part.operator, node.operator} <= COMPARISONS:
            yield part
            waiting += [part.left, part.right]


def check_comparison(types: NameUses, asked: Asked, node: Infix) -> bool:
    """Warn of a comparison of what a comparison or NOT yields; return whether this is one."""
    if node.operator not in COMPARISONS:
        return False
    if is_comparison(node.left):
        return _chain(types, asked, node)
    if isinstance(node.left, Prefix) and node.left.operator == "NOT":
        return _negated(types, asked, node, node.left)
    return False


def _chain(types: NameUses, asked: Asked, node: Infix) -> bool:
    """`a < x < b`; where the outcome is compared with a truth, `x > 3 == ok`, that is meant."""
    operators: list[str] = [node.operator]
    operands: list[Expression] = [node.right]
    left = node.left
    while isinstance(left, Infix) and left.operator in COMPARISONS:
        operators.insert(0, left.operator)
        operands.insert(0, left.right)
        left = left.left
    operands.insert(0, left)
    equals = node.operator in ("==", "<>")
    if equals and is_truth(types, asked.program, node.right):
        return False
    text = types.problems.source.text
    parts = [text[part.start : part.end] for part in operands]
    pairs = [
        f"({a} {operator} {b})" for a, operator, b in zip(parts, operators, parts[1:], strict=False)
    ]
    range_ = any(set(operators) <= way for way in _RANGES)
    sure = range_ and not any(isinstance(part, Number) for part in operands[1:-1])
    instead = " AND ".join(pairs)
    if sure:
        help_ = f"write `{instead}`"
    else:
        help_ = "write two comparisons and join them by AND, as `(x > 1) AND (x < 3)`"
    _warn(
        types,
        node,
        "this compares the outcome of a comparison, which is -1 or 0",
        help_,
        types.problems.replace(node.start, node.end, instead) if sure else None,
    )
    return True


def _negated(types: NameUses, asked: Asked, node: Infix, left: Prefix) -> bool:
    """`NOT x == 3`; of truths, `NOT ok == TRUE` and `NOT (ok == TRUE)` are the same."""
    operand = left.operand
    if types.dialect.is_as:
        return False  # there no other operator surprises either
    if any(is_truth(types, asked.program, part) for part in (operand, node.right)):
        return False
    text = types.problems.source.text
    instead = f"NOT ({text[operand.start : node.end]})"
    _warn(
        types,
        node,
        f"NOT acts before `{node.operator}`: this is not read as it looks",
        f"write `{instead}`",
        types.problems.replace(node.start, node.end, instead),
    )
    return True


def _warn(types: NameUses, node: Infix, headline: str, help_: str, fix: Fix | None) -> None:
    text = types.problems.source.text
    right = text[node.right.start : node.right.end]
    known = truth(evaluate(node, nothing_known))
    always = "" if known is None else f", which is {'always' if known else 'never'} true"
    types.problems.warning(
        PRECEDENCE,
        headline,
        node.start,
        node.end,
        f"this is read ({text[node.left.start : node.left.end]}) {node.operator} {right}{always}",
        help=(help_,),
        fix=fix,
    )


def is_truth(types: NameUses, program: str | None, node: Expression) -> bool:
    """Return whether an expression only ever is -1 or 0, as far as the text tells."""
    node = bare(node)
    if isinstance(node, Number):
        return False  # 0 may be a number or a truth, and 0 is mostly written for a number
    low, high = evaluate(node, nothing_known)
    if low >= -1.0 and high <= 0.0:
        return True
    if not isinstance(node, Name):
        return False
    entry = types.scope.entry(program, key(node.text))
    given = [evaluate(value, nothing_known) for value in entry.values]
    return bool(given) and all(low >= -1.0 and high <= 0.0 for low, high in given)
