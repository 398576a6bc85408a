"""Whether the robot program ever ends, judged after every tick.

The judgement is a convenience: it ends hopeless runs early. A fault of it is told, and the run
goes on to its limits; no mark is lost by it.
"""

import math

from vrts.base.diagnostic import Diagnostic
from vrts.engine.machine.forever.blame import waits
from vrts.engine.machine.forever.findings import goes_on, repeated, stuck
from vrts.engine.machine.forever.repeats import is_moment, repetition
from vrts.engine.machine.forever.waits import is_hopeless
from vrts.engine.machine.machine import Machine

LOOKS = 16  # ticks between looks at whether one who waits does so in vain
FAULTS = (
    ArithmeticError,
    AssertionError,
    AttributeError,
    LookupError,
    RuntimeError,
    TypeError,
    ValueError,
)  # what a mistake in the judgement may raise


def judge(machine: Machine, now: float) -> Diagnostic | None:
    """Return why the robot program never ends, if that is sure; ask after every tick run.

    What is kept to compare with is the same whether further commands may come or not; only where
    none will is anything said.
    """
    watcher = machine.watcher
    if watcher.broken:
        return None
    try:
        found = repetition(machine, now)
        if not machine.closed:
            return None
        if found is not None:
            return repeated(machine, found)
        if is_moment(machine) and is_hopeless(machine, now):
            return stuck(machine, now, goes_on(machine, now), waits(machine, machine.robot))
    except FAULTS as fault:
        watcher.broken = f"{type(fault).__name__}: {fault}"
    return None


def stopped(machine: Machine, now: float) -> Diagnostic:
    """Return why the robot program never ends where no program can go on any more."""
    why: tuple[str, ...] = ()
    try:
        why = waits(machine, machine.robot)
    except FAULTS as fault:
        machine.watcher.broken = f"{type(fault).__name__}: {fault}"
    return stuck(machine, now, why=why)


def waits_in_vain(machine: Machine) -> bool:
    """Return whether a robot program that waits does so until a command comes."""
    process = machine.process
    if not machine.robot.running:
        return True
    if not process.running or process.wake == math.inf:
        stirred = bool(machine.ticks) and machine.ticks[-1] == machine.last_tick
        return not (stirred and process.finished == machine.finished)  # it may not have seen that
    if machine.last_tick % LOOKS:
        return False
    try:
        return is_hopeless(machine, machine.now)
    except FAULTS:
        return True  # rather ask the operator too early than never
