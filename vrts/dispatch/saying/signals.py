"""Which signals from outside a program looks at, and which it sets."""

from contextlib import suppress

from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.parts import constant, parts
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Constant, Function, Unary
from vrts.ir.module import Module

FIRST_INPUT, FIRST_INTERNAL = 1001, 2001  # VAL's numbers of signals


def signal_of(argument: object) -> tuple[int, bool]:
    """Return a signal and whether on is meant.

    Raises:
        CannotSay: Its number is worked out in the run.
    """
    value = constant(argument)
    if not value:
        raise CannotSay("the number of a signal is worked out in the run", "write a number")
    return round(abs(value)), value > 0.0


def bits_of(first: object, length: object) -> range:
    """Return the signals that BITS means.

    Raises:
        CannotSay: They are worked out in the run.
    """
    begun, count = constant(first), 1.0 if length is None else constant(length)
    if begun is None or count is None:
        raise CannotSay("the signals of BITS are worked out in the run", "write numbers")
    return range(round(begun), round(begun) + round(count))


def read_outputs(module: Module) -> frozenset[int]:
    """Return the outputs that programs look at."""
    found: set[int] = set()
    for program in module.programs.values():
        for part in parts(program.instructions):
            if isinstance(part, Apply):
                found |= _looked_at(part)
    return frozenset(signal for signal in found if signal < FIRST_INPUT)


def _looked_at(part: Apply) -> set[int]:
    if part.function is Function.SIG:
        return _numbers(part.arguments)
    if part.function is Function.BITS:
        with suppress(CannotSay):
            return set(bits_of(*(*part.arguments, None)[:2]))
    return set()


def used_signals(module: Module, entry: str) -> tuple[set[int], set[int]]:
    """Return inputs and outputs that stand in a program, and in all that it calls, by number."""
    inputs: set[int] = set()
    outputs: set[int] = set()
    seen: set[str] = set()
    waiting: list[str | None] = [entry]
    while waiting:
        name = waiting.pop()
        if name is None or name in seen or name not in module.programs:
            continue
        seen.add(name)
        for instruction in module.programs[name].instructions:
            if isinstance(instruction, ir.Call | ir.React | ir.StartProcess):
                waiting.append(instruction.program)
            if isinstance(instruction, ir.React):
                inputs |= _numbers((instruction.signal,))
            if isinstance(instruction, ir.Signal):
                outputs |= _numbers(instruction.signals)
            if isinstance(instruction, ir.SetBits):
                with suppress(CannotSay):  # told where it stands
                    outputs |= set(bits_of(instruction.first, instruction.length))
            for part in parts(instruction):
                if isinstance(part, Apply):
                    looked = _looked_at(part)
                    inputs |= looked
                    outputs |= {signal for signal in looked if signal < FIRST_INPUT}
    return (
        {signal for signal in inputs if FIRST_INPUT <= signal < FIRST_INTERNAL},
        {signal for signal in outputs if signal < FIRST_INPUT},
    )


def _numbers(arguments: tuple[object, ...]) -> set[int]:
    plain = [a.operand if isinstance(a, Unary) else a for a in arguments]
    return {
        abs(round(e.value)) for e in plain if isinstance(e, Constant) and isinstance(e.value, float)
    }
