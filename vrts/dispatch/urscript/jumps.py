"""Programs with GOTO: stretches without jumps have numbers, and a loop goes from one to another."""

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.stretches import Stretches, loop_step, step_of
from vrts.dispatch.urscript.steps import Steps
from vrts.dispatch.urscript.values import number
from vrts.ir import instructions as ir
from vrts.ir.module import Program

INDENT = "  "


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
            past = ">" if loop_step(program, loop) > 0.0 else "<"
            return either(f"{v.place(place)} {past} last_{loop}", leave)
        case ir.NextFor(place, loop, test):
            more = f"{v.place(place)} + {number(loop_step(program, loop))}"
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
