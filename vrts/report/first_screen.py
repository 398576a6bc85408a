"""What everybody sees first, on every medium, in this order.

The mark; ready for the real robot, yes or no; the costliest cause in one sentence; a hint; the
table of losses; the moment whose picture to show.
"""

from dataclasses import dataclass
from fractions import Fraction

from vrts.base.diagnostic import Diagnostic, Moment
from vrts.base.source import SourceFile, Span
from vrts.check.mark.grade import Loss, Status
from vrts.check.mark.ready import obstacles
from vrts.check.rules.hints import Hints
from vrts.check.rules.scheme import TOTAL
from vrts.check.verdict import Answer, Verdict
from vrts.engine.memory.records import Ending
from vrts.report.assessment import Assessment
from vrts.report.plain import capital, one_line
from vrts.report.quantities import at_time, lost

NOTHING_LOST = "Nothing was lost: every goal is reached and nothing was touched"
ALL_DONE = "Nothing was lost: all that is asked for is done and nothing was touched"  # no goals
NOT_LOOKED_FOR = "Nothing was lost, but contacts were not looked for: collisions are switched off"
NOTHING_WRONG = "Nothing was found to be wrong"
FINE = (NOTHING_LOST, ALL_DONE, NOT_LOOKED_FOR, NOTHING_WRONG)


@dataclass(frozen=True, slots=True)
class FirstScreen:
    """The answer in one look. All texts are one line and free of control characters."""

    mark: Fraction | None  # None without a task
    status: str  # "graded", "does not compile", "holds", ...
    ready: bool  # for the real robot
    obstacles: tuple[str, ...]  # why not, most serious first
    why_not: str  # the first of them where the cause does not tell of it; "" otherwise
    ready_in: str  # "this scenario" or "every future"; "" where it is not ready
    cause: str  # a sentence, without full stop: "At 12.4 s, line 17 `…`, … (−1.5)"
    hint: str | None  # where to look; not the solution
    losses: tuple[Loss, ...]  # empty without a task
    verdicts: tuple[Verdict, ...]  # shown in place of the losses without a task
    moment: Moment | None  # of the cause: what the picture shows
    span: Span | None  # of the cause
    total: Fraction = TOTAL  # the mark is out of so many points


def first_screen(a: Assessment) -> FirstScreen:
    """Return what is shown first of an assessment."""
    errors = [d for d in a.findings if d.is_error]
    verdicts = a.judgement.verdicts if a.judgement else ()
    cause, hint, moment, span = _cause(a, errors, verdicts)
    grade = a.grade
    against = grade.obstacles if grade else _obstacles(a, errors)
    return FirstScreen(
        mark=grade.mark if grade else None,
        status=status(a),
        ready=grade.ready if grade else not against,
        obstacles=tuple(one_line(o) for o in against),
        ready_in="" if against else _ready_in(a),
        why_not=one_line(against[0]) if against and cause in FINE else "",
        cause=one_line(cause),
        hint=one_line(hint) if hint else None,
        losses=grade.losses if grade else (),
        verdicts=() if grade else verdicts,
        moment=moment,
        span=span,
        total=grade.total if grade else TOTAL,
    )


def status(a: Assessment) -> str:
    """Return what became of a program in a word or two."""
    if a.grade:
        return a.grade.status.value
    if a.source is None:
        return Status.UNREADABLE.value
    if a.module is None:
        return Status.DOES_NOT_COMPILE.value
    if a.run is None:
        return "compiles"
    ending = {Ending.ERROR: Status.STOPPED.value, Ending.LIMIT: Status.LIMIT.value}
    if a.run.ending in ending:
        return ending[a.run.ending]
    return a.judgement.answer.value if a.judgement else a.run.ending.value


def _cause(
    a: Assessment, errors: list[Diagnostic], verdicts: tuple[Verdict, ...]
) -> tuple[str, str | None, Moment | None, Span | None]:
    compiled = a.module is not None
    if a.grade and compiled:
        losses = [loss for loss in a.grade.losses if loss.points > 0]
        if not losses:
            off = a.judgement is not None and a.judgement.collisions is None
            path_only = a.task is not None and not a.task.targets
            fine = ALL_DONE if path_only else NOTHING_LOST
            return (NOT_LOOKED_FOR if off else fine, None, None, None)
        worst = losses[0]
        sentence = f"{capital(worst.sentence)} ({lost(worst.points)})"
        return (sentence, _loop_hint(a, worst) or worst.hint or None, worst.moment, worst.span)
    if errors:
        return _of_diagnostic(errors[0], a.source)
    for verdict in verdicts:
        if verdict.answer is not Answer.HOLDS:
            return (capital(verdict.summary), None, None, None)
    if a.grade and a.grade.losses:  # does not compile, yet nothing to quote
        return (capital(a.grade.losses[0].sentence), a.grade.losses[0].hint or None, None, None)
    return (NOTHING_WRONG, None, None, None)


def _loop_hint(a: Assessment, worst: Loss) -> str | None:
    """Return what the compiler said of an endless loop when a limit stopped the run."""
    if worst.kind != "program" or a.run is None or a.run.ending is not Ending.LIMIT:
        return None
    if a.task is not None and a.task.hints is Hints.NOTHING:
        return None
    said = (d for d in a.diagnostics if d.rule.slug == "endless-loop")
    first = next(said, None)
    if first is None or first.primary is None:
        return None
    return f"line {first.primary.span.line}: {first.primary.text}"


def _of_diagnostic(
    d: Diagnostic, shown: SourceFile | None
) -> tuple[str, str | None, Moment | None, Span | None]:
    span = d.primary.span if d.primary else None
    # lines of other texts, such as an instruction typed at the monitor, would be looked for in vain
    where = f"line {span.line}" if span and span.source is shown else ""
    when = at_time(d.moment.time_s) if d.moment else ""
    place = ", ".join(part for part in (when, where) if part)
    sentence = f"{place}: {d.headline}" if place else d.headline
    return (capital(sentence), d.help[0] if d.help else None, d.moment, span)


def _obstacles(a: Assessment, errors: list[Diagnostic]) -> tuple[str, ...]:
    """Return what speaks against the real robot, when no task says more."""
    told = tuple(d.headline for d in errors)
    if a.run is None or a.judgement is None:
        return told or ("the program was not executed and checked",)
    found = obstacles(a.run, a.judgement, said=a.diagnostics)
    return tuple(one.sentence for one in found) or told


def _ready_in(a: Assessment) -> str:
    """Return in what a program is ready: only a proof speaks of more than was executed."""
    proven = a.proof is not None and a.proof.answer is Answer.HOLDS
    return "every future" if proven else "this scenario"
