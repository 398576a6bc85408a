"""What graders' decisions make of one row: lateness, points in steps, doubts, and words."""

from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime
from fractions import Fraction
from typing import NamedTuple

from vrts.check.task.late_rules import LateRules
from vrts.marking.by_hand.decisions.ledger import Filed
from vrts.marking.by_hand.decisions.records import (
    ChangeMark,
    Comment,
    Decide,
    Excuse,
    Extend,
    Finish,
    Give,
)
from vrts.marking.by_hand.decisions.state import OfStudent, Prepared, program_in
from vrts.marking.by_hand.decisions.words import number, sentence_of
from vrts.marking.by_hand.excused import excused_result
from vrts.marking.by_hand.overrides import Override, change_of, settled_by
from vrts.marking.lateness import in_row, lateness
from vrts.marking.row import (
    Change,
    Decided,
    Given,
    Lateness,
    MadeStep,
    Row,
    Told,
    final_mark,
    row_of,
)
from vrts.report.plain import one_line

BY_HAND = "change by hand"  # title of the step
NOTHING = Fraction(0)


class Made(NamedTuple):
    """What decisions come to, in points."""

    steps: tuple[MadeStep, ...] = ()
    change: Change | None = None
    conflict: str = ""  # between `overrides.toml` and graders; then neither counts
    excused: str = ""


def undecided(row: Row) -> Row:
    """Return a row as it was before anybody decided anything."""
    held = row.decided
    if held is None:
        return row_of(row.result, row.student, row.handed_in, row.late)
    result = held.result or row.result
    late = held.late if held.due or held.result is not None else row.late
    return row_of(result, row.student, row.handed_in, late)


def graded(
    row: Row,
    mine: OfStudent,
    overrides: Sequence[Override],
    every: Prepared,
    rules: LateRules | None,
) -> Row:
    """Return a row with what is decided about it.

    Args:
        row: Undecided.
        mine: What graders have decided about it.
        overrides: Changes in `overrides.toml`, in the order of the file.
        every: Decisions of the class, for the items.
        rules: What lateness costs; None: nothing, or nobody knows.
    """
    late, due = _late(row, mine, rules)
    items = tuple(_items(mine, every))
    after_lateness = final_mark(row.result.exact_mark, late, None, row.result.exact_total)
    made = _made(row, mine, overrides, items, after_lateness)
    decided = Decided(
        tuple(_comments(mine)),
        items,
        made.steps,
        due,
        made.excused,
        (*(one.sentence for one in mine.conflicts), *((made.conflict,) if made.conflict else ())),
        tuple(_lapsed(mine)),
        row.late if due or made.excused else None,
        row.result if made.excused else None,
    )
    if made.excused:
        result, late = excused_result(row.result, made.excused), None
    else:
        result = row.result
    told = None if decided == Decided() else decided
    return row_of(result, row.student, row.handed_in, late, made.change, told)


def _late(row: Row, mine: OfStudent, rules: LateRules | None) -> tuple[Lateness | None, str]:
    """Return the lateness by a later deadline, and this deadline; it never costs more."""
    if not mine.extension:
        return row.late, ""
    said = mine.extension[0].said
    assert isinstance(said, Extend)
    if rules is None or row.handed_in.received is None or row.late is None:
        return row.late, said.due
    due = max(rules.due, datetime.fromisoformat(said.due))
    received = datetime.fromisoformat(row.handed_in.received)
    found = in_row(lateness(rules, received, due=due), row.result)
    if found is not None and Fraction(found.deduction) > Fraction(row.late.deduction):
        return row.late, said.due  # the table of the intake gives still more time
    return found, said.due


def _comments(mine: OfStudent) -> Iterator[Told]:
    for one in mine.comments:
        said = one.said
        if isinstance(said, Comment) and not said.private:
            yield Told(said.text, one.who, said.line, said.time_s)


def _items(mine: OfStudent, every: Prepared) -> Iterator[Given]:
    """Yield every item once that somebody has given."""
    given: dict[str, list[Filed]] = {}
    for one in mine.given:
        assert isinstance(one.said, Give)
        given.setdefault(one.said.item, []).append(one)
    for name in sorted(given):
        item = every.items[name]
        if item.withdrawn or item.differing:
            continue
        places = dict.fromkeys(
            (one.said.line, one.said.time_s)
            for one in given[name]
            if isinstance(one.said, Give) and (one.said.line, one.said.time_s) != (None, None)
        )
        who = ", ".join(dict.fromkeys(one.who for one in given[name]))
        yield Given(name, item.title, str(item.points), who, tuple(places))


def _lapsed(mine: OfStudent) -> Iterator[str]:
    for one in mine.lapsed:
        if isinstance(one.said, Give | ChangeMark):
            yield f"{one.who} ({one.name}) about another program: {sentence_of(one)}"


# --- points ---------------------------------------------------------------------------------------


def _made(
    row: Row,
    mine: OfStudent,
    overrides: Sequence[Override],
    items: Sequence[Given],
    after_lateness: Fraction | None,
) -> Made:
    """Return what changes a mark: items, then `overrides.toml`, then graders' changes."""
    excuses = [one for one in mine.mark if isinstance(one.said, Excuse)]
    if excuses:
        if overrides:
            return Made(conflict=_against(overrides, excuses))
        said = excuses[0].said
        assert isinstance(said, Excuse)
        return Made(excused=f"{one_line(said.reason)} ({_names(excuses)})")
    steps = _Steps(after_lateness or NOTHING)
    if row.result.exact_mark is not None:
        for item in items:
            steps.add(one_line(item.title), Fraction(item.points), f"by {item.who}")
    before = steps.value
    of_file = change_of(before, overrides, row.result)
    if of_file is not None:
        steps.add(BY_HAND, Fraction(of_file.delta), of_file.reason)
    changes = [_override(row, one) for one in mine.mark]
    if changes:
        first = changes[0]
        value = steps.value + first.delta if first.delta is not None else first.mark or NOTHING
        if overrides and first.mark is not None and value != steps.value:
            return Made(conflict=_against(overrides, mine.mark))
        steps.add(BY_HAND, value - steps.value, f"{first.reason} ({_names(mine.mark)})")
    preferred = None if mine.preferred is None else _preferred(row, *mine.preferred)
    if preferred is not None:
        assert preferred.mark is not None
        if (overrides or changes) and preferred.mark != steps.value:
            assert mine.preferred is not None
            return Made(conflict=_against(overrides, [*mine.mark, mine.preferred[0]]))
        delta = preferred.mark - steps.value
        steps.add(BY_HAND, delta, f"{preferred.reason} ({preferred.who})")
    by_graders = [*changes, *([] if preferred is None else [preferred])]
    if not by_graders and not (items and steps.made):
        return Made(change=of_file)
    dates = [one.said.at[:10] for one in mine.given] if items else []
    change = _change(row, steps, items, [*overrides, *by_graders], dates)
    return Made(tuple(steps.made), change)


class _Steps:
    """Points as they are added."""

    def __init__(self, value: Fraction) -> None:
        self.before = self.value = value
        self.made: list[MadeStep] = []

    def add(self, title: str, delta: Fraction, sentence: str) -> None:
        self.value += delta
        self.made.append(MadeStep(title, str(delta), sentence))


def _change(
    row: Row,
    steps: _Steps,
    items: Sequence[Given],
    made: Sequence[Override],
    dates: Sequence[str],
) -> Change | None:
    if not steps.made:
        return None
    reasons = [*(one_line(item.title) for item in items), *(one.reason for one in made)]
    who = [*(item.who for item in items), *(one.who for one in made)]
    return Change(
        str(steps.value - steps.before),
        "; ".join(dict.fromkeys(reasons)),
        ", ".join(dict.fromkeys(who)),
        max((*dates, *(one.date for one in made))),
        settled_by(made, row.result),
    )


def _override(row: Row, one: Filed) -> Override:
    """Return a change of a grader as one of `overrides.toml`, which settle doubts alike."""
    said = one.said
    assert isinstance(said, ChangeMark)
    return Override(
        row.id,
        None if said.delta is None else Fraction(said.delta),
        None if said.mark is None else Fraction(said.mark),
        one_line(said.reason),
        one.who,
        said.at[:10],
        said.settles,
        program_in(said, row.id),
    )


def _preferred(row: Row, finish: Filed, decide: Filed) -> Override | None:
    """Return the mark of the grader whose mark was decided to count."""
    said, why = finish.said, decide.said
    assert isinstance(said, Finish)
    assert isinstance(why, Decide)
    if said.mark is None:
        return None
    reason, who = one_line(why.reason), f"{finish.who}, decided by {decide.who}"
    mark = Fraction(said.mark)
    return Override(row.id, None, mark, reason, who, why.at[:10], (), said.program)


def _against(overrides: Iterable[Override], others: Iterable[Filed]) -> str:
    told = [f"`overrides.toml` ({one.who}): {_told(one)}" for one in overrides]
    told += [f"{one.who} ({one.name}): {sentence_of(one)}" for one in others]
    return f"decided differently: {'; '.join(told)}"


def _told(one: Override) -> str:
    value = one.mark if one.delta is None else one.delta
    what = "the mark " if one.delta is None else "points: "
    return f"{what}{number(value or NOTHING)}: {one.reason}"


def _names(records: Iterable[Filed]) -> str:
    return ", ".join(dict.fromkeys(one.who for one in records))
