"""Loops and waits that never end: what leads out of them, and that nothing changes what it asks."""

from collections.abc import Iterator
from typing import NamedTuple, cast

from vrts.engine.memory.events import SignalChanged
from vrts.ir.control import Jump, JumpIf, TestFor, Wait
from vrts.ir.expressions import Apply, Function
from vrts.why.chain import Link
from vrts.why.shown import value
from vrts.why.slicing.executed import Executed, Steps
from vrts.why.slicing.read import Reading, number, places_in, reading
from vrts.why.slicing.sources import chain_of, element_text

OUTPUTS = 1000  # signals above it are inputs
LONGEST = 4000  # statements in which a round of a loop is looked for


class Round(NamedTuple):
    """One time through a loop."""

    steps: tuple[Executed, ...]

    @property
    def inside(self) -> frozenset[int]:
        """Which instructions it executes."""
        return frozenset(step.at for step in self.steps)


def endless(steps: Steps) -> Iterator[Link]:
    """Yield what would lead out of a loop that never ends, and why it does not."""
    round_ = _last_round(steps)
    if not round_.steps:
        return
    leaving = [step for step in round_.steps if _leaves(steps, round_, step)]
    if not leaving:
        back = [s for s in round_.steps if isinstance(s.instruction, Jump)]
        last = back[-1] if back else round_.steps[-1]
        yield Link(None, last.cause.span, "no step leads out of this loop")
        return
    for step in reversed(leaving):
        found = list(asks(steps, step, round_))
        if found:
            yield from found
            return
    last = leaving[-1]
    alike = "this is asked each time, and always answered alike"
    if not any(True for _ in places_in(getattr(last.instruction, "condition", ()))):
        alike += ": it goes by no variable"
    yield Link(None, last.cause.span, alike)


def goes_round(steps: Steps) -> bool:
    """Return whether the robot program does the same steps again and again at its end."""
    robot = steps.of_robot[-LONGEST:]
    return bool(robot) and sum(step.at == robot[-1].at for step in robot) > 1


def asks(steps: Steps, step: Executed, round_: Round | None = None) -> Iterator[Link]:
    """Yield what a condition goes by, and where that was written last."""
    first = round_.steps[0].number if round_ is not None and round_.steps else None
    found = [r for r in _condition(steps, step) if r.known]
    still = [r for r in found if first is not None and _last_written(r) < first]
    in_vain = [r for r in found if first is not None and _last_written(r) >= first]
    for each in (in_vain or still or found)[:1]:
        name = element_text(each.place)
        says = f"`{name}` is {value(each.value)} here"
        if in_vain:  # what the loop works on is more to blame than what it goes by
            says += (
                " each time, whatever the loop does to it" if _as_before(steps, each, step) else ""
            )
        elif still:
            says += f" each time, and no step of the loop changes `{name}`"
        yield Link(None, step.cause.span, says)
        yield from chain_of(steps, each)
        return
    yield from signals(steps, step, again=first is not None)


def signals(steps: Steps, step: Executed, *, again: bool = False) -> Iterator[Link]:
    """Yield how the signals stand that a step asks for, and what switched them last."""
    for asked in _signals_in(getattr(step.instruction, "condition", None)):
        wanted = number(steps, asked, step.number - 1, step.activation)
        if wanted is None:
            continue
        number_ = abs(round(wanted))
        time_s = steps.time_of(step)
        on = number_ in steps.run.at(min(time_s, steps.run.horizon_s)).signals
        how = "on" if on else "off"
        changes = [
            e
            for e in steps.run.events
            if isinstance(e, SignalChanged) and e.signal == number_ and e.time_s <= time_s
        ]
        each_time = " each time" if again else ""
        says = f"signal {number_} is {how}{each_time}"
        if changes:
            last = changes[-1]
            yield Link(None, step.cause.span, says)
            span = None if last.cause is None else last.cause.span
            yield Link(last.time_s, span, f"it is switched {how} here last")
        else:
            who = "nothing outside" if number_ > OUTPUTS else "no step"
            other = "off" if on else "on"
            says += f": {who} switches it {other}"
            yield Link(None, step.cause.span, says)
        return


def _signals_in(node: object) -> Iterator[object]:
    """Yield the numbers of signals that an expression asks for."""
    if isinstance(node, Apply) and node.function is Function.SIG:
        yield from node.arguments
    elif isinstance(node, tuple):
        for part in cast("tuple[object, ...]", node):
            yield from _signals_in(part)


def _last_round(steps: Steps) -> Round:
    """Return the last time through what the robot program does again and again at its end.

    It is the longest piece of its record that is there twice in a row; where none is, all since
    the last step was executed first.
    """
    robot = steps.of_robot[-LONGEST:]
    ats = [step.at for step in robot]
    if not ats:
        return Round(())
    same = [k for k in range(len(ats) - 1) if ats[k] == ats[-1]]
    for k in same:
        length = len(ats) - 1 - k
        if 2 * length <= len(ats) and ats[-length:] == ats[-2 * length : -length]:
            return Round(robot[-length:])
    return Round(robot[same[0] + 1 :] if same else robot)


def _leaves(steps: Steps, round_: Round, step: Executed) -> bool:
    """Return whether a step could lead out of a loop: to what lies beyond it, and is never done."""
    base = steps.base_of(step.at)
    program = steps.program_of(step.at)[0]
    last = base + len(program.instructions)
    here = [at for at in round_.inside if base <= at < last]
    match step.instruction:
        case JumpIf(target=target):
            following = (base + target, step.at + 1)
        case TestFor(leave=leave):
            following = (base + leave, step.at + 1)
        case Wait():
            return True
        case _:
            return False
    return any(not min(here) <= at <= max(here) for at in following)


def _condition(steps: Steps, step: Executed) -> tuple[Reading, ...]:
    instruction = step.instruction
    asked = getattr(instruction, "condition", None)
    places = (instruction.place,) if isinstance(instruction, TestFor) else places_in(asked)
    return tuple(reading(steps, p, step.number - 1, step.activation) for p in places)


def _as_before(steps: Steps, each: Reading, step: Executed) -> bool:
    """Return whether a variable was the same when the step was executed the time before."""
    times = [n for n in steps.times(step.at) if n < step.number]
    return bool(times) and each.cell is not None and each.cell.at(times[-1] - 1) == each.value


def _last_written(each: Reading) -> int:
    since = [] if each.cell is None else [n for n in each.cell.since if n <= each.before]
    return since[-1] if since else 0
