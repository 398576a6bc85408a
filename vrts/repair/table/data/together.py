"""Rows of locations exchanged, and a whole table of them with other values: one mistake."""

from collections.abc import Iterator, Sequence

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Name
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.asked import Asked, name_of, written_number
from vrts.repair.table.numbers import AWAY, numbers_of, value_of, word_of
from vrts.repair.table.rows import SAME, UNITS, Row, is_as_taught, is_pose, tidy, values_of
from vrts.repair.written import WrittenRow


def rows_together(asked: Asked) -> Iterator[Candidate]:
    """Yield two rows exchanged, and all rows with other values."""
    rows = [row for row in asked.written.rows if is_pose(row)]
    yield from _exchanged(asked, rows)
    yield from _all_rows(asked, rows)


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
            right = _is_right(asked, one, b) and _is_right(asked, other, a)
            right = right and (is_as_taught(asked, one, b) or is_as_taught(asked, other, a))
            yield asked.candidate(
                Does.ORDER,
                line,
                edits,
                size=2,
                unusual=-0.9 if right else 0.4,
                old=f"{asked.text_of(a)} {asked.text_of(b)}",
                new=f"{asked.text_of(b)} {asked.text_of(a)}",
            )


def _is_right(asked: Asked, row: WrittenRow, name: Name | Element) -> bool:
    """Return whether the values of a row may be those of a name: the scene says no others."""
    known = key(name_of(name))
    said = known in asked.taught or any(body.name == known for body in asked.scene.bodies)
    return not said or is_as_taught(asked, row, name)


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
        others = [
            [*(tidy(x * unit, unit) for x in values_of(row)[:3]), *values_of(row)[3:]]
            for row in rows
        ]
        whole = together(others, 0.0, "every row", f"times {unit:g}")
        yield whole
        yield _with_steps(asked, whole, unit)
    for i, j in ((0, 1), (1, 2), (0, 2), (3, 4), (4, 5), (3, 5)):
        others = [list(values_of(row)) for row in rows]
        for each in others:
            each[i], each[j] = each[j], each[i]
        said = f"{'XYZOAT'[i]} and {'XYZOAT'[j]} exchanged"
        yield together(others, -0.1, "every row", said)
    taught = [asked.taught.get(key(name_of(row.node.target))) for row in rows]
    if any(taught):
        others = [t or values_of(row) for t, row in zip(taught, rows, strict=True)]
        yield together(others, 0.9, "every row", "as the scene says")


def _with_steps(asked: Asked, whole: Candidate, unit: float) -> Candidate:
    """Return the table in another unit, with the distances of the steps in that unit, too."""
    source = asked.written.source
    distances = [
        replacement(source, item.start, item.end, written_number(tidy(value_of(item) * unit, unit)))
        for step in asked.written.steps
        if word_of(step.statement) in AWAY
        for item, _ in numbers_of(step.statement)
    ]
    edits = (*whole.change.edits, *distances)
    new = f"times {unit:g}, and so every distance"
    change = whole.change._replace(edits=edits, size=len(edits), new=new)
    return whole._replace(cost=whole.cost + 0.1, change=change)
