"""What programs may still do in the tick under way, from where they are.

Which inputs they may look at: what was decided about others makes no difference any more. And how
many statements they may execute: how much of the share is left makes no difference to who cannot
use it up. Both are told too large rather than too small.
"""

import math

from vrts.engine.code.values.operands import number_of
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.engine.machine.forever.touches import signals_looked_at
from vrts.engine.machine.machine import Machine, in_turn
from vrts.engine.programs.context import Context
from vrts.engine.programs.signals import INPUTS
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Module
from vrts.ir.ranges import ANALOG_INPUTS

NONE: frozenset[int] = frozenset()
ANALOG = frozenset(-channel for channel in ANALOG_INPUTS)  # as decisions have them
OUTSIDE = ANALOG.union(INPUTS)
ELSEWHERE = (ir.Call, ir.CallNamed, ir.React, ir.ReactError, ir.StartProcess)


class Ahead:
    """What the programs of a module may look at, by instruction."""

    def __init__(self, module: Module) -> None:
        """Go through the programs."""
        own = {
            name: [_looked_at(instruction) for instruction in program.instructions]
            for name, program in module.programs.items()
        }
        self._all = NONE.union(*(inputs for of in own.values() for inputs in of))
        self._most = {
            name: _longest(program.instructions) for name, program in module.programs.items()
        }
        self._skips = any(
            isinstance(instruction, ir.Return) and instruction.skip is not None
            for program in module.programs.values()
            for instruction in program.instructions
        )  # RETURN n goes on anywhere in what called
        self._from = {
            name: _backward(program.instructions, own[name], self._all)
            for name, program in module.programs.items()
        }

    def of(self, machine: Machine) -> frozenset[int]:
        """Return the inputs that may still be looked at in the tick under way."""
        mid = machine.mid
        if mid is None:
            return NONE
        running = [c for c in in_turn(machine)[mid.turn :] if c.running]
        if len(running) == 1:
            return self._of(running[0])
        return NONE.union(*(self._of(c) for c in running))

    def statements(self, c: Context) -> float:
        """Return how many statements a program executes at most, without its reactions."""
        if c.watches or c.error_program is not None or c.cycles_left != 1:
            return math.inf
        loaded = c.system.programs.loaded
        most = 0.0
        for frame in c.frames:
            known = self._most[loaded[frame.program].program.name]
            most += known[min(frame.index, len(known) - 1)] if known else 0.0
        return most

    def _of(self, c: Context) -> frozenset[int]:
        if c.watches or c.error_program is not None or (self._skips and len(c.frames) > 1):
            return self._all.union(watch.signal for watch in c.watches)
        loaded = c.system.programs.loaded
        if len(c.frames) == 1 and c.cycles_left == 1:
            frame = c.frames[0]
            known = self._from[loaded[frame.program].program.name]
            return known[min(frame.index, len(known) - 1)] if known else NONE
        found = NONE
        for frame in c.frames:
            known = self._from[loaded[frame.program].program.name]
            found |= known[min(frame.index, len(known) - 1)] if known else NONE
        return found if c.cycles_left == 1 else self._all


def _looked_at(instruction: ir.Instruction) -> frozenset[int]:
    found: frozenset[int] = NONE
    for top in tops(instruction):
        for node in all_nodes(top):
            if isinstance(node, Apply):
                signals = signals_looked_at(node)
                found |= frozenset(INPUTS) if signals is None else signals
                if node.function is Function.ADC:
                    channel = number_of(node.arguments[0])
                    found |= ANALOG if channel is None else {-channel}
    if isinstance(instruction, ir.React):
        found |= frozenset(INPUTS)
    return found & OUTSIDE


def _backward(
    instructions: tuple[ir.Instruction, ...], own: list[frozenset[int]], every: frozenset[int]
) -> list[frozenset[int]]:
    """Return what may be looked at from each instruction on."""
    found = [
        inputs | every if isinstance(instruction, ELSEWHERE) else inputs
        for instruction, inputs in zip(instructions, own, strict=True)
    ]
    changed = True
    while changed:
        changed = False
        for k in range(len(found) - 1, -1, -1):
            ways = (k + 1, *jumps_of(instructions[k]))
            new = found[k].union(*(found[way] for way in ways if way < len(found)))
            if new != found[k]:
                found[k], changed = new, True
    return found


def _longest(instructions: tuple[ir.Instruction, ...]) -> list[float]:
    """Return the most statements from each instruction on; inf where a way leads back or away."""
    found = [math.inf] * (len(instructions) + 1)
    found[-1] = 0.0
    for k in range(len(instructions) - 1, -1, -1):
        instruction = instructions[k]
        ways = (k + 1, *jumps_of(instruction))
        if not isinstance(instruction, ELSEWHERE) and min(ways) > k:
            found[k] = 1.0 + max(found[min(way, len(instructions))] for way in ways)
    return found[:-1]
