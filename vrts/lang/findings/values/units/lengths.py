"""Lengths that look like metres or inches, and locations whose hand points up: data and TRANS."""

import math
from collections.abc import Sequence

from vrts.base.diagnostic import Rule
from vrts.base.pose import Pose
from vrts.base.source import Span
from vrts.ir.module import Datum
from vrts.lang.dialect import Angles
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.findings.values.units.reach import (
    FARTHEST,
    check_trans_reach,
    warn_of_reach,
)
from vrts.lang.joined import Joined
from vrts.lang.meaning.constants import constant
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Application, Element, Item, Name, Number
from vrts.lang.syntax.statements import SetLocation, Simple, SpeedStatement

LENGTH_UNIT = Rule("V235", "length-unit")
HAND_UP = Rule("V236", "missing-angles")

METRES = 2.0  # [mm] a location whose coordinates are all below is taken for one in metres
TOO_NEAR = 60.0  # [mm] no arm reaches so near its middle: taken for inches
ONE_PERCENT = 1.0  # [%] a speed below is hardly meant, unless others are given in percent
SMALL = 0.5  # [mm, %] distances and speeds below are hardly meant; half of one now and then is
TINY = 0.004  # [mm] offsets up to this are no metres either: nobody moves by so few millimetres
_GOALS = frozenset({"MOVE", "MOVES", "APPRO", "APPROS"})
_DISTANCE = {"APPRO": 1, "APPROS": 1, "DEPART": 0, "DEPARTS": 0}
MOTIONS = _GOALS | _DISTANCE.keys() | {"DRAW"}
_COORDINATES = 3
_ALL_BUT_ONE = 5  # values of TRANS
_WITHOUT_ANGLES = 4  # words of a line of data: a name and three numbers


def goals(types: NameUses) -> frozenset[str]:
    """Return the locations that programs go to as they are, never as a part of a compound."""
    found: set[str] = set()
    for asked in types.asked:
        node = asked.node
        if isinstance(node, Simple) and node.word in _GOALS:
            name = node.operands[0] if node.operands else None
            name = name.name if isinstance(name, Element) else name
            if isinstance(name, Name):
                found.add(key(name.text))
    return frozenset(found - types.parts)


def check_lengths(types: NameUses, asked: Asked, absolute: frozenset[str]) -> None:
    """Warn of distances, speeds and TRANS that look like metres."""
    node = asked.node
    if isinstance(node, Simple) and node.word in _DISTANCE:
        at = _DISTANCE[node.word]
        operand = node.operands[at] if len(node.operands) > at else None
        if operand is not None and asked.program is not None:
            _distance(types, asked.program, node.word, operand)
    elif isinstance(node, SpeedStatement) and node.word == "SPEED":
        _speed(types, asked.program, node)
    elif isinstance(node, SetLocation):
        target = node.target if isinstance(node.target, Name) else node.target.name
        if key(target.text) in absolute:
            _trans(types, node.value)
            if not types.problems.dialect.tolerant:
                check_trans_reach(types, node.value)
    if isinstance(node, Simple) and node.word in _GOALS and node.operands:
        _trans(types, node.operands[0])
        if not types.problems.dialect.tolerant:
            check_trans_reach(types, node.operands[0])
    if isinstance(node, Application) and node.name.text.lower() == "trans":
        _five(types, node)
    if isinstance(node, Application) and node.name.text.lower() == "shift":
        _offsets(types, asked.program, "SHIFT", node.arguments[1:])
    if isinstance(node, Simple) and node.word == "DRAW":
        _offsets(types, asked.program, "DRAW", node.operands)


def check_data(types: NameUses, data: list[Datum], absolute: frozenset[str]) -> None:
    """Warn of locations in data sections that look like metres or inches, or that point up."""
    if types.problems.dialect.tolerant:
        return  # robots of other makers have their middle elsewhere
    for datum in data:
        if not isinstance(datum.value, Pose) or datum.name not in absolute:
            continue
        x, y, z = (1000.0 * c for c in datum.value.translation)  # [mm]
        largest = max(abs(x), abs(y), abs(z))
        words = datum.span.text.replace(",", " ").replace("=", " ").split()
        if 0.0 < largest < METRES:
            _data(types, datum, "metres", 1000.0, f"{math.hypot(x, y, z):.3g} mm")
        elif 0.0 < math.hypot(x, y, z) < TOO_NEAR:
            _data(types, datum, "inches", 25.4, f"{math.hypot(x, y, z):.0f} mm")
        elif math.hypot(x, y, z) > FARTHEST:
            start = offset_of(types, datum.span)
            end = start + len(datum.span.text)
            warn_of_reach(types, f"`{datum.name}`", start, end, math.hypot(x, y, z))
        elif len(words) == _WITHOUT_ANGLES:
            _points_up(types, datum)


def _data(types: NameUses, datum: Datum, unit: str, factor: float, shown: str) -> None:
    problems = types.problems
    start = offset_of(types, datum.span)
    end = start + len(datum.span.text)
    problems.warning(
        LENGTH_UNIT,
        f"`{datum.name}` looks like {unit}: lengths are in millimetres",
        start,
        end,
        f"{shown} from the middle of the robot, too close for the arm",
        help=(f"multiply X, Y and Z by {factor:g}: write them in mm",),
        data={"name": datum.name},
    )


def _points_up(types: NameUses, datum: Datum) -> None:
    start = offset_of(types, datum.span)
    end = start + len(datum.span.text)
    types.problems.warning(
        HAND_UP,
        f"`{datum.name}` has no angles: the hand points up",
        start,
        end,
        notes=("three values are a position that is not turned: O 90, A -90, T 0",),
        help=("write all six, `X Y Z O A T`; with the angles 90 90 0 the hand points down",),
        data={"name": datum.name},
    )


def offset_of(types: NameUses, span: Span) -> int:
    """Return where a span begins in what is compiled, which may be several files."""
    source = types.problems.source
    base = 0
    if isinstance(source, Joined):
        base = source.starts[source.files.index(span.source)]
    return base + span.start


def _distance(types: NameUses, program: str, word: str, operand: Item) -> None:
    if isinstance(operand, Number) and operand.value >= SMALL:
        return
    distance = constant(types.scope, program, operand)
    if distance is None or not 0.0 < distance < SMALL:
        return
    types.problems.warning(
        LENGTH_UNIT,
        f"{word} by {distance:g} mm looks like metres: lengths are in millimetres",
        operand.start,
        operand.end,
        "a fraction of a millimetre",
        help=(f"write `{1000.0 * distance:g}`",),
        data={"distance_mm": distance},
    )


def _offsets(
    types: NameUses, program: str | None, word: str, offsets: Sequence[Item | None]
) -> None:
    """`SHIFT(part BY 0, 0, 0.05)`: all of them are fractions of a millimetre."""
    if program is None or types.problems.dialect.tolerant:
        return
    given = [offset for offset in offsets if offset is not None]
    values = [constant(types.scope, program, offset) for offset in given]
    sizes = [abs(value) for value in values if value is not None]
    if len(sizes) < len(given) or not TINY < max(sizes, default=0.0) < SMALL:
        return
    written = ", ".join(f"{1000.0 * value:g}" for value in values if value is not None)
    types.problems.warning(
        LENGTH_UNIT,
        f"{word} by {max(sizes):g} mm looks like metres: lengths are in millimetres",
        given[0].start,
        given[-1].end,
        "fractions of a millimetre",
        help=(f"write `{written}`",),
    )


def _speed(types: NameUses, program: str | None, node: SpeedStatement) -> None:
    level = node.levels[0]
    if program is None or any(other.unit for other in node.levels):
        return
    low = _percent(types, program, level.value)
    if low is None or not 0.0 < low < ONE_PERCENT:
        return
    if low >= SMALL and _knows_percent(types, program):
        return
    types.problems.warning(
        LENGTH_UNIT,
        f"SPEED {low:g} is a fraction of one percent",
        level.value.start,
        level.value.end,
        "in percent of the full speed",
        help=(
            f"write `SPEED {100.0 * low:g}` for {100.0 * low:g} percent",
            f"or `SPEED {1000.0 * low:g} MMPS` for {low:g} metres a second",
        ),
    )


def _percent(types: NameUses, program: str, node: Item) -> float | None:
    low, high = evaluate(node, nothing_known)
    return low if low == high else constant(types.scope, program, node)


def _knows_percent(types: NameUses, program: str) -> bool:
    """Return whether a program sets another speed in percent: then half of one is meant, too."""
    for asked in types.asked:
        node = asked.node
        if asked.program == program and isinstance(node, SpeedStatement) and node.word == "SPEED":
            value = _percent(types, program, node.levels[0].value)
            if node.levels[0].unit is None and value is not None and value >= ONE_PERCENT:
                return True
    return False


def _trans(types: NameUses, node: Item | None) -> None:
    if not isinstance(node, Application) or node.name.text.lower() != "trans":
        return
    given = node.arguments[:_COORDINATES]
    if len(given) < _COORDINATES or any(a is None for a in given):
        return
    values = [evaluate(argument, nothing_known) for argument in given]
    sizes = [abs(low) for low, high in values if low == high]
    broken = sum(size != round(size) for size in sizes)
    if len(sizes) < _COORDINATES or not 0.0 < max(sizes) < METRES or broken < 2:
        return
    first, last = given[0], given[-1]
    assert first is not None
    assert last is not None
    types.problems.warning(
        LENGTH_UNIT,
        "this TRANS looks like metres: lengths are in millimetres",
        first.start,
        last.end,
        "inside the robot",
        help=(f"write millimetres: `{', '.join(f'{1000.0 * low:g}' for low, _ in values)}`",),
    )


def _five(types: NameUses, node: Application) -> None:
    """`TRANS(x, y, z, o, a)`: the last angle is 0, which is hardly meant."""
    given = node.arguments
    if types.problems.dialect.angles is not Angles.OAT or types.problems.dialect.tolerant:
        return
    if len(given) != _ALL_BUT_ONE or any(argument is None for argument in given):
        return
    types.problems.warning(
        HAND_UP,
        "TRANS with five values: the sixth is 0",
        node.start,
        node.end,
        notes=("a location is X Y Z in mm and O A T in degrees",),
        help=("write all six: `TRANS(x, y, z, o, a, t)`",),
    )
