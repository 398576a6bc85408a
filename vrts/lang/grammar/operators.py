"""Precedence: a flat chain of operands and operators to a tree.

Table A is VAL-II's and V+'s, table B that of AS [manual language/operators#binding]. Inside a
level: left to right.
Operators before an operand bind tighter than any between two.
"""

from collections.abc import Sequence

from vrts.base.made import made
from vrts.lang.syntax.expressions import Expression, Infix, Parenthesised, Prefix
from vrts.lang.syntax.token import Token

_COMPARISONS = ("==", "<>", "<", "<=", ">", ">=")


def _levels(*levels: tuple[str, ...]) -> dict[str, int]:
    """Number the levels, tightest first, so that a larger number binds tighter."""
    return {operator: len(levels) - i for i, level in enumerate(levels) for operator in level}


TABLE_A = _levels(  # of VAL-II from memory only [assumed, manual language/operators#table-a]
    (":",),
    ("**",),
    ("*", "/", "MOD", "AND", "BAND"),
    ("+", "-", "OR", "BOR", "XOR", "BXOR"),
    _COMPARISONS,
)
TABLE_B = _levels(
    (":",),
    ("**",),
    ("*", "/"),
    ("MOD",),
    ("+", "-"),
    _COMPARISONS,
    ("BAND",),
    ("BOR",),
    ("BXOR",),
    ("AND",),
    ("OR",),
    ("XOR",),
)

_LOGICAL = frozenset({"AND", "OR", "XOR", "BAND", "BOR", "BXOR"})
_ORDERS = frozenset({"<", "<=", ">", ">="})
_QUOTIENTS = frozenset({"*", "/"})


def tree(chain: Sequence[Expression | Token], table: dict[str, int]) -> Expression:
    """Return the tree of a chain operand, operator, operand ... under a table.

    Iterative, so that a chain of any length does.
    """
    operands: list[Expression] = [_operand(chain[0])]
    operators: list[Token] = []
    for i in range(1, len(chain), 2):
        operator = chain[i]
        assert isinstance(operator, Token)
        level = table[operator.text]
        while operators and table[operators[-1].text] >= level:
            _combine(operands, operators.pop())
        operators.append(operator)
        operands.append(_operand(chain[i + 1]))
    while operators:
        _combine(operands, operators.pop())
    return operands[0]


def ambiguous(chain: Sequence[Expression | Token]) -> bool:
    """Return whether the two tables read a chain differently [W-PREC]."""
    words = {item.text for item in chain[1::2] if isinstance(item, Token)}
    comparing = not _LOGICAL.isdisjoint(words) and not words.isdisjoint(_COMPARISONS)
    dividing = "MOD" in words and not _QUOTIENTS.isdisjoint(words)
    return (comparing or dividing) and _shape(chain, TABLE_A) != _shape(chain, TABLE_B)


def compares_twice(chain: Sequence[Expression | Token]) -> bool:
    """Return whether a chain compares what a comparison yields: `1 <= s <= 100`."""
    before = ""
    for item in chain[1::2]:
        sign = item.text if isinstance(item, Token) else ""
        if sign in _LOGICAL:
            before = ""
        elif sign in _ORDERS:
            if before:
                return True
            before = sign
    return False


def written(expression: Expression, source: str, *, outermost: bool = True) -> str:
    """Return an expression with parentheses round every inner operation that mixes operators."""
    if not isinstance(expression, Infix):
        return source[expression.start : expression.end]
    left = written(expression.left, source, outermost=False)
    right = written(expression.right, source, outermost=False)
    text = f"{left} {expression.operator} {right}"
    return text if outermost else f"({text})"


def _operand(item: Expression | Token) -> Expression:
    assert not isinstance(item, Token)
    return item


def _combine(operands: list[Expression], operator: Token) -> None:
    right = operands.pop()
    left = operands.pop()
    if operator.text == "**" and isinstance(left, Prefix):  # -2^2 is -(2^2)
        inner = Infix("**", left.operand, right, left.operand.start, right.end, operator.start)
        operands.append(left._replace(operand=inner, end=right.end))
        return
    whole = (operator.text, left, right, left.start, right.end, operator.start)
    operands.append(made(Infix, whole))


def _shape(chain: Sequence[Expression | Token], table: dict[str, int]) -> list[int]:
    """Return the operators by place in the order in which they are carried out, as a tree code."""
    waiting: list[tuple[int, int]] = []  # level and place
    order: list[int] = []
    for i in range(1, len(chain), 2):
        operator = chain[i]
        assert isinstance(operator, Token)
        level = table[operator.text]
        while waiting and waiting[-1][0] >= level:
            order.append(waiting.pop()[1])
        waiting.append((level, i))
    order.extend(place for _, place in reversed(waiting))
    return order


def is_negative_number(expression: Expression) -> bool:
    """Return whether an expression is a number with a minus sign before it."""
    while isinstance(expression, Parenthesised):
        expression = expression.inner
    return isinstance(expression, Prefix) and expression.operator == "-"
