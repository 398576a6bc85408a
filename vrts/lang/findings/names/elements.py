"""Elements that nothing gives a value, though others of the array have one.

Only what is sure is told: an index that is a number, or that FOR loops with known limits make, in
steps that every pass comes to.
"""

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any, NamedTuple

from vrts.ir.module import Datum
from vrts.ir.values import Type
from vrts.lang.findings.names.misused_words import UNDEFINED_VARIABLE
from vrts.lang.findings.names.untaught import NOT_GIVEN, UNDEFINED_LOCATION
from vrts.lang.findings.values.complaints import OPERAND_RANGE
from vrts.lang.meaning.constants import constant
from vrts.lang.meaning.scope import Entry, Place, Scope
from vrts.lang.meaning.structure import Block
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Element, Item, Name, Number, Parenthesised, Prefix
from vrts.lang.syntax.expressions import Infix as Operation
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    For,
    Goto,
    HereStatement,
    If,
    SetLocation,
    Simple,
    Statement,
    While,
)

MOST_PASSES = 400  # of the loops around an element
MOST_ELEMENTS = 2000  # that are looked at in a file
_LEAVING = frozenset({"RETURN", "RETURNE", "HALT", "STOP", "EXIT"})

_LEAVES = (Name, Number)  # which hold nothing
_GIVING = (Assignment, SetLocation, HereStatement)

Index = tuple[int, ...]
_Passes = list[dict[str, int]]  # the variables that count, in each pass


class _Use(NamedTuple):
    """An element in a step, and which elements it is in the passes of the loops around it."""

    node: Element
    step: Statement
    passes: _Passes
    indices: list[Index]
    certain: bool  # whether all passes come to it
    loop: For | None  # the innermost


def check_elements(
    problems: Problems,
    scope: Scope,
    programs: Sequence[ProgramText],
    structures: Mapping[str, list[Block]],
    data: Sequence[Datum],
) -> None:
    """Warn of elements that are read and surely have no value, or an index below 0."""
    arrays = [entry for entry in scope.entries.values() if entry.array is not None and entry.reads]
    if not arrays or problems.dialect.tolerant:
        return
    left = MOST_ELEMENTS
    text = problems.source.text
    given: dict[str, set[Index]] = {}
    written: dict[str, set[int]] = {}  # where, as far as it is known which elements
    for datum in data:
        if datum.subscripts:
            given.setdefault(datum.name, set()).add(datum.subscripts)
    reads: list[_Use] = []
    for program in programs:
        loops = _Loops(scope, program, structures[program.name])
        for at, step in enumerate(program.steps):
            if left <= 0:
                break
            node = step.statement
            if node is None or text.find("[", node.start, node.end) < 0:
                continue
            for element in _elements(node):
                left -= 1
                if key(element.name.text) in scope.formals[program.name]:
                    continue
                use = loops.use(at, node, element) if left > 0 else None
                if use is None:
                    continue
                name = key(element.name.text)
                if element is getattr(node, "target", None):
                    if not isinstance(node, _GIVING):
                        continue  # DECOMPOSE gives values to several
                    given.setdefault(name, set()).update(use.indices)
                    written.setdefault(name, set()).add(element.name.start)
                elif use.certain:
                    reads.append(use)
    bodies = [(program.start, program.finish[1]) for program in programs]
    told: set[str] = set()
    for use in reads:
        name = key(use.node.name.text)
        entry = scope.entries.get(name)
        if entry is None or name in told:
            continue
        negative = next((i for i in use.indices if min(i) < 0), None)
        if negative is not None:
            _below(problems, use, negative)
            told.add(name)
        elif _all_known(entry, written.get(name, set()), bodies) and given.get(name):
            lost = [index for index in use.indices if index not in given[name]]
            if lost:
                _not_given(problems, entry, use, lost[0], given[name])
                told.add(name)


class _Loops:
    """The FOR loops of a program, and what their variables are in each pass."""

    def __init__(self, scope: Scope, program: ProgramText, found: Sequence[Block]) -> None:
        self.scope = scope
        self.program = program
        self.blocks = sorted(found, key=lambda block: block.opener)
        self.counted: dict[int, list[int] | None] = {}
        self.certain_to = _first_that_leaves(program)

    def use(self, at: int, step: Statement, node: Element) -> _Use | None:
        """Return which elements a node of a step is; None where that is not known."""
        names = set(_names(node.subscripts))
        values: dict[str, list[int]] = {}
        certain, loop = True, None
        for block in self.blocks:
            if block.opener > at:
                break
            if not block.opener < at < block.end:
                continue
            opener = self.program.steps[block.opener].statement
            if not isinstance(opener, For) or not isinstance(opener.target, Name):
                certain = False
                continue
            name = key(opener.target.text)
            numbers = self._values(block, opener)
            if numbers is None:
                certain = False
                values.pop(name, None)
                continue
            certain = certain and not self._left(block)
            loop = opener
            if name in names:
                values[name] = numbers
        if not names <= values.keys():
            return None
        order = [name for name in values if name in names]
        count = 1
        for name in order:
            count *= len(values[name])
        if not 0 < count <= MOST_PASSES:
            return None
        passes = [
            dict(zip(order, numbers, strict=True))
            for numbers in product(*(values[name] for name in order))
        ]
        indices: list[Index] = []
        for counted in passes:
            parts = [_whole(part, counted) for part in node.subscripts]
            known = [part for part in parts if part is not None]
            if len(known) < len(parts) or not known:
                return None
            indices.append(tuple(known))
        return _Use(node, step, passes, indices, certain and at <= self.certain_to, loop)

    def _values(self, block: Block, node: For) -> list[int] | None:
        """Return what the variable of a FOR counts; None where it is not known."""
        if block.opener not in self.counted:
            self.counted[block.opener] = self._count(block, node)
        return self.counted[block.opener]

    def _count(self, block: Block, node: For) -> list[int] | None:
        name = self.program.name
        first, last = constant(self.scope, name, node.first), constant(self.scope, name, node.last)
        by = constant(self.scope, name, node.increment) if node.increment is not None else 1.0
        if first is None or last is None or by is None or by == 0.0:
            return None
        if any(value != round(value) for value in (first, last, by)):
            return None
        if not 0 <= (last - first) / by < MOST_PASSES:
            return None
        target = key(node.target.text) if isinstance(node.target, Name) else ""
        for step in self.program.steps[block.opener + 1 : block.end]:
            inner = getattr(step.statement, "target", None)
            if isinstance(inner, Name) and key(inner.text) == target:
                return None
        end = round(last) + (1 if by > 0 else -1)
        return list(range(round(first), end, round(by)))

    def _left(self, block: Block) -> bool:
        """Whether a step of a loop may leave it."""
        for step in self.program.steps[block.opener + 1 : block.end]:
            node = step.statement
            if isinstance(node, Goto) or (isinstance(node, Simple) and node.word in _LEAVING):
                return True
        return False


def _first_that_leaves(program: ProgramText) -> int:
    """Return the first step that jumps or may end the program: up to it, every step is come to."""
    for at, step in enumerate(program.steps):
        node = step.statement
        if isinstance(node, Goto):
            return at
        if isinstance(node, Simple) and node.word in _LEAVING:
            return at
    return len(program.steps)


def _all_known(entry: Entry, known: set[int], bodies: Sequence[Place]) -> bool:
    """Whether it is known which elements of an array get values, in programs and data."""
    if entry.passed or entry.asked or entry.slot is not None or entry.both:
        return False
    return all(
        at in known or not any(start <= at < end for start, end in bodies) for at, _ in entry.writes
    )


def _below(problems: Problems, use: _Use, index: Index) -> None:
    when = _when(use, index)
    problems.warning(
        OPERAND_RANGE,
        f"an index cannot be {min(index)}",
        use.node.start,
        use.node.end,
        when,
        notes=("the controller stops here",),
        help=("the first element has index 0: begin the loop higher, or add to the index",),
    )


def _not_given(
    problems: Problems, entry: Entry, use: _Use, index: Index, given: set[Index]
) -> None:
    name = entry.name
    shown = f"{name}[{', '.join(map(str, index))}]"
    low, high = (f"{name}[{', '.join(map(str, end))}]" for end in (min(given), max(given)))
    has = f"`{low}`" if low == high else f"`{low}` to `{high}`"
    location = entry.type in (Type.POSE, Type.JOINTS)
    place = (use.node.start, use.node.end)
    help_ = f"values have {has}: give `{shown}` one, too, or write another index"
    loop = use.loop
    if loop is not None and len(index) == 1 and isinstance(use.node.subscripts[0], Name):
        place = (loop.start, loop.end)
        first, last = min(given)[0], max(given)[0]
        counter = problems.source.text[loop.target.start : loop.target.end]
        if len(given) == last - first + 1 and loop.increment is None:
            help_ = f"values have {has}: write `FOR {counter} = {first} TO {last}`"
    problems.warning(
        UNDEFINED_LOCATION if location else UNDEFINED_VARIABLE,
        f"`{shown}` is never given a value in this file",
        *place,
        _when(use, index),
        secondary=(problems.label(use.node.start, use.node.end, "used here"),)
        if place[0] != use.node.start
        else (),
        notes=(NOT_GIVEN,),
        help=(help_,),
        data={"name": name},
    )


def _when(use: _Use, index: Index) -> str:
    """Return in which pass an element has an index."""
    counted = use.passes[use.indices.index(index)]
    return ", ".join(f"where `{name}` is {value}" for name, value in counted.items())


def _whole(node: Item | None, counted: Mapping[str, int]) -> int | None:
    """Return a whole number that an index is; None where it is not known, or no whole number."""
    match node:
        case Number(value):
            return round(value) if value == round(value) else None
        case Name(text):
            return counted.get(key(text))
        case Parenthesised(inner):
            return _whole(inner, counted)
        case Prefix("-", operand):
            value = _whole(operand, counted)
            return None if value is None else -value
        case Operation(operator, left, right) if operator in ("+", "-", "*"):
            one, other = _whole(left, counted), _whole(right, counted)
            if one is None or other is None:
                return None
            return {"+": one + other, "-": one - other, "*": one * other}[operator]
        case _:
            return None


def _names(nodes: Sequence[Any]) -> Iterator[str]:
    waiting: list[Any] = [node for node in nodes if node is not None]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Name):
            yield key(part.text)
        else:
            waiting += [inner for inner in part if isinstance(inner, tuple)]


def _elements(node: Any) -> Iterator[Element]:
    """Return the elements of arrays in a step; of conditions, which may not come to all, none."""
    if isinstance(node, If | While):
        return
    waiting: list[Any] = [node]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Element) and part.subscripts:
            yield part
        if not isinstance(part, _LEAVES):
            waiting += [inner for inner in part if isinstance(inner, tuple)]
