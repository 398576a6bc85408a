"""Chains that somebody asks for: why something is as it is at a time, of a thing, of a value."""

from collections.abc import Iterator

from vrts.engine.memory.cells import Array, Bound, Cell
from vrts.engine.memory.events import Grasped, HandCommanded, Released
from vrts.engine.memory.records import INSTANT
from vrts.engine.run import Run
from vrts.ir.expressions import Global, Place
from vrts.ir.values import Type
from vrts.scene.model import Mobility
from vrts.why.chain import Chain, Link, shortened
from vrts.why.hands import brought, let_go, moving_then
from vrts.why.missed import never
from vrts.why.shown import length, point, where_of
from vrts.why.slicing.entered import called
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.read import Reading
from vrts.why.slicing.sources import chain_of
from vrts.why.stopped import of_step
from vrts.why.ways import speed_of


class Unknown(ValueError):  # noqa: N818 -- names the situation
    """Nothing of this run has such a name; the text says so."""


def why_at(run: Run, time_s: float) -> Chain:
    """Return why the arm does what it does at a time: motion, hand, or what is waited for."""
    steps = Steps(run)
    return shortened(_doing(run, time_s), list(_at(steps, time_s)))


def _doing(run: Run, time_s: float) -> str:
    motion = run.motion_begun(time_s)
    where = f"at {time_s:.1f} s the tool is at {point(run.at(time_s).X_WT.translation)}"
    moves = motion is not None and time_s < motion.end_s
    return f"{where}, and {'moves' if moves else 'the arm stands still'}"


def _at(steps: Steps, time_s: float) -> Iterator[Link]:
    run = steps.run
    motion = run.motion_begun(time_s)
    if motion is not None and time_s < motion.end_s:
        yield from brought(steps, time_s)
        number = steps.motion_at(time_s)
        link = None if number is None else speed_of(steps, number)
        if link is not None:
            yield link._replace(minor=True)
        return
    step = _waiting(steps, time_s)
    if step is not None:
        reached_s = min(time_s, steps.time_of(step))  # it may be finished only later
        yield Link(reached_s, step.cause.span, "the program is at this step then")
        yield from of_step(steps, step)
        call = called(steps, step)
        if call is not None:
            yield call


def _waiting(steps: Steps, time_s: float) -> Executed | None:
    finished = steps.history.finished_at(time_s)
    return steps.step(finished + 1) or steps.step(finished)


def why_of(run: Run, name: str, time_s: float | None = None, finished: int | None = None) -> Chain:
    """Return why a thing is where it is, or a variable what it is.

    Args:
        run: What happened.
        name: Of a thing, a variable, an element, or an argument of the innermost program.
        time_s: When [s]; None: at the end.
        finished: Statements finished then, within a tick; None: all of it.

    Raises:
        Unknown: Neither the scene nor the programs know the name.
    """
    steps = Steps(run)
    time_s = run.horizon_s if time_s is None else min(time_s, run.horizon_s)
    wanted = name.strip().lower().replace(" ", "")
    for body in run.scene.bodies:
        if body.name.lower() == wanted and body.mobility is Mobility.MOVABLE:
            return _of_body(steps, body.name, time_s)
    finished = run.history.finished_at(time_s) if finished is None else finished
    cell = _cell(steps, wanted, finished)
    if cell is None:
        raise Unknown(f"neither a thing of the scene nor a variable is called `{name}`")
    place = Place(Global(cell.name, Type.DYNAMIC))
    was = Reading(place, cell, cell.at(finished), finished, None)
    if not was.known:
        effect = f"`{cell.name}` has no value"
        return shortened(effect, [])
    return shortened(f"`{cell.name}` is {where_of(was.value)}", list(chain_of(steps, was)))


def _of_body(steps: Steps, name: str, time_s: float) -> Chain:
    run = steps.run
    state = run.at(time_s)
    at = state.poses[name].translation
    effect = f"`{name}` is at {point(at)}"
    happened = [
        e
        for e in run.events
        if isinstance(e, Grasped | Released) and e.body == name and e.time_s <= time_s + INSTANT
    ]
    if not happened:
        chain = list(never(steps, name))
        return shortened(f"{effect}, where it was at the start", chain)
    last = happened[-1]
    if isinstance(last, Released):
        return shortened(effect, list(let_go(steps, last, None)))
    return shortened(f"{effect}, in the hand", list(_held(steps, last)))


def _held(steps: Steps, grip: Grasped) -> Iterator[Link]:
    span = grip.cause.span if grip.cause else None
    told = [
        e
        for e in steps.run.events
        if isinstance(e, HandCommanded)
        and e.cause == grip.cause
        and e.time_s <= grip.time_s + INSTANT  # the same step may close the hand again later
    ]
    opening = steps.run.at(min(grip.time_s, steps.run.horizon_s)).hand_opening
    says = f"the hand takes hold of it here, {length(opening)} mm wide"
    yield Link(grip.time_s, span, says)
    began = told[-1].time_s if told else grip.time_s
    moving = list(moving_then(steps, grip.time_s))
    yield from moving or brought(steps, began)


def _cell(steps: Steps, wanted: str, finished: int) -> Cell | None:
    """Return the variable of a name: an argument of the innermost program first."""
    name, bracket, subscripts = wanted.partition("[")
    activation = steps.history.robot.trace.activation(finished)
    bound: Bound | None = None
    if activation is not None:
        program = steps.history.code.programs[activation.program]
        slots = (*program.formals, *program.autos)
        bound = next(
            (b for s, b in zip(slots, activation.slots, strict=True) if s.name == name), None
        )
    bound = steps.named.get(name) if bound is None else bound
    if isinstance(bound, Array):
        numbers = subscripts.rstrip("]").split(",") if bracket else []
        if not all(n.lstrip("-").isdigit() for n in numbers):
            return None
        return bound.elements.get(tuple(int(n) for n in numbers))
    return bound if not bracket else None
