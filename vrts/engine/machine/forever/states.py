"""The state of a machine apart from the time: two that are alike go on alike.

Whatever a program, the arm, the hand or a signal will do depends on what is told here, and on the
clock. Times are told from now on: what is over is 0.
"""

from typing import TypeAlias

from vrts.engine.code.steps.motion_steps import CUT_SHORT
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.watcher import Kept
from vrts.engine.memory.cells import Bound, Cell, Content, cells_of
from vrts.engine.memory.records import Lie, Motion, Placement
from vrts.engine.programs.context import Context
from vrts.engine.programs.frames import Frame
from vrts.engine.programs.watches import Watch
from vrts.ir import instructions as ir

DIGITS = 7  # of times [s]: what rounding leaves of the same time is the same
LEGS = 3  # motions that shape the one under way: a corner is made of the two before it
MOVES = (ir.Move, ir.Depart, ir.Drive, ir.Draw, ir.Align, ir.Ready, ir.Nest)
TIMED = (ir.WaitTime, ir.MoveHand, ir.Grasp)  # instructions that wait for `Context.until`

Numbers: TypeAlias = dict[int, tuple[int, int]]
"""Of cells, by id: what an argument stands for may be the same cell as something else."""


def state(machine: Machine, now: float, idle: frozenset[int]) -> Kept:
    """Return the state after a tick; variables of numbers in `idle` are left out."""
    system, robot, process = machine.system, machine.robot, machine.process
    bound = system.memory.bound
    numbers: Numbers = {}
    for k, item in enumerate(bound):
        for n, cell in enumerate(cells_of(item)):
            numbers[id(cell)] = (k, n)
    return Kept(
        (place(robot), place(process)),
        _program(robot, now, numbers, len(system.planner.motions)),
        _program(process, now, numbers, len(system.planner.motions)),
        arm(machine, now),
        _outside(machine, now),
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


def _program(c: Context, now: float, numbers: Numbers, motions: int) -> tuple[object, ...]:
    inner = len(c.frames) - 1
    waits = [*(frame.interrupted for frame in c.frames[1:]), None]
    return (
        place(c),
        c.running,
        c.finishing,
        _from_now(c.wake, now),
        _wait(c, inner, c.phase, c.until, now, motions),
        c.operands,
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
                _wait(c, k, wait.phase, wait.until, now, motions),
                (wait.phase, wait.operands, wait.priority),
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


def _wait(c: Context, k: int, phase: int, until: float, now: float, motions: int) -> object:
    """Return how long the instruction that a frame is at goes on, or which motion it began."""
    if phase == 0 or k < 0:
        return None
    frame = c.frames[k]
    program = c.system.programs.loaded[frame.program].program
    instruction = program.instructions[min(frame.index, len(program.instructions) - 1)]
    if isinstance(instruction, TIMED):
        return _from_now(until, now)
    return until - motions if isinstance(instruction, MOVES) and phase == CUT_SHORT else None


def _from_now(time_s: float, now: float) -> float:
    return round(time_s - now, DIGITS) if time_s > now else 0.0


# --- arm, hand, controller ------------------------------------------------------------------------


def arm(machine: Machine, now: float) -> tuple[object, ...]:
    """Return where the arm is, on its way to what, and all that is set for it."""
    planner = machine.system.planner
    motions, path_s = planner.motions, planner.scale.path(now)
    under_way: tuple[object, ...] = ()
    if planner.under_way(now):
        first = max(len(motions) - LEGS, motions.first)
        under_way = tuple(_motion(motions[k], path_s) for k in range(first, len(motions)))
    pending = planner.pending
    return (
        under_way,
        (pending.corner.goal, _from_now(pending.start_s, path_s)) if pending is not None else None,
        _from_now(planner.settled_at, now),
        _from_now(planner.motion_end, now),
        _from_now(planner.braking_until, now),
        (planner.configuration, planner.dest, planner.tool_at_dest, planner.branch, planner.ghost),
        (planner.request, planner.always, tuple(sorted(planner.next.items(), key=_name))),
        (planner.tool, planner.base, planner.overdue, planner.leg is None),
        (planner.scale.rate, round(planner.scale.rate_at(now), DIGITS)),
    )


def _motion(motion: Motion, path_s: float) -> tuple[object, ...]:
    shape = (motion.interpolation, motion.start, motion.goal, motion.X_WT, motion.speed_fraction)
    times = (round(motion.start_s - path_s, DIGITS), round(motion.end_s - path_s, DIGITS))
    return (shape, times, motion.cause, motion.cut)


def _outside(machine: Machine, now: float) -> tuple[object, ...]:
    system, hand = machine.system, machine.system.hand
    closing = hand.closing
    return (
        hand.opening(now),
        tuple((_from_now(s.end_s, now), s.end_m) for s in hand.strokes[-1:] if s.end_s > now),
        (_from_now(closing.end_s, now), closing.body, closing.tested) if closing else None,
        (hand.held, hand.slips),
        tuple(_lies(track[-1], now) for track in hand.placements.values()),
        tuple(sorted(system.switches.items())),
        tuple(cell.value for cell in system.cells()),
        tuple((_from_now(time_s, now), *what) for time_s, *what in system.scheduled),
        (system.answers_read, len(system.answers), system.powered, system.warned),
    )


def _lies(placement: Placement, now: float) -> tuple[object, ...]:
    lies = (placement.lie, placement.X, placement.support, _from_now(placement.start_s, now))
    return (*lies, placement.start_s) if placement.lie is Lie.FALLING else lies


def _name(setting: tuple[str, object]) -> str:
    return setting[0]
