"""What analog inputs are tried to read: a value for each way in which programs tell counts apart.

An input has at most 4096 counts. So each expression of it is worked out for all of them, by the
engine itself: counts for which all come to the same go on alike, and one of them stands for them.
Where programs do more with a count than that, some counts are tried: ends, boundaries, between.
"""

from collections.abc import Iterator, Sequence
from itertools import groupby, pairwise
from typing import NamedTuple, TypeAlias, cast

from vrts.engine.code.closures import Evaluate
from vrts.engine.code.layout import Layout
from vrts.engine.code.values.evaluate import compiler
from vrts.engine.code.values.operands import number_of
from vrts.engine.code.values.real_expressions import truth
from vrts.engine.faults import RuntimeFault
from vrts.engine.futures.regions import Numbers, compared_only, region
from vrts.engine.machine.forever.nodes import NODES, Node, all_nodes, children, tops
from vrts.engine.machine.machine import Machine
from vrts.engine.programs.context import Context
from vrts.engine.programs.outside import FreeSignals
from vrts.ir import instructions as ir
from vrts.ir.expressions import Apply, Binary, Constant, Expression, Function, Global, Place, Unary
from vrts.ir.module import Module
from vrts.ir.ranges import LEAST_COUNT, MOST_COUNT
from vrts.prove.environment.environment import Counts, Environment
from vrts.prove.graph.compared import compared

ALL = Counts(LEAST_COUNT, MOST_COUNT)
MOST_WAYS = 40  # in which an expression may come out, to be tried in every way
MOST_TRIED = 200  # counts that are all tried, whatever is done with them
_F = Function
PURE = frozenset(
    {
        *(_F.ADC, _F.ABS, _F.ATAN2, _F.COS, _F.SIN, _F.TAN, _F.FRACT, _F.INT, _F.ROUND, _F.MAX),
        *(_F.MIN, _F.OUTSIDE, _F.SIGN, _F.SQR, _F.SQRT, _F.BCD, _F.DCB),
    }
)  # functions of numbers alone

Signature: TypeAlias = tuple[object, ...]


class Asked(NamedTuple):
    """An expression of one analog input, and what is asked of it."""

    expression: Expression
    condition: bool = False  # whether it is true; else what it is
    among: Numbers | None = None  # where it lies among these; None: its very value


class Tried(NamedTuple):
    """What an analog input is tried to read."""

    counts: tuple[float, ...]
    sampled: bool  # others may lead to something else
    may: Counts  # what it may read

    @property
    def words(self) -> str:
        """What it may read, and of a sample what is tried."""
        least, most, listed = self.may
        if listed:
            return f"each of {', '.join(map(str, listed))}"
        if not self.sampled:
            return f"every count from {least} to {most}"
        shown = ", ".join(f"{count:g}" for count in self.counts)
        return f"{least} to {most}: {shown} only"


class Readings:
    """Says which counts of analog inputs are tried."""

    def __init__(self, environment: Environment, module: Module) -> None:
        """Take what they may read, and the programs that look at them."""
        self._may, self._module = environment.analog, module
        self._known: dict[int, Tried] = {}
        self._asked: dict[int, dict[Asked, None]] | None = None  # by channel

    def of(self, machine: Machine, channel: int) -> Tried:
        """Return what an analog input is tried to read in futures of a machine."""
        known = self._known.get(channel)
        if known is None:
            known = self._known[channel] = self._found(machine, channel)
        return known

    def known(self, channel: int) -> Tried:
        """Return the same once it was asked."""
        return self._known[channel]

    def _found(self, machine: Machine, channel: int) -> Tried:
        if self._asked is None:
            self._asked = _all_asked(self._module)
        may = self._may.get(channel, ALL)
        counts = may.values or tuple(range(may.least, may.most + 1))
        asked = [*self._asked.get(channel, ()), *self._asked.get(0, ())]
        few = [values for values in _values(machine, channel, asked, counts) if _are_few(values)]
        ways: dict[Signature, list[int]] = {}
        signatures = list(zip(*few, strict=True)) or [()] * len(counts)
        for count, signature in zip(counts, signatures, strict=True):
            ways.setdefault(signature, []).append(count)
        if len(few) == len(asked) and len(ways) <= MOST_TRIED:
            tried = sorted(min(alike, key=_from_zero) for alike in ways.values())
            return Tried(tuple(map(float, tried)), sampled=False, may=may)
        if len(counts) <= MOST_TRIED:
            return Tried(tuple(map(float, counts)), sampled=False, may=may)
        some = _some(counts, signatures, compared(self._module))
        return Tried(tuple(map(float, some)), sampled=True, may=may)


def _values(
    machine: Machine, channel: int, asked: Sequence[Asked], counts: Sequence[int]
) -> Iterator[tuple[object, ...]]:
    """Yield for each expression what is seen of it, for every count; nothing: it is of no input."""
    expressions = compiler(Layout())
    c = machine.copy().robot
    on = c.signals.on
    assert isinstance(on, FreeSignals)
    for one in asked:
        if 0 in _inputs(one.expression):
            yield tuple(counts)  # nobody knows which input it reads
            continue
        read = truth(expressions, one.expression) if one.condition else None
        look = expressions.value(one.expression) if read is None else cast("Evaluate", read)
        found: list[object] = []
        for count in counts:
            on.decided = {-channel: float(count)}
            found.append(_seen(look, c, one.among))
        yield tuple(found)


def _seen(look: Evaluate, c: Context, among: Numbers | None) -> object:
    try:
        value = look(c)
    except RuntimeFault as fault:
        return fault.kind
    return region(cast("float", value), among) if among is not None else value


def _are_few(values: Sequence[object]) -> bool:
    return len(set(values)) <= MOST_WAYS


def _some(
    counts: Sequence[int], signatures: Sequence[Signature], known: Sequence[float]
) -> list[int]:
    """Return ends, boundaries and what lies between them, of counts without gaps."""
    found = {counts[0], counts[-1], *(count for count in (0,) if counts[0] <= 0 <= counts[-1])}
    for _, run in groupby(zip(signatures, counts, strict=True), key=_signature):
        alike = [count for _, count in run]
        found |= {alike[0], alike[-1]}
    near = {round(number) + d for number in known for d in (-1, 0, 1)}
    found |= {count for count in near if counts[0] <= count <= counts[-1]}
    ordered = sorted(found)
    return sorted({*ordered, *((a + b) // 2 for a, b in pairwise(ordered))})


def _signature(entry: tuple[Signature, int]) -> Signature:
    return entry[0]


def _from_zero(count: int) -> tuple[int, bool]:
    return abs(count), count < 0


# --- what programs ask ----------------------------------------------------------------------------


def _all_asked(module: Module) -> dict[int, dict[Asked, None]]:
    """Return what programs ask of analog inputs; 0: of one whose number is computed."""
    found: dict[int, dict[Asked, None]] = {}
    held = compared_only(module, shown=True)
    for program in module.programs.values():
        for instruction in program.instructions:
            for channel, asked in _asked(instruction, held):
                found.setdefault(channel, {}).setdefault(asked)
    return found


def _asked(instruction: ir.Instruction, held: dict[str, Numbers]) -> Iterator[tuple[int, Asked]]:
    """Yield the expressions of one analog input each that an instruction looks at, whole ones."""
    condition, among = None, None
    match instruction:
        case ir.JumpIf(condition=condition) | ir.Wait(condition=condition):
            pass
        case ir.Assign(place=Place(variable=Global(name=name), subscripts=())) if name in held:
            among = held[name]
        case ir.Type():
            among = ()
        case _:
            pass
    for top in tops(instruction):
        for channel, node in _whole(top):
            yield channel, Asked(_bare(node), node is condition, among if node is top else None)


def _whole(node: Node) -> Iterator[tuple[int, Expression]]:
    """Yield what a part of an instruction asks of analog inputs, each as large as it can be."""
    inputs = _inputs(node)
    if not inputs:
        return
    if len(inputs) == 1 and _is_pure(node):
        yield next(iter(inputs)), cast("Expression", node)
        return
    if isinstance(node, Apply) and node.function is Function.ADC:
        yield 0, node
    for child in children(node):
        yield from _whole(child)


def _inputs(node: Node) -> set[int]:
    """Return the analog inputs that are read in a part of an instruction; 0: nobody knows which."""
    return {
        number_of(one.arguments[0]) or 0
        for one in all_nodes(node)
        if isinstance(one, Apply) and one.function is Function.ADC
    }


def _is_pure(node: Node) -> bool:
    """Return whether a value depends on nothing but numbers and analog inputs that are named."""
    match node:
        case Constant(value=value):
            return isinstance(value, float)
        case Apply(function=Function.ADC, arguments=arguments):
            return number_of(arguments[0]) is not None
        case Apply(function=function):
            if function not in PURE:
                return False
        case Unary() | Binary():
            pass
        case _:
            return False
    return all(_is_pure(child) for child in children(node))


def _bare(node: Expression) -> Expression:
    """Return an expression without where it stands: of two that are alike one is enough."""
    match node:
        case Constant():
            return node._replace(span=None)
        case Unary(operand=operand):
            return node._replace(operand=_bare(operand), span=None)
        case Binary(left=left, right=right):
            return node._replace(left=_bare(left), right=_bare(right), span=None)
        case Apply(arguments=arguments):
            bare = tuple(
                _bare(cast("Expression", one)) if isinstance(one, NODES) else one
                for one in arguments
            )
            return node._replace(arguments=bare, span=None)
        case _:
            return node
