"""Other values in rows of locations: mistyped, of another unit, taught by the scene."""

import math
from collections.abc import Callable, Iterator, Sequence
from statistics import median

from vrts.base.oat import rotation_from_oat
from vrts.base.pose import IDENTITY_ROTATION, Rotation, rotate, transpose
from vrts.base.units import DEG
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.asked import Asked, components, name_of, names_in, written_number
from vrts.repair.table.numbers import (
    BESIDE,
    FACTORS,
    mistyped,
    value_of,
)
from vrts.repair.written import WrittenRow

Row = Sequence[float]
ASKED = 0.6  # [mm] so near to what geometry asks for an explained value is the one that was meant
MEANT = -0.8  # what it speaks for a value that geometry asks for and a slip explains
ONE_DIGIT = -0.2  # and for a value that differs in one digit
UNEXPLAINED = 0.25  # and against a value that neither a slip nor geometry explains
AS_TAUGHT = 0.6  # what speaks against another value where a row is as the scene says
IN_LINE = -0.3  # what speaks for a location over a thing that it is beside
MEASURED = 0.35  # what a teacher says against another X or Y where it is that of a thing
ASIDE = 100.0  # [mm] so far beside a thing a location may be that was meant to be over it
ABOUT = 300.0  # [mm] so far from a location a thing may be to have to do with it
SQUARE = -0.3  # what speaks for a value with which a way is along an axis
SLIPPED = 3  # values in which a location may differ from what the scene says by a slip
UNROUND = 0.3  # what a teacher says against a number that nobody measures
SAME = 0.02  # [mm], [deg] of two values that differ by less neither is another
POSE = 6
TURNS = (90.0, -90.0, 180.0, -180.0, 10.0, -10.0, 20.0, -20.0, 30.0, -30.0, 45.0, -45.0)
ANGLES = (0.0, 90.0, -90.0, 180.0)
SMALL = 0.1  # of what is usual: a location so near to the robot has another unit
FITS = 0.8  # what speaks for the unit in which it is as far away as the others
UNITS = (25.4, 10.0, 1000.0, 0.1, 1 / 25.4)


def other_rows(asked: Asked) -> Iterator[Candidate]:
    """Yield every row of locations with other values."""
    rows = [row for row in asked.written.rows if is_pose(row)]
    frames = _frames(rows)
    columns = [sorted({round(values_of(row)[n], 2) for row in rows}) for n in range(POSE)]
    for row in rows:
        if asked.matters(row.line):
            yield from _single(asked, row, columns, frames)
            yield from _several(asked, row)


def slipped_rows(asked: Asked) -> frozenset[int]:
    """Return the lines of locations that differ from what the scene says in a few values."""
    found: set[int] = set()
    for row in asked.written.rows:
        taught = asked.taught.get(key(name_of(row.node.target))) if is_pose(row) else None
        if taught is None or not asked.matters(row.line):
            continue
        apart = sum(abs(a - b) > SAME for a, b in zip(values_of(row), taught, strict=True))
        if 0 < apart <= SLIPPED:
            found.add(row.line)
    return frozenset(found)


def as_taught(asked: Asked) -> Iterator[Candidate]:
    """Yield each location that differs from what the scene says by a slip, as the scene says."""
    lines = slipped_rows(asked)
    for row in asked.written.rows:
        if row.line in lines and is_pose(row):
            taught = asked.taught[key(name_of(row.node.target))]
            yield _row(asked, row, taught, Does.ROW, -0.9, priced=1.2)


def values_of(row: WrittenRow) -> tuple[float, ...]:
    """Return the numbers of a row."""
    return tuple(value_of(value) for value in row.node.values if isinstance(value, Number))


def is_pose(row: WrittenRow) -> bool:
    """Return whether a row is of a location by X, Y, Z, O, A, T."""
    return (
        row.kind == "locations"
        and len(row.node.values) == POSE
        and not name_of(row.node.target).startswith("#")
    )


def _frames(rows: Sequence[WrittenRow]) -> list[Rotation]:
    """Return the orientations in which residuals may be asked for: of the world and of rows."""
    found: dict[tuple[float, ...], Rotation] = {IDENTITY_ROTATION: IDENTITY_ROTATION}
    for row in rows:
        turned = transpose(rotation_from_oat(*values_of(row)[3:]))
        found.setdefault(tuple(round(x, 9) for x in turned), turned)
    return list(found.values())


def _single(
    asked: Asked,
    row: WrittenRow,
    columns: Sequence[Sequence[float]],
    frames: Sequence[Rotation],
) -> Iterator[Candidate]:
    """Yield a row with one other value."""
    values = values_of(row)
    taught = asked.taught.get(key(name_of(row.node.target)))
    things = [components(body.X_WO) for body in asked.scene.bodies]
    near = _nearest(asked, values)
    beside = _beside(asked, row)
    as_taught = AS_TAUGHT if is_as_taught(asked, row, row.node.target) else 0.0
    for n, value in enumerate(values):
        others = Others(value)
        add = others.add
        if taught is not None:
            add(-0.9, taught[n])
        for thing in things:
            if _in_line(values, thing, n):
                add(IN_LINE, thing[n])
        for k, other in enumerate(near):
            add(0.15 + 0.1 * k, other[n])
        for each in beside:
            add(SQUARE if _is_square(values, each, n) else 0.05, each[n])
        if n < 3:
            _lengths(asked, n, value, columns[n], frames, add)
        else:
            _angles(value, columns[n], add)
            for X_WT in asked.blame.poses:
                wanted = components(X_WT)
                if all(abs(values[k] - wanted[k]) < 1.0 for k in range(3, POSE) if k != n):
                    add(-0.4, wanted[n])
        meant = MEASURED if any(_is_at(values, thing, n) for thing in things) else 0.0
        item = row.node.values[n]
        for other, unusual in others.found.items():
            doubt = 0.0 if unusual <= MEANT or is_round(other) else UNROUND
            doubt += UNEXPLAINED if unusual > 0.25 else 0.0
            yield asked.instead(
                Does.NUMBER,
                row.line,
                item,
                written_number(other),
                unusual=unusual + 0.5 * as_taught,
                doubt=doubt + max(as_taught, meant),
            )


def _in_line(values: Row, thing: Row, n: int) -> bool:
    """Return whether a location would be over a thing, or in it, but for its X or for its Y."""
    return (
        n < 2
        and abs(values[1 - n] - thing[1 - n]) <= SAME
        and SAME < abs(values[n] - thing[n]) < ASIDE
    )


def _is_at(values: Row, thing: Row, n: int) -> bool:
    """Return whether the X or the Y of a location is that of a thing which is not far from it."""
    return n < 2 and abs(values[n] - thing[n]) <= SAME and math.dist(values[:2], thing[:2]) < ABOUT


def _is_square(values: Row, other: Row, n: int) -> bool:
    """Return whether the way from a location to another is along an axis, but for one value."""
    apart = [k for k in range(3) if abs(values[k] - other[k]) > SAME]
    return len(apart) == 2 and n in apart


def _beside(asked: Asked, row: WrittenRow) -> list[Row]:
    """Return the locations that steps name just before and after one: ways are mostly square."""
    mine = key(name_of(row.node.target))
    known = {key(name_of(each.node.target)): each for each in asked.written.rows if is_pose(each)}
    named = [key(each.text) for step in asked.written.steps for each in names_in(step)]
    named = [name for name in named if name in known]
    beside = {
        named[j]: None
        for k, name in enumerate(named)
        if name == mine
        for j in (k - 1, k + 1)
        if 0 <= j < len(named) and named[j] != mine
    }
    return [values_of(known[name]) for name in beside]


class Others:
    """Other values than one, each with how unusual the mistake would be."""

    def __init__(self, value: float) -> None:
        """Begin with none."""
        self.value = value
        self.found: dict[float, float] = {}

    def add(self, unusual: float, other: float) -> None:
        """Take a value, unless it is the same."""
        other = round(other, 2) + 0.0
        if abs(other - self.value) > SAME:
            self.found[other] = min(unusual, self.found.get(other, unusual))


def _lengths(
    asked: Asked,
    n: int,
    value: float,
    column: Sequence[float],
    frames: Sequence[Rotation],
    add: Callable[[float, float], None],
) -> None:
    slips = {0.08 * k: tidy(value * factor, factor) for k, factor in enumerate(FACTORS)}
    for unusual, other in slips.items():
        add(unusual, other)
    for other in mistyped(value):
        add(0.25, other)
    explained = [*slips.values(), *mistyped(value)]
    for k, frame in enumerate(frames):
        for residual in asked.blame.residuals:
            by = rotate(frame, residual)[n]
            if abs(by) > 0.5:
                _wanted(value, value + by, explained, 0.05 + 0.1 * min(k, 3), add)
    for X_WT in asked.blame.poses:
        _wanted(value, components(X_WT)[n], explained, 0.1, add)
    for other in column:
        add(0.3, other)
        add(0.5, -other)
    for k, by in enumerate(BESIDE):
        add(0.5 + 0.05 * k, value + by)
        add(0.5 + 0.05 * k, value - by)


def tidy(value: float, factor: float = 1.0) -> float:
    """Return the whole number that a value is but for what was rounded before a factor."""
    whole = float(round(value))
    return whole if abs(value - whole) <= 0.006 * max(abs(factor), 1.0) else value


def is_round(value: float) -> bool:
    """Return whether a value is one that people measure: whole millimetres or degrees."""
    return abs(value - round(value)) < 0.01


def _wanted(
    value: float,
    wanted: float,
    explained: Sequence[float],
    unusual: float,
    add: Callable[[float, float], None],
) -> None:
    """Take what geometry asks for: as the value that a slip explains, or as a whole number."""
    near = min(explained, key=lambda other: abs(other - wanted))
    if abs(near - wanted) <= min(ASKED, 0.02 * abs(near)):
        add(MEANT, near)
    elif _one_digit(value, wanted):
        add(unusual + ONE_DIGIT, float(round(wanted)))
    else:
        nearest = float(round(wanted))
        add(unusual, nearest if abs(nearest - wanted) < 0.1 else wanted)


def _one_digit(value: float, wanted: float) -> bool:
    """Return whether two whole numbers differ in one digit."""
    a, b = f"{value:.0f}", f"{wanted:.0f}"
    whole = is_round(value) and abs(wanted - round(wanted)) < ASKED
    return whole and len(a) == len(b) and sum(x != y for x, y in zip(a, b, strict=True)) == 1


def _angles(value: float, column: Sequence[float], add: Callable[[float, float], None]) -> None:
    add(0.1, -value)
    for k, by in enumerate(TURNS):
        add(0.15 + 0.04 * k, value + by)
    for other in (180.0 - value, 90.0 - value):
        add(0.4, other)
    for other in (*column, *ANGLES):
        add(0.2, other)
    for k, factor in enumerate((10.0, 0.1, 180.0 / 3.141592653589793, DEG)):
        add(0.2 + 0.1 * k, value * factor)
    for other in mistyped(value):
        add(0.3, other)


def _several(asked: Asked, row: WrittenRow) -> Iterator[Candidate]:
    """Yield a row with several other values: exchanged, in another unit, moved, as taught."""
    values = values_of(row)
    for first in (0, 3):
        for i in range(first, first + 3):
            for j in range(i + 1, first + 3):
                if abs(values[i] - values[j]) > SAME:
                    other = list(values)
                    other[i], other[j] = other[j], other[i]
                    yield _row(asked, row, other, Does.ORDER, 0.1 - 0.3)
    usual = median(math.hypot(*values_of(each)[:3]) for each in asked.written.rows if is_pose(each))
    small = math.hypot(*values[:3]) < SMALL * usual
    for k, unit in enumerate(UNITS):
        other = [*(tidy(x * unit, unit) for x in values[:3]), *values[3:]]
        fits = small and 0.5 * usual < math.hypot(*other[:3]) < 2.0 * usual
        unusual = 0.1 + 0.1 * k - (FITS if fits else 0.0)
        yield _row(asked, row, other, Does.ROW, unusual, priced=1.6)
    for residual in asked.blame.residuals:
        other = [*(x + d for x, d in zip(values, residual, strict=False)), *values[3:]]
        yield _row(asked, row, other, Does.ROW, 0.3)
    for X_WT in asked.blame.poses:
        yield _row(asked, row, components(X_WT), Does.ROW, 0.4, priced=2)
    name = key(name_of(row.node.target))
    bodies = {body.name: components(body.X_WO) for body in asked.scene.bodies if body.name == name}
    for taught, other in (bodies | asked.taught).items():
        same = taught == name
        yield _row(
            asked,
            row,
            other,
            Does.ROW,
            -0.9 if same else 0.8,
            priced=1.2 if same else None,
        )


def _row(
    asked: Asked,
    row: WrittenRow,
    other: Row,
    does: Does,
    unusual: float,
    priced: float | None = None,
) -> Candidate:
    source = asked.written.source
    values = values_of(row)
    different = [n for n in range(POSE) if abs(values[n] - other[n]) > SAME]
    edits = [
        replacement(
            source, row.node.values[n].start, row.node.values[n].end, written_number(other[n])
        )
        for n in different
    ]
    old = " ".join(asked.text_of(row.node.values[n]) for n in different)
    new = " ".join(written_number(other[n]) for n in different)
    things = [components(body.X_WO) for body in asked.scene.bodies]
    meant = any(_is_at(values, thing, n) for thing in things for n in different)
    return asked.candidate(
        does,
        row.line,
        edits,
        size=len(different),
        unusual=unusual,
        priced=priced,
        old=old,
        new=new,
        doubt=MEASURED if meant else 0.0,
    )


def _nearest(asked: Asked, values: Row) -> list[tuple[float, ...]]:
    """Return the two locations of the scene that differ from a row in the fewest values."""

    def unlike(other: Row) -> int:
        return sum(abs(a - b) > SAME for a, b in zip(values, other, strict=True))

    return sorted(asked.taught.values(), key=unlike)[:2]


def is_as_taught(asked: Asked, row: WrittenRow, name: Name | Element) -> bool:
    """Return whether the scene teaches the values of a row under another name."""
    known = key(name_of(name))
    things = [components(body.X_WO) for body in asked.scene.bodies if body.name == known]
    taught = asked.taught.get(known)
    return any(
        all(abs(a - b) <= SAME for a, b in zip(values_of(row), each, strict=True))
        for each in (*things, *(() if taught is None else (taught,)))
    )
