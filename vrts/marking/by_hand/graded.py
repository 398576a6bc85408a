"""What graders' decisions make of one row: lateness, points in steps, doubts, and words."""

from collections.abc import Iterable, Iterator, Sequence
from datetime import datetime
from fractions import Fraction
from typing import NamedTuple

from vrts.check.task.late_rules import LateRules
from vrts.check.task.score import to_tenth
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
from vrts.marking.by_hand.decisions.sound import above, beyond
from vrts.marking.by_hand.decisions.state import OfStudent, Prepared, program_in
from vrts.marking.by_hand.decisions.words import due_words, number, sentence_of
from vrts.marking.by_hand.excused import excused_result
from vrts.marking.by_hand.overrides import Override, change_of, settled_by
from vrts.marking.lateness import in_row, lateness
from vrts.marking.row import (
    BEST_OF,
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
    items: tuple[Given, ...] = ()  # that count
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
    after_lateness = final_mark(row.result.exact_mark, late, None, row.result.exact_total)
    made = _made(row, mine, overrides, every, after_lateness)
    decided = Decided(
        tuple(_comments(mine)),
        made.items,
        made.steps,
        due,
        made.excused,
        (*(one.sentence for one in mine.conflicts), *((made.conflict,) if made.conflict else ())),
        tuple(_lapsed(mine)),
        "" if made.excused else _again(row, due, rules),
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


def _again(row: Row, due: str, rules: LateRules | None) -> str:
    """Return why the attempt that counts may be another one by a later deadline; "": it is not.

    Only marking chooses among attempts: by the deadline that it knew.
    """
    if not due or rules is None:
        return ""
    known = row.handed_in.due
    before = rules.due if known is None else datetime.fromisoformat(known)
    if datetime.fromisoformat(due) <= before:
        return ""
    if not (rules.is_exam or row.handed_in.why.startswith(BEST_OF)):
        return ""
    return f"there is time until {due_words(due)}, by which another attempt may count: mark again"


def _comments(mine: OfStudent) -> Iterator[Told]:
    for one in mine.comments:
        said = one.said
        if isinstance(said, Comment) and not said.private:
            yield Told(said.text, one.who, said.line, said.time_s)


def _items(gives: Iterable[Filed], every: Prepared) -> Iterator[Given]:
    """Yield every item once that somebody has given."""
    given: dict[str, list[Filed]] = {}
    for one in gives:
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
    every: Prepared,
    after_lateness: Fraction | None,
) -> Made:
    """Return what changes a mark: items, then `overrides.toml`, then graders' changes.

    Items that their grader has given behind a mark by hand are added to it.
    """
    excuses = [one for one in mine.mark if isinstance(one.said, Excuse)]
    if excuses and not overrides:
        said = excuses[0].said
        assert isinstance(said, Excuse)
        return Made(excused=f"{one_line(said.reason)} ({_names(excuses)})")
    total = row.result.exact_total
    steps = _Steps(after_lateness or NOTHING)
    first = [one for one in mine.given if one.name not in mine.later]
    items = tuple(_items(first, every)) if row.result.exact_mark is not None else ()
    for item in items:
        steps.add(one_line(item.title), Fraction(item.points), f"by {item.who}")
    plain = Made(tuple(steps.made), _change(row, steps, items, (), mine.given), items)
    if excuses:
        return plain._replace(conflict=_against(overrides, excuses))
    flaw = _beyond(row, mine, every)
    if flaw:
        return plain._replace(conflict=flaw)
    beside = _beside(overrides, first, items)
    if beside:
        return plain._replace(conflict=_against(overrides, beside))
    of_file = change_of(steps.value, overrides, row.result)
    if of_file is not None:
        steps.add(BY_HAND, Fraction(of_file.delta), of_file.reason)
    changes = [_override(row, group) for group in mine.changes]
    for change in changes:
        value = steps.value + change.delta if change.delta is not None else change.mark or NOTHING
        if overrides and change.mark is not None and _differ(value, steps.value, total):
            return plain._replace(conflict=_against(overrides, mine.mark))
        steps.add(BY_HAND, value - steps.value, f"{change.reason} ({change.who})")
    known = {item.item for item in items}
    behind = [one for one in mine.given if one.name in mine.later]
    for item in _items(behind, every):
        if item.item not in known:
            steps.add(one_line(item.title), Fraction(item.points), f"by {item.who}")
            items = (*items, item)
    by_graders = list(changes)
    if mine.preferred is not None:
        preferred = _preferred(row, *mine.preferred, steps.value)
        if preferred is not None and preferred.delta is not None:
            if overrides and preferred.delta:
                return plain._replace(conflict=_against(overrides, [mine.preferred[0]]))
            since = _since(mine, every) if preferred.delta else ""
            if since:
                return plain._replace(conflict=since)
            steps.add(BY_HAND, preferred.delta, f"{preferred.reason} ({preferred.who})")
            by_graders.append(preferred)
    if not by_graders and not (items and steps.made):
        return Made(change=of_file)
    change = _change(row, steps, items, [*overrides, *by_graders], mine.given)
    return Made(tuple(steps.made), change, items)


def _differ(one: Fraction, other: Fraction, total: Fraction) -> bool:
    """Return whether two values are different marks: marks are tenths from 0 to the total."""
    return to_tenth(one, total) != to_tenth(other, total)


def _beside(
    overrides: Sequence[Override], gives: Iterable[Filed], items: Iterable[Given]
) -> list[Filed]:
    """Return gives which a mark in `overrides.toml` would swallow; those of days before it may be.

    The file knows days only: what came on the same day may have come behind it.
    """
    marks = [one.date for one in overrides if one.mark is not None]
    if not marks:
        return []
    counting = {item.item for item in items if Fraction(item.points)}
    return [
        one
        for one in gives
        if isinstance(one.said, Give)
        and one.said.item in counting
        and one.said.at[:10] >= marks[-1]
    ]


def _beyond(row: Row, mine: OfStudent, every: Prepared) -> str:
    """Return what is above the total of the task, and so cannot be meant; "" for nothing."""
    total = row.result.exact_total
    named = [*mine.mark, *([] if mine.preferred is None else [mine.preferred[0]])]
    found = [
        f"{one.who} ({one.name}): {text}" for one in named if (text := beyond(one.said, total))
    ]
    for name in dict.fromkeys(one.said.item for one in mine.given if isinstance(one.said, Give)):
        if abs(every.items[name].points) > total:
            found.append(f"item `{name}`: {above(every.items[name].points, total)}")
    return f"cannot be meant, and does not count: {'; '.join(found)}" if found else ""


def _since(mine: OfStudent, every: Prepared) -> str:
    """Return what was decided after it was decided whose mark counts; "" for nothing."""
    assert mine.preferred is not None
    finish, decide = mine.preferred
    when = datetime.fromisoformat(decide.said.at)
    found = [one.name for one in (*mine.mark, *mine.given) if _time(one.said.at) > when]
    for name in dict.fromkeys(one.said.item for one in mine.given if isinstance(one.said, Give)):
        if every.items[name].at and _time(every.items[name].at) > when:
            found.append(every.items[name].version)
    if not found:
        return ""
    return (
        f"{decide.who} ({decide.name}) decided that {finish.name} counts, before"
        f" {', '.join(dict.fromkeys(found))}: finish it again, and decide again"
    )


def _time(text: str) -> datetime:
    return datetime.fromisoformat(text)


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
    given: Iterable[Filed],
) -> Change | None:
    if not steps.made:
        return None
    counting = {item.item for item in items}
    dates = [o.said.at[:10] for o in given if isinstance(o.said, Give) and o.said.item in counting]
    reasons = [*(one_line(item.title) for item in items), *(one.reason for one in made)]
    who = [*(item.who for item in items), *(one.who for one in made)]
    return Change(
        str(steps.value - steps.before),
        "; ".join(dict.fromkeys(reasons)),
        ", ".join(dict.fromkeys(who)),
        max((*dates, *(one.date for one in made))),
        settled_by(made, row.result),
    )


def _override(row: Row, group: Sequence[Filed]) -> Override:
    """Return a change of graders as one of `overrides.toml`, which settle doubts alike."""
    said = [one.said for one in group if isinstance(one.said, ChangeMark)]
    first = said[0]
    settles = dict.fromkeys(reason for one in said for reason in one.settles)
    return Override(
        row.id,
        None if first.delta is None else Fraction(first.delta),
        None if first.mark is None else Fraction(first.mark),
        one_line(first.reason),
        _names(group),
        first.at[:10],
        tuple(settles),
        program_in(first, row.id),
    )


def _preferred(row: Row, finish: Filed, decide: Filed, value: Fraction) -> Override | None:
    """Return what the mark of the grader whose mark was decided to count adds to a value.

    It settles no doubt: that two graders agree on a mark does not say when it was handed in.
    """
    said, why = finish.said, decide.said
    assert isinstance(said, Finish)
    assert isinstance(why, Decide)
    if said.mark is None:
        return None
    reason, who = one_line(why.reason), f"{finish.who}, decided by {decide.who}"
    mark = Fraction(said.mark)
    same = not _differ(mark, value, row.result.exact_total)
    delta = NOTHING if same else mark - value
    return Override(row.id, delta, None, reason, who, why.at[:10], (), said.program)


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
