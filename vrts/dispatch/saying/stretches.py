"""Programs that jump, as stretches: each is entered at its beginning alone, and has a number.

A controller without jumps carries them out in a loop that goes from one number to another.
"""

from typing import TypeAlias

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import constant
from vrts.ir import instructions as ir
from vrts.ir.module import Program
from vrts.lang.meaning.structure import word_of
from vrts.lang.syntax.program import ProgramText

JUMPS = (ir.Jump, ir.JumpIf)
LEAVES = (ir.Jump, ir.NextFor, ir.Return, ir.Halt, ir.Stop)

Stretches: TypeAlias = list[tuple[int, int]]  # first instruction, and the one behind the last


def jumps(program: Program, text: ProgramText) -> bool:
    """Return whether a program has a jump that is no structure word."""
    structured = {step.number for step in text.steps if word_of(step) is not None}
    return any(
        isinstance(instruction, JUMPS) and origin.step not in structured
        for instruction, origin in zip(program.instructions, program.origins, strict=True)
    )


def numbered(program: Program) -> Stretches:
    """Return the stretches of a program that are entered at their beginning alone."""
    first = {0}
    for k, instruction in enumerate(program.instructions):
        targets = ir.jumps_of(instruction)
        first |= set(targets)
        if targets or ends(instruction):
            first.add(k + 1)
    starts = sorted(k for k in first if k < len(program.instructions))
    return list(zip(starts, [*starts[1:], len(program.instructions)], strict=True))


def ends(instruction: ir.Instruction) -> bool:
    """Return whether nothing is carried out behind an instruction unless it is jumped to."""
    return isinstance(instruction, LEAVES) or bool(ir.jumps_of(instruction))


def step_of(loop: ir.BeginFor) -> float:
    """Return the step of a FOR.

    Raises:
        CannotSay: It is not known before the run.
    """
    by = 1.0 if loop.increment is None else constant(loop.increment)
    if by is None or by == 0.0:
        raise CannotSay("the step of a FOR is worked out in the run", "write a number")
    return by


def loop_step(program: Program, loop: int) -> float:
    """Return the step of a FOR of a number.

    Raises:
        CannotSay: It is not known before the run.
    """
    begun = (i for i in program.instructions if isinstance(i, ir.BeginFor) and i.loop == loop)
    return step_of(next(begun))
