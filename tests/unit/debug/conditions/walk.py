"""The machine of a run, seen on the way through it: what histories must tell, told by itself.

A fork for each instant would execute the run again and again. Nothing that is looked at changes:
who asks has the machine's own arm, hand and signals, but variables and chance of its own.
"""

import copy
import math
from collections.abc import Callable, Mapping, Sequence
from typing import cast

from vrts.base.stack import deep_stack
from vrts.debug.conditions.hearing import Hear
from vrts.debug.passages import Instant
from vrts.engine.code.closures import Step
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.schedule import has_work
from vrts.engine.machine.tick import run_until
from vrts.engine.memory.cells import Bound, Cell, Memory
from vrts.engine.memory.records import INSTANT
from vrts.engine.programs.context import Context
from vrts.engine.programs.system import System
from vrts.engine.run import Run

STRIDE_S = 0.25  # simulated time after which somebody is heard again
OFTEN = 64  # instants after which somebody is heard again

See = Callable[[int, Machine], None]
"""Takes which of the instants it is, and the machine as it is then."""


class Walk:
    """A machine that goes through a run once more; it goes on from where it came to last."""

    def __init__(self, run: Run) -> None:
        """Take a run that can go on."""
        self._run = run
        self._tick = run.history.tick_s
        self._machine: Machine | None = None
        self._reached_s = 0.0
        self._wanted: dict[int, list[int]] = {}  # number of the next statement: instants
        self._seen: Callable[[Context], None] = lambda c: None

    @deep_stack()
    def over(self, instants: Sequence[Instant], see: See, hear: Hear) -> None:
        """Go to instants, and let each be seen once; those that do not come are left out.

        Raises:
            Interrupted: `hear` has heard somebody; what was seen was seen.
        """
        if not instants:
            return
        hear()
        order = sorted(range(len(instants)), key=lambda k: instants[k])
        machine = self._from(instants[order[0]])
        self._machine = None  # until it has come through
        count, left = 0, set(order)
        self._wanted.clear()
        for k in order:
            self._wanted.setdefault(instants[k].finished + 1, []).append(k)

        def shown(k: int) -> None:
            nonlocal count
            count += 1
            if count % OFTEN == 0:
                hear()
            left.discard(k)
            see(k, machine)

        def seen(c: Context) -> None:
            for k in self._wanted[c.finished]:
                if k in left and abs(instants[k].time_s - c.now) < INSTANT:
                    shown(k)

        self._seen = seen
        try:
            for k in order:
                if k in left:
                    self._go(machine, instants[k].time_s, hear)
                    if k in left and machine.finished == instants[k].finished:
                        shown(k)
        finally:
            self._seen = lambda c: None
            self._wanted.clear()
        self._machine, self._reached_s = machine, instants[order[-1]].time_s

    def _go(self, machine: Machine, time_s: float, hear: Hear) -> None:
        while has_work(machine) and (machine.next_tick - 1) * self._tick < time_s - STRIDE_S:
            hear()
            run_until(machine, machine.next_tick * self._tick + STRIDE_S / 2)
        run_until(machine, time_s)

    def _from(self, first: Instant) -> Machine:
        """Return a machine that has not come to an instant yet."""
        number = math.floor(first.time_s / self._tick + INSTANT / self._tick)
        last = self._machine
        if last is not None and last.last_tick < number and self._reached_s <= first.time_s:
            return last
        kept = [m for m in self._run.checkpoints if m.last_tick < number]
        machine = (kept or [self._run.checkpoints[0]])[-1].copy()
        machine.closed = machine.closed or self._run.machine.closed
        machine.know(self._run.machine.issued)
        machine.executable = executable = copy.copy(machine.executable)
        executable.steps = tuple(
            tuple([self._noticed(step) for step in steps]) for steps in executable.steps
        )
        return machine

    def _noticed(self, step: Step) -> Step:
        """Return a step before which it is looked whether somebody wants to see the machine."""
        wanted = self._wanted

        def noticed(c: Context) -> int:
            if c.finished in wanted:
                self._seen(c)
            return step(c)

        return noticed


class Present:
    """A program in execution that looks at a machine, and changes nothing of it."""

    def __init__(self, machine: Machine, at: Instant, memory: Memory, *, process: bool) -> None:
        """Stand at an instant, with variables of its own.

        Args:
            machine: As it is then.
            at: The instant.
            memory: The variables.
            process: It is the process control program that asks.
        """
        c = machine.process if process else machine.robot
        self.now, self.finished = at.time_s, at.finished
        self.slots: list[Bound] = []
        self.memory = _Variables(memory, machine.system.memory)
        self.system = _Chance(machine.system)
        self.planner, self.hand, self.signals = c.planner, c.hand, c.signals
        self.robot, self.process = machine.robot, machine.process
        self.priority, self.last_error = c.priority, c.last_error


class _Variables:
    """Variables of its own, beside those that the controller counts."""

    def __init__(self, own: Memory, held: Memory) -> None:
        self.bound, self._held = own.bound, held

    def cells(self) -> list[Cell]:
        return self._held.cells()

    @property
    def size(self) -> int:
        return self._held.size


class _Chance:
    """What the programs share, with chance and counts of its own."""

    def __init__(self, system: System) -> None:
        self._system = system
        self.clock_reads = 0
        self.random_state, self.draws = system.random_state, system.draws
        self.outside = None
        self.facts = None
        self.timers: Mapping[int, float] = system.timers
        self.programs = system.programs

    def is_on(self, switch: str) -> bool:
        return self._system.is_on(switch)

    def parameter(self, name: str, otherwise: float) -> float:
        return self._system.parameter(name, otherwise)


def as_context(present: Present) -> Context:
    """Return what expressions take for a program in execution."""
    return cast("Context", present)
