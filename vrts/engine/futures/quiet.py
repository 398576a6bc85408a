"""Machines in which one program works with numbers and signals only, and nothing else changes.

Copies of such a machine share arm, hand and settings, and its ticks need no look at these. Before
a statement that may change something of them the machine has its own again.
"""

import math
from functools import partial

from vrts.engine.code.closures import Step
from vrts.engine.code.executable import Executable
from vrts.engine.faults import RuntimeFault
from vrts.engine.machine.execution import run_frame
from vrts.engine.machine.machine import Machine, MidTick
from vrts.engine.machine.reacting import catch, react
from vrts.engine.memory.cells import Bound
from vrts.engine.memory.records import INSTANT, Ending, Lie
from vrts.engine.motion.planner import Planner
from vrts.engine.programs.context import Context
from vrts.engine.programs.outside import FreeSignals, Question, Undecided
from vrts.engine.programs.system import System
from vrts.ir import instructions as ir

# what changes nothing but variables, signals, the place in the program and what is written
HARMLESS = (
    *(ir.Jump, ir.JumpIf, ir.Assign, ir.BeginFor, ir.TestFor, ir.NextFor, ir.BeginCase),
    *(ir.TestCase, ir.Wait, ir.WaitTime, ir.Signal, ir.SetBits, ir.Reset, ir.Type),
)


def guard(executable: Executable) -> None:
    """Let every step that may change what machines share part them first."""
    executable.steps = tuple(
        tuple(
            _guarded(instruction, step)
            for instruction, step in zip(known.program.instructions, steps, strict=True)
        )
        for known, steps in zip(executable.programs.loaded, executable.steps, strict=True)
    )


def _guarded(instruction: ir.Instruction, step: Step) -> Step:
    if isinstance(instruction, HARMLESS):
        return step
    before = _own_arm if isinstance(instruction, ir.Delay) else _own

    def guarded(c: Context) -> int:
        if c.system.parts is not None:
            before(c)
        return step(c)

    return guarded


def _own(c: Context) -> None:
    assert c.system.parts is not None
    c.system.parts()


def _own_arm(c: Context) -> None:
    """Part for a DELAY: it changes until when the arm is held, and may use up settings."""
    planner = Planner.__new__(Planner)
    planner.__dict__.update(c.planner.__dict__)
    if planner.settings.next:
        planner.settings = planner.settings.copy()
    c.system.planner = c.planner = planner


def part(machine: Machine) -> None:
    """Have everything for itself from now on."""
    system = machine.system
    if system.parts is None:
        return
    system.own()
    machine.robot.attach(system)
    machine.process = machine.process.copy(system, {})
    machine.watcher = machine.watcher.copy()
    machine.wire()


def quiet(machine: Machine) -> None:
    """Let a machine share with its copies what does not change, if that is so now."""
    if _is_quiet(machine, machine.system, machine.robot):
        machine.system.parts = partial(part, machine)


def fork(machine: Machine) -> Machine:
    """Return a copy, which shares what does not change."""
    if machine.system.parts is None:
        return machine.copy()
    other = Machine.__new__(Machine)
    other.__dict__.update(machine.__dict__)
    copies: dict[int, Bound] = {}
    system = other.system = machine.system.half_copied(copies)
    robot = other.robot = machine.robot.copy(system, copies)
    robot.robot, robot.process = robot, machine.process
    if machine.mid is not None:
        other.mid = machine.mid.copy()
    system.events.counted = other.counted
    system.parts = partial(part, other)
    return other


def let_go(machine: Machine) -> None:
    """Take a machine apart that nobody needs any more, so that its memory is free at once.

    Its parts know each other: without this they would lie about until Python looks for such.
    """
    system, robot = machine.system, machine.robot
    system.events.counted = _nobody
    del robot.robot, robot.process
    if system.parts is None:
        del machine.process.robot, machine.process.process
    system.parts = None


def quick_tick(machine: Machine) -> tuple[bool, Question | None]:
    """Go on to the end of a tick of a quiet machine.

    Returns:
        Whether it is over, or has come to a question; else it is a machine as any other now, in
        the middle of a tick. And that question.
    """
    system, c, mid = machine.system, machine.robot, machine.mid
    on = system.signals.on
    assert isinstance(on, FreeSignals)
    if mid is None:
        assert system.outside is not None
        on.decided.clear()
        on.looked = False
        system.outside.begin_again(None)
        tick = machine.next_tick
        machine.last_tick, machine.next_tick = tick, tick + 1
        c.now = now = tick * machine.tick
        mid = machine.mid = MidTick(machine.finished, system.signals.changes)
        if c.wake <= now + INSTANT or c.wake == math.inf:
            c.wake = now
            mid.steps = machine.scene.controller.programs.steps_a_tick
    if mid.steps is not None:
        question = _go_on(machine, system, c, mid, mid.steps)
        if question is not None:
            return True, question
        if system.parts is None:
            return False, None
    machine.mid = None
    wake = c.wake
    waits = wake > c.now and not (wake == math.inf and machine.finished != mid.finished)
    if waits and wake < math.inf and not on.looked:
        machine.next_tick = max(machine.next_tick, machine.tick_of(wake))
    return True, None


def _go_on(
    machine: Machine, system: System, c: Context, mid: MidTick, left: int
) -> Question | None:
    """Execute statements; return what has to be decided. `mid` tells how many may follow."""
    before = machine.finished
    try:
        unused = run_frame(machine, c, left)
    except Undecided as undecided:
        mid.steps = left - (machine.finished - before)
        return undecided.question
    except RuntimeFault as fault:
        part(machine)
        catch(machine, c, fault)
        mid.steps = left - 1
    else:
        goes_on = unused or machine.finished - before >= left
        mid.steps = unused if goes_on else 0
    if system.parts is None and mid.steps > 0 and c.running:
        react(machine, c, look=False)
    return None


def _is_quiet(machine: Machine, system: System, c: Context) -> bool:
    """Return whether nothing moves, nothing is due, and only the robot program executes."""
    planner, hand, now = system.planner, system.hand, machine.now
    if (
        c.ending is not Ending.RUNNING
        or c.watches
        or planner.pending is not None
        or machine.process.frames
        or machine.process.ending is not Ending.NOT_STARTED
    ):
        return False
    settled_s = planner.scale.time(planner.given.end_s) + planner.settling_s
    return (
        max(settled_s, planner.braking_until, planner.scale.knots[-1].time_s) <= now
        and machine.arrived == len(planner.given.motions)
        and _is_alone(machine, system, c)
        and hand.closing is None
        and not (hand.strokes and hand.strokes[-1].end_s > now)
        and all(
            track[-1].start_s <= now and track[-1].lie is not Lie.FALLING
            for track in hand.placements.values()
        )
    )


def _is_alone(machine: Machine, system: System, c: Context) -> bool:
    """Return whether nobody but the program itself may do something to it."""
    scenario = machine.scenario
    return (
        machine.mid is None
        and not machine.closed
        and machine.obeyed == len(machine.issued)
        and machine.stopped is None
        and not (system.outside is not None and system.outside.turns)
        and not system.scheduled
        and not system.tracing
        and system.answers_read == len(system.answers)
        and system.signals.next_input_s is None
        and machine.faults_done == len(scenario.faults)
        and machine.turns_done == len(scenario.process_first)
        and not machine.sensing.sensors
        and not (c.finishing or c.next_hand or c.at_once)
        and c.steps_left is None
        and c.fault is None
        and c.error_program is None
    )


def _nobody() -> int:
    """Count no statements."""
    return 0
