"""From what the intake found to what is marked, and from results to the rows of a class."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from datetime import datetime
from fractions import Fraction

from vrts.base.diagnostic import Diagnostic, Rule, warning
from vrts.check.task.late_rules import LateRules
from vrts.marking.intake.candidate import data_of
from vrts.marking.intake.row import Attempt, Tried
from vrts.marking.intake.row import Kind as Problem
from vrts.marking.intake.row import Row as Found
from vrts.marking.intake.tree.opening import Tree, Unreadable
from vrts.marking.lateness import Marks, best, in_row, lateness, marks
from vrts.marking.marking import Done, Entry
from vrts.marking.result import Kind, Result
from vrts.marking.row import BEST_OF, HandedIn, Lateness, MarkedAttempt, Row, Student, row_of
from vrts.marking.unsafe import WITHOUT_MARK, Doubt, Reason

KINDS = {
    Problem.MISSING: Kind.MISSING,
    Problem.AMBIGUOUS: Kind.AMBIGUOUS,
    Problem.EXCUSED: Kind.EXCUSED,
    Problem.UNREADABLE: Kind.UNREAD,
}  # any other problem: the hand-in is unreadable for anybody, and gets 0

UNBOUNDED = "two engines disagree"  # a review that may also raise a mark
NOTHING_LATE = Rule("V756", "nothing-late")

Mark = Callable[[Sequence[Entry]], Iterable[Done]]


def entries(tree: Tree, found: Iterable[Found]) -> Iterator[Entry]:
    """Yield what is to be marked, with the programs read from the download."""
    for row in found:
        if row.problem is not None or row.file is None:
            problem = row.problem
            kind = Kind.MISSING if problem is None else KINDS.get(problem.kind, Kind.UNREADABLE)
            sentence = "nothing was handed in" if problem is None else problem.sentence
            yield Entry(row.identifier, row.title, None, kind, sentence)
        else:
            yield _entry(tree, row.identifier, row.title, row.file)


def with_best_attempts(
    tree: Tree, found: Sequence[Found], rules: LateRules | None, mark: Mark
) -> tuple[Found, ...]:
    """Return the rows with the attempt that earns most, after what lateness costs.

    Args:
        tree: The download.
        found: Rows of the intake, with the latest attempts.
        rules: What lateness costs.
        mark: Marks programs without writing anything.
    """
    several = [row for row in found if _has_choice(row)]
    tried: dict[str, tuple[Found, Attempt]] = {}
    asked: list[Entry] = []
    for row in several:
        for attempt in row.attempts:
            name = str(len(tried))
            tried[name] = (row, attempt)
            asked.append(_entry(tree, name, row.title, attempt.file, row.identifier))
    results = {done.entry.identifier: done.result for done in mark(asked)}
    chosen: dict[str, Found] = {}
    for row in several:
        names = [name for name, (whose, _) in tried.items() if whose is row]
        worth = [
            _worth(results[name], row, tried[name][1], rules, results[name].exact_mark)
            for name in names
        ]
        number = best(worth)
        attempt = tried[names[number]][1]
        why = f"{BEST_OF} {len(names)} attempts, number {number + 1}{_as_good(worth, number)}"
        if rules is not None and rules.is_exam:
            why = f"{why}; {row.why}"
        chosen[row.identifier] = replace(
            row,
            file=attempt.file,
            received=attempt.received,
            why=why,
            problem=None,
            doubts=tuple(_doubts(row, [results[name] for name in names], number, rules)),
            tried=tuple(Tried(*tried[name][1], results[name].mark) for name in names),
        )
    return tuple(chosen.get(row.identifier, row) for row in found)


def _as_good(worth: Sequence[Marks], chosen: int) -> str:
    """Return which attempts are worth as much as the chosen one, in words; "" for none."""
    alike = [str(k + 1) for k, one in enumerate(worth) if k != chosen and one == worth[chosen]]
    return f", as good as {' and '.join(alike)}: the first of these" if alike else ""


def _worth(
    result: Result, row: Found, attempt: Attempt, rules: LateRules | None, mark: Fraction | None
) -> Marks:
    """Return what an attempt is worth with a mark, after what lateness costs."""
    late = lateness(rules, attempt.received, due=row.due)
    return marks(mark or Fraction(0), late, result.exact_total)


def _doubts(
    row: Found, results: Sequence[Result], chosen: int, rules: LateRules | None
) -> Iterator[Doubt]:
    """Yield why another attempt may be better than the one that was chosen."""
    taken, own = row.attempts[chosen], results[chosen]
    if own.kind in WITHOUT_MARK:
        return
    got = _worth(own, row, taken, rules, own.exact_mark).final
    least = None if own.lowest is None else Fraction(own.lowest)
    low = got if least is None else _worth(own, row, taken, rules, least).final
    for number, (attempt, result) in enumerate(zip(row.attempts, results, strict=True)):
        if number == chosen:
            continue
        which = f"attempt {number + 1} of {len(results)}, `{attempt.file}`,"
        open_ = result.kind in WITHOUT_MARK or any(UNBOUNDED in text for text in result.review)
        most = _worth(result, row, attempt, rules, result.exact_total if open_ else None).final
        if open_ and most > got:
            reason = WITHOUT_MARK.get(result.kind, Reason.UNDETERMINED)
            why = result.review[0] if result.review else result.cause
            yield Doubt(reason, f"{which} may be better than the one that counts: {why}")
        now = _worth(result, row, attempt, rules, result.exact_mark).final
        if low < now:
            words = f"{which} gets {float(now):g}, and counts if the chosen one gets less"
            yield Doubt(Reason.UNDETERMINED, words)


def _has_choice(row: Found) -> bool:
    """Return whether there is another attempt than the latest, which may be no program."""
    if row.problem is None:
        return len(row.attempts) > 1
    return bool(row.attempts) and row.problem.kind not in (Problem.EXCUSED, Problem.AMBIGUOUS)


def class_row(found: Found, result: Result, rules: LateRules | None) -> Row:
    """Return the row of a submission in the list of marks, without changes by hand."""
    student = found.student
    received = found.received
    by = found.chosen_by or found.due  # what graders gave more is added to the row by hand
    return row_of(
        result,
        Student(student.name, student.email, student.login, dict(student.ids)),
        HandedIn(
            found.file or "",
            found.why,
            _iso(received),
            found.attempt,
            found.doubts,
            _iso(by),
            tuple(MarkedAttempt(one.file, _iso(one.received), one.mark) for one in found.tried),
        ),
        _late(found, result, rules),
    )


def _iso(when: datetime | None) -> str | None:
    return None if when is None else when.isoformat()


def nothing_late(rules: LateRules | None, found: Sequence[Found]) -> tuple[Diagnostic, ...]:
    """Return a warning where Canvas calls nothing late and nothing else tells what is.

    Canvas cannot call anything late in an assignment that has no due date there.
    """
    of_canvas = [row for row in found if row.file and row.flagged is not None]
    untold = [row for row in of_canvas if row.received is None and row.late is None]
    if rules is None or rules.is_exam or not untold or any(row.flagged for row in of_canvas):
        return ()
    one = len(untold) == 1
    what = "1 hand-in has" if one else f"{len(untold)} hand-ins have"
    headline = f"Canvas calls nothing LATE, and {what} no time: taken as on time"
    note = "Canvas calls nothing late in an assignment that has no due date there"
    remedies = (
        "look whether the assignment has the task's due date in Canvas",
        "if it has none, write times into the column `received` of the table of the intake",
    )
    return (warning(NOTHING_LATE, headline, notes=(note,), help=remedies),)


def _entry(tree: Tree, identifier: str, title: str, file: str, whose: str = "") -> Entry:
    try:
        return Entry(identifier, title, data_of(tree, file), whose=whose)
    except Unreadable as flaw:
        return Entry(identifier, title, None, Kind.UNREAD, f"`{title}` {flaw}", whose=whose)


def _late(found: Found, result: Result, rules: LateRules | None) -> Lateness | None:
    called = found.called_late
    if rules is not None and rules.is_exam and not called:
        called = found.late  # a platform tells what came too late, and not what came too early
    late = lateness(rules, found.received, due=found.due, called_late=called)
    nothing_came = result.kind in (Kind.MISSING, Kind.EXCUSED)
    return None if late.untimed and nothing_came else in_row(late, result)
