"""Which instructions any future executes, and which steps none does."""

from collections.abc import Iterable
from typing import Any

from vrts.engine.futures.bare import NoTrace
from vrts.engine.machine.machine import Machine
from vrts.engine.programs.loaded import Loaded
from vrts.ir import instructions as ir
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Module
from vrts.prove.proof import Step


class Executed:
    """Takes the numbers of instructions as a trace does, and keeps each once."""

    def __init__(self) -> None:
        """Know none."""
        self.numbers: set[int] = set()
        self.append = self.numbers.add  # of an instruction that begins

    def pop(self, index: Any = -1) -> None:
        """Keep it although it waits: it was come to."""


def watched(machine: Machine, executed: Executed) -> None:
    """Let a machine and all copies of it note what they execute."""
    for c in (machine.robot, machine.process):
        assert isinstance(c.trace, NoTrace)
        c.trace.instructions = executed  # type: ignore[assignment]


def dead_steps(
    module: Module, loaded: Iterable[Loaded], executed: Executed, entry: str
) -> tuple[Step, ...]:
    """Return the steps that no future executes, with the reason."""
    found: list[Step] = []
    begun = {
        one.program.name
        for one in loaded
        if any(one.base + k in executed.numbers for k in range(len(one.program.instructions)))
    }
    for one in loaded:
        program = one.program
        if program.name not in begun:
            if program.name != entry and program.name in module.programs and program.steps:
                who = _names(module, program.name)
                found.append(Step(program.name, 1, f"`{program.name}` is never executed{who}"))
            continue
        ways = _ways_in(program.instructions)
        alive = {
            program.origins[k].step
            for k in range(len(program.instructions))
            if one.base + k in executed.numbers
        }
        last = len(program.steps)
        told = {
            program.origins[k].step: k
            for k in range(len(program.instructions) - 1, -1, -1)
            if program.origins[k].step not in alive and program.origins[k].step <= last
        }
        for step, first in sorted(told.items()):
            reason = _why(program.instructions, program.origins, first, ways, alive)
            found.append(Step(program.name, step, reason))
    return tuple(found)


def _ways_in(instructions: tuple[ir.Instruction, ...]) -> dict[int, list[int]]:
    """Return for each instruction those that may lead to it."""
    ways: dict[int, list[int]] = {}
    for k, instruction in enumerate(instructions):
        for to in jumps_of(instruction):
            ways.setdefault(to, []).append(k)
        if not isinstance(instruction, ir.Jump | ir.Return | ir.ReturnError | ir.Stop | ir.Halt):
            ways.setdefault(k + 1, []).append(k)
    return ways


def _why(
    instructions: tuple[ir.Instruction, ...],
    origins: tuple[Any, ...],
    first: int,
    ways: dict[int, list[int]],
    alive: set[int],
) -> str:
    steps = sorted({origins[k].step for k in ways.get(first, ())})
    before = [step for step in steps if step in alive]
    if not steps:
        return "no way leads to it"
    if before:
        return f"step {before[0]} never goes on to it"
    return f"it is come to from step {steps[0]} only, which no future executes"


def _names(module: Module, name: str) -> str:
    callers = sorted(
        program.name
        for program in module.programs.values()
        if any(getattr(one, "program", None) == name for one in program.instructions)
    )
    return f": only `{callers[0]}` names it" if callers else ": no program names it"
