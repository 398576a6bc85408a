"""Nodes of the syntax tree from the reductions of the grammar: one function per alias.

Tokens and nodes both end in `start` and `end`, so the range of a node is that of its parts.
"""

from typing import Any, cast

from vrts.base.diagnostic import Rule
from vrts.base.made import made
from vrts.lang.dialect import Precedence
from vrts.lang.grammar.lalr import Build
from vrts.lang.grammar.operators import TABLE_A, TABLE_B, ambiguous, compares_twice, tree, written
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    Expression,
    FormatItem,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
    Text,
)
from vrts.lang.syntax.program import DataLine
from vrts.lang.syntax.statements import (
    Assignment,
    CallNamed,
    CallStatement,
    Case,
    Declare,
    Device,
    For,
    Give,
    Goto,
    HereStatement,
    If,
    Level,
    PackStatement,
    Put,
    ReactStatement,
    Rest,
    SetLocation,
    Setting,
    ShiftStatement,
    Simple,
    SpeedStatement,
    Structure,
    Until,
    ValueGroup,
    While,
)
from vrts.lang.vocabulary.functions import FUNCTIONS

PRECEDENCE = Rule("V150", "precedence")


# The values of a rule are tokens and nodes by its alternatives; the grammar guarantees their
# types, so they are not checked again here.
Values = list[Any]


def builders(problems: Problems, table: Precedence = Precedence.A) -> dict[str, Build]:
    """Return the builder of every alias of the grammar; W-PREC goes to `problems`."""
    warns = not problems.dialect.is_as  # AS has always read them by table B
    levels, other = (TABLE_A, TABLE_B) if table is Precedence.A else (TABLE_B, TABLE_A)

    def expression(v: Values) -> Any:
        chain = v[0]
        if len(chain) == 1:
            return chain[0]
        result = tree(chain, levels)
        if len(chain) > 3 and warns and ambiguous(chain) and not compares_twice(chain):
            _read_otherwise(problems, result, tree(chain, other), table, _half_said(chain))
        return result

    return {**_BUILDERS, "expression": expression}


def _half_said(chain: Any) -> bool:
    """Return whether a number alone is joined by AND or OR, as in `x == 1 OR 2`."""
    joins = [k for k in range(1, len(chain), 2) if chain[k].text.upper() in ("AND", "OR")]
    parts = zip([-1, *joins], [*joins, len(chain)], strict=True)
    return any(b - a == 2 and isinstance(chain[a + 1], Number) for a, b in parts if joins)


def _read_otherwise(
    problems: Problems, result: Expression, other: Expression, table: Precedence, half_said: bool
) -> None:
    """Warn of an expression that the two tables read differently [W-PREC]."""
    text = problems.source.text
    read, otherwise = written(result, text), written(other, text)
    condition = any(sign in read for sign in ("==", "<", ">"))
    meant = otherwise if condition and table is Precedence.A else read
    if condition and table is Precedence.A:
        headline = "this condition is not read as it looks"
        note = "in VAL-II AND binds like `*` and OR like `+`, before comparisons"
    else:
        headline = "other controllers of the family read this otherwise"
        note = f"they read {otherwise}"
    problems.warning(
        PRECEDENCE,
        headline,
        result.start,
        result.end,
        f"VAL-II reads {read}" if table is Precedence.A else f"this is read {read}",
        notes=(note,),
        help=(
            ("name what is compared on both sides: `(x == 1) OR (x == 2)`",)
            if half_said
            else (f"write parentheses: {meant}",)
        ),
        fix=None if half_said else problems.replace(result.start, result.end, meant),
    )


def _list(values: Any) -> tuple[Any, ...]:
    """Return the operands of a list; one that is nothing but empty has none."""
    return () if len(values) == 1 and values[0] is None else tuple(values)


def _subscripts(values: Any) -> tuple[Any, ...]:
    """Return the subscripts of an element; `a[]` and `a[,]` are whole arrays."""
    return () if all(value is None for value in values) else tuple(values)


def _value(token: Any, sign: float = 1.0) -> Number:
    return made(Number, (sign * token.value, token.start, token.end))


def _name(v: Values) -> Name:
    token = v[0]
    return made(Name, (token.text, token.start, token.end))


def _always(token: Any) -> bool:
    return token is not None


def _last(*nodes: Any) -> int:
    """Return the end of the last node that is there."""
    return max(node.end for node in nodes if node is not None)


def _level(v: Values) -> Level:
    unit = v[1].text if len(v) > 1 else None
    return Level(v[0], unit, v[0].start, v[-1].end)


def _speed(v: Values) -> SpeedStatement:
    levels = tuple(v[1])
    end = _last(levels[-1], v[2])
    return SpeedStatement(v[0].text, levels, _always(v[2]), None, v[0].start, end)


def _profile(v: Values) -> SpeedStatement:
    """`ACCEL (profile) up, down` of V+; the values may be missing."""
    levels = tuple(v[4]) if len(v) > 5 else ()
    end = _last(v[3], *levels, v[-1])
    return SpeedStatement(v[0].text, levels, _always(v[-1]), _list(v[2]), v[0].start, end)


def _setting(v: Values) -> Setting:
    value = v[1] if len(v) > 2 else None
    return Setting(v[0].text, value, _always(v[-1]), v[0].start, _last(v[0], value, v[-1]))


def _react(v: Values) -> ReactStatement:
    operands = _list(v[1])
    return ReactStatement(
        v[0].text, operands, _always(v[2]), v[0].start, _last(v[0], *operands, v[2])
    )


def _on_call(v: Values) -> ReactStatement:
    program = Name(v[3].text, v[3].start, v[3].end)
    operands = (v[1], program, v[5]) if len(v) > 5 else (v[1], program)
    return ReactStatement(v[0].text, operands, False, v[0].start, v[-1].end)


def _opaque(v: Values) -> Rest:
    """A step that is well formed and never carried out; the names in it are added later."""
    written = [value for value in v if value is not None and not isinstance(value, list)]
    for value in v:
        if isinstance(value, list):
            written += cast("Values", value)
    return Rest(v[0].text, (), v[0].start, _last(*written))


def _device(v: Values) -> Device:
    unit = _list(v[2]) if len(v) > 2 else None
    operands = _list(v[-1])
    closing = v[3] if len(v) > 2 else None
    return Device(v[0].text, unit, operands, None, v[0].start, _last(v[0], closing, *operands))


def _device_put(v: Values) -> Device:
    unit = _list(v[2]) if len(v) > 4 else None
    operands, equal, given = _list(v[-3]), v[-2], _list(v[-1])
    return Device(v[0].text, unit, operands, given, v[0].start, _last(equal, *given))


def _task_call(v: Values) -> Device | Simple:
    """`EXECUTE task program(a, b), cycles` of V+: what it names, and what it passes.

    Task 1, with nothing passed, is the second program of VAL-II [manual language/processes#tasks].
    """
    at = next(i for i in (1, 2) if getattr(v[i], "kind", "") == "PROGRAM")
    program = Name(v[at].text, v[at].start, v[at].end)
    passed = _list(v[at + 2]) if len(v) > at + 2 else ()
    more = tuple(v[-1] or ())
    operands = (*v[1:at], program, *passed, *more)
    closing = v[-2]
    task = v[1] if at == 2 else None
    second = isinstance(task, Number) and task.value == 1.0
    if v[0].text.upper() == "EXECUTE" and second and not passed and len(more) <= _OF_PROCESS:
        return Simple("PCEXECUTE", (program, *more), v[0].start, _last(closing, *operands))
    return Device(v[0].text, None, operands, None, v[0].start, _last(closing, *operands))


def _declare(v: Values) -> Declare:
    kind = v[1].text if len(v) > 2 else None
    return Declare(v[0].text, kind, tuple(v[-1]), v[0].start, v[-1][-1].end)


def _give(v: Values) -> Give:
    return Give(v[0].text, v[1], tuple(v[3]), v[0].start, v[3][-1].end)


def _if_relation(v: Values) -> Goto:
    """`IF a EQ b THEN label` of VAL."""
    relation = v[2]
    condition = Infix(relation.text, v[1], v[3], v[1].start, v[3].end, relation.start)
    return Goto(v[5], condition, v[0].start, v[5].end)


def signals_hold(operands: tuple[Any, ...], start: int, end: int) -> Application:
    """Return `SIG(...)` for operands that are signals."""
    return Application(Name("SIG", start, start), operands, None, start, end)


def _input(item: Any) -> Infix:
    """Return the input that a channel number of VAL means: 1 is 1001, -1 is -1001."""
    start, end = item.start, item.end
    sign = Application(Name("SIGN", start, start), (item,), None, start, end)
    offset = Infix("*", Number(1000.0, start, start), sign, start, end, start)
    return Infix("+", item, offset, start, end, start)


def _if_signals(v: Values) -> Goto:
    """`IFSIG a, b THEN label` of VAL."""
    items = tuple(_input(item) for item in v[1] if item is not None)
    start, end = (items[0].start, items[-1].end) if items else (v[0].start, v[0].end)
    condition = signals_hold(items, start, end)
    return Goto(v[3], condition, v[0].start, v[3].end)


def _call_named(v: Values) -> CallNamed:
    program, arguments = v[1], ()
    if len(v) == 2 and isinstance(program, Application) and program.name.text[0] == "$":
        if program.name.text.lower() not in FUNCTIONS:
            program, arguments = program.name, program.arguments  # `CALLS $name(a)`
    elif len(v) == 5:
        program, arguments = Text(v[1].value, v[1].start, v[1].end), _list(v[3])
    elif len(v) > 5:
        program = Element(v[1], _list(v[3]), v[1].start, v[4].end)
        arguments = _list(v[6])
    return CallNamed(program, arguments, v[0].start, v[-1].end)


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


_OF_PROCESS = 2  # cycles and first step: what PCEXECUTE takes besides the program
_BUILDERS: dict[str, Build] = {
    "assignment": lambda v: Assignment(v[0], v[2], v[0].start, v[2].end),
    "set_near": lambda v: Rest("POINT", (), v[0].start, v[5].end),
    "set_location": lambda v: SetLocation(v[1], v[3], v[0].start, v[3].end),
    "here": lambda v: HereStatement(v[1], v[0].start, v[1].end),
    "shift": _shift,
    "simple": _operands(),
    "simple_one": _operands(1),
    "simple_two": _operands(1, 3),
    "simple_three": _operands(1, 3, 5),
    "simple_list": _simple_list,
    "give": _give,
    "put": lambda v: Put(v[0].text, v[1], None, v[3], v[0].start, v[3].end),
    "put_bits": lambda v: Put(v[0].text, v[1], v[3], v[5], v[0].start, v[5].end),
    "pack": lambda v: PackStatement(v[1], v[3], v[5], v[7], v[0].start, v[7].end),
    "device": _device,
    "device_put": _device_put,
    "task_call": _task_call,
    "tail": lambda v: _list(v[1]),
    "setting": _setting,
    "setting_value": _setting,
    "react": _react,
    "on_call": _on_call,
    "on_goto": _opaque,
    "until_signal": lambda v: Device(v[0].text, None, (v[1], v[3]), None, v[0].start, v[3].end),
    "level": _level,
    "speed": _speed,
    "profile": _profile,
    "declare": _declare,
    "goto": lambda v: Goto(v[1], None, v[0].start, v[1].end),
    "goto_if": lambda v: Goto(v[1], v[3], v[0].start, v[3].end),
    "if_goto": lambda v: Goto(v[3], v[1], v[0].start, v[3].end),
    "if_relation": _if_relation,
    "if_signals": _if_signals,
    "if_then": lambda v: If(v[1], v[0].start, v[2].end),
    "while_do": lambda v: While(v[1], v[0].start, v[2].end),
    "until": lambda v: Until(v[1], v[0].start, v[1].end),
    "for_to": _for,
    "case_of": lambda v: Case(v[1], v[0].start, v[2].end),
    "value": lambda v: ValueGroup(tuple(v[1]), v[0].start, v[2].end),
    "structure": lambda v: Structure(v[0].text, v[0].start, v[-1].end),
    "call": _call,
    "call_named": _call_named,
    "command": lambda v: (_list(v[1]), _list(v[3]) if len(v) > 2 else None),
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
    "element": lambda v: Element(v[0], _subscripts(v[2]), v[0].start, v[3].end),
    "name": _name,
    "format": lambda v: FormatItem(v[0].text, v[0].start, v[0].end),
    "nothing": lambda _: None,
}
