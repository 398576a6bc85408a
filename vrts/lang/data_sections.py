""".LOCATIONS, .REALS and .STRINGS to initial values."""

import re

from vrts.base.diagnostic import Rule
from vrts.base.oat import pose_from_components
from vrts.base.pose import IDENTITY_ROTATION, Pose
from vrts.base.units import DEG, MM
from vrts.ir.module import Datum
from vrts.ir.values import Type, Value
from vrts.lang.lalr import Failure
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.scope import Scope
from vrts.lang.splitter import Line, Section
from vrts.lang.steps import StepParser
from vrts.lang.syntax import Element, Name, Number, Text

INVALID_DATA = Rule("V145", "invalid-data-line")
VALUE_COUNT = Rule("V146", "value-count")
VALUE_REPLACED = Rule("V216", "value-replaced")

_NAME = re.compile(r"[$#]?[A-Za-z][\w.]*", re.ASCII)
_FORMS = {
    "locations": "name X Y Z O A T",
    "reals": "name value",
    "strings": '$name "text"',
}


def read_data(section: Section, parser: StepParser, scope: Scope) -> list[Datum]:
    """Return the values of a data section; report lines that give none."""
    data: list[Datum] = []
    for line in section.lines:
        datum = _read(section.kind, line, parser, scope)
        if datum is not None:
            data.append(datum)
    return data


def _read(kind: str, line: Line, parser: StepParser, scope: Scope) -> Datum | None:
    problems = parser.problems
    before = len(problems.found)
    datum = _value_of(kind, line, parser, scope)
    if datum is None and len(problems.found) > before:
        name = _NAME.match(line.text)
        if name is not None:  # a bad line still means to give its name a value
            scope.entry(None, key(name.group())).writes.append((line.start, line.end))
    return datum


def _value_of(kind: str, line: Line, parser: StepParser, scope: Scope) -> Datum | None:
    problems = parser.problems
    node = parser.data(line)
    if node is None:
        return None
    if isinstance(node, Failure):
        _invalid(problems, line, kind, "this line gives no value")
        return None
    name = node.target if isinstance(node.target, Name) else node.target.name
    subscripts: list[int] = []
    if isinstance(node.target, Element):
        for subscript in node.target.subscripts:
            if not isinstance(subscript, Number):
                _invalid(problems, line, kind, "an index in a data section is a number")
                return None
            subscripts.append(round(subscript.value))
    numbers = [v.value for v in node.values if isinstance(v, Number)]
    texts = [v.value for v in node.values if isinstance(v, Text)]
    sigil = name.text[0] if name.text[0] in "$#" else ""
    value: Value
    if kind == "strings":
        if sigil != "$" or len(texts) != 1 or numbers:
            _invalid(problems, line, kind, "a string has a name with `$` and one text")
            return None
        value, type_ = texts[0], Type.STRING
    elif texts or sigil == "$":
        _invalid(problems, line, kind, "strings belong to a .STRINGS section")
        return None
    elif kind == "reals":
        if sigil or len(numbers) != 1:
            _count(problems, line, name.text, len(numbers), "one value")
            return None
        value, type_ = numbers[0], Type.REAL
    elif sigil == "#":
        if len(numbers) != 6:
            _count(problems, line, name.text, len(numbers), "6 joint angles")
            return None
        a, b, c, d, e, f = (number * DEG for number in numbers)
        value, type_ = (a, b, c, d, e, f), Type.JOINTS
    else:
        pose = _pose(numbers)
        if pose is None:
            _count(
                problems, line, name.text, len(numbers), "6 values: X Y Z in mm, O A T in degrees"
            )
            return None
        value, type_ = pose, Type.POSE
    where = (name.start, name.end)
    entry = scope.entry(None, key(name.text))
    entry.spellings.setdefault(name.text.lower(), where)
    entry.writes.append(where)
    if type_ in (Type.REAL, Type.POSE):
        entry.types.setdefault(type_, where)
    if subscripts and entry.array is None:
        entry.array = where
    elif not subscripts and entry.scalar is None:
        entry.scalar = where
        if isinstance(node.values[0], Number) and kind == "reals":
            entry.values.append(node.values[0])
    return Datum(key(name.text), tuple(subscripts), value, problems.span(node.start, node.end))


def _pose(numbers: list[float]) -> Pose | None:
    match numbers:
        case [x, y, z]:
            return Pose(IDENTITY_ROTATION, (x * MM, y * MM, z * MM))
        case [x, y, z, o, a, t]:
            return pose_from_components(x, y, z, o, a, t)
        case [nx, ny, nz, ox, oy, oz, ax, ay, az, px, py, pz]:
            rotation = (nx, ox, ax, ny, oy, ay, nz, oz, az)
            return Pose(rotation, (px * MM, py * MM, pz * MM))
        case _:
            return None


def _invalid(problems: Problems, line: Line, kind: str, headline: str) -> None:
    problems.error(
        INVALID_DATA,
        headline,
        line.start,
        line.end,
        help=(f"write `{_FORMS[kind]}`",),
    )


def _count(problems: Problems, line: Line, name: str, count: int, wanted: str) -> None:
    problems.error(
        VALUE_COUNT,
        f"`{name}` has {count} value{'' if count == 1 else 's'}",
        line.start,
        line.end,
        f"it takes {wanted}",
        data={"name": name, "count": count},
    )


def report_replaced(problems: Problems, data: list[Datum]) -> None:
    """Warn where a later line gives the same variable another value."""
    seen: dict[tuple[str, tuple[int, ...]], Datum] = {}
    for datum in data:
        before = seen.get((datum.name, datum.subscripts))
        seen[datum.name, datum.subscripts] = datum
        if before is not None:
            problems.warning(
                VALUE_REPLACED,
                f"`{datum.name}` is given a value twice; the last one holds",
                datum.span.start,
                datum.span.end,
                secondary=(problems.label(before.span.start, before.span.end, "first here"),),
                help=("take one of the lines out",),
            )
