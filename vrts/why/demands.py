"""Demands of a task and limits of the robot as effects: what led there, or when it was decided."""

import math
from collections.abc import Iterator

from vrts.base.pose import rotation_angle
from vrts.base.source import Span
from vrts.check.mark.grade import Loss
from vrts.check.task.demands import DEMAND, Demand, Keeps
from vrts.check.task.task import Task
from vrts.ir.module import Program
from vrts.why.chain import Link
from vrts.why.left_out import skipped
from vrts.why.shown import point
from vrts.why.slicing.executed import Steps
from vrts.why.ways import FAR_ROUND, decided, speed_of, way_begins


def demanded(steps: Steps, loss: Loss, task: Task | None = None) -> Iterator[Link]:
    """Yield what led to a demand that is not kept, or a limit that is broken."""
    if loss.moment is None:
        found = task.demands if task is not None else ()
        for demand in found:
            if DEMAND + demand.name == loss.check:
                yield from _of_text(steps, demand, loss.span)
        return
    time_s = loss.moment.time_s
    number = steps.motion_at(time_s)
    if number is None:
        return
    run = steps.run
    motion = run.motions[number]
    start = run.at(min(motion.start_s, run.horizon_s)).X_WT.translation
    says = f"the tool is on its way from {point(start)} to {point(motion.X_WT.translation)}"
    before = run.at(min(motion.start_s, run.horizon_s)).X_WT
    turned = math.degrees(rotation_angle(before.rotation, motion.X_WT.rotation))
    if turned > 1.0:
        says += f", and turns by {turned:.0f} degrees"
    yield Link(motion.start_s, motion.cause.span, says)
    if loss.kind == "limit":
        link = speed_of(steps, number)
        if link is not None:
            yield link
    yield from decided(steps, number)
    if turned > FAR_ROUND:
        yield from way_begins(steps, number)


def _of_text(steps: Steps, demand: Demand, span: Span | None) -> Iterator[Link]:
    """Yield when it was decided that a program does not keep to a rule about its text."""
    match demand.keeps:
        case Keeps.USES if span is None:
            over = steps.run.ended_s or steps.run.horizon_s
            last = steps.of_robot[-1].cause.span if steps.of_robot else None
            says = f"the program is over here, and no step of the file is {demand.word}"
            yield Link(over, last, says)
        case Keeps.USES:
            yield Link(None, span, "this step is never carried out")
            for program, base, index in _where(steps, span):
                yield from skipped(steps, program, base, index)
        case Keeps.AVOIDS:
            times = [n for _, base, k in _where(steps, span) for n in steps.times(base + k)]
            time_s = steps.history.time_of(times[0]) if times else None
            more = "" if times else ", though it is never carried out: the text counts"
            yield Link(time_s, span, f"{demand.word} is used here{more}")
        case Keeps.STEPS:
            yield Link(None, None, "all steps of the file count, also those of programs not called")
        case _:
            return


def _where(steps: Steps, span: Span | None) -> Iterator[tuple[Program, int, int]]:
    """Yield where the instructions of a line are: program, first number, index."""
    code = steps.history.code
    for program, base in zip(code.programs, code.bases, strict=True):
        for index, cause in enumerate(program.origins):
            if span is not None and cause.span.line == span.line:
                yield program, base, index
                return
