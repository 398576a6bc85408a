"""Programs with GOTO: stretches without jumps have numbers, and a loop goes from one to another."""

from vrts.dispatch.linuxcnc.names import number
from vrts.dispatch.linuxcnc.steps import Steps
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.stretches import Stretches, loop_step, step_of
from vrts.ir import instructions as ir
from vrts.ir.expressions import Place, Slot
from vrts.ir.module import Program

INDENT = "  "
GOTO = "#<v_goto>"


def write_jump(program: Program, k: int, steps: Steps, stretches: Stretches, here: int) -> bool:
    """Write an instruction that chooses what comes next; return whether it is one.

    Args:
        program: The program.
        k: Index of the instruction.
        steps: The writer of its steps.
        stretches: Of the program.
        here: Number of the stretch that it stands in.

    Raises:
        CannotSay: LinuxCNC does nothing of the kind.
    """
    numbers = {first: number for number, (first, _) in enumerate(stretches)}
    values, lines = steps.values, steps.lines

    def either(condition: str, target: int) -> None:
        label = steps.label()
        lines.extend((f"o{label} if {condition}", f"{INDENT}{GOTO} = {numbers[target]}"))
        lines.extend((f"o{label} else", f"{INDENT}{GOTO} = {here + 1}", f"o{label} endif"))

    match program.instructions[k]:
        case ir.Jump(target):
            lines.append(f"{GOTO} = {numbers[target]}")
        case ir.JumpIf(condition, when, target):
            text = values.condition(condition)
            either(text if when else f"[{text} EQ 0]", target)
        case ir.BeginFor(place, first, last, _, loop) as begun:
            step_of(begun)
            _counted(place)
            lines.append(f"{values.place(place)} = {values.real(first)}")
            lines.append(f"#<v_last_{loop}> = {values.real(last)}")
        case ir.TestFor(place, loop, leave):
            past = "GT" if loop_step(program, loop) > 0.0 else "LT"
            either(f"[{values.place(place)} {past} #<v_last_{loop}>]", leave)
        case ir.NextFor(place, loop, test):
            by = number(loop_step(program, loop))
            lines.append(f"{values.place(place)} = [{values.place(place)} + {by}]")
            lines.append(f"{GOTO} = {numbers[test]}")
        case ir.BeginCase(selector, case):
            lines.append(f"#<v_case_{case}> = {values.real(selector)}")
        case ir.TestCase(case, wanted, otherwise):
            tests = " OR ".join(f"[#<v_case_{case}> EQ {values.real(v)}]" for v in wanted)
            either(f"[[{tests}] EQ 0]", otherwise)
        case ir.Grasp():
            raise CannotSay("LinuxCNC has nothing that means GRASP")
        case _:
            return False
    return True


def _counted(place: Place) -> None:
    if isinstance(place.variable, Slot):
        raise CannotSay("a FOR counts with an argument", "count with another variable")
