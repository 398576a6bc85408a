"""Every lost point with its cause: where and when, in one sentence, and what to look at."""

from fractions import Fraction

from vrts.base.diagnostic import Diagnostic, Moment
from vrts.base.source import Span
from vrts.check.collision.in_words import subject, target
from vrts.check.judgement import Judgement
from vrts.check.mark.earned import COLLISION
from vrts.check.mark.grade import Loss
from vrts.check.task.demands import DEMAND
from vrts.check.task.score import (
    FULL,
    Achieved,
    Parts,
    contact_loss,
    faultless,
)
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, ContactEvent
from vrts.check.verdicts.targets import Reached, describe, judged_at
from vrts.check.verdicts.vias import Lack, Passed
from vrts.engine.hand.hand import CLOSED_ON_NOTHING, DROP_HEIGHT, DROPPED, OFF_CENTRE, TOPPLED
from vrts.engine.memory.events import Cause, Found, Grasped, Released
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run

NOTHING = Fraction(0)
PROGRAM_ENDS = (Ending.COMPLETED, Ending.HALTED)

SHORTFALL_HINT = "look at the end of the replay: where is the object, and where should it be?"
VIA_HINTS = {
    Lack.DIRECTION: "compare the hand's direction there with the one that is asked for",
    Lack.TOO_FAST: "look at the speed of this motion",
    Lack.TOO_SLOW: "look at the speed of this motion, and whether the arm stops there",
}


class Mishap:
    """A contact event or a dropped object, with what is said about it."""

    def __init__(self, time_s: float, loss: Loss) -> None:
        self.time_s = time_s
        self.loss = loss


def mishaps_of(run: Run, judgement: Judgement) -> list[Mishap]:
    """Return contact events and dropped objects, in time order."""
    found: list[Mishap] = []
    if judgement.collisions is not None:
        collision = next(v for v in judgement.verdicts if v.check == "collision")
        errors = [d for d in collision.findings if d.is_error]
        for event, finding in zip(judgement.collisions.contacts, errors, strict=True):
            found.append(Mishap(event.start_s, _contact_loss(event, finding)))
    for event in run.events:
        if isinstance(event, Released) and event.height_m > DROP_HEIGHT:
            found.append(Mishap(event.time_s, _drop_loss(run, event)))
    return sorted(found, key=lambda mishap: mishap.time_s)


def _contact_loss(event: ContactEvent, finding: Diagnostic) -> Loss:
    sentence = f"{where(event.start_s, event.cause)}, {subject(event)} hits {target(event)}"
    hint = finding.help[0] if finding.help else ""
    span = event.cause.span if event.cause else None
    return Loss(NOTHING, "contact", sentence, hint, span, finding.moment, COLLISION)


def _drop_loss(run: Run, event: Released) -> Loss:
    finding = _warning(run, event.time_s, event.body)
    headline = finding.diagnostic.headline if finding else f"`{event.body}` is dropped"
    hint = finding.diagnostic.help[0] if finding and finding.diagnostic.help else ""
    sentence = f"{where(event.time_s, event.cause)}, {headline}"
    span = event.cause.span if event.cause else None
    seen = moment(run, event.time_s, (event.body,))
    return Loss(NOTHING, "drop", sentence, hint, span, seen, COLLISION)


def losses_of(
    task: Task,
    run: Run,
    results: tuple[Reached, ...],
    points: Passed,
    mishaps: list[Mishap],
    demands: list[Loss],
    achieved: Achieved,
    parts: Parts,
    mark: Fraction,
) -> tuple[Loss, ...]:
    """Return every loss; they add up to 10 - mark exactly."""
    scheme = task.mark
    full_targets = scheme.targets + (NOTHING if task.vias else scheme.vias)
    total = sum((goal.weight for goal in task.goals), NOTHING) or Fraction(1)
    causes: list[Loss] = []
    stopped = stopped_by(run)
    merged = NOTHING  # goals not reached because the program was stopped
    for result in results:
        lost = full_targets * result.goal.weight * (1 - result.share) / total
        if stopped is not None and _why(run, result.goal.body) is None:
            merged += lost
        elif lost:
            causes.append(_target_loss(run, task, result, lost))
    causes += _via_losses(run, task, points)
    spent = NOTHING
    for count, mishap in enumerate(mishaps, 1):
        so_far = contact_loss(count, scheme)
        causes.append(mishap.loss._replace(points=so_far - spent))
        spent = so_far
    causes += demands
    _forgive(causes, parts)
    time = scheme.time_bonus - parts.time
    if stopped is not None:
        causes.append(stopped._replace(points=merged + time))
        time = NOTHING
    causes = [loss for loss in causes if loss.points]  # contacts beyond the cap cost nothing
    causes.sort(key=lambda loss: -loss.points)
    if time:
        causes.append(_time_loss(task, achieved, time))
    rest = FULL - scheme.time_bonus - full_targets - (scheme.vias if task.vias else NOTHING)
    if rest:
        sentence = f"the task gives at most {float(FULL - rest):g} points"
        causes.append(Loss(rest, "task", sentence, "", None, None))
    rounding = FULL - mark - sum((loss.points for loss in causes), NOTHING)
    if rounding:
        sentence = "the mark is rounded to a tenth"
        causes.append(Loss(rounding, "rounding", sentence, "", None, None))
    return tuple(causes)


def _forgive(causes: list[Loss], parts: Parts) -> None:
    """Take back what contacts and demands cost beyond zero, from the last one on."""
    excess = parts.contacts + parts.demands - parts.targets - parts.vias
    for k in range(len(causes) - 1, -1, -1):
        if excess <= 0:
            return
        if causes[k].kind in ("contact", "drop", "demand"):
            back = min(excess, causes[k].points)
            causes[k] = causes[k]._replace(points=causes[k].points - back)
            excess -= back


def _target_loss(run: Run, task: Task, result: Reached, lost: Fraction) -> Loss:
    time_s = judged_at(run, task)
    body = result.goal.body
    missing = [goal.body for goal in task.goals if not _was_grasped(run, goal.body)]
    sentence, hint, span = f"`{body}` {describe(result)}", SHORTFALL_HINT, None
    why = _why(run, body, missing.index(body) if body in missing else 0)
    if why is not None:
        time_s = why.time_s
        span = why.cause.span if why.cause else None
        sentence = f"{where(why.time_s, why.cause)}, {why.diagnostic.headline}: {sentence}"
        hint = why.diagnostic.help[0] if why.diagnostic.help else hint
    elif not _was_grasped(run, body):
        sentence = f"`{body}` was never picked up: it {describe(result)}"
    return Loss(lost, "target", sentence, hint, span, moment(run, time_s, (body,)))


def _via_losses(run: Run, task: Task, points: Passed) -> list[Loss]:
    found: list[Loss] = []
    for visits, lack in zip(points.visits, points.lacks, strict=True):
        if lack is None:
            continue
        instant = None if lack is Lack.ORDER else moment(run, visits.best_s, ())
        found.append(
            Loss(
                task.mark.vias / len(task.vias),
                "via",
                f"the tool does not pass `{visits.via.name}` {lack.value}",
                VIA_HINTS.get(lack, "look at the path of the tool in the replay"),
                None,
                instant,
            )
        )
    return found


def broken_demands(task: Task, judgement: Judgement) -> list[Loss]:
    """Return a loss for every demand that is not kept."""
    verdicts = [v for v in judgement.verdicts if v.check.startswith(DEMAND)]
    found: list[Loss] = []
    for demand, verdict in zip(task.demands, verdicts, strict=True):
        if verdict.answer is not Answer.VIOLATED:
            continue
        (finding,) = verdict.findings
        span = finding.primary.span if finding.primary else None
        line = "" if span is None else f", line {span.line} `{' '.join(span.text.split())}`"
        sentence = verdict.summary
        if finding.moment is not None:
            sentence = f"at {finding.moment.time_s:.1f} s{line}, {sentence}"
        elif line:
            sentence = f"{line[2:]}: {sentence}"
        hint = finding.help[0] if finding.help else ""
        found.append(
            Loss(demand.points, "demand", sentence, hint, span, finding.moment, verdict.check)
        )
    return found


def _time_loss(task: Task, achieved: Achieved, lost: Fraction) -> Loss:
    if faultless(achieved) and achieved.duration_s is not None:
        sentence = (
            f"the program takes {float(achieved.duration_s):.1f} s;"
            f" full points are given up to {task.t_par:.1f} s"
        )
        hint = "where does the arm move slowly although nothing is near?"
    else:
        sentence = "points for speed are given only when nothing else is wrong"
        hint = "mend the other losses first"
    return Loss(lost, "time", sentence, hint, None, None)


def stopped_by(run: Run) -> Loss | None:
    """Return the loss of a program that did not come to its own end."""
    if run.ending in PROGRAM_ENDS:
        return None
    errors = [e for e in run.events if isinstance(e, Found) and e.diagnostic.is_error]
    if not errors:
        sentence, hint = f"the program is {run.ending.value} at the end", "let it come to its end"
        return Loss(NOTHING, "program", sentence, hint, None, None)
    event = errors[-1]
    found = event.diagnostic
    sentence = f"{where(event.time_s, event.cause)}, {found.headline}"
    hint = found.help[0] if found.help else "read the error and its line"
    span = found.primary.span if found.primary else None
    return Loss(NOTHING, "program", sentence, hint, span, moment(run, event.time_s, ()))


def _why(run: Run, body: str, turn: int = 0) -> Found | None:
    """Return the engine's finding that tells best why an object is not where it should be.

    An object that was never in the hand is put down to a hand that closed on nothing: the first
    such object to the first such hand, the second (`turn` 1) to the second.
    """
    found = [event for event in run.events if isinstance(event, Found)]
    for rule in (TOPPLED, DROPPED, OFF_CENTRE):
        for event in found:
            if event.diagnostic.rule == rule and event.diagnostic.data.get("body") == body:
                return event
    if run.ending not in PROGRAM_ENDS or _was_grasped(run, body):
        return None
    empty = [event for event in found if event.diagnostic.rule == CLOSED_ON_NOTHING]
    return empty[min(turn, len(empty) - 1)] if empty else None


def _was_grasped(run: Run, body: str) -> bool:
    return any(isinstance(event, Grasped) and event.body == body for event in run.events)


def _warning(run: Run, time_s: float, body: str) -> Found | None:
    for event in run.events:
        if not isinstance(event, Found) or event.time_s != time_s:
            continue
        if event.diagnostic.data.get("body") == body:
            return event
    return None


def where(time_s: float, cause: Cause | None) -> str:
    """Return when and in which line something happened: "at 12.4 s, line 17 `MOVES base2_put`"."""
    when = f"at {time_s:.1f} s"
    if cause is None:
        return when
    span: Span = cause.span
    text = " ".join(span.text.split())
    return f"{when}, line {span.line} `{text}`"


def moment(run: Run, time_s: float, bodies: tuple[str, ...]) -> Moment:
    """Return an instant of a run for a picture."""
    state = run.at(min(time_s, run.horizon_s))
    return Moment(time_s, (*state.configuration, state.hand_opening), bodies)
