"""What an expression may yield, as far as numbers and some variables are known."""

import math
from collections.abc import Callable

from vrts.base.numbers import single
from vrts.lang.findings.values import intervals
from vrts.lang.findings.values.intervals import ANY, TRUTH, Interval, of_truth, point, truth
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Infix,
    Item,
    Name,
    Number,
    Parenthesised,
    Prefix,
)
from vrts.lang.vocabulary.functions import CONSTANTS

Known = Callable[[str], Interval]  # what a plain variable may be, by its key

_SUMS = frozenset({"+", "-"})
_RANGES: dict[str, Interval] = {
    "sin": (-1.0, 1.0),
    "cos": (-1.0, 1.0),
    "random": (0.0, 1.0),
    "sqr": (0.0, math.inf),
    "sqrt": (0.0, math.inf),
    "len": (0.0, 128.0),
    "sig": TRUTH,
    "defined": TRUTH,
}


def nothing_known(_: str) -> Interval:
    """Know no variable."""
    return ANY


def evaluate(node: Item | None, known: Known) -> Interval:
    """Return what an expression of numbers may yield."""
    match node:
        case Number(value):
            return point(value)
        case Name(text):
            constant = CONSTANTS.get(text.lower())
            return known(key(text)) if constant is None else point(single(constant))
        case Parenthesised(inner):
            return evaluate(inner, known)
        case Prefix(operator, operand):
            return _prefixed(operator, evaluate(operand, known))
        case Infix(operator, left, right):
            return _joined(operator, evaluate(left, known), evaluate(right, known))
        case Application():
            return _applied(node, known)
        case _:
            return ANY


def _prefixed(operator: str, a: Interval) -> Interval:
    if operator == "-":
        return intervals.negated(a)
    if operator == "NOT":
        known = truth(a)
        return of_truth(None if known is None else not known)
    return a if operator == "+" else ANY


def _joined(operator: str, a: Interval, b: Interval) -> Interval:
    if operator in _SUMS and (a is ANY or b is ANY):
        return ANY
    match operator:
        case "+":
            return intervals.added(a, b)
        case "-":
            return intervals.added(a, intervals.negated(b))
        case "*":
            return intervals.multiplied(a, b)
        case "/":
            return intervals.divided(a, b)
        case "<":
            return of_truth(intervals.less(a, b))
        case ">":
            return of_truth(intervals.less(b, a))
        case "<=":
            return of_truth(_not(intervals.less(b, a)))
        case ">=":
            return of_truth(_not(intervals.less(a, b)))
        case "==":
            return of_truth(intervals.equal(a, b))
        case "<>":
            return of_truth(_not(intervals.equal(a, b)))
        case "AND":
            both = truth(a), truth(b)
            return of_truth(False if False in both else None if None in both else True)
        case "OR":
            both = truth(a), truth(b)
            return of_truth(True if True in both else None if None in both else False)
        case _:
            return ANY


def _not(known: bool | None) -> bool | None:
    return None if known is None else not known


def _applied(node: Application, known: Known) -> Interval:
    name = node.name.text.lower()
    if name == "abs" and node.arguments:
        low, high = evaluate(node.arguments[0], known)
        if low <= 0.0 <= high:
            return 0.0, max(-low, high)
        return (low, high) if low > 0.0 else (-high, -low)
    if name in ("int", "max", "min") and node.arguments:
        given = [evaluate(argument, known) for argument in node.arguments]
        if name == "int":
            return float(_whole(given[0][0])), float(_whole(given[0][1]))
        pick = max if name == "max" else min
        return pick(low for low, _ in given), pick(high for _, high in given)
    return _RANGES.get(name, ANY)


def _whole(value: float) -> float:
    return value if math.isinf(value) else math.trunc(value)
