"""The steps that both programs executed, found when they are asked for."""

from bisect import bisect_right
from collections import defaultdict
from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

from vrts.engine.history import ProgramHistory
from vrts.engine.memory.cells import Bound
from vrts.engine.memory.events import Cause
from vrts.engine.memory.trace import Activation
from vrts.engine.run import Run
from vrts.ir.control import Call, CallNamed
from vrts.ir.instructions import Instruction
from vrts.ir.module import Program
from vrts.ir.motion import Align, Depart, Draw, Drive, Grasp, Move, Nest, Ready

MOTIONS = (Move, Depart, Drive, Draw, Align, Ready, Nest, Grasp)


class Executed(NamedTuple):
    """A step as it was executed."""

    number: int  # statements finished with it
    at: int  # number of its instruction among all
    process: bool  # by the process control program
    cause: Cause
    instruction: Instruction
    activation: Activation | None

    @property
    def line(self) -> int:
        """Where it stands in its source."""
        return self.cause.span.line


class Steps:
    """What was executed, by number of statement."""

    def __init__(self, run: Run) -> None:
        """Look at a run."""
        self.run = run
        self.history = run.history
        self.named: Mapping[str, Bound] = {b.name: b for b in self.history.memory.bound}
        self.data = {_element(d.name, d.subscripts): d for d in run.module.data}

    def step(self, number: int) -> Executed | None:
        """Return the step that a statement executed; None where it was a command."""
        for program in (self.history.robot, self.history.process):
            index = self._index(program, number)
            if index is not None:
                return self._executed(program, index, number)
        return None

    @cached_property
    def of_robot(self) -> tuple[Executed, ...]:
        """All steps that the robot program finished, in their order."""
        robot, finished = self.history.robot, self.history.finished
        numbers = (self.number_of(robot, k) for k in range(len(robot.trace.instructions)))
        return tuple(
            self._executed(robot, k, number)
            for k, number in enumerate(numbers)
            if number <= finished
        )

    def robot_index(self, number: int) -> int | None:
        """Return where a statement of the robot program stands in `of_robot`."""
        return self._index(self.history.robot, number)

    def motion_index(self, motion: int) -> int | None:
        """Return where the step that asked for a motion stands in `of_robot`."""
        return self._motions.get(motion)

    def last(self, cause: Cause | None, time_s: float) -> Executed | None:
        """Return when an instruction was executed last, not later than a time."""
        if cause is None:
            return None
        latest = self.history.finished_at(time_s)
        for program in (self.history.robot, self.history.process):
            found: Executed | None = None
            for at in self._numbers_of(cause):
                indices = self._where(program).get(at, [])
                for index in reversed(indices):
                    number = self.number_of(program, index)
                    if number <= latest + 1:  # one more: a step that fails is not finished
                        if found is None or number > found.number:
                            found = self._executed(program, index, number)
                        break
            if found is not None:
                return found
        return None

    def waiting(self, cause: Cause | None) -> Executed | None:
        """Return the step that a program still waits in when the run is over; None: in none."""
        finished = self.history.finished
        for program in (self.history.robot, self.history.process):
            resting = program.trace.resting
            if cause is None or not resting or self.history.code.causes[resting[-1]] != cause:
                continue
            owner, within = self.program_of(resting[-1])
            return Executed(
                finished + 1,
                resting[-1],
                not program.is_robot,
                cause,
                owner.instructions[within],
                program.trace.activation(finished),
            )
        return None

    def times(self, at: int, *, process: bool = False) -> list[int]:
        """Return the numbers of the statements that executed an instruction."""
        program = self.history.process if process else self.history.robot
        return [self.number_of(program, index) for index in self._where(program).get(at, [])]

    def of_motion(self, motion: int) -> Executed | None:
        """Return the step that asked for a motion."""
        index = self._motions.get(motion)
        if index is None:
            return None
        robot = self.history.robot
        return self._executed(robot, index, self.number_of(robot, index))

    def motion_at(self, time_s: float) -> int | None:
        """Return the number of the last motion that has begun at a time."""
        found: int | None = None
        for number, motion in enumerate(self.run.motions):
            if motion.start_s > time_s + 1e-9:
                break
            found = number
        return found

    def entered(self, activation: Activation | None) -> Executed | None:
        """Return the step that began an activation: a CALL, or what a reaction interrupted."""
        if activation is None or activation.called_from is None:
            return None
        for program in (self.history.robot, self.history.process):
            trace = program.trace
            for changed, each in zip(trace.changed, trace.activations, strict=True):
                if each is activation:
                    return self.step(changed)
        return None

    def calls(self, step: Executed) -> bool:
        """Return whether a step is a CALL."""
        return isinstance(step.instruction, Call | CallNamed)

    def time_of(self, step: Executed) -> float:
        """Return when a step was executed [s]; of one that is not finished, when all was over."""
        if step.number > self.history.finished:
            return self.run.ended_s or self.run.horizon_s
        return self.history.time_of(step.number)

    def program_of(self, at: int) -> tuple[Program, int]:
        """Return the program of an instruction, and its index in it."""
        code = self.history.code
        k = bisect_right(code.bases, at) - 1
        return code.programs[k], at - code.bases[k]

    def base_of(self, at: int) -> int:
        """Return the number of the first instruction of an instruction's program."""
        code = self.history.code
        return code.bases[bisect_right(code.bases, at) - 1]

    def number_of(self, program: ProgramHistory, index: int) -> int:
        """Return the statement's number of an entry of a program's trace."""
        trace = program.trace
        k = bisect_right(trace.counts, index) - 1
        return trace.begun[k] + index - trace.counts[k] + 1

    @cached_property
    def _motions(self) -> dict[int, int]:
        found: dict[int, int] = {}
        robot, at = self.history.robot.trace.instructions, 0
        causes = self.history.code.causes
        for number, motion in enumerate(self.run.motions):
            here = at
            while here < len(robot) and causes[robot[here]] != motion.cause:
                here += 1
            if here < len(robot):
                found[number] = here
                at = here + 1
            elif at:
                found[number] = at - 1  # a step of several motions
        return found

    @cached_property
    def _robot_where(self) -> Mapping[int, list[int]]:
        return _by_instruction(self.history.robot)

    @cached_property
    def _process_where(self) -> Mapping[int, list[int]]:
        return _by_instruction(self.history.process)

    def _where(self, program: ProgramHistory) -> Mapping[int, list[int]]:
        return self._robot_where if program.is_robot else self._process_where

    def _numbers_of(self, cause: Cause) -> list[int]:
        return [at for at, each in enumerate(self.history.code.causes) if each == cause]

    def _index(self, program: ProgramHistory, number: int) -> int | None:
        trace = program.trace
        k = bisect_right(trace.begun, number - 1) - 1
        if k < 0:
            return None
        index = trace.counts[k] + number - 1 - trace.begun[k]
        following = trace.counts[k + 1] if k + 1 < len(trace.counts) else len(trace.instructions)
        return index if index < following else None

    def _executed(self, program: ProgramHistory, index: int, number: int) -> Executed:
        at = program.trace.instructions[index]
        owner, within = self.program_of(at)
        return Executed(
            number,
            at,
            not program.is_robot,
            self.history.code.causes[at],
            owner.instructions[within],
            program.trace.activation(number - 1),
        )


def _by_instruction(program: ProgramHistory) -> Mapping[int, list[int]]:
    found: defaultdict[int, list[int]] = defaultdict(list)
    for index, at in enumerate(program.trace.instructions):
        found[at].append(index)
    return found


def _element(name: str, subscripts: tuple[int, ...]) -> str:
    return f"{name}[{','.join(map(str, subscripts))}]" if subscripts else name
