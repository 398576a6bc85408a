"""What an execution left behind, as plain data: all that a Run answers from.

It is taken from a machine, with which it shares everything, or read from a file.
"""

import math
from array import array
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.cells import Bound, Cell
from vrts.engine.memory.event_log import EventLog
from vrts.engine.memory.events import Cause
from vrts.engine.memory.records import INSTANT, ArmPiece, Ending, Motion, Placement, Stroke
from vrts.engine.memory.trace import Trace
from vrts.engine.motion.time_scale import TimeScale
from vrts.engine.programs.context import Context
from vrts.engine.programs.cycles import next_instruction
from vrts.ir.commands import TimedCommand
from vrts.ir.module import Module, Program
from vrts.robots.model import Configuration
from vrts.scene.model import Scenario, Scene


class Code(NamedTuple):
    """Every program that was ever in memory; instructions are numbered through all of them."""

    programs: Sequence[Program]
    bases: Sequence[int]  # number of the first instruction of each program
    causes: Sequence[Cause]  # of all instructions


class ProgramHistory(NamedTuple):
    """What the robot program or the process control program did, and its state at the end."""

    is_robot: bool
    trace: Trace
    place: int | None  # the instruction that comes next
    ending: Ending
    cycles_done: int
    cycles_left: int
    priority: int
    waits: bool


class ArmHistory(NamedTuple):
    """Where the arm was; times are path times, which `scale` maps to run time."""

    configuration: Configuration  # before the first motion
    pieces: Sequence[ArmPiece]
    motions: Sequence[Motion]
    scale: TimeScale


class HandHistory(NamedTuple):
    """What the hand did, and where it left things."""

    opening_m: float  # before the first stroke
    strokes: Sequence[Stroke]
    placements: Mapping[str, Sequence[Placement]]


class MemoryHistory(NamedTuple):
    """Every value that anything ever had."""

    bound: Sequence[Bound]  # the global variables
    tool: Cell
    base: Cell
    parameters: Mapping[str, Cell]


@dataclass(frozen=True, slots=True)
class History:
    """One execution. Its tables may hold more than `finished` statements: another future's."""

    module: Module  # the programs in memory at the end
    code: Code
    scene: Scene
    scenario: Scenario
    issued: tuple[TimedCommand, ...]
    tick_s: float
    now_s: float  # the last tick that was run
    started_s: float
    ended_s: float | None  # the robot program is over and the arm stands still
    closed: bool  # no further command comes
    finished: int  # statements of both programs
    ticks: "array[int]"  # ticks in which statements were executed
    counts: "array[int]"  # beside `ticks`: statements finished after it
    robot: ProgramHistory
    process: ProgramHistory
    arm: ArmHistory
    hand: HandHistory
    memory: MemoryHistory
    events: EventLog

    def finished_at(self, time_s: float) -> int:
        """Return how many statements are finished at a time."""
        tick = math.floor(time_s / self.tick_s + INSTANT / self.tick_s)
        k = bisect_right(self.ticks, tick)
        return min(self.counts[k - 1], self.finished) if k else 0

    def time_of(self, finished: int) -> float:
        """Return the time of the tick in which a number of statements was reached."""
        k = bisect_right(self.counts, finished - 1)
        return self.ticks[k] * self.tick_s if finished > 0 and k < len(self.ticks) else 0.0


def history_of(machine: Machine) -> History:
    """Return what a machine knows. Nobody may change the machine afterwards."""
    system = machine.system
    programs, planner, hand = system.programs, system.planner, system.hand
    given = planner.given
    return History(
        module=machine.executable.module,
        code=Code(
            [known.program for known in programs.loaded],
            [known.base for known in programs.loaded],
            programs.causes,
        ),
        scene=machine.scene,
        scenario=machine.scenario,
        issued=machine.issued,
        tick_s=machine.tick,
        now_s=machine.now,
        started_s=machine.started_s,
        ended_s=machine.ended_s,
        closed=machine.closed,
        finished=machine.finished,
        ticks=machine.ticks,
        counts=machine.counts,
        robot=_program(machine, machine.robot),
        process=_program(machine, machine.process),
        arm=ArmHistory(given.initial, given.pieces, given.motions, planner.scale),
        hand=HandHistory(machine.initial_opening, hand.strokes, hand.placements),
        memory=MemoryHistory(
            system.memory.bound, system.held_tool, system.held_base, system.parameters
        ),
        events=system.events,
    )


def _program(machine: Machine, c: Context) -> ProgramHistory:
    return ProgramHistory(
        c.is_robot,
        c.trace,
        next_instruction(c),
        c.ending,
        c.cycles_done,
        c.cycles_left,
        c.priority,
        c.wake > machine.now,
    )
