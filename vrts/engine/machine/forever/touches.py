"""What instructions look at, and what they change, as far as their text tells.

Both are told too large rather than too small: a signal whose number is computed is any signal, and
an argument stands for every variable that any call passes.
"""

from collections.abc import Iterable
from typing import NamedTuple

from vrts.engine.code.values.operands import number_of
from vrts.engine.code.values.volatile import CLOCKS, SWAPS
from vrts.engine.machine.forever.nodes import Node, all_nodes, tops
from vrts.engine.programs.signals import OUTPUTS
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function, Global, Place, Slot, WholeArray
from vrts.ir.module import Module

Code = Iterable[ir.Instruction]

ARM = frozenset(
    {
        Function.HERE,
        Function.HERE_JOINTS,
        Function.DEST,
        Function.DEST_JOINTS,
        Function.BASE,
        Function.TOOL,
        Function.INRANGE,
        Function.HAND,
        Function.STATE,
        Function.SPEED,
        Function.SWITCH,
        Function.PARAMETER,
    }
)  # functions that ask arm, hand or settings
OTHER = frozenset({Function.STATUS, Function.FREE, Function.OPAQUE})  # they depend on anything
DISTURBS = (ir.Brake, ir.SetMonitorSpeed, ir.Switch, ir.SetParameter, ir.Prompt)


class Looks(NamedTuple):
    """What some instructions look at."""

    signals: frozenset[int] = frozenset()
    names: frozenset[str] = frozenset()  # of global variables
    any_signal: bool = False
    clock: bool = False  # also random numbers
    arm: bool = False  # where it is, what is set, and what the hand does
    other: bool = False  # something that cannot be told apart


class Changes(NamedTuple):
    """What some instructions may change."""

    signals: frozenset[int] = frozenset()
    names: frozenset[str] = frozenset()
    any_signal: bool = False
    arm: bool = False  # the arm, what is set, or which answers are left

    def touch(self, looks: Looks) -> bool:
        """Return whether something that is looked at may change."""
        return (
            looks.other
            or bool(self.signals & looks.signals)
            or (self.any_signal and bool(looks.signals or looks.any_signal))
            or (looks.any_signal and bool(self.signals))
            or bool(self.names & looks.names)
            or (self.arm and looks.arm)
        )


def passed(module: Module) -> frozenset[str]:
    """Return the variables that any call passes: each may be what an argument stands for."""
    calls = (
        instruction
        for program in module.programs.values()
        for instruction in program.instructions
        if isinstance(instruction, ir.Call | ir.CallNamed)
    )
    return frozenset(
        argument.variable.name
        for call in calls
        for argument in call.arguments
        if isinstance(argument, Place | WholeArray) and isinstance(argument.variable, Global)
    )


def looks_of(nodes: Iterable[Node], aliases: frozenset[str]) -> Looks:
    """Return what expressions look at; `aliases` is what arguments may stand for."""
    signals: set[int] = set()
    names: set[str] = set()
    any_signal = clock = arm = other = False
    for top in nodes:
        for node in all_nodes(top):
            if isinstance(node, Place | WholeArray):
                names |= _names(node, aliases)
            if not isinstance(node, Apply):
                continue
            found = signals_looked_at(node)
            any_signal |= found is None
            signals |= found or set()
            clock |= node.function in CLOCKS
            arm |= node.function in ARM
            other |= node.function in OTHER or node.function in SWAPS
    return Looks(frozenset(signals), frozenset(names), any_signal, clock, arm, other)


def changes_of(code: Code, aliases: frozenset[str]) -> Changes:
    """Return what instructions may change."""
    signals: set[int] = set()
    names: set[str] = set()
    any_signal = arm = False
    for instruction in code:
        found = _signals_set(instruction)
        any_signal |= found is None
        signals |= found or set()
        arm |= isinstance(instruction, DISTURBS)
        for top in tops(instruction):
            if isinstance(top, Place | WholeArray):
                names |= _names(top, aliases)
            for node in all_nodes(top):
                if isinstance(node, Apply) and node.function in SWAPS:
                    for argument in node.arguments:
                        names |= _swapped(argument, aliases)
    return Changes(frozenset(signals), frozenset(names), any_signal, arm)


def _names(node: Place | WholeArray, aliases: frozenset[str]) -> frozenset[str]:
    return aliases if isinstance(node.variable, Slot) else frozenset({node.variable.name})


def _swapped(argument: object, aliases: frozenset[str]) -> frozenset[str]:
    place = getattr(argument, "place", argument)
    return _names(place, aliases) if isinstance(place, Place) else frozenset()


def signals_looked_at(node: Apply) -> set[int] | None:
    """Return the signals that a function looks at; None when they cannot be told."""
    if node.function is Function.SIG:
        numbers = [number_of(argument) for argument in node.arguments]
        return None if None in numbers else {abs(n) for n in numbers if n is not None}
    if node.function is Function.BITS:
        return _run(*node.arguments[:2])
    return set()


def _signals_set(instruction: ir.Instruction) -> set[int] | None:
    """Return the signals that an instruction changes; None when they cannot be told."""
    match instruction:
        case ir.Signal(signals=signals):
            numbers = [number_of(signal) for signal in signals]
        case ir.Pulse(signal=signal) | ir.DelayedSignal(signal=signal):
            numbers = [number_of(signal)]
        case ir.SetBits(first=first, length=length):
            return _run(first, length)
        case ir.Reset():
            return set(OUTPUTS)
        case _:
            return set()
    return None if None in numbers else {abs(n) for n in numbers if n is not None}


def _run(first: object, length: object) -> set[int] | None:
    begin, many = number_of(first), number_of(length)
    return None if begin is None or many is None else set(range(begin, begin + many))
