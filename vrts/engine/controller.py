"""Runs begin, grow and are cut: `start`, `advance`, `truncate` are pure functions of runs."""

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType

from vrts.base.stack import deep_stack
from vrts.engine.code.executable import Executable
from vrts.engine.machine.machine import Machine
from vrts.engine.machine.schedule import has_work
from vrts.engine.machine.tick import run_until, settle
from vrts.engine.run import OutOfHorizon, Run
from vrts.ir.commands import (
    Abort,
    Command,
    Execute,
    Proceed,
    PutBack,
    Retry,
    TakeAway,
    TimedCommand,
)
from vrts.ir.module import Module
from vrts.scene.model import Act, Deed, Parts, Scenario, Scene

CHECKPOINT = 5.0  # [s] of simulated time between states kept for `truncate`, at first
MOST_CHECKPOINTS = 64  # beyond, every other one is given up
FEW_CELLS = 1000  # of which a copy costs nothing worth mentioning
STATEMENTS_A_CELL = 10  # with more, a state is kept after so many statements for each of them
TIDYING: Mapping[Parts, tuple[Command, ...]] = MappingProxyType(
    {Parts.LEFT: (), Parts.PUT_BACK: (PutBack(),), Parts.TAKEN: (TakeAway(),)}
)
AFTERWARDS = 10.0  # [s] longest time anything may move after the program has ended


@deep_stack()
def start(module: Module, scene: Scene, scenario: Scenario | None = None) -> Run:
    """Return a run at time 0 in which nothing executes."""
    scenario = scenario or Scenario()
    executable = Executable(module, scenario.limits.call_depth)
    machine = Machine(executable, scene, scenario)
    return Run(machine, 0.0, (machine,))


@deep_stack()
def advance(
    run: Run, until_s: float, commands: Sequence[TimedCommand] = (), *, closed: bool = False
) -> Run:
    """Return a run that goes on to a time [s], with commands issued from its horizon on.

    Args:
        run: The run so far.
        until_s: How far it goes on.
        commands: What the controller is told.
        closed: No other command will ever come: what waits for one is stuck.

    Raises:
        ValueError: The time or a command lies in the past of the run.
    """
    if until_s < run.until_s:
        raise ValueError(f"{until_s} s is before the horizon at {run.until_s} s")
    for timed in commands:
        if timed.time_s < run.until_s:
            raise ValueError(f"a command at {timed.time_s} s is in the past of the run")
    machine = run.machine.copy()
    machine.closed = machine.closed or closed
    machine.issue(tuple(commands))
    return _grown(machine, run.until_s, until_s, run.checkpoints)


@deep_stack()
def truncate(run: Run, time_s: float) -> Run:
    """Return the run as it was known at an earlier time, with commands issued later forgotten.

    Raises:
        OutOfHorizon: The time is not within the run.
    """
    if not 0.0 <= time_s <= run.until_s:
        raise OutOfHorizon(time_s, run.until_s)
    kept = [machine for machine in run.checkpoints if machine.last_tick * machine.tick <= time_s]
    machine = kept[-1].copy()
    machine.closed = False
    machine.know(tuple(c for c in run.machine.issued if c.time_s <= time_s))
    run_until(machine, time_s)
    return Run(machine, time_s, tuple(kept))


@deep_stack()
def forked(run: Run, commands: Sequence[TimedCommand], until_s: float) -> Run:
    """Return the run that it would have been with commands at an earlier moment of it.

    Commands that were issued later than the first of these are forgotten; no further ones come.

    Args:
        run: A run that can go on.
        commands: What the controller is told, in order; a command may come within a tick.
        until_s: How far the other run goes.

    Raises:
        OutOfHorizon: The first command is not within the run.
    """
    first = commands[0]
    if not 0.0 <= first.time_s <= run.until_s:
        raise OutOfHorizon(first.time_s, run.until_s)
    tick = run.machine.tick
    kept = [m for m in run.checkpoints if m.last_tick * tick < first.time_s - 0.5 * tick]
    machine = kept[-1].copy()
    machine.closed = True
    earlier = tuple(c for c in run.machine.issued if c.order <= first.order)
    machine.know((*earlier, *commands))
    return _grown(machine, machine.now, until_s, tuple(kept))


@deep_stack()
def resumed(checkpoints: Sequence[Machine], until_s: float) -> Run:
    """Return the run that goes on from the last of some states of it, with no further commands."""
    machine = checkpoints[-1].copy()
    machine.closed = True
    return _grown(machine, machine.now, until_s, tuple(checkpoints))


def execute(
    module: Module, scene: Scene, scenario: Scenario | None = None, program: str | None = None
) -> Run:
    """Run a program from time 0 to its end; None runs the main one of the module.

    Raises:
        ValueError: There is no such program.
    """
    name = program or module.main
    if name is None or name not in module.programs:
        raise ValueError(f"no program {name!r}")
    run = start(module, scene, scenario)
    commands = commands_of(run.scenario, name)
    horizon = commands[-1].time_s + run.scenario.limits.time_s + AFTERWARDS
    return advance(run, horizon, commands, closed=True)


def commands_of(scenario: Scenario, program: str) -> list[TimedCommand]:
    """Return what the operator of a scenario does with a program, EXECUTE at time 0 first."""
    found = [TimedCommand(0.0, Execute(program))]
    for act in scenario.operator:
        found += [TimedCommand(act.time_s, command) for command in _commands(act, program)]
    return found


def _commands(act: Act, program: str) -> tuple[Command, ...]:
    match act.deed:
        case Deed.STOP:
            return (Abort(),)
        case Deed.PROCEED:
            return (Proceed(),)
        case Deed.RETRY:
            return (Retry(),)
        case Deed.EXECUTE:
            return (*TIDYING[act.parts], Execute(program))


class Controller:
    """A run that grows: what a monitor, a live server and a debugger drive."""

    def __init__(self, module: Module, scene: Scene, scenario: Scenario | None = None) -> None:
        """Begin at time 0."""
        self.run = start(module, scene, scenario)
        self._waiting: list[TimedCommand] = []

    def issue(self, command: Command, time_s: float) -> None:
        """Give a command at a simulated time from the horizon on."""
        self._waiting.append(TimedCommand(time_s, command))

    def advance(self, until_s: float) -> Run:
        """Go on to a time [s]."""
        self.run = advance(self.run, until_s, self._waiting)
        self._waiting = []
        return self.run

    @deep_stack()
    def advance_until_stopped(self, most_s: float) -> Run:
        """Go on until no robot program executes and the arm rests, or one waits in vain.

        A program that waits for an answer, or for a signal that nothing will change, waits in vain
        until a command comes.

        Args:
            most_s: Longest simulated time [s].
        """
        machine = self.run.machine.copy()
        machine.issue(tuple(self._waiting))
        self._waiting = []
        begin = self.run.until_s
        run_until(machine, begin + most_s, stop_when_idle=True)
        reached = min(max(machine.now, machine.ended_s or 0.0, begin), begin + most_s)
        settle(machine, reached)
        self.run = Run(machine, reached, (*self.run.checkpoints, machine.copy()))
        return self.run

    def truncate(self, time_s: float) -> Run:
        """Forget everything after a time [s]."""
        self.run = truncate(self.run, time_s)
        self._waiting = []
        return self.run


def _grown(
    machine: Machine, from_s: float, until_s: float, checkpoints: tuple[Machine, ...]
) -> Run:
    kept = list(checkpoints)
    step = _spacing(kept)
    boundary = (math.floor(from_s / step) + 1) * step
    while boundary < until_s and has_work(machine):
        run_until(machine, boundary)
        if _worth(machine, kept[-1]):
            kept.append(machine.copy())
        if len(kept) > MOST_CHECKPOINTS:
            kept = [kept[0], *kept[2::2]]
            step *= 2.0
        boundary = (math.floor(boundary / step) + 1) * step
    run_until(machine, until_s)
    return Run(machine, until_s, tuple(kept))


def _worth(machine: Machine, last: Machine) -> bool:
    """Return whether a state is worth keeping: a copy costs as much as there are variables."""
    size = machine.system.memory.size
    return size < FEW_CELLS or machine.finished - last.finished >= STATEMENTS_A_CELL * size


def _spacing(kept: Sequence[Machine]) -> float:
    """Return the time between checkpoints [s]: twice as long whenever they were thinned out."""
    spacing = CHECKPOINT
    while kept and kept[-1].now > spacing * MOST_CHECKPOINTS:
        spacing *= 2.0
    return spacing
