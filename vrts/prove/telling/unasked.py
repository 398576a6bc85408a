"""What programs read that is always the same here, whatever it is at a real controller."""

from collections.abc import Collection, Iterable, Iterator

from vrts.engine.machine.forever.nodes import all_nodes, tops
from vrts.engine.programs.loaded import Loaded
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Function

NO_OTHER_TIME = "here the controller is switched on at midnight, and no other time was tried"
UNASKED = {
    Function.PENDANT: ("PENDANT", "nobody presses a key here, and nothing else was tried"),
    Function.TIME: ("TIME", NO_OTHER_TIME),
    Function.TIME_TEXT: ("$TIME", NO_OTHER_TIME),
    Function.DATE_TEXT: ("$DATE", "it is always 1 January 1988 here, and no other day was tried"),
}


def unasked(loaded: Iterable[Loaded], executed: Collection[int]) -> Iterator[str]:
    """Yield what executed steps read of which one value alone was tried.

    A step that only types it decides nothing.

    Args:
        loaded: The programs.
        executed: Numbers of the instructions that some future executes.
    """
    for one in loaded:
        told: set[tuple[int, str]] = set()
        for k, instruction in enumerate(one.program.instructions):
            if one.base + k not in executed or isinstance(instruction, ir.Type):
                continue
            step = one.program.origins[k].step
            for top in tops(instruction):
                for node in all_nodes(top):
                    if isinstance(node, Apply) and node.function in UNASKED:
                        name, words = UNASKED[node.function]
                        if (step, name) not in told:
                            told.add((step, name))
                            yield f"step {step} of `{one.program.name}` reads {name}: {words}"
