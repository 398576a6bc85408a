"""Rows that a program names and does not have, as the scene or geometry says."""

from collections.abc import Iterator

from vrts.base.pose import IDENTITY_ROTATION, Pose
from vrts.lang.names import key
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.table.asked import Asked, components, name_of, names_in, written_number
from vrts.repair.table.rows import POSE, Row, values_of


def untaught(asked: Asked) -> Iterator[Candidate]:
    """Yield rows that the program names and does not have, as the scene says."""
    written = asked.written
    used = {key(part.text) for step in written.steps for part in names_in(step)}
    source = written.source
    for name in sorted(used - asked.defined):
        if name in asked.arrays:
            continue
        taught = asked.taught.get(name)
        given = [(0.0, taught)] if taught is not None else _guessed(asked, name)
        for unusual, values in given:
            numbers = " ".join(f"{written_number(x):>9}" for x in values)
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
                unusual=unusual,
                new=line.strip(),
            )


def _guessed(asked: Asked, name: str) -> Iterator[tuple[float, Row]]:
    """Yield where a location may be that nobody taught: of things, of goals, beside its neighbours.

    A way that goes round something mostly changes one of X, Y and Z at a time.
    """
    for body in asked.scene.bodies:
        if body.name == name:
            yield 0.0, components(body.X_WO)
    for goal in asked.task.goals:
        for choice in goal.choices:
            yield 0.4, components(choice.X_WG)
    known = {key(name_of(row.node.target)): values_of(row) for row in asked.written.rows}
    named = [key(each.text) for step in asked.written.steps for each in names_in(step)]
    k = named.index(name) if name in named else 0
    before = next((known[n] for n in reversed(named[:k]) if n in known), None)
    after = next((known[n] for n in named[k + 1 :] if n in known), None)
    if before is None or after is None or len(before) < POSE or len(after) < POSE:
        return
    for via in asked.task.vias:
        place = components(Pose(IDENTITY_ROTATION, via.point))
        yield 0.3, (*place[:3], *after[3:])
    for x, y, z in ((1, 0, 1), (0, 1, 0), (1, 0, 0), (0, 1, 1), (0, 0, 1), (1, 1, 0)):
        mixed = [(before, after)[way][n] for n, way in enumerate((x, y, z))]
        yield 0.35, (*mixed, *after[3:])
