"""Conditions that AND and OR decide by themselves: `SIG(1001) AND SIG(-1001)`, `x == x`."""

from itertools import combinations
from typing import NamedTuple

from vrts.base.diagnostic import Fix, Rule
from vrts.lang.findings.values.comparisons import COMPARISONS, bare, operands_of
from vrts.lang.findings.values.conditions import ALWAYS_TRUE
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.findings.values.intervals import TRUTH
from vrts.lang.findings.ways.branches import shape
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.name_uses import NameUses
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Text,
)
from vrts.lang.vocabulary.functions import CONSTANTS

NEVER_TRUE = Rule("V168", "never-true")

MOST_OPERANDS = 24  # of one AND or OR; every two of them are compared

_MIRRORED = {"==": "==", "<>": "<>", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_NEGATED = {"==": "<>", "<>": "==", "<": ">=", "<=": ">", ">": "<=", ">=": "<"}
_EVER_NEW = frozenset({"random"})  # two of them are two numbers


class Fact(NamedTuple):
    """What a condition says of one quantity; a truth is a number that equals 1 or does not."""

    of: object  # the quantity, whatever its place
    operator: str
    value: float | str
    node: Expression  # that says so


def check_same(types: NameUses, node: Infix) -> None:
    """Warn of a comparison of something with itself."""
    left, right = bare(node.left), bare(node.right)
    if type(left) is not type(right) or node.operator not in COMPARISONS or not _steady(left):
        return
    if shape(left) != shape(right):
        return
    holds = node.operator in ("==", "<=", ">=")
    _warn(
        types,
        node,
        holds=holds,
        text="both sides are the same",
        help_="compare with something else",
        fix=None,
    )


def check_joined(types: NameUses, node: Infix) -> bool:
    """Warn of an AND that can never hold, and of an OR that always does."""
    holds = node.operator == "OR"
    operands = operands_of(node)
    if len(operands) > MOST_OPERANDS:
        return False
    facts = [fact for operand in operands for fact in _facts(operand, operand, negated=holds)]
    for a, b in combinations(facts, 2):
        if a.of == b.of and _exclude(a, b):
            _decided(types, node, (a, b), alone=len(operands) == 2)
            return True
    return False


def _decided(types: NameUses, node: Infix, pair: tuple[Fact, Fact], *, alone: bool) -> None:
    problems = types.problems
    text = problems.source.text
    first, second = (f"`{_written(fact.node, text)}`" for fact in pair)
    holds = node.operator == "OR"
    other = "AND" if holds else "OR"
    compared = all(_is_comparison(fact.node) for fact in pair)
    distinct = all(fact.operator == "==" for fact in pair)  # `x <> 1 OR x <> 2` and its opposite
    swaps = compared and alone and (distinct or holds)
    start, end = node.operator_start, node.operator_start + len(node.operator)
    instead = f"{text[node.start : start]}{other}{text[end : node.end]}"
    if swaps:
        help_ = f"write `{instead}`"
    elif compared:
        help_ = f"write {other}, or turn one of the signs round"
    else:
        help_ = "leave one of the two out, or ask for something else there"
    _warn(
        types,
        node,
        holds=holds,
        text=f"one of {first} and {second} always holds"
        if holds
        else f"{first} and {second} exclude each other",
        help_=help_,
        fix=problems.replace(start, end, other) if swaps and distinct else None,
    )


def _warn(
    types: NameUses, node: Expression, *, holds: bool, text: str, help_: str, fix: Fix | None
) -> None:
    types.problems.warning(
        ALWAYS_TRUE if holds else NEVER_TRUE,
        f"this condition is {'always' if holds else 'never'} true",
        node.start,
        node.end,
        text,
        help=(help_,),
        fix=fix,
    )


# --- what operands say ---------------------------------------------------------------------------


def _facts(node: Expression, whole: Expression, *, negated: bool) -> list[Fact]:
    """Return what a condition says when it holds, or, negated, when it does not."""
    node = bare(node)
    if isinstance(node, Prefix) and node.operator == "NOT":
        return _facts(node.operand, whole, negated=not negated)
    if isinstance(node, Infix):
        return _compared(node, whole, negated=negated)
    if isinstance(node, Application) and node.name.text.lower() == "sig":
        return _signals(node, whole, negated=negated)
    if isinstance(node, Name) and node.text.lower() in CONSTANTS:
        return []
    return [_truth(shape(node), whole, holds=not negated)] if _steady(node) else []


def _truth(of: object, whole: Expression, *, holds: bool) -> Fact:
    return Fact(("truth", of), "==" if holds else "<>", 1.0, whole)


def _signals(node: Application, whole: Expression, *, negated: bool) -> list[Fact]:
    arguments = node.arguments
    if negated and len(arguments) != 1:
        return []
    found: list[Fact] = []
    for argument in arguments:
        number = number_of(argument)
        on, of = True, argument
        while isinstance(of, Prefix | Parenthesised):
            on = on is not (isinstance(of, Prefix) and of.operator == "-")
            of = of.inner if isinstance(of, Parenthesised) else of.operand
        if number is not None:
            found.append(_truth(("sig", abs(number)), whole, holds=on is not negated))
        elif of is not None and _steady(of):
            found.append(_truth(("sig", shape(of)), whole, holds=on is not negated))
    return found


def _compared(node: Infix, whole: Expression, *, negated: bool) -> list[Fact]:
    if node.operator not in COMPARISONS:
        return []
    for side, other, operator in (
        (node.left, node.right, node.operator),
        (node.right, node.left, _MIRRORED[node.operator]),
    ):
        value = _constant(other)
        side = bare(side)
        if value is None or not _steady(side):
            continue
        if evaluate(side, nothing_known) == TRUTH and operator in ("==", "<>"):
            if value not in (-1.0, 0.0):
                return []
            holds = (value == -1.0) is (operator == "==")
            return _facts(side, whole, negated=negated is holds)
        return [Fact(shape(side), _NEGATED[operator] if negated else operator, value, whole)]
    return []


def _constant(node: Expression) -> float | str | None:
    if isinstance(node, Text):
        return node.value.lower()
    low, high = evaluate(node, nothing_known)
    return low if low == high else None


def _steady(node: Item | None) -> bool:
    """Return whether an expression is the same each time it stands in one condition."""
    match node:
        case Name(text):
            return text.lower() not in CONSTANTS and text.lower() not in _EVER_NEW
        case Number():
            return False
        case Element(_, subscripts):
            return all(isinstance(part, Number) or _steady(part) for part in subscripts)
        case Application(name, arguments):
            return name.text.lower() not in _EVER_NEW and all(
                isinstance(part, Number) or part is None or _steady(part) or number_of(part)
                for part in arguments
            )
        case _:
            return False


def _exclude(a: Fact, b: Fact) -> bool:
    """Return whether no value is as both say."""
    if type(a.value) is not type(b.value):
        return False
    for one, two in ((a, b), (b, a)):
        if one.operator == "==":
            return not _holds(one.value, two.operator, two.value)
    if a.operator[0] == b.operator[0] or "<>" in (a.operator, b.operator):
        return False
    low, high = (a, b) if a.operator[0] == ">" else (b, a)
    if isinstance(low.value, str) or isinstance(high.value, str):
        return False
    if low.value == high.value:
        return low.operator == ">" or high.operator == "<"
    return low.value > high.value


def _holds(value: float | str, operator: str, limit: float | str) -> bool:
    if operator in ("==", "<>"):
        return (value == limit) is (operator == "==")
    if isinstance(value, str) or isinstance(limit, str):
        return True  # the order of strings is not looked at
    if value == limit:
        return operator[1:] == "="
    return (value < limit) is (operator[0] == "<")


def _is_comparison(node: Expression) -> bool:
    inner = bare(node)
    return isinstance(inner, Infix) and inner.operator in COMPARISONS


def _written(node: Expression, text: str) -> str:
    inner = bare(node)
    return text[inner.start : inner.end]
