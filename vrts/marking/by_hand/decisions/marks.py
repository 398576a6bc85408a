"""What graders decide about one mark: points add up; marks and excuses take the place of it.

In one file a mark or an excuse takes the place of what stood before it, and points behind it are
added to it. Between files points add up as well. A mark beside points or items of another grader is
a conflict; so are marks that differ, a mark and an excuse, and other points for the same reason.
"""

from collections import defaultdict
from collections.abc import Collection, Hashable, Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.check.task.score import in_tenths
from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import ChangeMark, Decision, Excuse, Give
from vrts.marking.by_hand.decisions.settled import Side, settled_sides

Groups = tuple[tuple[Filed, ...], ...]


class MarkNow(NamedTuple):
    """What is decided about the mark of a student."""

    mark: tuple[Filed, ...] = ()  # changes or excuses that count
    changes: Groups = ()  # the same changes: those in a group say the same, and count once
    given: tuple[Filed, ...] = ()  # items that count, but for those that are withdrawn
    later: frozenset[str] = frozenset()  # names of gives behind the mark that counts
    conflicts: tuple[tuple[str, tuple[Filed, ...]], ...] = ()  # about what, and all sides


class _Mine(NamedTuple):
    """What one grader says."""

    base: Filed | None  # the last mark or excuse
    points: Side  # behind it
    given: Side  # behind it
    before: Side  # items before it

    @property
    def sets(self) -> bool:
        return self.base is not None and isinstance(self.base.said, ChangeMark)

    @property
    def excuses(self) -> bool:
        return self.base is not None and isinstance(self.base.said, Excuse)


def mark_of(
    student: str,
    records: Iterable[Filed],
    lapsed: Collection[str],
    items: Collection[str],
    decides: Sequence[Filed],
) -> MarkNow:
    """Return what is decided about a mark.

    Args:
        student: Id.
        records: Of all graders that change the mark, excuse, or give items.
        lapsed: Names of those that are about another program.
        items: Ids of those that change marks now.
        decides: Of all graders.
    """
    by_grader: dict[str, list[Filed]] = defaultdict(list)
    for one in records:
        by_grader[one.grader].append(one)
    every = [_mine(by_grader[name], lapsed) for name in sorted(by_grader)]
    given = tuple(one for mine in every for one in (*mine.before, *mine.given))
    based = [mine for mine in every if mine.base is not None]
    if not any(mine.sets for mine in based):
        excuses = tuple(mine.base for mine in based if mine.base is not None)
        if excuses:
            return MarkNow(excuses, given=given)
        return _added(student, [mine.points for mine in every], decides)._replace(given=given)
    return _with_marks(student, every, given, items, decides)


def _mine(records: Sequence[Filed], lapsed: Collection[str]) -> _Mine:
    ordered = sorted(records, key=lambda one: one.said.number)
    bases = [one for one in ordered if is_base(one.said)]
    base = bases[-1] if bases else None
    from_here = 0 if base is None else base.said.number
    held = [one for one in ordered if one.name not in lapsed]
    behind = [one for one in held if one.said.number > from_here]
    return _Mine(
        None if base is None or base.name in lapsed else base,
        tuple(one for one in behind if isinstance(one.said, ChangeMark)),
        tuple(one for one in behind if isinstance(one.said, Give)),
        tuple(o for o in held if o.said.number < from_here and isinstance(o.said, Give)),
    )


def is_base(said: Decision) -> bool:
    """Return whether a record takes the place of a mark."""
    return isinstance(said, Excuse) or (isinstance(said, ChangeMark) and said.mark is not None)


def _with_marks(
    student: str,
    every: Sequence[_Mine],
    given: Side,
    items: Collection[str],
    decides: Sequence[Filed],
) -> MarkNow:
    """Return what counts where somebody has set a mark."""
    own = {_item(one) for mine in every if mine.sets for one in (*mine.before, *mine.given)}
    sides: list[Side] = []
    whose: dict[str, _Mine] = {}  # by name of the first record of a side
    for mine in every:
        behind = [one for one in mine.given if _item(one) in items]
        if mine.base is None:
            side = (*mine.points, *(one for one in behind if _item(one) not in own))
        else:
            side = (mine.base, *mine.points, *behind)
        if side:
            sides.append(side)
            whose[side[0].name] = mine
    found = settled_sides(sides, _content, decides, student)
    if found.sides:
        flat = tuple(one for side in found.sides for one in side)
        return MarkNow(given=given, conflicts=(("", flat),))
    held = {one.name for side in found.kept for one in side}
    out = {one.name for side in sides for one in side} - held
    left = tuple(one for one in given if one.name not in out)
    kept = [whose[side[0].name] for side in found.kept]
    excuses = tuple(mine.base for mine in kept if mine.base is not None and mine.excuses)
    if excuses:
        return MarkNow(excuses, given=left)
    first = kept[0]
    if first.base is None:
        return _added(student, [mine.points for mine in kept], decides)._replace(given=left)
    bases = tuple(mine.base for mine in kept if mine.base is not None)
    later = frozenset(one.name for mine in kept for one in mine.given)
    groups = (bases, *((one,) for one in first.points))
    return MarkNow((*bases, *first.points), groups, left, later)


def _content(side: Side) -> Hashable:
    """Return what a side comes to; what has no mark in it is like no other."""
    first = side[0].said
    if isinstance(first, Excuse):
        return "excused"
    if isinstance(first, ChangeMark) and first.mark is not None:
        value = Fraction(first.mark) + sum((_points(one) for one in side[1:]), Fraction(0))
        return in_tenths(value), frozenset(_item(o) for o in side if isinstance(o.said, Give))
    return side[0].grader


def _added(student: str, sides: Iterable[Side], decides: Sequence[Filed]) -> MarkNow:
    """Return points that add up; what two graders give for the same reason counts once."""
    by_reason: dict[str, list[Side]] = defaultdict(list)
    for side in sides:
        mine: dict[str, list[Filed]] = defaultdict(list)
        for one in side:
            mine[_reason(one)].append(one)
        for reason, found in mine.items():
            by_reason[reason].append(tuple(sorted(found, key=lambda one: (_points(one), one))))
    groups: list[tuple[Filed, ...]] = []
    conflicts: list[tuple[str, tuple[Filed, ...]]] = []
    for reason in sorted(by_reason):
        found = settled_sides(by_reason[reason], _all_points, decides, student)
        if found.sides:
            conflicts.append((reason, tuple(one for side in found.sides for one in side)))
        else:
            groups += zip(*found.kept, strict=True)
    groups.sort(key=lambda group: (group[0].grader, group[0].said.number))
    mark = sorted((one for group in groups for one in group), key=_place)
    return MarkNow(tuple(mark), tuple(groups), conflicts=tuple(conflicts))


def _place(one: Filed) -> tuple[str, int]:
    return one.grader, one.said.number


def _all_points(side: Side) -> Hashable:
    return tuple(_points(one) for one in side)


def _points(one: Filed) -> Fraction:
    said = one.said
    return Fraction((said.delta or "0") if isinstance(said, ChangeMark) else "0")


def _reason(one: Filed) -> str:
    assert isinstance(one.said, ChangeMark)
    return " ".join(one.said.reason.split()).casefold()


def _item(one: Filed) -> str:
    assert isinstance(one.said, Give)
    return one.said.item
