"""Other values in rows of locations: mistyped, of another unit, taught by the scene."""

from collections.abc import Callable, Iterator, Sequence

from vrts.base.oat import rotation_from_oat
from vrts.base.pose import IDENTITY_ROTATION, Rotation, rotate, transpose
from vrts.base.units import DEG
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name, Number
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.asked import Asked, components, name_of, names_in, written_number
from vrts.repair.table.numbers import BESIDE, FACTORS, mistyped, value_of
from vrts.repair.written import WrittenRow

Row = Sequence[float]
SAME = 0.02  # [mm], [deg] of two values that differ by less neither is another
POSE = 6
TURNS = (90.0, -90.0, 180.0, -180.0, 10.0, -10.0, 20.0, -20.0, 30.0, -30.0, 45.0, -45.0)
ANGLES = (0.0, 90.0, -90.0, 180.0)
UNITS = (25.4, 10.0, 1000.0, 0.1, 1 / 25.4)


def other_rows(asked: Asked) -> Iterator[Candidate]:
    """Yield every row of locations with other values."""
    rows = [row for row in asked.written.rows if _is_pose(row)]
    frames = _frames(rows)
    columns = [sorted({round(values_of(row)[n], 2) for row in rows}) for n in range(POSE)]
    for row in rows:
        if asked.matters(row.line):
            yield from _single(asked, row, columns, frames)
            yield from _several(asked, row)
    yield from _exchanged(asked, rows)
    yield from _all_rows(asked, rows)
    yield from _missing(asked)


def values_of(row: WrittenRow) -> tuple[float, ...]:
    """Return the numbers of a row."""
    return tuple(value_of(value) for value in row.node.values if isinstance(value, Number))


def _is_pose(row: WrittenRow) -> bool:
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
    near = _nearest(asked, values)
    for n, value in enumerate(values):
        others = Others(value)
        add = others.add
        if taught is not None:
            add(-0.9, taught[n])
        for k, other in enumerate(near):
            add(0.15 + 0.1 * k, other[n])
        if n < 3:
            _lengths(asked, n, value, columns[n], frames, add)
        else:
            _angles(value, columns[n], add)
        item = row.node.values[n]
        for other, unusual in others.found.items():
            yield asked.instead(Does.NUMBER, row.line, item, written_number(other), unusual=unusual)


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
    for k, factor in enumerate(FACTORS):
        add(0.08 * k, value * factor)
    for other in mistyped(value):
        add(0.25, other)
    for k, frame in enumerate(frames):
        for residual in asked.blame.residuals:
            by = rotate(frame, residual)[n]
            if abs(by) > 0.5:
                add(0.05 + 0.1 * min(k, 3), value + by)
    for X_WT in asked.blame.poses:
        add(0.1, components(X_WT)[n])
    for other in column:
        add(0.3, other)
        add(0.5, -other)
    for k, by in enumerate(BESIDE):
        add(0.5 + 0.05 * k, value + by)
        add(0.5 + 0.05 * k, value - by)


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
    for k, unit in enumerate(UNITS):
        other = [*(x * unit for x in values[:3]), *values[3:]]
        yield _row(asked, row, other, Does.ROW, 0.1 + 0.1 * k, priced=1.6)
    for residual in asked.blame.residuals:
        other = [*(x + d for x, d in zip(values, residual, strict=False)), *values[3:]]
        yield _row(asked, row, other, Does.ROW, 0.3)
    for X_WT in asked.blame.poses:
        yield _row(asked, row, components(X_WT), Does.ROW, 0.4, priced=2)
    name = key(name_of(row.node.target))
    for taught, other in asked.taught.items():
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
    return asked.candidate(
        does, row.line, edits, size=len(different), unusual=unusual, priced=priced, old=old, new=new
    )


def _nearest(asked: Asked, values: Row) -> list[tuple[float, ...]]:
    """Return the two locations of the scene that differ from a row in the fewest values."""

    def unlike(other: Row) -> int:
        return sum(abs(a - b) > SAME for a, b in zip(values, other, strict=True))

    return sorted(asked.taught.values(), key=unlike)[:2]


def _exchanged(asked: Asked, rows: Sequence[WrittenRow]) -> Iterator[Candidate]:
    """Yield two rows with their names exchanged."""
    source = asked.written.source
    for k, one in enumerate(rows):
        for other in rows[k + 1 :]:
            if not (asked.matters(one.line) or asked.matters(other.line)):
                continue
            a, b = one.node.target, other.node.target
            edits = (
                replacement(source, a.start, a.end, asked.text_of(b)),
                replacement(source, b.start, b.end, asked.text_of(a)),
            )
            line = min(one.line, other.line, key=asked.against)
            right = _as_taught(asked, one, b) and _as_taught(asked, other, a)
            yield asked.candidate(
                Does.ORDER,
                line,
                edits,
                size=2,
                unusual=-0.9 if right else 0.4,
                old=f"{asked.text_of(a)} {asked.text_of(b)}",
                new=f"{asked.text_of(b)} {asked.text_of(a)}",
            )


def _as_taught(asked: Asked, row: WrittenRow, name: Name | Element) -> bool:
    """Return whether the scene teaches the values of a row under another name."""
    taught = asked.taught.get(key(name_of(name)))
    return taught is not None and all(
        abs(a - b) <= SAME for a, b in zip(values_of(row), taught, strict=True)
    )


def _all_rows(asked: Asked, rows: Sequence[WrittenRow]) -> Iterator[Candidate]:
    """Yield the whole table in another unit, or with two columns exchanged: one mistake."""
    if len(rows) < 2:
        return
    source = asked.written.source
    line = min((row.line for row in rows), key=asked.against)

    def together(others: Sequence[Row], unusual: float, old: str, new: str) -> Candidate:
        edits = [
            replacement(source, value.start, value.end, written_number(x))
            for row, other in zip(rows, others, strict=True)
            for value, before, x in zip(row.node.values, values_of(row), other, strict=True)
            if abs(before - x) > SAME
        ]
        return asked.candidate(
            Does.ROW,
            line,
            edits,
            size=len(edits),
            priced=1.8,
            unusual=unusual,
            old=old,
            new=new,
        )

    for unit in UNITS:
        others = [[*(x * unit for x in values_of(row)[:3]), *values_of(row)[3:]] for row in rows]
        yield together(others, 0.3, "every row", f"every row, times {unit:g}")
    for i, j in ((0, 1), (1, 2), (0, 2), (3, 4), (4, 5), (3, 5)):
        others = [list(values_of(row)) for row in rows]
        for each in others:
            each[i], each[j] = each[j], each[i]
        said = f"every row, {'XYZOAT'[i]} and {'XYZOAT'[j]} exchanged"
        yield together(others, 0.4, "every row", said)
    taught = [asked.taught.get(key(name_of(row.node.target))) for row in rows]
    if any(taught):
        others = [t or values_of(row) for t, row in zip(taught, rows, strict=True)]
        yield together(others, 0.9, "every row", "every row as the scene says")


def _missing(asked: Asked) -> Iterator[Candidate]:
    """Yield rows that the program names and does not have, as the scene says."""
    written = asked.written
    used = {key(part.text) for step in written.steps for part in names_in(step)}
    source = written.source
    for name in sorted(used - asked.defined):
        taught = asked.taught.get(name)
        if taught is None:
            continue
        numbers = " ".join(f"{written_number(x):>9}" for x in taught)
        line = f"{name:<13}{numbers}\n"
        lines = sorted(written.data_lines)
        if lines:
            at = written.line_start(lines[0] + 1)
            text = line
        else:
            at = len(written.text)
            ended = "" if written.text.endswith("\n") else "\n"
            text = f"{ended}.LOCATIONS\n{line}.END\n"
        where = lines[0] + 1 if lines else len(source.line_starts)
        yield asked.candidate(
            Does.ROW,
            where,
            (replacement(source, at, at, text),),
            size=7,
            priced=1,
            against=0.0,
            new=line.strip(),
        )
