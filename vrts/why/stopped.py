"""Programs that stop, loops that never end: the step, what it read, and where that came from."""

from collections.abc import Iterator

from vrts.engine.faults import LINE_FROM_SINGULARITY
from vrts.engine.memory.events import Found
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.control import JumpIf, TestFor, Wait
from vrts.ir.expressions import Place
from vrts.ir.motion import Move
from vrts.why.chain import Link
from vrts.why.entered import called, reacted
from vrts.why.executed import Executed, Steps
from vrts.why.read import Reading, element, places_in, reading, readings
from vrts.why.shown import value
from vrts.why.sources import chain_of, element_text, passed
from vrts.why.ways import decided, leads

RECENT = 200  # statements looked at for what decides an endless loop


def last_error(run: Run) -> Found | None:
    """Return the error that stopped a program."""
    errors = [e for e in run.events if isinstance(e, Found) and e.diagnostic.is_error]
    return errors[-1] if errors else None


def stopped(steps: Steps, event: Found) -> Iterator[Link]:
    """Yield why a program stopped: what the step read that failed."""
    if steps.run.ending is Ending.LIMIT:
        yield from endless(steps)
        return
    step = steps.last(event.cause, event.time_s)
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
    for each in target[:2]:
        yield from chain_of(steps, each)
    call = called(steps, step)
    if call is not None and not target:
        yield call
    yield from reacted(steps, step)


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


def endless(steps: Steps) -> Iterator[Link]:
    """Yield what the tests of a loop that never ends go by, and where that was written last."""
    finished = steps.history.finished
    seen: set[str] = set()
    for number in range(finished, max(finished - RECENT, 0), -1):
        step = steps.step(number)
        if step is None or not isinstance(step.instruction, JumpIf | TestFor | Wait):
            continue
        for place in _condition(step):
            was = reading(steps, place, step.number - 1, step.activation)
            name = element_text(place)
            if not was.known or name in seen:
                continue
            seen.add(name)
            says = f"`{name}` is {value(was.value)} here, each time"
            yield Link(None, step.cause.span, says)
            yield from chain_of(steps, was)
            return


def _condition(step: Executed) -> tuple[Place, ...]:
    instruction = step.instruction
    if isinstance(instruction, TestFor):
        return (instruction.place,)
    return tuple(places_in(getattr(instruction, "condition", None)))
