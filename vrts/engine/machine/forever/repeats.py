"""States that come again: what happened once from there on happens for ever.

Brent's method: a state is kept, and compared with later ones until a power of two of ticks has
passed; then a later one is kept. A loop that reads a clock or random numbers, or that an input
still to change may end, is never called endless. Where the other program cannot change anything
that the robot program looks at on its way round, the robot program is compared alone.
"""

from typing import NamedTuple

from vrts.engine.code.values.operands import number_of
from vrts.engine.machine.forever.idle import idle
from vrts.engine.machine.forever.nodes import tops
from vrts.engine.machine.forever.reach import ahead
from vrts.engine.machine.forever.touches import Looks, changes_of, looks_of, passed
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.schedule import changes_to_come
from vrts.engine.machine.states.arm import arm
from vrts.engine.machine.states.state import contents, place, state
from vrts.engine.machine.watcher import Kept
from vrts.engine.memory.cells import Cell, Content
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir

MOST_LOOKED_AT = 5000  # statements of a loop that are gone through
STARTS = (ir.StartProcess, ir.Prompt)  # depend on the other program


class Repetition(NamedTuple):
    """Everything is, or all that matters to the robot program is, as it was at an earlier time."""

    kept: Kept
    now_s: float
    round: tuple[int, ...]  # numbers of the robot program's instructions since, in order
    alone: bool = False  # the other program is elsewhere, which does not matter


def repetition(machine: Machine, now: float) -> Repetition | None:
    """Return a repetition, if there is one; ask after every tick run."""
    watcher = machine.watcher
    if changes_to_come(machine) or machine.stopped is not None or machine.robot.finishing:
        watcher.begin()
        return None
    kept = watcher.kept
    found = None
    if kept is not None:
        if _may_repeat(machine, kept):
            if _alike(kept, state(machine, now, _idle(machine))):
                return Repetition(kept, now, _round(machine, kept))
            watcher.witness = _difference(machine, kept)
        elif machine.process.running:
            found = _alone(machine, kept, now)
    watcher.left -= 1
    if watcher.left <= 0:
        watcher.keep(state(machine, now, _idle(machine)))
    return found


def is_moment(machine: Machine) -> bool:
    """Return whether a state was kept just now: at such moments more than usual is looked at."""
    return machine.watcher.left == machine.watcher.power


def instructions(machine: Machine, numbers: tuple[int, ...]) -> list[ir.Instruction]:
    """Return instructions by their numbers, each once."""
    found: list[ir.Instruction] = []
    wanted = set(numbers)
    for loaded in machine.system.programs.loaded:
        inside = range(loaded.base, loaded.base + len(loaded.program.instructions))
        found += [loaded.program.instructions[k - loaded.base] for k in inside if k in wanted]
    return found


def executed(machine: Machine, c: Context, finished: int) -> tuple[int, ...]:
    """Return the numbers of what a program executed since so many statements were finished."""
    begin, stop = c.trace.executed(finished), c.trace.executed(machine.finished)
    return tuple(c.trace.instructions[begin:stop])


def _idle(machine: Machine) -> frozenset[int]:
    known = machine.watcher.idle
    if known is None or known[0] is not machine.executable:
        known = machine.watcher.idle = (machine.executable, idle(machine.executable))
    return known[1]


def _may_repeat(machine: Machine, kept: Kept) -> bool:
    """Return whether a quick look finds no difference to a state that was kept."""
    witness = machine.watcher.witness
    return (
        kept.clock_reads == machine.system.clock_reads
        and kept.places == (place(machine.robot), place(machine.process))
        and (witness is None or witness[0].value == witness[1])
    )


def _alike(one: Kept, other: Kept) -> bool:
    return one[:7] == other[:7]


def _difference(machine: Machine, kept: Kept) -> tuple[Cell, Content] | None:
    """Return a variable that has changed, most likely not for the last time, and what it was."""
    unread = _idle(machine)
    for k, (bound, values) in enumerate(
        zip(machine.system.memory.bound, kept.values, strict=False)
    ):
        if k not in unread and isinstance(bound, Cell) and (bound.value,) != values:
            return bound, values[0]
    return None


def _round(machine: Machine, kept: Kept) -> tuple[int, ...]:
    return executed(machine, machine.robot, kept.finished)


# --- the robot program alone ----------------------------------------------------------------------


def _alone(machine: Machine, kept: Kept, now: float) -> Repetition | None:
    """Return a repetition of the robot program alone, where nothing can come from the other."""
    watcher, robot = machine.watcher, machine.robot
    if not watcher.tries or kept.places[0] != place(robot):
        return None
    if robot.trace.executed(kept.finished) == robot.trace.executed(machine.finished):
        return None
    if kept.arm != arm(machine, now):
        return None
    watcher.tries -= 1
    passes = _round(machine, kept)
    if len(passes) > MOST_LOOKED_AT:
        return None
    code = instructions(machine, passes)
    aliases = passed(machine.executable.module)
    looks = looks_of((top for one in code for top in tops(one)), aliases)
    if looks.clock or any(isinstance(one, STARTS) for one in code):
        return None
    looks = _also_watched(looks, robot, code)
    if changes_of(ahead(machine.process), aliases).touch(looks):
        return None
    known = state(machine, now, frozenset())
    if (kept.robot, kept.outside) != (known.robot, known.outside):
        return None
    if _signals(kept, looks) != _signals(known, looks) or not _same_values(machine, kept, looks):
        return None
    return Repetition(kept, now, passes, alone=True)


def _also_watched(looks: Looks, c: Context, code: list[ir.Instruction]) -> Looks:
    """Return looks with those at signals that reactions are for, and at the arm that moves."""
    begun = [number_of(one.signal) for one in code if isinstance(one, ir.React)]
    watched = {watch.signal for watch in c.watches} | {abs(n) for n in begun if n is not None}
    any_signal = looks.any_signal or None in begun
    return looks._replace(signals=looks.signals | watched, any_signal=any_signal, arm=True)


def _signals(kept: Kept, looks: Looks) -> frozenset[int]:
    return kept.signals if looks.any_signal else kept.signals & looks.signals


def _same_values(machine: Machine, kept: Kept, looks: Looks) -> bool:
    """Return whether what is looked at has the values that were kept."""
    bound, unread = machine.system.memory.bound, _idle(machine)
    numbers = machine.executable.layout.numbers
    wanted = [numbers[name] for name in looks.names if name in numbers]
    return all(
        k in unread or (k < len(kept.values) and kept.values[k] == contents(bound[k]))
        for k in wanted
    )
