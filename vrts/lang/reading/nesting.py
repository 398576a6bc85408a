"""Parentheses and brackets of a step: each has its partner, and they do not nest too deeply."""

from typing import Any

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Element, Infix, Parenthesised, Prefix
from vrts.lang.syntax.token import Token

NESTED_TOO_DEEPLY = Rule("V113", "nested-too-deeply")
MISSING_PARENTHESIS = Rule("V128", "missing-parenthesis")
MISSING_BRACKET = Rule("V129", "missing-bracket")

MAX_NESTING = 200  # parentheses and brackets
MAX_DEPTH = 400  # levels of an expression: operators in a row nest too

_BRACKETS = frozenset({"LPAREN", "LBRACKET", "RPAREN", "RBRACKET"})
_CLOSES = {"RPAREN": "LPAREN", "RBRACKET": "LBRACKET"}


def balanced(tokens: list[Token], problems: Problems) -> bool:
    """Report the first parenthesis or bracket without its partner, or nesting too deep."""
    open_: list[Token] = []
    prefixes = 0
    if len(tokens) <= MAX_NESTING:  # as most: they cannot nest too deeply
        tokens = [token for token in tokens if token.kind in _BRACKETS]
    for token in tokens:
        kind = token.kind
        prefixes = prefixes + 1 if kind in ("MINUS", "PLUS") or token.text.upper() == "NOT" else 0
        if kind in ("LPAREN", "LBRACKET"):
            open_.append(token)
        elif kind in _CLOSES:
            if open_ and open_[-1].kind == _CLOSES[kind]:
                open_.pop()
                continue
            _unmatched(token, open_[-1] if open_ else None, problems)
            return False
        if len(open_) + prefixes > MAX_NESTING:
            problems.error(
                NESTED_TOO_DEEPLY,
                f"this expression is nested more than {MAX_NESTING} levels deep",
                token.start,
                token.end,
                help=("compute parts of it in steps of their own",),
            )
            return False
    if open_:
        _unmatched(open_[-1], None, problems)
    return not open_


def _unmatched(token: Token, inside: Token | None, problems: Problems) -> None:
    bracket = token.kind in ("LBRACKET", "RBRACKET")
    rule = MISSING_BRACKET if bracket else MISSING_PARENTHESIS
    opens = token.kind in ("LPAREN", "LBRACKET")
    partner = {"(": ")", "[": "]", ")": "(", "]": "["}[token.text]
    words = "Missing bracket" if bracket else "Missing parenthesis"
    secondary = ()
    if inside is not None:
        secondary = (problems.label(inside.start, inside.end, "this one is still open"),)
    problems.error(
        rule,
        f"`{token.text}` is never closed" if opens else f"`{token.text}` closes nothing",
        token.start,
        token.end,
        f"no `{partner}` follows" if opens else f"no `{partner}` is open here",
        secondary=secondary,
        notes=(f"VAL-II says *{words}*",),
        help=(f"add `{partner}`" + ("" if opens else f", or take `{token.text}` out"),),
    )


def too_deep(problems: Problems, statement: Any) -> bool:
    """Report a statement whose expressions are nested beyond `MAX_DEPTH`, and return whether."""
    waiting: list[tuple[Any, int]] = [(statement, 0)]
    while waiting:
        node, depth = waiting.pop()
        if depth > MAX_DEPTH:
            problems.error(
                NESTED_TOO_DEEPLY,
                f"this expression joins more than {MAX_DEPTH} operands",
                statement.start,
                statement.end,
                help=("compute parts of it in steps of their own",),
            )
            return True
        deeper = depth + isinstance(node, Infix | Prefix | Parenthesised | Application | Element)
        parts: list[Any] = [part for part in node if isinstance(part, tuple)]
        waiting.extend((part, deeper) for part in parts)
    return False
