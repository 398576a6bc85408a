"""How programs use their locations: as places, behind a frame, as tools, or as what they work out.

What a subroutine does with an argument counts for whatever is given to it.
"""

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias, cast

from vrts.base.source import Span
from vrts.ir.control import Call
from vrts.ir.expressions import (
    Apply,
    Compose,
    Constant,
    Expression,
    Load,
    Place,
    Slot,
    Variable,
    WholeArray,
)
from vrts.ir.module import Module
from vrts.ir.motion import SetTool

_Key: TypeAlias = tuple[str, int, str]
"""A variable: its program and slot where it is an argument or its own, else ("", -1, name)."""


class Uses(NamedTuple):
    """What is done with one variable."""

    as_place: bool = False
    behind: tuple[Expression, ...] = ()  # what it stands behind in a compound; empty: in none
    as_tool: bool = False
    written: Span | None = None  # the first step that gives it a value


class _Found(NamedTuple):
    key: _Key
    uses: Uses


class _Passed(NamedTuple):
    key: _Key  # of what is passed
    to: _Key


def uses_of(module: Module) -> dict[str, Uses]:
    """Return what programs do with each variable of the controller's memory, by its name."""
    known: dict[_Key, Uses] = {}
    passed: list[_Passed] = []
    for program in module.programs.values():
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            for one in _of_instruction(instruction, origin.span, program.name):
                if isinstance(one, _Passed):
                    passed.append(one)
                else:
                    known[one.key] = _both(known.get(one.key, Uses()), one.uses)
    changed = True
    while changed:  # until what arguments are used for is known of all that is given to them
        changed = False
        for key, to in passed:
            before = known.get(key, Uses())
            after = _both(before, known.get(to, Uses()))
            changed |= after != before
            known[key] = after
    return {name: uses for (program, _, name), uses in known.items() if not program}


def _both(one: Uses, other: Uses) -> Uses:
    return Uses(
        one.as_place or other.as_place,
        one.behind or other.behind,
        one.as_tool or other.as_tool,
        one.written or other.written,
    )


def _of_instruction(instruction: object, span: Span, program: str) -> Iterator[_Found | _Passed]:
    if isinstance(instruction, Call):
        for number, argument in enumerate(instruction.arguments):
            if isinstance(argument, Place | WholeArray):
                key = _key(argument.variable, program)
                yield _Passed(key, (instruction.program, number, ""))
                yield from _read(getattr(argument, "subscripts", ()), Uses(as_place=True), program)
            else:
                yield from _read(argument, Uses(as_place=True), program)
        return
    how = Uses(as_tool=True) if isinstance(instruction, SetTool) else Uses(as_place=True)
    fields = cast("tuple[object, ...]", instruction) if isinstance(instruction, tuple) else ()
    for field in fields:
        several = cast("tuple[object, ...]", field) if type(field) is tuple else (field,)
        for one in several:  # PROMPT writes several
            if isinstance(one, Place):
                yield _Found(_key(one.variable, program), Uses(written=span))
                yield from _read(one.subscripts, Uses(as_place=True), program)
            else:
                yield from _read(one, how, program)


def _read(node: object, how: Uses, program: str) -> Iterator[_Found]:
    """Go through an expression, or whatever holds some."""
    match node:
        case Constant() | Span():
            return
        case Load(place):
            yield from _read(place, how, program)
        case Place(variable, subscripts) | WholeArray(variable, subscripts):
            yield _Found(_key(variable, program), how)
            if isinstance(node, Place):
                yield from _read(subscripts, Uses(as_place=True), program)
        case Compose(parts):
            for number, part in enumerate(parts):
                yield from _read(part, Uses(behind=parts[:number]) if number else how, program)
        case Apply(_, arguments):
            inner = how if how.behind else Uses(as_place=True)
            yield from _read(arguments, inner, program)
        case tuple():
            for part in cast("tuple[object, ...]", node):
                yield from _read(part, how, program)
        case _:
            return


def _key(variable: Variable, program: str) -> _Key:
    if isinstance(variable, Slot):
        return (program, variable.number, "")
    return ("", -1, variable.name)
