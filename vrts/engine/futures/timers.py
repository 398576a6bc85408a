"""What programs ask of timers: of which readings it does not matter what they are to the full."""

import math
from collections.abc import Collection, Iterator, Mapping

from vrts.engine.futures.regions import COMPARISONS, Numbers, compared_only, number
from vrts.engine.futures.since import readings
from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Binary, Function, Global, Place
from vrts.ir.module import Module

NONE: Collection[str] = frozenset()


def most_compared(module: Module, since: Collection[str] = NONE) -> float:
    """Return what is more than all that timers are compared with; inf: more is done with them.

    Args:
        module: The programs.
        since: Variables that hold readings, of which only the time that has passed is asked.
    """
    held = compared_only(module)
    asked: list[float] = []
    for program in module.programs.values():
        for instruction in program.instructions:
            numbers = _asked_of_timers(instruction, held, since)
            if numbers is None:
                return math.inf
            asked += numbers
    return max((abs(number) for number in asked), default=0.0) + 1.0


def ever_new(module: Module, since: Collection[str] = NONE) -> Iterator[tuple[str, int]]:
    """Yield program and step of what does more with a timer than to compare it.

    Each of its readings makes another state, so futures that go on with it never meet.

    Args:
        module: The programs.
        since: As for `most_compared`.
    """
    held = compared_only(module)
    for program in module.programs.values():
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            if _asked_of_timers(instruction, held, since) is None:
                yield program.name, origin.step


def timers_read(module: Module, since: Collection[str]) -> Iterator[Apply]:
    """Yield where timers are read, but for what only the time that has passed is asked of."""
    held = compared_only(module)
    for program in module.programs.values():
        for instruction in program.instructions:
            passed = {id(one.timer) for one in readings(instruction, held) if one.name in since}
            for top in tops(instruction):
                for node in all_nodes(top):
                    if _is_timer(node) and id(node) not in passed:
                        assert isinstance(node, Apply)
                        yield node


def _asked_of_timers(
    instruction: ir.Instruction, held: Mapping[str, Numbers], since: Collection[str]
) -> list[float] | None:
    """Return the numbers that timers of an instruction are compared with, at once or later.

    None: more is done with one of them.
    """
    asked: list[float] = []
    nodes = [node for top in tops(instruction) for node in all_nodes(top)]
    timers = sum(map(_is_timer, nodes))
    timers -= sum(one.name in since for one in readings(instruction, held))
    for node in nodes:
        if isinstance(node, Binary) and node.operator in COMPARISONS:
            beside = list(_beside_timer(node))
            asked += beside
            timers -= len(beside)
    match instruction:
        case ir.Assign(
            place=Place(variable=Global(name=name), subscripts=()),
            value=Apply(function=Function.TIMER),
        ) if name in held:
            asked += held[name]
            timers -= 1
        case _:
            pass
    return asked if timers == 0 else None


def _beside_timer(node: Binary) -> Iterator[float]:
    """Yield the number that a timer is compared with."""
    for one, other in ((node.left, node.right), (node.right, node.left)):
        border = number(other)
        if _is_timer(one) and border is not None:
            yield border


def _is_timer(node: object) -> bool:
    return isinstance(node, Apply) and node.function is Function.TIMER
