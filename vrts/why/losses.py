"""A chain of causes for every loss of a mark; without a task, for everything that went wrong."""

from fractions import Fraction

from vrts.check.goals.reached import reached
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade, Loss
from vrts.check.mark.losses import mishaps_of, stopped_by
from vrts.check.task.task import Task
from vrts.check.verdicts.vias import passed
from vrts.engine.memory.events import Found, Released
from vrts.engine.run import Run
from vrts.why.chain import Chain, Link, shortened
from vrts.why.demands import demanded
from vrts.why.hands import CLOSED_ON_NOTHING, let_go
from vrts.why.missed import missed
from vrts.why.passing import missed_point
from vrts.why.slicing.executed import Steps
from vrts.why.slow import too_slow
from vrts.why.stopped import last_error, of_step, stopped
from vrts.why.touching import contact

WAITS = "points for speed are given only when nothing else is wrong"  # no cause of its own


def chains(
    run: Run, judgement: Judgement, task: Task | None = None, grade: Grade | None = None
) -> tuple[Chain, ...]:
    """Return a chain for each loss, beside `grade.losses`; one of no links where none is known.

    Without a task: for each contact and drop, and for what stopped the program.
    """
    if grade is None or task is None:
        return tuple(chain for _, chain in alone(run, judgement))
    steps = Steps(run)
    return tuple(_chain(steps, judgement, task, loss) for loss in grade.losses)


def alone(run: Run, judgement: Judgement) -> list[tuple[float, Chain]]:
    """Return when something went wrong, whatever a task asks for, and why."""
    steps = Steps(run)
    found = [(one.time_s, one.loss) for one in mishaps_of(run, judgement)]
    stop, event = stopped_by(run), last_error(run)
    if stop is not None:
        found.append((run.horizon_s if event is None else event.time_s, stop))
    return [(time_s, _chain(steps, judgement, None, loss)) for time_s, loss in found]


def _chain(steps: Steps, judgement: Judgement, task: Task | None, loss: Loss) -> Chain:
    return shortened(loss.sentence, _links(steps, judgement, task, loss), loss.kind)


def _links(steps: Steps, judgement: Judgement, task: Task | None, loss: Loss) -> list[Link]:
    run = steps.run
    match loss.kind:
        case "program":
            event = last_error(run)
            return [] if event is None else list(stopped(steps, event))
        case "contact" | "drop":
            same = loss._replace(points=Fraction(0))
            for mishap in mishaps_of(run, judgement):
                if mishap.loss._replace(points=Fraction(0)) != same:
                    continue
                if mishap.event is not None:
                    return list(contact(steps, mishap.event))
                return _dropped(steps, mishap.time_s, loss)
            return []
        case "target":
            body = loss.moment.bodies[0] if loss.moment and loss.moment.bodies else ""
            for result in reached(run, task) if task else ():
                if result.body == body and result.share < 1:
                    return list(missed(steps, result, loss.span))
            return []
        case "via":
            points = passed(run, task) if task else None
            pairs = zip(points.visits, points.lacks, strict=True) if points else ()
            for visits, lack in pairs:
                if (
                    points
                    and lack is not None
                    and f" `{visits.via.name}` {lack.value}" in loss.sentence
                ):
                    return list(missed_point(steps, visits, lack, points))
            return []
        case "time":
            return [] if loss.sentence.startswith(WAITS) else list(too_slow(steps))
        case "limit" | "demand":
            return list(demanded(steps, loss, task))
        case _:
            return []


def _dropped(steps: Steps, time_s: float, loss: Loss) -> list[Link]:
    for event in steps.run.events:
        if (
            isinstance(event, Released)
            and event.time_s == time_s
            and f"`{event.body}`" in loss.sentence
        ):
            return list(let_go(steps, event, None))
    return []


def findings(run: Run) -> tuple[tuple[Found, Chain], ...]:
    """Return a chain for every finding of a run: for editors, beside their lines."""
    steps = Steps(run)
    found: list[tuple[Found, Chain]] = []
    for event in run.events:
        if not isinstance(event, Found) or event.cause is None:
            continue
        if event.diagnostic.rule == CLOSED_ON_NOTHING:
            continue
        step = steps.last(event.cause, event.time_s)
        links = [] if step is None else list(of_step(steps, step))
        found.append((event, shortened(event.diagnostic.headline, links)))
    return tuple(found)
