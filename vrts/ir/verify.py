"""Structural validity of a module. Empty is valid; lowering is verified in every test."""

from vrts.ir.instructions import (
    BeginCase,
    BeginFor,
    NextFor,
    Return,
    TestCase,
    TestFor,
    jumps_of,
)
from vrts.ir.module import Module, Program


def verify(module: Module) -> list[str]:
    """Return what is wrong with a module, in words; an empty list when nothing is."""
    wrong: list[str] = []
    for name, program in module.programs.items():
        if name != program.name:
            wrong.append(f"program {program.name} is filed under {name}")
        wrong += [f"{name}: {fault}" for fault in _faults(program)]
    return wrong


def _faults(program: Program) -> list[str]:
    wrong: list[str] = []
    count = len(program.instructions)
    if not count or not isinstance(program.instructions[-1], Return):
        wrong.append("does not end with Return")
    if len(program.origins) != count:
        wrong.append(f"{count} instructions, {len(program.origins)} origins")
    numbers = [origin.step for origin in program.origins]
    if numbers != sorted(numbers):
        wrong.append("the steps of the instructions do not ascend")
    for k, first in enumerate(program.steps):
        if not 0 <= first < count:
            wrong.append(f"step {k + 1} begins outside the program")
        elif numbers[first] < k + 1 or (first and numbers[first - 1] >= k + 1):
            wrong.append(f"step {k + 1} does not begin at its first instruction")
    loops, cases = set[int](), set[int]()
    for i, instruction in enumerate(program.instructions):
        for target in jumps_of(instruction):
            if not 0 <= target < count:
                wrong.append(f"instruction {i} jumps outside the program")
        if isinstance(instruction, BeginFor):
            loops.add(instruction.loop)
            following = program.instructions[i + 1] if i + 1 < count else None
            if not isinstance(following, TestFor) or following.loop != instruction.loop:
                wrong.append(f"instruction {i}: a FOR is not followed by its test")
        elif isinstance(instruction, BeginCase):
            cases.add(instruction.case)
        elif isinstance(instruction, TestFor | NextFor) and instruction.loop not in loops:
            wrong.append(f"instruction {i} belongs to no loop")
        elif isinstance(instruction, TestCase) and instruction.case not in cases:
            wrong.append(f"instruction {i} belongs to no CASE")
    if loops != set(range(program.loops)) or cases != set(range(program.cases)):
        wrong.append("loops or cases are not numbered from 0 without gaps")
    slots = (*program.formals, *program.autos)
    if [slot.number for slot in slots] != list(range(len(slots))):
        wrong.append("formals are not numbered in their order")
    return wrong
