"""What a program waits for, and whether it may still come."""

from typing import NamedTuple

from vrts.engine.code.values.operands import number_of
from vrts.engine.machine.forever.reach import ahead
from vrts.engine.machine.forever.touches import Looks, changes_of, looks_of, passed
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.schedule import at_rest_s, changes_to_come, next_event_s
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.context import Context
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Expression, Function


class Waiting(NamedTuple):
    """A program that waits."""

    looks: Looks
    answer: bool = False  # for a line of the terminal


def waiting(machine: Machine, c: Context) -> Waiting | None:
    """Return what a program waits for; None when it goes on by itself, or when the arm does."""
    if not c.running or not c.frames or c.wake <= c.now + INSTANT:
        return None
    frame = c.frames[-1]
    instruction = machine.system.programs.loaded[frame.program].program.instructions[frame.index]
    match instruction:
        case ir.Wait(condition=condition) if condition is not None:
            looks = looks_of((condition,), passed(machine.executable.module))
            return Waiting(_not_yet(machine, condition, looks))
        case ir.Prompt():
            return Waiting(Looks(), answer=True)
        case _:
            return None


def is_hopeless(machine: Machine, now: float) -> bool:
    """Return whether the robot program waits for what the other one will never bring about."""
    robot, process = machine.robot, machine.process
    found = waiting(machine, robot)
    if found is None or not _is_quiet(machine, now):
        return False
    if found.answer and machine.system.answers_read < len(machine.system.answers):
        return False
    changes = changes_of(ahead(process), passed(machine.executable.module))
    for watch in robot.watches:
        comes = changes.any_signal or watch.signal in changes.signals
        if watch.priority > robot.priority and (watch.pending or comes):
            return False  # a reaction may do anything
    return not (found.looks.clock or changes.touch(found.looks))


def _is_quiet(machine: Machine, now: float) -> bool:
    """Return whether arm, hand and the outside change nothing any more."""
    return (
        not changes_to_come(machine)
        and next_event_s(machine) is None
        and at_rest_s(machine) <= now + INSTANT
    )


def _not_yet(machine: Machine, condition: Expression, looks: Looks) -> Looks:
    """Return what is looked at without signals that are as a plain SIG wants them already."""
    if not (isinstance(condition, Apply) and condition.function is Function.SIG):
        return looks
    on = machine.system.signals.on
    numbers = [number_of(argument) for argument in condition.arguments]
    missing = {abs(n) for n in numbers if n is not None and (abs(n) in on) is not (n > 0)}
    return looks._replace(signals=frozenset(missing))
