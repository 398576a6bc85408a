"""Programs with GOTO: stretches without jumps have numbers, and a loop goes from one to another."""

from typing import TypeAlias

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.urscript.blocks import step_of
from vrts.dispatch.urscript.steps import Steps
from vrts.dispatch.urscript.values import number
from vrts.ir import instructions as ir
from vrts.ir.module import Program
from vrts.lang.meaning.structure import word_of
from vrts.lang.syntax.program import ProgramText

INDENT = "  "
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


def kept(program: Program) -> list[str]:
    """Return the variables that loops and cases keep."""
    rows = [f"local last_{k} = 0.0" for k in range(program.loops)]
    return rows + [f"local case_{k} = 0.0" for k in range(program.cases)]


def go(number: int, here: int, passes: str) -> list[str]:
    """Return the lines that go on at a stretch; one that goes back lets a frame pass."""
    return [*([passes] if number <= here else []), f"v_goto = {number}"]


def jump_lines(
    program: Program, k: int, steps: Steps, stretches: Stretches, here: int
) -> list[str] | None:
    """Return what an instruction becomes that chooses what comes next; None: it does not.

    Args:
        program: The program.
        k: Index of the instruction.
        steps: The writer of its steps.
        stretches: Of the program.
        here: Number of the stretch that it stands in.

    Raises:
        CannotSay: URScript has nothing of the kind.
    """
    numbers = {first: number for number, (first, _) in enumerate(stretches)}
    v, passes = steps.values, steps.mode.passes

    def either(condition: str, target: int) -> list[str]:
        chosen = [INDENT + row for row in go(numbers[target], here, passes)]
        others = [INDENT + row for row in go(here + 1, here, passes)]
        return [f"if {condition}:", *chosen, "else:", *others, "end"]

    match program.instructions[k]:
        case ir.Jump(target):
            return go(numbers[target], here, passes)
        case ir.JumpIf(condition, when, target):
            text = v.condition(condition)
            return either(text if when else f"not {text}", target)
        case ir.BeginFor(place, first, last, _, loop) as begun:
            step_of(begun)
            return [steps.given(place, v.real(first)), f"last_{loop} = {v.real(last)}"]
        case ir.TestFor(place, loop, leave):
            past = ">" if _step(program, loop) > 0.0 else "<"
            return either(f"{v.place(place)} {past} last_{loop}", leave)
        case ir.NextFor(place, loop, test):
            more = f"{v.place(place)} + {number(_step(program, loop))}"
            return [steps.given(place, more), *go(numbers[test], here, passes)]
        case ir.BeginCase(selector, case):
            return [f"case_{case} = {v.real(selector)}"]
        case ir.TestCase(case, values, otherwise):
            tests = " or ".join(f"(case_{case} == {v.real(value)})" for value in values)
            return either(f"not ({tests})", otherwise)
        case ir.Grasp():
            raise CannotSay("URScript has nothing that means GRASP")
        case _:
            return None


def _step(program: Program, loop: int) -> float:
    begun = (i for i in program.instructions if isinstance(i, ir.BeginFor) and i.loop == loop)
    return step_of(next(begun))
