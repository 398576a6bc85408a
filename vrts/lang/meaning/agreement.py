"""Types of names that only other names tell: `a = b`, and what CALL passes.

A name without prefix is a number or a location all over a compilation. What a program does with its
formals comes first; then the calls decide, in the order of the text; `a = b` alone is of numbers.
"""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.ir.values import Type
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry, Place
from vrts.lang.meaning.type_mistakes import wrong_type
from vrts.lang.names import key
from vrts.lang.syntax.expressions import Element, Expression, Infix, Item, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Assignment, CallStatement

_SPREADING = frozenset({Type.REAL, Type.POSE})  # types that a name without prefix may have


class _Move(NamedTuple):
    """`a = b` between names whose types are open where it stands."""

    node: Assignment
    names: tuple[Name, Name]
    entries: tuple[Entry, Entry]


def settle_types(resolver: Resolver, programs: list[ProgramText]) -> dict[int, Place]:
    """Give every name the type that its uses, assignments and calls tell.

    Returns:
        The argument that decided the type of a formal, by the identity of its entry, for formals
        that their own program leaves open.
    """
    moves = _moves(resolver)
    spread = _Spread(resolver, moves)
    spread.upwards(resolver.scope.all_entries())
    decided: dict[int, Place] = {}
    if spread.open_formals:
        _downwards(resolver, programs, spread, decided)
    for move in moves:
        _settle(resolver, spread, move)
    if moves and spread.open_formals:
        _downwards(resolver, programs, spread, decided)
    return decided


def type_of_argument(resolver: Resolver, program: str, argument: Item) -> Type:
    """Return the type of what a call passes."""
    if isinstance(argument, Name | Element):
        name = argument if isinstance(argument, Name) else argument.name
        return resolver.type_of_name(program, name)
    if isinstance(argument, Infix) and argument.operator == ":":
        return Type.POSE
    return resolver.argument_types.get(id(argument), Type.DYNAMIC)


class _Spread:
    """Types on their way from formals to what is passed to them, and over `a = b`."""

    def __init__(self, resolver: Resolver, moves: list[_Move]) -> None:
        scope = resolver.scope
        self.near: dict[int, list[Entry]] = {}  # names that a name gives its type to, by identity
        for entry in scope.all_entries():
            for passed in entry.passed:
                formal = scope.formal(passed)
                if formal is not None:
                    self.near.setdefault(id(formal), []).append(entry)
        for move in moves:
            one, other = move.entries
            self.near.setdefault(id(one), []).append(other)
            self.near.setdefault(id(other), []).append(one)
        self.open_formals = any(
            entry.slot is not None and entry.type is Type.DYNAMIC
            for formals in scope.formals.values()
            for entry in formals.values()
        )

    def upwards(self, typed: list[Entry]) -> None:
        """Spread the types of names as far as they go."""
        waiting = [entry for entry in reversed(typed) if entry.type in _SPREADING]
        while waiting:
            known = waiting.pop()
            for entry in self.near.get(id(known), ()):
                if entry.type is Type.DYNAMIC:
                    entry.types[known.type] = next(iter(entry.spellings.values()), (0, 0))
                    waiting.append(entry)


def _downwards(
    resolver: Resolver, programs: list[ProgramText], spread: _Spread, decided: dict[int, Place]
) -> None:
    """Give formals that their programs leave open the types that calls pass, the first one."""
    calls = [
        (caller, argument, formal)
        for caller, argument, formal in _arguments(resolver, programs)
        if formal.type is Type.DYNAMIC
    ]
    takers: dict[int, list[tuple[Item, Entry]]] = {}  # of a variable that is passed, by identity
    waiting: list[tuple[Type, Item, Entry]] = []
    for caller, argument, formal in calls:
        found = type_of_argument(resolver, caller, argument)
        if found in _SPREADING:
            waiting.append((found, argument, formal))
        elif isinstance(argument, Name | Element):
            name = argument if isinstance(argument, Name) else argument.name
            entry = resolver.scope.entry(caller, key(name.text))
            takers.setdefault(id(entry), []).append((argument, formal))
    waiting.reverse()
    while waiting:
        found, argument, formal = waiting.pop()
        if formal.type is not Type.DYNAMIC:
            continue
        formal.types[found] = decided[id(formal)] = (argument.start, argument.end)
        spread.upwards([formal])
        waiting += [(found, *taker) for taker in reversed(takers.get(id(formal), ()))]


def _arguments(
    resolver: Resolver, programs: list[ProgramText]
) -> Iterator[tuple[str, Item, Entry]]:
    """Return the caller of every argument, and the formal that takes it."""
    scope = resolver.scope
    for program in programs:
        for step in program.steps:
            node = step.statement
            if not isinstance(node, CallStatement):
                continue
            called = scope.programs.get(key(node.program.text))
            for argument, formal in zip(
                node.arguments, called.formals if called is not None else (), strict=False
            ):
                if argument is not None and formal.name.text and formal.name.text[0] not in "$#":
                    entry = scope.formals[called.name][key(formal.name.text)]  # type: ignore[union-attr]
                    yield program.name, argument, entry


def _moves(resolver: Resolver) -> list[_Move]:
    found: list[_Move] = []
    for node in resolver.moves:
        where = resolver.program_of.get(node.start, resolver.program)
        target, value = _name_of(node.target), _name_of(node.value)
        entries = tuple(resolver.scope.entry(where, key(name.text)) for name in (target, value))
        found.append(_Move(node, (target, value), (entries[0], entries[1])))
    return found


def _name_of(node: Expression) -> Name:
    assert isinstance(node, Name | Element)
    return node if isinstance(node, Name) else node.name


def _settle(resolver: Resolver, spread: _Spread, move: _Move) -> None:
    """Decide about `a = b`: numbers, unless one of them is a location elsewhere."""
    kinds = [set(entry.types) & _SPREADING for entry in move.entries]
    if {Type.POSE} not in kinds:
        for entry, name in zip(move.entries, move.names, strict=True):
            if not entry.types:
                entry.types[Type.REAL] = (name.start, name.end)
                spread.upwards([entry])
        return
    if {Type.REAL} in kinds and resolver.dialect.tolerant:
        wrong = Type.POSE if kinds[1] == {Type.POSE} else Type.REAL
        wanted = Type.REAL if wrong is Type.POSE else Type.POSE
        why = f"`{move.names[0].text}` holds {'a number' if wanted is Type.REAL else 'a location'}"
        resolver.wrong_lines.add(resolver.problems.source.line_of(move.node.start))
        wrong_type(resolver.problems, move.node.value, wrong, wanted, why)
    else:
        resolver.assigned_location(move.node)
