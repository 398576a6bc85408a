"""Every lost point with its cause: where and when, in one sentence, and what to look at."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.base.beside import beside
from vrts.base.diagnostic import Diagnostic, Moment
from vrts.base.source import Span
from vrts.check.collision.in_words import subject, target
from vrts.check.goals.reached import Reached, judged_at
from vrts.check.judgement import Judgement
from vrts.check.mark.earned import COLLISION, at_the_end
from vrts.check.mark.grade import Loss, ShownParts
from vrts.check.mark.reasons import PROGRAM_ENDS, reasons, was_grasped
from vrts.check.mark.shown import CONTACTS, in_group
from vrts.check.rounding import exact_mm, exact_s
from vrts.check.task.demands import DEMAND
from vrts.check.task.score import (
    Achieved,
    Parts,
    Touched,
    contact_loss,
    divided,
    faultless,
)
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, ContactEvent
from vrts.check.verdicts import every_future
from vrts.check.verdicts.limits import LIMITS
from vrts.check.verdicts.targets import describe
from vrts.check.verdicts.vias import Lack, Passed
from vrts.engine.hand.told import DROP_HEIGHT
from vrts.engine.memory.events import Cause, Found, Released
from vrts.engine.memory.records import Ending
from vrts.engine.motion.remarks import JOINT_SPEED
from vrts.engine.programs.locks import LOCKED_SETTING
from vrts.engine.run import Run

NOTHING = Fraction(0)

STOP_NOTHING = (LOCKED_SETTING, JOINT_SPEED)  # errors after which a program goes on

NEVER_HINT = (
    "look in the replay at the place where the hand closes: it does not take hold of this object"
)
SHORTFALL_HINT = "look at the end of the replay: where is the object, and where should it be?"
VIA_HINTS = {
    Lack.DIRECTION: "compare the hand's direction there with the one that is asked for",
    Lack.TOO_FAST: "look at the speed of this motion",
    Lack.TOO_SLOW: "look at the speed of this motion, and whether the arm stops there",
}


class Mishap:
    """A contact event or a dropped object, with what is said about it."""

    def __init__(self, time_s: float, loss: Loss, event: ContactEvent | None = None) -> None:
        self.time_s = time_s
        self.loss = loss
        self.event = event  # None: an object was dropped


def mishaps_of(run: Run, judgement: Judgement) -> list[Mishap]:
    """Return contact events and dropped objects, in time order."""
    found: list[Mishap] = []
    if judgement.collisions is not None:
        collision = next(v for v in judgement.verdicts if v.check == "collision")
        errors = [d for d in collision.findings if d.is_error]
        for event, finding in zip(judgement.collisions.contacts, errors, strict=True):
            found.append(Mishap(event.start_s, _contact_loss(event, finding), event))
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


def touched_by(mishaps: Sequence[Mishap]) -> Touched:
    """Return what mishaps come to, as far as it may cost."""
    events = [mishap.event for mishap in mishaps if mishap.event is not None]
    return touched_in(events, len(mishaps) - len(events))


def touched_in(events: Iterable[ContactEvent], drops: int = 0) -> Touched:
    """Return what contacts and drops come to, as far as it may cost."""
    seconds, count = NOTHING, 0
    deepest: dict[tuple[str, str], Fraction] = {}
    for event in events:
        count += 1
        seconds += exact_s(event.end_s) - exact_s(event.start_s)
        pair = (event.first, event.second)
        deepest[pair] = max(deepest.get(pair, NOTHING), exact_mm(event.depth_m))
    return Touched(count, drops, seconds, sum(deepest.values(), NOTHING))


class Causes(NamedTuple):
    """Every loss, exactly, before any is shown."""

    targets: list[Loss]
    merged: Fraction  # of targets not reached because the program was stopped
    vias: list[Loss]
    costs: list[Loss]  # limits, contacts and drops, demands; less what nothing was left for


def causes_of(
    task: Task,
    run: Run,
    results: tuple[Reached, ...],
    points: Passed,
    limits: Loss | None,
    mishaps: list[Mishap],
    demands: list[Loss],
    parts: Parts,
) -> Causes:
    """Return what points are lost by, but for time."""
    scheme = task.mark
    full_targets, full_vias = divided(scheme, targets=bool(task.targets), vias=bool(task.vias))
    total = sum((goal.weight for goal in task.targets), NOTHING) or Fraction(1)
    stopped = stopped_by(run)
    why = reasons(run, _wanted(task))
    targets: list[Loss] = []
    merged = NOTHING
    for result in results:
        lost = full_targets * result.goal.weight * (1 - result.share) / total
        if stopped is not None and result.body not in why:
            merged += lost
        elif lost:
            targets.append(_target_loss(run, task, result, why.get(result.body), lost))
    if at_the_end(task) and stopped is not None:
        merged += full_targets  # these are for coming to the end
    costs = [limits] if limits is not None else []
    spent = NOTHING
    for count, mishap in enumerate(mishaps, 1):
        so_far = contact_loss(touched_by(mishaps[:count]), scheme)
        costs.append(mishap.loss._replace(points=so_far - spent))
        spent = so_far
    costs += demands
    _forgive(costs, parts)
    return Causes(targets, merged, _via_losses(run, task, points, full_vias), costs)


def losses_of(
    task: Task, run: Run, causes: Causes, achieved: Achieved, shown: ShownParts
) -> tuple[Loss, ...]:
    """Return every loss as it is shown; they add up to what the mark lacks exactly."""
    most, stopped = shown.most, stopped_by(run)
    rest = Loss(causes.merged, "program", "", "", None, None)
    *targets, merged = in_group([*causes.targets, rest], most.targets - shown.targets)
    found = [*targets, *in_group(causes.vias, most.vias - shown.vias)]
    for kinds, points in (
        (CONTACTS, shown.contacts),
        (("limit",), shown.limits),
        (("demand",), shown.demands),
    ):
        found += in_group([loss for loss in causes.costs if loss.kind in kinds], points)
    time = most.time - shown.time
    if stopped is not None:
        found.append(stopped._replace(points=merged.points + time))
        time = NOTHING
    found = [loss for loss in found if loss.points]  # contacts beyond the cap cost nothing
    found.sort(key=lambda loss: (loss.kind != "limit", -loss.points))
    if time:
        hidden = None if found else _greatest(causes)
        found.append(_time_loss(task, achieved, time, hidden))
    if most.rest:
        sentence = f"the task gives at most {float(task.mark.total - most.rest):g} points"
        found.append(Loss(most.rest, "task", sentence, "", None, None))
    return tuple(found)


def _greatest(causes: Causes) -> Loss | None:
    """Return what most is lost by, before it is rounded."""
    every = [loss for loss in (*causes.targets, *causes.vias, *causes.costs) if loss.points]
    return max(every, key=lambda loss: loss.points, default=None)


def _forgive(causes: list[Loss], parts: Parts) -> None:
    """Take back what is taken off beyond zero, from the last one on."""
    excess = parts.costs - parts.targets - parts.vias
    for k in range(len(causes) - 1, -1, -1):
        if excess <= 0:
            return
        back = min(excess, causes[k].points)
        causes[k] = causes[k]._replace(points=causes[k].points - back)
        excess -= back


def _target_loss(run: Run, task: Task, result: Reached, why: Found | None, lost: Fraction) -> Loss:
    time_s = judged_at(run, task)
    body = result.body
    sentence, hint, span = f"`{body}` {describe(result)}", SHORTFALL_HINT, None
    if why is not None:
        time_s = why.time_s
        span = why.cause.span if why.cause else None
        sentence = f"{where(why.time_s, why.cause)}, {why.diagnostic.headline}: {sentence}"
        hint = why.diagnostic.help[0] if why.diagnostic.help else hint
    elif not was_grasped(run, body):
        sentence = f"`{body}` was never picked up: it {describe(result)}"
        hint = NEVER_HINT
    return Loss(lost, "target", sentence, hint, span, moment(run, time_s, (body,)))


def _wanted(task: Task) -> tuple[str, ...]:
    """Return the objects that a task asks something of, each once."""
    goals = (name for goal in task.goals for name in goal.bodies)
    return tuple(dict.fromkeys((*goals, *(relation.body for relation in task.relations))))


def _via_losses(run: Run, task: Task, points: Passed, full: Fraction) -> list[Loss]:
    found: list[Loss] = []
    for visits, lack in zip(points.visits, points.lacks, strict=True):
        if lack is None:
            continue
        instant = None if lack is Lack.ORDER else moment(run, visits.best_s, ())
        found.append(
            Loss(
                full / len(task.vias),
                "via",
                f"the tool does not pass `{visits.via.name}` {lack.value}",
                VIA_HINTS.get(lack, "look at the path of the tool in the replay"),
                None,
                instant,
            )
        )
    return found


def broken_limits(task: Task, run: Run, judgement: Judgement) -> Loss | None:
    """Return the loss of a run that breaks a limit of the robot, or moves one; None: none does."""
    verdict = next((v for v in judgement.verdicts if v.check == LIMITS), None)
    if verdict is None or verdict.answer is not Answer.VIOLATED:
        return None
    locked = (e for e in run.events if isinstance(e, Found))
    first = next((e for e in locked if e.diagnostic.rule == LOCKED_SETTING), None)
    finding = verdict.findings[0] if verdict.findings else first and first.diagnostic
    assert finding is not None
    span = finding.primary.span if finding.primary else None
    time_s = finding.moment.time_s if finding.moment else first.time_s if first else run.started_s
    line = "" if span is None else f", line {span.line} `{' '.join(span.text.split())}`"
    hint = finding.help[0] if finding.help else ""
    return Loss(
        task.mark.broken_limit,
        "limit",
        f"at {time_s:.1f} s{line}, {verdict.summary}",
        hint,
        span,
        finding.moment or moment(run, time_s, ()),
        LIMITS,
    )


def broken_demands(task: Task, judgement: Judgement) -> list[Loss]:
    """Return a loss for every demand that is not kept."""
    verdicts = [v for v in judgement.verdicts if v.check.startswith(DEMAND)]
    found: list[Loss] = []
    for demand, verdict in zip(task.costs, verdicts, strict=True):
        if verdict.answer is not Answer.VIOLATED:
            continue
        (finding,) = verdict.findings
        span = finding.primary.span if finding.primary else None
        line = "" if span is None else f", line {span.line} `{' '.join(span.text.split())}`"
        sentence = verdict.summary
        if verdict.check == every_future.CHECK:
            pass  # it tells of another run, and when and where in it
        elif finding.moment is not None:
            sentence = f"at {finding.moment.time_s:.1f} s{line}, {sentence}"
        elif line:
            sentence = f"{line[2:]}: {sentence}"
        hint = finding.help[0] if finding.help else ""
        found.append(
            Loss(demand.points, "demand", sentence, hint, span, finding.moment, verdict.check)
        )
    return found


def _time_loss(task: Task, achieved: Achieved, lost: Fraction, hidden: Loss | None) -> Loss:
    """Return why points for speed are lost.

    Args:
        task: The task.
        achieved: What the run comes to.
        lost: The points.
        hidden: What else is wrong, if that costs too little to be shown.
    """
    if faultless(achieved) and achieved.duration_s is not None:
        took, par = beside(achieved.duration_s, exact_s(task.t_par), least=1, most=3)
        sentence = f"the program takes {took} s; full points are given up to {par} s"
        hint = "where does the arm move slowly although nothing is near?"
    else:
        sentence = "points for speed are given only when nothing else is wrong"
        hint = "mend the other losses first"
        if hidden is not None:
            sentence, hint = f"{sentence}: {hidden.sentence}", hidden.hint
    return Loss(lost, "time", sentence, hint, None, None)


def stopped_by(run: Run) -> Loss | None:
    """Return the loss of a program that did not come to its own end."""
    if run.ending in PROGRAM_ENDS:
        return None
    errors = [e for e in run.events if isinstance(e, Found) and e.diagnostic.is_error]
    errors = [e for e in errors if e.diagnostic.rule not in STOP_NOTHING]
    if not errors:
        sentence, hint = f"the program is {run.ending.value} at the end", "let it come to its end"
        if run.ending is Ending.NOT_STARTED:
            sentence, hint = "nothing was executed", "execute a program"
        return Loss(NOTHING, "program", sentence, hint, None, None)
    event = errors[-1]
    found = event.diagnostic
    sentence = f"{where(event.time_s, event.cause)}, {found.headline}"
    hint = found.help[0] if found.help else "read the error and its line"
    span = found.primary.span if found.primary else None
    return Loss(NOTHING, "program", sentence, hint, span, moment(run, event.time_s, ()))


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
