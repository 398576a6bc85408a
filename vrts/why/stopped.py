"""Programs that stop: the step, what it read, and where that came from."""

import math
from collections.abc import Iterator
from difflib import get_close_matches

from vrts.base.pose import Pose, rotation_angle
from vrts.engine.faults import LINE_FROM_SINGULARITY
from vrts.engine.memory.events import Found
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.control import Wait
from vrts.ir.motion import Depart, Draw, Drive, Interpolation, Move
from vrts.why.chain import Link
from vrts.why.loops.endless import endless, goes_round, signals
from vrts.why.shown import where_of
from vrts.why.slicing.entered import called, reacted
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.given import is_given
from vrts.why.slicing.read import Reading, element, places_in, readings
from vrts.why.slicing.sources import chain_of, passed
from vrts.why.slow import too_slow
from vrts.why.ways import FAR_ROUND, decided, leads, way_begins

LIKE = 0.75  # of two names: one may be meant for the other [assumed]


def last_error(run: Run) -> Found | None:
    """Return the error that stopped a program."""
    errors = [e for e in run.events if isinstance(e, Found) and e.diagnostic.is_error]
    return errors[-1] if errors else None


def stopped(steps: Steps, event: Found) -> Iterator[Link]:
    """Yield why a program stopped: what the step read that failed."""
    step = steps.waiting(event.cause) or steps.last(event.cause, event.time_s)
    waits = step is not None and isinstance(step.instruction, Wait)
    if steps.run.ending is Ending.LIMIT and not waits:
        yield from endless(steps) if goes_round(steps) else too_slow(steps)
        return
    if step is None:
        return
    if event.diagnostic.rule == LINE_FROM_SINGULARITY:
        yield from _from_here(steps, event.time_s)
        return
    yield from of_step(steps, step)


def _from_here(steps: Steps, time_s: float) -> Iterator[Link]:
    """Yield how the arm came to where no line can start."""
    number = steps.motion_at(time_s)
    if number is None:
        yield Link(None, None, "no motion came before: the arm stands as it stood at the start")
        return
    yield leads(steps, number)
    yield from decided(steps, number)


def of_step(steps: Steps, step: Executed) -> Iterator[Link]:
    """Yield where the values came from that a step read, those without a value first."""
    found = readings(steps, step)
    unknown = [r for r in found if not r.known]
    for each in unknown:
        real = element(steps, each.place, each.before, each.activation)
        yield from _unset(steps, each, real)
        return
    known = [r for r in found if r.known]
    target = known[:1] if isinstance(step.instruction, Move) else known
    turned = list(_turned(steps, step, target[0])) if target else []
    at_start = bool(turned) and is_given(steps, target[0])
    if not at_start:  # of a way that turns, the end that is as the scene gives it comes first
        yield from turned[:1]
    for each in target[:2]:
        links = chain_of(steps, each)
        yield from (link._replace(minor=link.minor or at_start) for link in links)
    if at_start:
        yield from turned
    if isinstance(step.instruction, Wait):
        yield from signals(steps, step)
    if isinstance(step.instruction, Move | Depart | Draw | Drive) and not target:
        yield from _from_where(steps, step)
    call = called(steps, step)
    if call is not None and not target:
        yield call
    yield from reacted(steps, step)


def _turned(steps: Steps, step: Executed, target: Reading) -> Iterator[Link]:
    """Yield where a straight line would have begun that turns the tool far, and why there."""
    instruction = step.instruction
    straight = isinstance(instruction, Move) and instruction.interpolation is Interpolation.LINEAR
    number = _before(steps, step)
    if not straight or number is None or not isinstance(target.value, Pose):
        return
    motion = steps.run.motions[number]
    turn = math.degrees(rotation_angle(motion.X_WT.rotation, target.value.rotation))
    if turn < FAR_ROUND:
        return
    yield from way_begins(steps, number + 1, turn)


def _from_where(steps: Steps, step: Executed) -> Iterator[Link]:
    """Yield where a motion would have begun whose numbers stand in its own line."""
    number = _before(steps, step)
    if number is None:
        return
    motion = steps.run.motions[number]
    says = f"the way begins at {where_of(motion.X_WT)}, where this step leads"
    yield Link(motion.start_s, motion.cause.span, says)
    yield from decided(steps, number)


def _before(steps: Steps, step: Executed) -> int | None:
    """Return the motion before that of a step, which may have begun."""
    number = steps.motion_at(steps.time_of(step))
    while number and steps.run.motions[number].cause == step.cause:
        number -= 1  # what there is of the way itself
    return number


def _unset(steps: Steps, each: Reading, real: str) -> Iterator[Link]:
    """Yield which variable had no value, and by which subscripts it was chosen."""
    yield from chain_of(steps, each)
    variable = each.place.variable
    number = getattr(variable, "number", None)
    inner: Reading | None = each
    if isinstance(number, int):
        alias = passed(steps, number, variable.name, each.activation)
        inner = None if alias is None else alias.inner
    if inner is not None and not inner.place.subscripts:
        yield Link(None, None, f"no step and no line of data gives `{real}` a value")
        yield from _meant(steps, real)


def _meant(steps: Steps, name: str) -> Iterator[Link]:
    """Yield a line of data with nearly the same name that nothing reads."""
    read = {
        place.variable.name
        for program in steps.history.code.programs
        for instruction in program.instructions
        for place in places_in(tuple(instruction))
    }
    unread = [each for each in steps.data if each.partition("[")[0] not in read]
    for each in get_close_matches(name, unread, n=1, cutoff=LIKE):
        says = f"`{each}` has a value here, and no step reads it"
        yield Link(None, steps.data[each].span, says)
