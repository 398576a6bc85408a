"""Numbers that the programs know: with these whatever comes from outside may be compared."""

from typing import cast

from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Constant, Function
from vrts.ir.module import Module

COMPARE = (ir.Assign, ir.JumpIf, ir.Wait, ir.BeginFor, ir.BeginCase, ir.TestCase, ir.Grasp)


def compared(module: Module) -> list[float]:
    """Return the numbers that a variable may be compared with sooner or later."""
    found: list[float] = []
    left: list[object] = [
        instruction
        for program in module.programs.values()
        for instruction in program.instructions
        if isinstance(instruction, COMPARE)
    ]
    while left:
        match left.pop():
            case Apply(function=Function.SIG | Function.BITS | Function.TIMER | Function.ADC):
                pass  # numbers of signals, timers and analog inputs
            case Constant(value=float(number)):
                found += [number, -number]
            case part:
                if isinstance(part, tuple):
                    left += cast("tuple[object, ...]", part)
    return found
