"""What outside may decide when it is asked, and what is nothing special about it."""

from typing import NamedTuple

from vrts.engine.machine.machine import Machine, program_under_way
from vrts.engine.memory.events import Cause
from vrts.engine.programs.cycles import place
from vrts.engine.programs.outside import Kind, Question
from vrts.ir import instructions as ir
from vrts.ir.module import Module
from vrts.prove.environment.environment import Environment
from vrts.prove.environment.states import Behaviours
from vrts.prove.explore.answers import Free, tried
from vrts.prove.explore.frontier import Future
from vrts.prove.explore.readings import Readings
from vrts.prove.proof import Decided, What


class Way(NamedTuple):
    """Something that outside may decide."""

    value: bool | float | str
    cost: int  # 0: as if nothing had happened
    decided: Decided | None  # what a story tells of it; None: nothing has changed


STAYS = (Way(False, 0, None), Way(True, 0, None))  # an input that is as it was


class Outside:
    """Says what may be decided in futures of one environment."""

    def __init__(self, environment: Environment, module: Module, tick_s: float) -> None:
        """Take what may come from outside, and the programs that look at it."""
        self.environment = environment
        self.answers = tried(environment.answers, module)
        self.free = Free(module)  # answers where the environment says nothing of them
        self.readings = Readings(environment, module)
        self.behaviours = Behaviours(environment, tick_s)

    def is_open(self, future: Future, question: Question) -> bool:
        """Return whether an answer may differ; of inputs the environment may leave one."""
        if question.kind is Kind.ANALOG:
            return len(self.readings.of(future.machine, question.number).counts) > 1
        if question.kind is not Kind.INPUT:
            return True
        return len(self.behaviours.may(future.outside, question.number)) > 1

    def ways(self, future: Future, question: Question) -> tuple[Way, ...]:
        """Return what may be decided, what costs nothing first; nothing: nobody says."""
        machine = future.machine
        now, cause = machine.robot.now, _looks(machine)
        match question.kind:
            case Kind.INPUT:
                number = question.number
                before = future.inputs.get(number, False) is True
                values = self.behaviours.may(future.outside, number)
                found = [STAYS[before]] if before in values else []
                if (not before) in values:
                    if _was_so(machine, number):
                        now -= machine.tick
                    decided = Decided(now, What.INPUT, number, not before, cause)
                    found.append(Way(not before, 1, decided))
                return tuple(found)
            case Kind.ANALOG:
                channel, before = question.number, future.inputs.get(-question.number, 0.0)
                values = self.readings.of(machine, channel).counts
                found = [Way(before, 0, None)] if before in values else []
                for value in values:
                    if value != before:
                        decided = Decided(now, What.ANALOG, channel, value, cause)
                        found.append(Way(value, int(bool(found)), decided))
                return tuple(found)
            case Kind.ANSWER:
                return tuple(
                    Way(text, k > 0, Decided(now, What.ANSWER, 0, text, cause))
                    for k, text in enumerate(self._lines(machine))
                )
            case Kind.TURN:
                first = Decided(now, What.TURN, 0, value=True, cause=place(machine.process))
                return (Way(value=False, cost=0, decided=None), Way(True, 1, first))
            case Kind.GRIP:
                time_s = machine.next_tick * machine.tick
                missing = Decided(time_s, What.GRIP, 0, value=False, cause=_closes(machine))
                return (Way(value=True, cost=0, decided=None), Way(False, 1, missing))
            case Kind.RANDOM:
                return tuple(
                    Way(value, k > 0, Decided(now, What.RANDOM, 0, value, cause))
                    for k, value in enumerate(self.environment.random)
                )

    def _lines(self, machine: Machine) -> tuple[str, ...]:
        """Return what may be typed at the PROMPT under way; nothing: nobody says."""
        frame = program_under_way(machine).frames[-1]
        program = machine.system.programs.loaded[frame.program].program
        prompt = program.instructions[frame.index]
        assert isinstance(prompt, ir.Prompt)
        found = self.answers
        if self.environment.answers is None:
            free = self.free.at(program.name, frame.index)
            if free is None:
                return ()
            found = free
        return found.lines(len(prompt.places))


def _closes(machine: Machine) -> Cause | None:
    closing = machine.system.hand.closing
    return None if closing is None else closing.cause


def _was_so(machine: Machine, number: int) -> bool:
    """Return whether a reaction takes what it finds for what was so before the program went on."""
    return any(watch.signal == number and watch.state is None for watch in machine.robot.watches)


def _looks(machine: Machine) -> Cause | None:
    return place(program_under_way(machine))
