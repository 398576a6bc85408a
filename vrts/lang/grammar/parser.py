"""The only door to Lark: checks the grammar and compiles it to tables.

The tables are kept in `tables.py`, so a start of vrts neither imports Lark nor analyses the
grammar (0.15 s); a test compiles the grammar anew and compares. After a change of the grammar:

    python -c "from vrts.lang.grammar.parser import tables_source as t; print(t(), end='')" > new
    mv new vrts/lang/grammar/tables.py
"""

from collections.abc import Callable, Iterator
from importlib.resources import files
from typing import Any, TypeAlias, cast

from lark import Lark
from lark.grammar import Rule
from lark.lexer import Lexer, TerminalDef

STARTS = ("command", "data", "expression", "step")
Serialise: TypeAlias = Callable[[list[type]], tuple[dict[str, Any], dict[int, Any]]]
_SHIFT = 0  # how Lark serialises a shift; a reduction is 1


class _NoLexer(Lexer):
    """Stands in for a lexer: the tokens come from `tokeniser`."""

    def __init__(self, lexer_conf: object) -> None:
        pass

    def lex(self, lexer_state: object, parser_state: object) -> Iterator[Any]:
        return iter(())


def grammar_text() -> str:
    """Return the grammar."""
    return files("vrts.lang.grammar").joinpath("grammar.lark").read_text("utf-8")


def tables_source() -> str:
    """Return the text of `tables.py` for the grammar.

    Raises:
        lark.exceptions.GrammarError: The grammar has a conflict.
    """
    lark = Lark(grammar_text(), parser="lalr", start=list(STARTS), lexer=_NoLexer, strict=True)
    serialise = cast("Serialise", lark.memo_serialize)  # pyright: ignore[reportUnknownMemberType]
    data, memo = serialise([TerminalDef, Rule])
    table: dict[str, Any] = data["parser"]["parser"]
    names: dict[int, str] = table["tokens"]
    starts: dict[str, int] = table["start_states"]
    ends: dict[str, int] = table["end_states"]
    states: dict[int, dict[int, tuple[int, Any]]] = table["states"]
    rules: dict[tuple[str, int, str], int] = {}
    number = {starts[start]: i for i, start in enumerate(STARTS)}
    accepting = {ends[start] for start in STARTS}
    queue = list(number)
    rows: list[str] = []
    for state in queue:  # breadth first, so that numbers do not depend on hash order
        row: dict[str, int] = {}
        by_name = {names[key]: entry for key, entry in states[state].items()}
        for name in sorted(by_name):
            kind, target = by_name[name]
            if kind == _SHIFT:
                if target not in number:
                    number[target] = len(number)
                    queue.append(target)
                row[name] = number[target]
            else:
                rule = memo[target["@"]]
                key = (str(rule["origin"]["name"]), len(rule["expansion"]), str(rule["alias"]))
                row[name] = -1 - rules.setdefault(key, len(rules))
        rows.append(_row(row))
    accepted = sorted(number[state] for state in accepting)
    return "\n".join(
        [
            '"""Tables of the grammar: made by `parser.tables_source`, not by hand."""',
            "",
            "# fmt: off",
            "# ruff: noqa: E501",
            f"STARTS: dict[str, int] = { ({start: i for i, start in enumerate(STARTS)})!r}",
            f"ENDS: frozenset[int] = frozenset({accepted!r})",
            "RULES: tuple[tuple[str, int, str], ...] = (",
            *(f"    {rule!r}," for rule in rules),
            ")",
            "ACTIONS: tuple[dict[str, int], ...] = (",
            *(f"    {row}," for row in rows),
            ")",
            "",
        ]
    )


def _row(row: dict[str, int]) -> str:
    return "{" + ", ".join(f"{name!r}: {action}" for name, action in row.items()) + "}"
