"""Nodes of the syntax tree from the reductions of the grammar: one function per alias.

Tokens and nodes both end in `start` and `end`, so the range of a node is that of its parts.
"""

from typing import Any

from vrts.base.diagnostic import Rule
from vrts.lang.lalr import Build
from vrts.lang.operators import TABLE_A, TABLE_B, ambiguous, tree, written
from vrts.lang.problems import Problems
from vrts.lang.syntax import (
    Application,
    Assignment,
    CallStatement,
    Case,
    DataLine,
    Element,
    For,
    FormatItem,
    Goto,
    HereStatement,
    If,
    Name,
    Number,
    Parenthesised,
    Prefix,
    SetLocation,
    ShiftStatement,
    Simple,
    SpeedStatement,
    Structure,
    Text,
    Until,
    ValueGroup,
    While,
)

PRECEDENCE = Rule("V150", "precedence")

# The values of a rule are tokens and nodes by its alternatives; the grammar guarantees their
# types, so they are not checked again here.
Values = list[Any]


def builders(problems: Problems) -> dict[str, Build]:
    """Return the builder of every alias of the grammar; W-PREC goes to `problems`."""

    def expression(v: Values) -> Any:
        chain = v[0]
        if len(chain) == 1:
            return chain[0]
        result = tree(chain, TABLE_A)
        if ambiguous(chain):
            text = problems.source.text
            meant = written(tree(chain, TABLE_B), text)
            problems.warning(
                PRECEDENCE,
                "this condition is not read as it looks",
                result.start,
                result.end,
                f"VAL-II reads {written(result, text)}",
                notes=("in VAL-II AND binds like `*` and OR like `+`, before comparisons",),
                help=(f"write parentheses: {meant}",),
                fix=problems.replace(result.start, result.end, meant),
            )
        return result

    return {**_BUILDERS, "expression": expression}


def _list(values: Any) -> tuple[Any, ...]:
    """Return the operands of a list; one that is nothing but empty has none."""
    return () if len(values) == 1 and values[0] is None else tuple(values)


def _value(token: Any, sign: float = 1.0) -> Number:
    return Number(sign * token.value, token.start, token.end)


def _speed(v: Values) -> SpeedStatement:
    units = [token.text for token in v[2:] if token.kind == "UNIT"]
    always = v[-1].kind == "ALWAYS" if len(v) > 2 else False
    return SpeedStatement(v[1], units[0] if units else None, always, v[0].start, v[-1].end)


def _for(v: Values) -> For:
    return For(v[1], v[3], v[5], v[7] if len(v) == 8 else None, v[0].start, v[-1].end)


def _call(v: Values) -> CallStatement:
    program = Name(v[1].text, v[1].start, v[1].end)
    return CallStatement(program, _list(v[3]) if len(v) == 5 else (), v[0].start, v[-1].end)


def _simple_list(v: Values) -> Simple:
    operands = _list(v[1])
    end = operands[-1].end if operands and operands[-1] is not None else v[0].end
    return Simple(v[0].text, operands, v[0].start, end)


def _operands(*places: int) -> Build:
    def build(v: Values) -> Simple:
        return Simple(v[0].text, tuple(v[i] for i in places), v[0].start, v[-1].end)

    return build


def _application(v: Values) -> Application:
    return Application(v[0], _list(v[2]), None, v[0].start, v[-1].end)


def _application_by(v: Values) -> Application:
    before, after = _list(v[2]), _list(v[4])
    return Application(v[0], before + after, len(before), v[0].start, v[-1].end)


def _shift(v: Values) -> ShiftStatement:
    return ShiftStatement(v[1], _list(v[3]), v[0].start, v[2].end)


def _append(v: Values) -> Any:
    v[0].append(v[-1])
    return v[0]


def _link(v: Values) -> Any:
    v[0].append(v[1])
    v[0].append(v[2])
    return v[0]


_BUILDERS: dict[str, Build] = {
    "assignment": lambda v: Assignment(v[0], v[2], v[0].start, v[2].end),
    "set_location": lambda v: SetLocation(v[1], v[3], v[0].start, v[3].end),
    "here": lambda v: HereStatement(v[1], v[0].start, v[1].end),
    "shift": _shift,
    "simple": _operands(),
    "simple_one": _operands(1),
    "simple_two": _operands(1, 3),
    "simple_three": _operands(1, 3, 5),
    "simple_list": _simple_list,
    "speed": _speed,
    "goto": lambda v: Goto(_value(v[1]), None, v[0].start, v[1].end),
    "if_goto": lambda v: Goto(_value(v[3]), v[1], v[0].start, v[3].end),
    "if_then": lambda v: If(v[1], v[0].start, v[2].end),
    "while_do": lambda v: While(v[1], v[0].start, v[2].end),
    "until": lambda v: Until(v[1], v[0].start, v[1].end),
    "for_to": _for,
    "case_of": lambda v: Case(v[1], v[0].start, v[2].end),
    "value": lambda v: ValueGroup(tuple(v[1]), v[0].start, v[2].end),
    "structure": lambda v: Structure(v[0].text, v[0].start, v[-1].end),
    "call": _call,
    "execute": tuple,
    "data_line": lambda v: DataLine(v[0], tuple(v[-1]), v[0].start, v[-1][-1].end),
    "number": lambda v: _value(v[0]),
    "positive": lambda v: _value(v[1])._replace(start=v[0].start),
    "negative": lambda v: _value(v[1], -1.0)._replace(start=v[0].start),
    "text": lambda v: Text(v[0].value, v[0].start, v[0].end),
    "first": list,
    "more": _append,
    "more_after_comma": _append,
    "link": _link,
    "prefix": lambda v: Prefix(v[0].text, v[1], v[0].start, v[1].end),
    "application": _application,
    "application_by": _application_by,
    "parenthesised": lambda v: Parenthesised(v[1], v[0].start, v[2].end),
    "element": lambda v: Element(v[0], _list(v[2]), v[0].start, v[3].end),
    "name": lambda v: Name(v[0].text, v[0].start, v[0].end),
    "format": lambda v: FormatItem(v[0].text, v[0].start, v[0].end),
    "nothing": lambda _: None,
}
