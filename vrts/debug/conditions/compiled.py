"""A text made ready to be asked often, for one kind of what its names stand for."""

from array import array
from collections.abc import Mapping, Sequence
from contextlib import suppress
from typing import NamedTuple, cast

from vrts.debug.conditions.elements import Elements
from vrts.debug.conditions.functions import Functions
from vrts.debug.conditions.past import Past
from vrts.debug.conditions.vectors import Columns, NotAtOnce
from vrts.engine.code.closures import Evaluate
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.evaluate import compiler
from vrts.engine.code.values.functions import PURE
from vrts.engine.code.values.volatile import SWAPS
from vrts.engine.memory.cells import UNDEFINED, Array, Bound, Cell, Memory
from vrts.ir.data import Assign
from vrts.ir.expressions import Apply, Function
from vrts.ir.module import Module
from vrts.ir.values import Type

# what changes between two ticks, at which commands come
_MOVES = frozenset(
    {
        *(Function.HERE, Function.HERE_JOINTS, Function.HAND, Function.TIMER),
        *(Function.TIME, Function.TIME_TEXT, Function.DATE_TEXT),
    }
)
_RECORDED = frozenset(PURE) | {
    *_MOVES,
    *SWAPS,  # they change variables that stand for the program's
    Function.SWITCH,
    Function.PARAMETER,
    Function.PENDANT,
    Function.ERROR_TEXT,
    Function.SIG,
    Function.BITS,
    Function.DEFINED,
    Function.ENCODE,
    Function.UNPACK,
    Function.LAST,
    Function.BASE,
    Function.TOOL,
}
# what was noted of the machine itself
_OF_THE_MACHINE = frozenset(
    {
        *(Function.RANDOM, Function.DEST, Function.DEST_JOINTS, Function.INRANGE, Function.SPEED),
        *(Function.ADC, Function.PRIORITY, Function.STATE, Function.STATUS, Function.ERROR),
        Function.FREE,
    }
)


class Compiled(NamedTuple):
    """An expression made ready."""

    problem: str = ""  # why it cannot be read; empty: it can
    evaluate: Evaluate | None = None  # None: the controller itself has to be asked
    at_once: Columns | None = None  # the same at many instants; None: it cannot be
    wanted: Type = Type.REAL
    at_ticks: bool = False  # what it asks for changes between two ticks
    swaps: bool = False  # it changes its variables
    memory: Memory = Memory([])
    cells: Sequence[tuple[int, Cell]] = ()  # scalars, beside their places in the names
    arrays: Sequence[tuple[int, Elements]] = ()

    def forget(self) -> None:
        """Let its variables be as if it had never been asked."""
        for bound in self.memory.bound:
            if isinstance(bound, Array):
                bound.elements.clear()
            else:
                bound.value, bound.since, bound.values = UNDEFINED, array("I"), array("d")


def unreadable(problem: str) -> Compiled:
    """Return what an expression is that cannot be read."""
    return Compiled(problem)


def made(
    module: Module,
    names: Sequence[str],
    sources: Sequence[Bound | None],
    finished: int,
    past: Past,
    functions: Functions,
) -> Compiled:
    """Compile an expression that was read.

    Args:
        module: It gives its value to a variable, in a program of one step.
        names: What the expression names.
        sources: What the names stand for, beside them.
        finished: Statements that are finished where that is so.
        past: What the expression asks where histories tell.
        functions: What compiles it for many instants at once.
    """
    (program,) = module.programs.values()
    step, *others = program.instructions
    asked = set(_functions(step))
    told = not asked & (_OF_THE_MACHINE | {Function.TIMER}) or past.facts is not None
    known = told and asked <= _RECORDED | _OF_THE_MACHINE
    if len(others) != 1 or not isinstance(step, Assign) or not known:
        return Compiled()
    layout = Layout()
    evaluate = compiler(layout).value(step.value)
    by_name = dict(zip(names, enumerate(sources), strict=True))
    bound: list[Bound] = []
    cells: list[tuple[int, Cell]] = []
    arrays: list[tuple[int, Elements]] = []
    same: dict[int, Bound] = {}  # two names may stand for one variable
    for name in layout.names:
        k, source = by_name.get(name, (-1, None))
        item: Bound
        if source is not None and id(source) in same:
            item = same[id(source)]
        elif isinstance(source, Array):
            item = Array(name)
            item.elements = Elements(name, past)
            arrays.append((k, item.elements))
        elif name in layout.arrays and (source is None or source.at(finished) is UNDEFINED):
            item = Array(name)
        else:
            item = Cell(name)
            if source is not None:
                cells.append((k, item))
        if source is not None:
            same[id(source)] = item
        bound.append(item)
    at_once: Columns | None = None
    with suppress(NotAtOnce):  # then it is asked at each instant alone
        at_once = functions.real(step.value, _places(names))
    return Compiled(
        "",
        evaluate,
        at_once,
        step.place.variable.type,
        bool(asked & _MOVES),
        bool(asked & SWAPS),
        Memory(bound),
        cells,
        arrays,
    )


def _places(names: Sequence[str]) -> Mapping[str, int]:
    return {name: k for k, name in enumerate(names)}


def _functions(node: object) -> "list[Function]":
    """Return the functions that a step asks."""
    if not isinstance(node, tuple):
        return []
    inner = [function for part in cast("tuple[object, ...]", node) for function in _functions(part)]
    return [node.function, *inner] if isinstance(node, Apply) else inner
