"""Which instruction of the new programs each of the old ones is, and which say something else."""

from collections.abc import Iterator, Mapping
from typing import NamedTuple, TypeAlias, cast

from vrts.base.source import Span
from vrts.ir import instructions as ir
from vrts.ir.expressions import Global
from vrts.ir.module import Module, Program

Spans: TypeAlias = dict[Span, Span]
_TARGETS: Mapping[type, str] = {
    ir.Jump: "target",
    ir.JumpIf: "target",
    ir.TestFor: "leave",
    ir.NextFor: "test",
    ir.TestCase: "otherwise",
}
_NOT_ON = (ir.Jump, ir.NextFor, ir.Return, ir.ReturnError, ir.Stop, ir.Halt)
_LEAPS = (ir.ReturnError,)  # they go on at a step that nothing in them names


class Aligned(NamedTuple):
    """An old program beside the new one of its name."""

    places: Mapping[int, int]  # of old instructions: where the new program is then
    differ: frozenset[int]  # old instructions that say something else, or go on elsewhere


class Changes(NamedTuple):
    """What two modules do not have in common, beside their steps."""

    programs: frozenset[str]  # in one of them only, or with other arguments
    data: frozenset[str]  # variables whose first values differ
    is_same: bool  # every program does the same


def changes(old: Module, new: Module) -> Changes:
    """Return what differs between two modules, but for their steps."""
    names = {*old.programs, *new.programs}
    other = {
        name
        for name in names
        if name not in old.programs
        or name not in new.programs
        or _head(old.programs[name]) != _head(new.programs[name])
    }
    before = {(d.name, d.subscripts): d.value for d in old.data}
    after = {(d.name, d.subscripts): d.value for d in new.data}
    data = {key[0] for key in {*before, *after} if before.get(key) != after.get(key)}
    same = not other and all(
        alike(old.programs[name].instructions, new.programs[name].instructions, {})
        for name in names
    )
    return Changes(frozenset(other), frozenset(data), same)


def aligned(old: Program, new: Program, changed: Changes, spans: Spans) -> Aligned:
    """Return which instructions of two programs of one name are the same.

    Args:
        old: A program.
        new: The program in its place; it has the same arguments.
        changed: What else differs: what an instruction speaks of.
        spans: Gains where the places of the old text are in the new one.
    """
    spans[old.span] = new.span
    places: dict[int, int] = {}
    differ: set[int] = set()
    to_do = [(0, 0, -1)]
    while to_do:
        at, to, before = to_do.pop()
        if at >= len(old.instructions) or to >= len(new.instructions):
            differ.add(before)
            continue
        if at in places:
            if places[at] != to:
                differ.add(before)
            continue
        places[at] = to
        one, other = old.instructions[at], new.instructions[to]
        field = _TARGETS.get(type(one))
        mine = _without(one, field)
        if type(one) is not type(other) or not alike(mine, _without(other, field), spans):
            differ.add(at)
            continue
        spans[old.origins[at].span] = new.origins[to].span
        leaps = isinstance(one, _LEAPS) or (isinstance(one, ir.Return) and one.skip is not None)
        if _speaks_of(one, changed) or (leaps and not changed.is_same):
            differ.add(at)
        if field is not None:
            to_do.append((getattr(one, field), getattr(other, field), at))
        if not isinstance(one, _NOT_ON):
            to_do.append((at + 1, to + 1, at))
    return Aligned(places, frozenset(differ))


def alike(one: object, other: object, spans: Spans) -> bool:
    """Return whether two parts of instructions say the same, wherever they stand in their texts."""
    if isinstance(one, Span):
        if isinstance(other, Span):
            spans.setdefault(one, other)
        return isinstance(other, Span)
    if isinstance(one, tuple):
        mine, theirs = cast("tuple[object, ...]", one), cast("tuple[object, ...]", other)
        return (
            type(mine) is type(theirs)
            and len(mine) == len(theirs)
            and all(alike(a, b, spans) for a, b in zip(mine, theirs, strict=True))
        )
    return type(one) is type(other) and repr(one) == repr(other)


def _without(one: ir.Instruction, field: str | None) -> object:
    return one if field is None else one._replace(**{field: 0})  # type: ignore[arg-type]


def _head(program: Program) -> tuple[object, ...]:
    slots = [(slot.name, slot.number, slot.type) for slot in (*program.formals, *program.autos)]
    return (len(program.formals), slots, program.array_formals)


def _speaks_of(one: object, changed: Changes) -> bool:
    """Return whether an instruction names what differs; a name in a string may be any program's."""
    if isinstance(one, ir.CallNamed) and changed.programs:
        return True
    return any(
        name in (changed.data if is_variable else changed.programs)
        for name, is_variable in _names(one)
    )


def _names(node: object) -> Iterator[tuple[str, bool]]:
    """Yield the names in an instruction, and whether each is that of a variable."""
    if isinstance(node, Global):
        yield node.name, True
    elif isinstance(node, str):
        yield node, False
    elif isinstance(node, tuple) and not isinstance(node, Span):
        for part in cast("tuple[object, ...]", node):
            yield from _names(part)
