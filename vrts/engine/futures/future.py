"""One future: a machine that goes on until something from outside has to be decided.

Decisions are taken late, at the statement that looks, within the tick; the machine is forked there
and the tick goes on. A decision about an input holds for its tick.
"""

import math
import sys
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from vrts.base.stack import deep_stack
from vrts.engine.code.executable import Executable
from vrts.engine.futures.bare import Fresh, without_past
from vrts.engine.futures.quiet import guard, part, quick_tick, quiet
from vrts.engine.machine.forget import forget_arm_and_hand
from vrts.engine.machine.machine import Machine, statement_under_way
from vrts.engine.machine.tick import begin_tick, end_tick, go_on, skip_ahead
from vrts.engine.memory.events import Event
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.context import Context
from vrts.engine.programs.outside import FreeSignals, Kind, Outside, Question, Undecided
from vrts.ir.commands import Command, TimedCommand
from vrts.ir.module import Module
from vrts.scene.model import Scenario, Scene

UNLIMITED: Final = {
    "statements": sys.maxsize,
    "time_s": sys.maxsize,
    "motions": sys.maxsize,
    "output_characters": sys.maxsize,
}  # how long it took to come to a state is no part of it
KEPT_S = 0.1  # [s] of motion behind the present tick: more than a tick


@deep_stack()
def begin(
    module: Module,
    scene: Scene,
    scenario: Scenario,
    free: frozenset[int] = frozenset(),
    *,
    answers: bool = False,
    random: bool = False,
    grips: bool = False,
    turns: bool = False,
) -> Machine:
    """Return a machine at time 0 that keeps no past and in which nothing executes.

    Args:
        module: The programs.
        scene: Where the robot stands.
        scenario: What is not free.
        free: Inputs that are decided whenever they are looked at; analog ones are -1 to -8.
        answers: Whether answers to PROMPT are decided, once those of the scenario are used up.
        random: Whether the numbers of RANDOM are decided.
        grips: Whether it is decided for each part that the hand closes on if it is there.
        turns: Whether it is decided which of two programs goes on first in a tick.
    """
    executable = Executable(module, scenario.limits.call_depth)
    guard(executable)
    endless = replace(scenario, limits=replace(scenario.limits, **UNLIMITED))
    machine = without_past(Machine(executable, scene, endless))
    signals = machine.system.signals
    signals.on = FreeSignals(signals.on, free)
    machine.system.outside = Outside(answers=answers, random=random, grips=grips, turns=turns)
    return machine


def command(machine: Machine, order: Command) -> None:
    """Give a command that is obeyed in the next tick."""
    machine.issue((TimedCommand((machine.last_tick + 1) * machine.tick, order),))


def tick(machine: Machine) -> Question | None:
    """Go on to the end of a tick, the one under way or the next that may matter.

    Returns:
        What has to be decided before it can go on; None once the tick is over.
    """
    if machine.system.parts is not None:
        if machine.obeyed == len(machine.issued):
            is_over, question = quick_tick(machine)
            if is_over:
                return question
        else:
            part(machine)
    on = _signals(machine)
    if machine.mid is None:
        if _would_grip(machine):
            return Question(Kind.GRIP)
        on.decided.clear()
        on.looked = False
        _outside(machine).begin_again(None)
        begin_tick(machine, machine.next_tick)
        if _may_go_first(machine):
            assert machine.mid is not None
            machine.mid.process_first = None
    if machine.mid is not None and machine.mid.process_first is None:
        return Question(Kind.TURN)
    try:
        go_on(machine)
    except Undecided as undecided:
        return undecided.question
    progress, stirred = end_tick(machine)
    machine.issued, machine.obeyed = machine.issued[machine.obeyed :], 0
    if not _looks(machine, on):
        skip_ahead(machine, progress=progress, stirred=stirred)
    forget_arm_and_hand(machine, machine.now - KEPT_S)
    quiet(machine)
    return None


def decide(machine: Machine, question: Question, value: bool | str | float) -> None:
    """Answer a question of a machine, which then can go on."""
    system = machine.system
    mid = machine.mid
    if mid is not None and question.kind is not Kind.TURN:
        _outside(machine).begin_again(statement_under_way(machine))
    match question.kind, value:
        case Kind.TURN, bool():
            assert mid is not None
            mid.process_first = value
        case Kind.INPUT, bool():
            _signals(machine).decided[question.number] = value
        case Kind.ANALOG, float():
            _signals(machine).decided[-question.number] = value
        case Kind.ANSWER, str():
            part(machine)
            system.answers.append(value)
        case Kind.RANDOM, float():
            _outside(machine).draws.append(value)
        case Kind.GRIP, bool():
            part(machine)
            hand = system.hand
            _outside(machine).gripped_s = hand.grasps_s
            if not value:
                hand.miss()
        case _:
            raise TypeError(f"{value!r} is no answer to {question}")


def _would_grip(machine: Machine) -> bool:
    """Return whether the hand will have grasped something in the next tick that may be missing."""
    outside, grasps_s = _outside(machine), machine.system.hand.grasps_s
    if not outside.grips or grasps_s is None or grasps_s == outside.gripped_s:
        return False
    return grasps_s <= machine.next_tick * machine.tick


def _may_go_first(machine: Machine) -> bool:
    """Return whether it may matter which of two programs goes on first in the tick under way.

    One that is begun in this tick goes on in it only if its turn is still to come.
    """
    robot, process = machine.robot, machine.process
    return (
        _outside(machine).turns
        and robot.running
        and _is_awake(robot)
        and (not process.running or _is_awake(process))
    )


def _is_awake(c: Context) -> bool:
    """Return whether a program may go on in this tick: it waits for no time that is known."""
    return c.wake <= c.now + INSTANT or c.wake == math.inf or bool(c.watches)


def happened(machine: Machine) -> Sequence[Event]:
    """Return what has happened since this was asked last, and forget it."""
    events = machine.system.events
    assert isinstance(events, Fresh)
    return events.take()


def _outside(machine: Machine) -> Outside:
    outside = machine.system.outside
    assert outside is not None
    return outside


def _signals(machine: Machine) -> FreeSignals:
    on = machine.system.signals.on
    assert isinstance(on, FreeSignals)
    return on


def _looks(machine: Machine, on: FreeSignals) -> bool:
    """Return whether a free input is looked at again in the very next tick."""
    programs = [c for c in (machine.robot, machine.process) if c.running]
    return (on.looked and bool(programs)) or any(
        watch.signal in on.free for c in programs for watch in c.watches
    )
