"""What the operator may do: stop the arm on its way and go on, and execute the program again."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.engine.controller import TIDYING
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.programs.cycles import place
from vrts.ir.commands import Abort, Command, Execute, Proceed, Retry, TimedCommand
from vrts.prove.environment.environment import Afterwards, Environment
from vrts.prove.explore.frontier import Future
from vrts.prove.proof import Decided, What

STOP = "stop"
COMMANDS = {Afterwards.PROCEED: Proceed(), Afterwards.RETRY: Retry()}


class Deed(NamedTuple):
    """What the operator does, and when."""

    commands: tuple[TimedCommand, ...]
    decided: Decided


class Operator:
    """Says what the operator may do in futures of one environment."""

    def __init__(self, environment: Environment, entry: str) -> None:
        """Take what may be done, and the program that is executed again."""
        self.environment, self.entry = environment, entry

    def stops(self, future: Future) -> Deed | None:
        """Return a stop in the next tick, if there may be one: once, while the arm moves."""
        machine = future.machine
        if not self.may_stop(future) or machine.next_tick % self.environment.stop_every:
            return None
        return _deed(machine, machine.next_tick, (Abort(),), What.STOP, STOP)

    def next_stop(self, future: Future) -> int | None:
        """Return the next tick in which a stop may come; None: there is none."""
        if not self.may_stop(future):
            return None
        after, every = future.machine.last_tick + 1, self.environment.stop_every
        return -(-after // every) * every

    def may_stop(self, future: Future) -> bool:
        """Return whether the operator may stop the arm while it goes on."""
        machine = future.machine
        if not self.environment.stops or future.stopped or not machine.robot.running:
            return False
        return machine.system.planner.settled_at > machine.now + INSTANT

    def afterwards(self, future: Future) -> Iterator[Deed]:
        """Yield what may be done once the robot program is over, as soon as the arm stands."""
        machine = future.machine
        ended_s = machine.now if machine.ended_s is None else machine.ended_s
        tick = max(machine.tick_of(ended_s), machine.last_tick) + 1
        ending = machine.robot.ending
        if ending in (Ending.ABORTED, Ending.PAUSED):
            for after in (Afterwards.PROCEED, Afterwards.RETRY):
                if after in self.environment.stops:
                    command = COMMANDS[after]
                    yield _deed(machine, tick, (command,), What.STOP, after.value)
        again = self.environment.again
        most = again.most is None or future.again < again.most
        if ending in (Ending.COMPLETED, Ending.HALTED) and most:
            commands = (*TIDYING[again.parts], Execute(self.entry))
            yield _deed(machine, tick, commands, What.AGAIN, value=True)

    def memory(self, future: Future) -> tuple[int, bool]:
        """Return what tells futures in the same state apart: what may still be done."""
        return (future.again if self.environment.again.most is not None else 0, future.stopped)


def _deed(
    machine: Machine, tick: int, commands: tuple[Command, ...], what: What, value: bool | str
) -> Deed:
    time_s = tick * machine.tick
    timed = tuple(TimedCommand(time_s, command) for command in commands)
    return Deed(timed, Decided(time_s, what, 0, value, place(machine.robot)))
