"""The state of a machine apart from the time: two that are alike go on alike.

Whatever a program, the arm, the hand or a signal will do depends on what is told here, and on the
clock. Times are told from now on: what is over is 0.
"""

from typing import TypeAlias

from vrts.engine.code.steps.motion_steps import CUT_SHORT
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.states.arm import arm
from vrts.engine.machine.states.nearly import DIGITS, NEARLY, Nearly, from_now
from vrts.engine.machine.watcher import Kept
from vrts.engine.memory.cells import Bound, Cell, Content, cells_of
from vrts.engine.memory.records import Ending, Lie, Placement
from vrts.engine.programs.context import Context
from vrts.engine.programs.frames import Frame
from vrts.engine.programs.watches import Watch
from vrts.ir import instructions as ir

MOVES = (ir.Move, ir.Depart, ir.Drive, ir.Draw, ir.Align, ir.Ready, ir.Nest)
TIMED = (ir.WaitTime, ir.MoveHand, ir.Grasp)  # instructions that wait for `Context.until`

Numbers: TypeAlias = dict[int, tuple[int, int]]
"""Of cells, by id: what an argument stands for may be the same cell as something else."""


def state(
    machine: Machine, now: float, idle: frozenset[int] = frozenset(), named: Nearly = NEARLY
) -> Kept:
    """Return the state after a tick, or within one.

    Args:
        machine: The machine.
        now: The time [s].
        idle: Numbers of variables that are left out.
        named: What stands for joints, poses and polynomials.
    """
    system, robot, process = machine.system, machine.robot, machine.process
    bound = system.memory.bound
    return Kept(
        (place(robot), place(process)),
        *programs(machine, now, named),
        arm(machine, now, named),
        (*outside(machine, now, named), *sorted(system.signals.counts.items())),
        frozenset(system.signals.on),
        tuple(() if k in idle else contents(item) for k, item in enumerate(bound)),
        system.clock_reads,
        now,
        machine.finished,
    )


def place(c: Context) -> tuple[object, ...]:
    """Return where a program is: cheap to compare."""
    return (c.ending, c.phase, c.priority, tuple([(f.program, f.index) for f in c.frames]))


def contents(bound: Bound) -> tuple[Content, ...]:
    """Return what a variable holds."""
    return (bound.value,) if isinstance(bound, Cell) else tuple(c.value for c in cells_of(bound))


def programs(
    machine: Machine, now: float, named: Nearly
) -> tuple[tuple[object, ...], tuple[object, ...]]:
    """Return where the two programs are, what they wait for, and what their own variables hold."""
    robot, process = machine.robot, machine.process
    numbers: Numbers = {}
    if any(frame.slots for c in (robot, process) for frame in c.frames):
        for k, item in enumerate(machine.system.memory.bound):
            for n, cell in enumerate(cells_of(item)):
                numbers[id(cell)] = (k, n)
    return _program(robot, now, numbers, named), _program(process, now, numbers, named)


def _program(c: Context, now: float, numbers: Numbers, named: Nearly) -> tuple[object, ...]:
    if c.ending is Ending.NOT_STARTED and not c.frames:
        return (place(c), c.program)
    motions = len(c.system.planner.given.motions)
    inner = len(c.frames) - 1
    waits = [*(frame.interrupted for frame in c.frames[1:]), None]
    return (
        place(c),
        c.running,
        c.finishing,
        from_now(c.wake, now),
        waits_for(c, inner, c.phase, c.until, now, motions),
        named(c.operands),
        c.fault.number if c.fault is not None else None,
        tuple(c.next_hand),
        tuple(_watch(watch) for watch in c.watches),
        c.reactions_wait,
        c.error_program,
        c.last_error.number if c.last_error is not None else None,
        (c.program, c.cycles_left, c.kept_cycles),
        (c.steps_left, c.at_once, c.step_was_cut),
        tuple(_frame(frame, depth, numbers) for depth, frame in enumerate(c.frames)),
        tuple(
            wait
            and (
                waits_for(c, k, wait.phase, wait.until, now, motions),
                (wait.phase, named(wait.operands), wait.priority),
                wait.fault.number if wait.fault is not None else None,
            )
            for k, wait in enumerate(waits)
        ),
    )


def _watch(w: Watch) -> tuple[object, ...]:
    kind = (w.program, w.priority, w.immediate, w.always, w.after_motion)
    return (w.signal, w.on, w.state, w.pending, kind)


def _frame(frame: Frame, depth: int, numbers: Numbers) -> tuple[object, ...]:
    """Return what a frame holds; a cell that is not global has the number of its meeting."""
    held: list[tuple[tuple[int, int], Content]] = []
    for slot in frame.slots:
        for cell in cells_of(slot):
            held.append((numbers.setdefault(id(cell), (-1 - depth, len(held))), cell.value))
    counts = tuple(len(cells_of(slot)) for slot in frame.slots)
    inside = (tuple(frame.limits), tuple(frame.increments), tuple(frame.cases))
    return (frame.kind, counts, tuple(held), inside)


def waits_for(c: Context, k: int, phase: int, until: float, now: float, motions: int) -> object:
    """Return how long the instruction that a frame is at goes on, or which motion it began."""
    if phase == 0 or k < 0:
        return None
    frame = c.frames[k]
    program = c.system.programs.loaded[frame.program].program
    instruction = program.instructions[min(frame.index, len(program.instructions) - 1)]
    if isinstance(instruction, TIMED):
        return from_now(until, now)
    return until - motions if isinstance(instruction, MOVES) and phase == CUT_SHORT else None


def outside(machine: Machine, now: float, named: Nearly) -> tuple[object, ...]:
    """Return what the hand does, where objects are, and what is set for the controller."""
    system, hand = machine.system, machine.system.hand
    closing = hand.closing
    return (
        named(hand.opening(now)),
        tuple((from_now(s.end_s, now), named(s.end_m)) for s in hand.strokes[-1:] if s.end_s > now),
        (from_now(closing.end_s, now), closing.body, closing.tested) if closing else None,
        (hand.held, hand.slips, hand.misses),
        tuple([_lies(track[-1], now, named) for track in hand.placements.values()]),
        tuple(sorted(system.switches.items())),
        tuple([(cell.name, cell.value) for cell in system.cells()]),
        tuple(sorted(system.analog.items())),
        tuple((from_now(time_s, now), *what) for time_s, *what in system.scheduled),
        (tuple(system.answers[system.answers_read :]), system.draws),
        (system.powered, system.warned),
    )


def _lies(placement: Placement, now: float, named: Nearly) -> tuple[object, ...]:
    lies = (placement.lie, named(placement.X), placement.support)
    begins = placement.start_s - now  # what falls has fallen so far
    return (*lies, round(begins, DIGITS) if placement.lie is Lie.FALLING or begins > 0.0 else 0.0)
