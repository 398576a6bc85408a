"""Data sections to initial values: .LOCATIONS, .REALS, .STRINGS and those of the relatives.

Lines are read as they stand in real files: values between blanks or commas, with or without `=`
behind the name, locations of 3, 6 or 12 values [manual language/files#data-lines].
"""

import math
import re
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.numbers import round_half_away
from vrts.base.oat import rotation_from_oat
from vrts.base.pose import IDENTITY_ROTATION, Pose, Rotation
from vrts.ir.module import Datum
from vrts.ir.values import Joints, Type, Value
from vrts.lang.decimals import metres, radians
from vrts.lang.dialect import Angles, Dialect
from vrts.lang.grammar.lalr import Failure
from vrts.lang.meaning.data_mistakes import (
    FORMS,
    INVALID_DATA,
    ODD_QUOTES,
    explain,
    explain_string,
    plain,
    wrong_count,
)
from vrts.lang.meaning.scope import Scope
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.sections.lines import Line, Section
from vrts.lang.steps.step_parser import StepParser, names_in
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.lang.syntax.program import DataLine

EXTRA_AXES = Rule("V162", "extra-axes")
NO_ROTATION = Rule("V163", "no-rotation")
VALUE_REPLACED = Rule("V216", "value-replaced")

MOST_MEANT = 8  # names of a bad line that are taken as given a value
MAX_STRING = 128  # [manual language/strings#length]
SKEW = 1e-3  # how far a matrix may be from a rotation and still be read as one [assumed]
_JOINTS = 6
_MOST_AXES = 18  # of AS: POINT/18 sets the last
_FEWEST_AXES = 4  # of a robot that V+ is for
_MATRIX = 12  # values of a location of V+; also the most axes
_NUMBERS = re.compile(r"[-+]?[.\d][-+.\deE, \t]*", re.ASCII)
_STRING = re.compile(
    r"(?P<name>\$[A-Za-z][\w.]*)[ \t]*(?:\[(?P<subscripts>[^\]]*)\])?[ \t]*=?[ \t]*(?P<value>.*)$",
    re.ASCII,
)


class _Read(NamedTuple):
    """A line that gives a value."""

    name: str  # as written
    start: int  # of the name
    subscripts: tuple[int, ...]
    value: Value
    type: Type
    number: Number | None = None  # of a real, as written


def read_data(section: Section, parser: StepParser, scope: Scope) -> list[Datum]:
    """Return the values of a data section; report lines that give none."""
    data: list[Datum] = []
    axes = _axes(section)
    for line, more in _entries(section, parser.problems.dialect):
        found = _read(section.kind, line, more, parser, axes)
        if found is not None:
            _note(found, scope)
            span = parser.problems.span(line.start, (line, *more)[-1].end)
            data.append(Datum(key(found.name), found.subscripts, found.value, span))
        else:
            for name in names_in(line.text)[:MOST_MEANT]:  # a bad line still means to give a value
                for meant in (name, *(f"{sigil}{name.lstrip('$#')}" for sigil in ("$", "#", ""))):
                    if meant:
                        scope.entry(None, meant).writes.append((line.start, line.end))
    return data


def _axes(section: Section) -> int:
    """Return how many values most precision points of a section have: the axes of its robot."""
    counts = Counter(len(line.text.split()) - 1 for line in section.lines if line.text[0] == "#")
    return counts.most_common(1)[0][0] if counts else _JOINTS


def _entries(section: Section, dialect: Dialect) -> Iterator[tuple[Line, tuple[Line, ...]]]:
    """Yield every line of a section with the lines that carry it on.

    V+ stores the twelve numbers of a location on two lines, the second without a name.
    """
    joins = section.kind == "locations" and dialect.has("+")
    held: Line | None = None
    more: tuple[Line, ...] = ()
    for line in section.lines:
        if joins and held is not None and _NUMBERS.fullmatch(line.text) is not None:
            more = (*more, line)
            continue
        if held is not None:
            yield held, more
        held, more = line, ()
    if held is not None:
        yield held, more


def _note(found: _Read, scope: Scope) -> None:
    where = (found.start, found.start + len(found.name))
    entry = scope.entry(None, key(found.name))
    entry.spellings.setdefault(found.name.lower(), where)
    entry.writes.append(where)
    if found.type in (Type.REAL, Type.POSE):
        entry.types.setdefault(found.type, where)
        entry.given.setdefault(found.type, where)
    if found.subscripts and entry.array is None:
        entry.array = where
    elif not found.subscripts and entry.scalar is None:
        entry.scalar = where
        if found.number is not None:
            entry.values.append(found.number)


def _read(
    kind: str, line: Line, more: tuple[Line, ...], parser: StepParser, axes: int
) -> _Read | None:
    if kind == "strings":
        return _string(parser.problems, line)
    problems = parser.problems
    strict = not problems.dialect.tolerant
    if strict and not plain(line.text) and explain(line, kind, problems):
        return None
    node = parser.data(line, more)
    if isinstance(node, Failure):
        _invalid(problems, line, kind, "this line gives no value")
    if not isinstance(node, DataLine):
        return None
    name = node.target if isinstance(node.target, Name) else node.target.name
    subscripts = _subscripts(node, problems, line, kind)
    numbers = [value for value in node.values if isinstance(value, Number)]
    if subscripts is None:
        return None
    if len(numbers) < len(node.values) or name.text[0] == "$":
        problems.error(
            INVALID_DATA,
            "a string stands here, not a number",
            line.start,
            line.end,
            help=("end this section by `.END`, and write the string below `.STRINGS`",),
        )
        return None
    if kind == "reals":
        if name.text[0] == "#" or len(numbers) != 1:
            wrong_count(problems, line, name.text, len(numbers), kind)
            return None
        value = numbers[0].value
        return _Read(name.text, name.start, subscripts, value, Type.REAL, numbers[0])
    if name.text[0] == "#":
        joints = _joints(problems, line, name, numbers, axes)
        if joints is None:
            return None
        return _Read(name.text, name.start, subscripts, joints, Type.JOINTS)
    pose = _pose(problems, line, name, numbers)
    if pose is None:
        return None
    return _Read(name.text, name.start, subscripts, pose, Type.POSE)


def _subscripts(
    node: DataLine, problems: Problems, line: Line, kind: str
) -> tuple[int, ...] | None:
    found: list[int] = []
    if isinstance(node.target, Element):
        for subscript in node.target.subscripts:
            if not isinstance(subscript, Number):
                _invalid(problems, line, kind, "an index in a data section is a number")
                return None
            found.append(round_half_away(subscript.value))
    return tuple(found)


def _string(problems: Problems, line: Line) -> _Read | None:
    """`$name "text"`; the quotes may be missing."""
    match = _STRING.match(line.text)
    text = match["value"].strip() if match is not None else ""
    quoted = len(text) > 1 and text[0] == text[-1] == '"'
    inner = text[1:-1] if quoted else text
    odd = not quoted and not problems.dialect.tolerant and ODD_QUOTES.match(line.text)
    if match is None or not text or '"' in inner or odd:
        explain_string(line, problems)
        return None
    if len(inner) > MAX_STRING:
        _invalid(problems, line, "strings", f"a string has at most {MAX_STRING} characters")
        return None
    subscripts: list[int] = []
    for written in (match["subscripts"] or "").split(",") if match["subscripts"] else ():
        if not written.strip().isdecimal():
            _invalid(problems, line, "strings", "an index in a data section is a number")
            return None
        subscripts.append(int(written))
    return _Read(match["name"], line.start, tuple(subscripts), inner, Type.STRING)


# --- locations ------------------------------------------------------------------------------------


def _written(problems: Problems, number: Number) -> str:
    """Return a number as written, with its sign, so that it is rounded only once."""
    text = problems.source.text[number.start : number.end].lstrip("+-")
    if not text[:1].isdecimal() and text[:1] != ".":
        return repr(number.value)  # `^HFF`
    return f"-{text}" if math.copysign(1.0, number.value) < 0 else text  # -0.0 of what is tiny


def _joints(
    problems: Problems, line: Line, name: Name, numbers: list[Number], axes: int
) -> Joints | None:
    fewer = problems.dialect.has("+") and _FEWEST_AXES <= len(numbers) < _JOINTS
    if fewer and len(numbers) == axes:
        problems.warning(
            EXTRA_AXES,
            f"`{name.text}` has {len(numbers)} axes; the other joints are at 0",
            name.start,
            name.end,
            help=("the simulated arm has six joints",),
        )
        zero = Number(0.0, name.start, name.start)
        numbers = numbers + [zero] * (_JOINTS - len(numbers))
    numbers = _first_six(problems, name, numbers)
    if len(numbers) != _JOINTS:
        wrong_count(problems, line, name.text, len(numbers), "locations")
        return None
    a, b, c, d, e, f = (radians(_written(problems, number)) for number in numbers)
    return (a, b, c, d, e, f)


def _first_six(problems: Problems, name: Name, numbers: list[Number]) -> list[Number]:
    """Return the values without those of more axes, which AS and V+ have."""
    most = _MOST_AXES if problems.dialect.is_as else _MATRIX
    if not (problems.dialect.has("+a") and _JOINTS < len(numbers) <= most):
        return numbers
    problems.warning(
        EXTRA_AXES,
        f"`{name.text}` has {len(numbers)} axes; the first six are taken",
        name.start,
        name.end,
        help=("the simulated arm has six joints",),
    )
    return numbers[:_JOINTS]


def _pose(problems: Problems, line: Line, name: Name, numbers: list[Number]) -> Pose | None:
    if problems.dialect.is_as or (problems.dialect.has("a") and len(numbers) != _MATRIX):
        numbers = _first_six(problems, name, numbers)
    texts = [_written(problems, number) for number in numbers]
    match texts:
        case [x, y, z]:
            return Pose(IDENTITY_ROTATION, (metres(x), metres(y), metres(z)))
        case [x, y, z, *angles] if len(angles) == 3:
            o, a, t = map(float, angles)
            if problems.dialect.angles is Angles.ZYZ:
                o, a = o + 90.0, a - 90.0
            return Pose(rotation_from_oat(o, a, t), (metres(x), metres(y), metres(z)))
        case [nx, ny, nz, ox, oy, oz, ax, ay, az, x, y, z]:
            columns = (nx, ox, ax, ny, oy, ay, nz, oz, az)
            r1, r2, r3, r4, r5, r6, r7, r8, r9 = map(float, columns)
            rotation: Rotation = (r1, r2, r3, r4, r5, r6, r7, r8, r9)
            if _skew(rotation) > SKEW:
                problems.error(
                    NO_ROTATION,
                    f"the matrix of `{name.text}` is no rotation",
                    line.start,
                    line.end,
                    notes=("12 values are the columns n, o, a of a rotation, and the position",),
                    help=("write six values: `X Y Z O A T`",),
                )
                return None
            return Pose(rotation, (metres(x), metres(y), metres(z)))
        case _:
            wrong_count(problems, line, name.text, len(numbers), "locations")
            return None


def _skew(r: Rotation) -> float:
    """Return how far a matrix is from a rotation: columns of length 1, square, right-handed."""
    n, o, a = (r[0], r[3], r[6]), (r[1], r[4], r[7]), (r[2], r[5], r[8])
    across = (
        n[1] * o[2] - n[2] * o[1] - a[0],
        n[2] * o[0] - n[0] * o[2] - a[1],
        n[0] * o[1] - n[1] * o[0] - a[2],
    )
    products = [sum(u * v for u, v in zip(p, q, strict=True)) for p, q in ((n, o), (n, a), (o, a))]
    lengths = [abs(sum(u * u for u in column) - 1.0) for column in (n, o, a)]
    return max(*map(abs, products), *lengths, *map(abs, across))


# --- wording --------------------------------------------------------------------------------------


def _invalid(problems: Problems, line: Line, kind: str, headline: str) -> None:
    problems.error(
        INVALID_DATA,
        headline,
        line.start,
        line.end,
        help=(f"write `{FORMS[kind]}`",),
    )


def report_replaced(problems: Problems, data: list[Datum]) -> None:
    """Warn where a later line gives the same variable another value."""
    seen: dict[tuple[str, tuple[int, ...]], Datum] = {}
    for datum in data:
        before = seen.get((datum.name, datum.subscripts))
        seen[datum.name, datum.subscripts] = datum
        if before is not None and _name_written(before) == _name_written(datum):
            problems.warning(
                VALUE_REPLACED,
                f"`{datum.name}` is given a value twice; the last one holds",
                datum.span.start,
                datum.span.end,
                secondary=(problems.label(before.span.start, before.span.end, "first here"),),
                help=("take one of the lines out",),
            )


def _name_written(datum: Datum) -> str:
    """Return the name in full: of names that are the same when cut off, other messages tell."""
    return re.split(r"[^$#\w.]", datum.span.text.lower(), maxsplit=1)[0]
