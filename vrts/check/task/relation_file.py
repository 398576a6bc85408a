"""Reads `[[relation]]` of a task: how an object is to end beside, on or in something."""

from collections.abc import Sequence
from fractions import Fraction

from vrts.base.diagnostic import Rule
from vrts.base.pose import Vector
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import DEG, MM
from vrts.check.task.goal_file import FARTHEST, ORIENTATION_DEG, POSITION_MM, WIDEST_DEG, carried
from vrts.check.task.goals import Relation, Stands
from vrts.scene.model import Scene

RELATION = Rule("V657", "relation")

BY_MM = 1.0  # when the file does not say how far
BESIDE = (Stands.LEFT, Stands.RIGHT, Stands.FARTHER, Stands.NEARER)
TO_ANOTHER = (*BESIDE, Stands.ON, Stands.ALIGNED)
KEYS = (*(stands.value for stands in TO_ANOTHER), "from_mm")
WORDS = {
    Stands.LEFT: "left of",
    Stands.RIGHT: "right of",
    Stands.FARTHER: "farther than",
    Stands.NEARER: "nearer than",
    Stands.ON: "stacked on",
    Stands.ALIGNED: "aligned with",
}


def read_relations(top: Table, problems: Problems, scene: Scene) -> tuple[Relation, ...]:
    """Return every relation of a task; what is wrong goes to `problems`."""
    found: list[Relation] = []
    for table in top.tables("relation"):
        relation = _relation(table, problems, scene)
        if relation is None:
            continue
        if any(other.title == relation.title for other in found):
            problems.error(
                RELATION,
                f"two relations are called `{relation.title}`",
                table.span,
                help=("delete one of the two, or give them titles",),
            )
        found.append(relation)
    _contradictions(found, problems)
    return tuple(found)


def _relation(table: Table, problems: Problems, scene: Scene) -> Relation | None:
    everything = [body.name for body in scene.bodies]
    name = table.string("object", choices=everything, required=True)
    others = {stands: table.string(stands.value, choices=everything) for stands in TO_ANOTHER}
    by = table.number("by_mm", BY_MM, minimum=0.0, maximum=FARTHEST)
    along = table.string("along", choices=("x", "y"))
    tolerance = table.number("position_mm", above=0.0, maximum=FARTHEST)
    turn = table.number("orientation_deg", ORIENTATION_DEG, above=0.0, maximum=WIDEST_DEG)
    low = table.numbers("from_mm", count=3, minimum=-FARTHEST, maximum=FARTHEST)
    high = table.numbers("to_mm", count=3, minimum=-FARTHEST, maximum=FARTHEST)
    weight = table.fraction("weight", Fraction(1), minimum=0.001)
    title = table.string("title")
    before = len(problems.found)
    table.finish()
    given = [key for key in KEYS if key in table]
    if len(given) != 1:
        headline = f"{table.title} needs exactly one of {', '.join(KEYS)}"
        problems.error(RELATION, headline, table.span)
    stands = next((s for s in TO_ANOTHER if s.value in table), Stands.INSIDE)
    if len(given) == 1:
        _check_keys(table, problems, stands)
    if name is None or len(problems.found) > before:
        return None
    if not carried(table, problems, scene, (name,)):
        return None
    if stands is Stands.INSIDE:
        box = _box(table, problems, low, high)
        words = title or f"{name} inside"
        if box is None:
            return None
        slack = None if tolerance is None else tolerance * MM
        return Relation(
            name, stands, "", weight, words, table.span, 0.0, slack, lower=box[0], upper=box[1]
        )
    other = others[stands]
    if other is None:
        return None
    if other == name:
        headline = f"`{name}` cannot be {WORDS[stands]} itself"
        problems.error(RELATION, headline, table.value_span(stands.value))
        return None
    if stands is Stands.ALIGNED and tolerance is None:
        tolerance = POSITION_MM
    return Relation(
        name,
        stands,
        other,
        weight,
        title or f"{name} {WORDS[stands]} {other}",
        table.span,
        by * MM if stands in BESIDE else 0.0,
        None if tolerance is None else tolerance * MM,
        turn * DEG,
        along or "",
    )


def _check_keys(table: Table, problems: Problems, stands: Stands) -> None:
    """Report keys that say nothing about a relation, and one that it needs."""
    meant = {
        "by_mm": stands in BESIDE,
        "along": stands is Stands.ALIGNED,
        "orientation_deg": stands is Stands.ALIGNED,
        "to_mm": stands is Stands.INSIDE,
    }
    for key, here in meant.items():
        if key in table and not here:
            what = "a box" if stands is Stands.INSIDE else f"`{stands.value}`"
            problems.error(RELATION, f"`{key}` says nothing about {what}", table.span_of(key))
    if stands is Stands.ALIGNED and "along" not in table:
        problems.error(
            RELATION,
            "in which direction the row goes is not said",
            table.span,
            help=('add `along = "x"` for a row away from the robot, `along = "y"` for one across',),
        )


def _box(
    table: Table,
    problems: Problems,
    low: tuple[float, ...] | None,
    high: tuple[float, ...] | None,
) -> tuple[Vector, Vector] | None:
    if low is None or high is None:
        if low is not None and "to_mm" not in table:
            problems.error(RELATION, "the box has one corner", table.span, help=("add `to_mm`",))
        return None
    if any(a >= b for a, b in zip(low, high, strict=True)):
        problems.error(
            RELATION,
            "the box is empty",
            table.value_span("to_mm"),
            help=("every number of `to_mm` must be more than that of `from_mm`",),
        )
        return None
    (a, b, c), (d, e, f) = low, high
    return (a * MM, b * MM, c * MM), (d * MM, e * MM, f * MM)


def _contradictions(relations: Sequence[Relation], problems: Problems) -> None:
    """Report relations that would need an object to be beside itself, or to stand on itself."""
    rows = (
        ({Stands.LEFT: False, Stands.RIGHT: True}, "left of"),
        ({Stands.FARTHER: False, Stands.NEARER: True}, "farther than"),
        ({Stands.ON: False}, "stacked on"),
    )
    for kinds, words in rows:
        after: dict[str, set[str]] = {}
        for relation in relations:
            if relation.stands not in kinds:
                continue
            ends = (relation.body, relation.other)
            first, second = reversed(ends) if kinds[relation.stands] else ends
            if _leads(after, second, first) and relation.span is not None:
                problems.error(
                    RELATION,
                    f"`{first}` would have to be {words} itself",
                    relation.span,
                    "by this relation and those before it",
                )
                return
            after.setdefault(first, set()).add(second)


def _leads(after: dict[str, set[str]], start: str, end: str) -> bool:
    pending, seen = [start], {start}
    while pending:
        name = pending.pop()
        if name == end:
            return True
        new = after.get(name, set()) - seen
        seen |= new
        pending += sorted(new)
    return False
