"""Who moves from one marking of a class to another, as after a task was repaired, and why."""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Literal

from vrts.marking.by_hand.overrides import Override
from vrts.marking.result import Exact, Mark, Named, Record, Result
from vrts.marking.row import Class, Row, final_mark

SCHEMA = "vrts.diff/1"
MOST_REASONS = 8
ROUNDING = "rounding"  # kind of the entry that makes checks add up to the mark: no reason


class Move(Record, frozen=True):
    """A student whose final mark is another one."""

    id: str
    name: str
    old: Mark | None
    new: Mark | None
    by: Exact | None  # null: one of them is no mark
    reasons: tuple[str, ...]

    @property
    def falls(self) -> bool:
        """Whether the new mark is lower."""
        return self.by is not None and Fraction(self.by) < 0

    @property
    def rises(self) -> bool:
        """Whether the new mark is higher."""
        return self.by is not None and Fraction(self.by) > 0


class Diff(Record, frozen=True):
    """What two markings of a class have not in common."""

    schema: Literal["vrts.diff/1"]
    old: str  # title
    new: str
    conditions: tuple[str, ...]  # sentences: what was changed for all
    moves: tuple[Move, ...]  # largest fall first, largest rise last, then where a mark is none
    same: int  # students whose mark is the same
    gone: tuple[str, ...]  # ids that are in the old marking only
    added: tuple[str, ...]


def diff(old: Class, new: Class) -> Diff:
    """Return who moves, and why."""
    before = {row.id: row for row in old.rows}
    after = {row.id: row for row in new.rows}
    common = [(before[name], row) for name, row in after.items() if name in before]
    conditions = tuple(_conditions(common))
    moves = [
        _move(row, now, all_alike=bool(conditions)) for row, now in common if row.final != now.final
    ]
    return Diff(
        "vrts.diff/1",
        old.title,
        new.title,
        conditions,
        tuple(sorted(moves, key=_order)),
        len(common) - len(moves),
        tuple(name for name in before if name not in after),
        tuple(name for name in after if name not in before),
    )


def never_lower(found: Diff, new: Class, who: str, day: str) -> tuple[Override, ...]:
    """Return changes by hand that give everybody who falls the old mark.

    Args:
        found: Who falls.
        new: The new marking, with the changes by hand that there are already.
        who: Decides it.
        day: ISO 8601.
    """
    reason = f"never lowered after marking again by `{found.new}`"
    rows = {row.id: row for row in new.rows}
    return tuple(
        Override(move.id, -Fraction(move.by) + _below_zero(rows[move.id]), None, reason, who, day)
        for move in found.moves
        if move.falls and move.by is not None
    )


def _below_zero(row: Row) -> Fraction:
    """Return by how much changes by hand, which no mark shows, take more than there is."""
    taken = Fraction(0) if row.change is None else Fraction(row.change.delta)
    there = final_mark(row.result.exact_mark, row.late, None, row.result.exact_total) or Fraction(0)
    return max(Fraction(0), -(there + taken))


def _order(move: Move) -> tuple[bool, Fraction, str]:
    return move.by is None, Fraction(move.by or 0), move.id


def _move(old: Row, new: Row, *, all_alike: bool) -> Move:
    a, b = old.exact_final, new.exact_final
    by = None if a is None or b is None else str(b - a)
    reasons = tuple(_reasons(old, new))
    if not reasons:
        reasons = ("as the task has changed",) if all_alike else ("for no reason that is recorded",)
    if len(reasons) > MOST_REASONS:
        rest = len(reasons) - MOST_REASONS + 1
        reasons = (*reasons[: MOST_REASONS - 1], f"and {rest} more")
    return Move(new.id, new.student.name, old.final, new.final, by, reasons)


# why


def _conditions(pairs: Iterable[tuple[Row, Row]]) -> Iterator[str]:
    """Yield what is another one for all: the task, the scene, the version."""
    results = [(old.result, new.result) for old, new in pairs]
    yield from _changed("task", [(a.task, b.task) for a, b in results])
    yield from _changed("scene", [(a.scene, b.scene) for a, b in results])
    versions = [(a.versions, b.versions) for a, b in results]
    for what, values in (
        ("vrts", [(a.vrts, b.vrts) for a, b in versions]),
        ("version of the scoring", [(str(a.scoring), str(b.scoring)) for a, b in versions]),
        ("what measures distances", [(a.engine, b.engine) for a, b in versions]),
    ):
        changes = dict.fromkeys((a, b) for a, b in values if a and b and a != b)
        yield from (f"{what}: {a} → {b}" for a, b in changes)


def _changed(what: str, pairs: Sequence[tuple[Named, Named]]) -> Iterator[str]:
    changed = [(a, b) for a, b in pairs if a.sha256 != b.sha256]
    if changed:
        some = "" if len(changed) == len(pairs) else f" for {len(changed)} of {len(pairs)} students"
        yield f"the {what} has changed{some}: {_named(*changed[0])}"


def _named(a: Named, b: Named) -> str:
    if a.name != b.name:
        return f"`{a.name}` → `{b.name}`"
    return f"`{a.name}` {a.sha256[:8]} → {b.sha256[:8]}"


def _reasons(old: Row, new: Row) -> Iterator[str]:
    """Yield why a mark is another one, weightiest first."""
    a, b = old.result, new.result
    yield from _program(a, b)
    if a.kind is not b.kind:
        yield f"{a.kind.value} → {b.kind.value}: {b.cause}"
    checks = tuple(_checks(a, b))
    yield from checks
    if not checks:
        yield from _losses(a, b)
    late = [Fraction(0) if row.late is None else Fraction(row.late.deduction) for row in (old, new)]
    if late[0] != late[1]:
        yield f"for lateness {points(-late[0])} → {points(-late[1])}"
    change = [
        Fraction(0) if row.change is None else Fraction(row.change.delta) for row in (old, new)
    ]
    if change[0] != change[1]:
        yield f"by hand {points(change[0])} → {points(change[1])}"


def _program(a: Result, b: Result) -> Iterator[str]:
    digests = [None if r.program is None else r.program.sha256 for r in (a, b)]
    if digests[0] != digests[1]:
        yield "another program was marked"


def _checks(a: Result, b: Result) -> Iterator[str]:
    before, after = (
        {check.id: check for check in r.checks if check.kind != ROUNDING} for r in (a, b)
    )
    for name in {**before, **after}:
        old, new = before.get(name), after.get(name)
        if old is None and new is not None:
            yield f"new: {new.title}, {new.answer}, {new.points:.4g} points"
        elif new is None and old is not None:
            yield f"not asked any more: {old.title}, {old.points:.4g} points"
        elif old is not None and new is not None:
            if (old.answer, old.points) == (new.answer, new.points):
                continue
            words = new.answer if old.answer == new.answer else f"{old.answer} → {new.answer}"
            yield f"{new.title}: {words}, {old.points:.4g} → {new.points:.4g} points"


def _losses(a: Result, b: Result) -> Iterator[str]:
    before = [(loss.sentence, loss.points_exact) for loss in a.losses]
    after = [(loss.sentence, loss.points_exact) for loss in b.losses]
    for sentence, lost in after:
        if (sentence, lost) not in before:
            yield f"now lost: {points(-abs(Fraction(lost)))}, {sentence}"
    for sentence, lost in before:
        if (sentence, lost) not in after:
            yield f"no longer lost: {points(abs(Fraction(lost)))}, {sentence}"


def points(number: Fraction) -> str:
    """Return points with their sign, rounded for reading."""
    return f"{float(number):+.2f}".rstrip("0").rstrip(".") if number else "0"
