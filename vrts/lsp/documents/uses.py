"""The names on one line of a program: what each is, and whether it gets a value there.

A line that does not parse, as it is half typed, gives the names of its words.
"""

from collections.abc import Iterator
from enum import Enum
from functools import lru_cache
from typing import Any, NamedTuple

from vrts.base.source import SourceFile
from vrts.lang.dialect import Dialect
from vrts.lang.meaning.structure import word_of
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.sections.lines import Line
from vrts.lang.steps.labels import read_label
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    FormatItem,
    Infix,
    Name,
    Number,
    Parenthesised,
    Prefix,
)
from vrts.lang.syntax.statements import (
    Assignment,
    Bad,
    CallNamed,
    CallStatement,
    Declare,
    Device,
    For,
    Give,
    Goto,
    HereStatement,
    PackStatement,
    ReactStatement,
    SetLocation,
    ShiftStatement,
    Simple,
    Statement,
)
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS, bare_functions
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS


class Kind(Enum):
    """What a name stands for, as far as one line tells."""

    PROGRAM = "program"
    LABEL = "label"
    VARIABLE = "variable"  # a number, or nothing tells
    LOCATION = "location"
    JOINTS = "precision point"
    STRING = "string"
    FUNCTION = "function"
    CONSTANT = "constant"
    SIGNAL = "signal"


class Role(Enum):
    """What happens to a name."""

    READ = "read"
    WRITE = "write"  # gets a value, or is where a label or a program stands
    OWN = "own"  # declared as the program's own: AUTO, LOCAL


class Use(NamedTuple):
    """A name at a place; offsets count from the start of its line's text."""

    name: str  # as the controller keeps it
    kind: Kind
    role: Role
    start: int
    end: int
    sure: bool = False  # whether the line shows what a variable holds


PROGRAM_WORDS = frozenset({"REACTE", "PCEXECUTE"})  # their first operand names a program
_SYSTEM_WORDS = frozenset({"ENABLE", "DISABLE"})  # their operands are switches
_LOCATION_GIVERS = frozenset({"INVERSE", "FRAME"})
_SIGNAL_WORDS = frozenset({"SIGNAL", "SIGNALI", "RUNSIG", "PULSE"})
_ARITHMETIC = frozenset({"+", "-", "*", "/", "MOD", "AND", "OR", "XOR", "<", ">", "<=", ">="})
_NOT_NAMES = OPERATORS.keys() | QUALIFIERS.keys()


class ReadLine(NamedTuple):
    """What a line of a program says."""

    word: str | None  # a word of structure: IF, FOR, ELSE, END ...
    uses: tuple[Use, ...]  # its names, in their order


@lru_cache(1 << 16)
def read_line(text: str, dialect: Dialect) -> ReadLine:
    """Return what a line of a program says; never fails.

    Args:
        text: The line without comment and outer blanks.
        dialect: The language.
    """
    problems = Problems(SourceFile("", text), dialect)
    parser = StepParser(problems)
    line = Line(1, text, 0, len(text))
    label, rest, at = read_label(line, problems, parser.tolerated)
    found: list[Use] = []
    if label is not None:
        found.append(Use(str(label.number), Kind.LABEL, Role.WRITE, label.start, label.end))
    step = parser.step(line)
    statement = step.statement
    if isinstance(statement, Bad):
        found += _of_words(parser, rest, at, dialect)
    elif statement is not None:
        found += _Walk(dialect).statement(statement)
    ordered = tuple(sorted(set(found), key=lambda use: (use.start, use.end)))
    return ReadLine(word_of(step), ordered)


def variable_kind(name: str) -> Kind:
    """Return what the sign before a name says; a plain one may be a number or a location."""
    return {"$": Kind.STRING, "#": Kind.JOINTS}.get(name[:1], Kind.VARIABLE)


def _of_words(parser: StepParser, text: str, at: int, dialect: Dialect) -> Iterator[Use]:
    """Return the names of a line that does not parse."""
    classified = parser.tokens(text, at) if text else None
    if classified is None:
        return
    tokens, head = classified
    program_follows = head.word is not None and head.word.text == "CALL"
    for number, token in enumerate(tokens):
        if token.kind not in ("NAME", "STRINGNAME", "JOINTNAME"):
            continue
        if number == 0 and (len(tokens) == 1 or tokens[1].text not in "=["):
            continue  # an instruction that is not there yet
        if token.text.upper() in _NOT_NAMES:
            continue
        if program_follows and number == 1:
            yield Use(key(token.text), Kind.PROGRAM, Role.READ, token.start, token.end)
            continue
        role = Role.WRITE if number == 0 else Role.READ
        applied = number + 1 < len(tokens) and tokens[number + 1].kind == "LPAREN"
        yield _variable(token.text, token.start, token.end, role, None, dialect, applied=applied)


def _variable(
    text: str,
    start: int,
    end: int,
    role: Role,
    kind: Kind | None,
    dialect: Dialect,
    *,
    applied: bool = False,
) -> Use:
    lower = text.lower()
    if applied and lower in FUNCTIONS:
        return Use(lower, Kind.FUNCTION, Role.READ, start, end)
    if role is Role.READ and lower in CONSTANTS:
        return Use(lower, Kind.CONSTANT, role, start, end)
    if role is Role.READ and lower in bare_functions(dialect):
        return Use(lower, Kind.FUNCTION, role, start, end)
    own = variable_kind(text)
    if own is not Kind.VARIABLE:
        return Use(key(text), own, role, start, end, True)
    return Use(key(text), kind or own, role, start, end, kind is not None)


class _Walk:
    """Goes through a statement, with what each place of it holds."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect

    def statement(self, node: Statement) -> Iterator[Use]:
        match node:
            case Assignment(target, value):
                kind = Kind.VARIABLE if _is_number(value) else None
                yield from self._write(target, kind)
                yield from self._read(value)
            case SetLocation(target, value):
                yield from self._write(target, Kind.LOCATION)
                yield from self._read(value, Kind.LOCATION)
            case HereStatement(target):
                last = target
                if isinstance(target, Infix) and target.operator == ":":
                    yield from self._read(target.left, Kind.LOCATION)
                    last = target.right
                yield from self._write(last, Kind.LOCATION)
            case ShiftStatement(target, offsets):
                yield from self._write(target, Kind.LOCATION)
                yield from self._items(offsets)
            case Simple():
                yield from self._simple(node)
            case Give(word, target, values):
                if word != "PARAMETER":
                    place = Kind.LOCATION if word in _LOCATION_GIVERS else None
                    yield from self._write(target, place)
                value_kind = Kind.LOCATION if word not in ("PARAMETER", "SETI") else None
                for value in values:
                    yield from self._read(value, value_kind)
            case PackStatement(target, first, length, value):
                yield from self._write(target, Kind.STRING)
                yield from self._items((first, length, value))
            case ReactStatement(_, operands):
                yield from self._items(operands[:1], signal=True)
                if len(operands) > 1:
                    yield from self._program(operands[1])
                yield from self._items(operands[2:])
            case Device(word, unit, operands, given):
                yield from self._items((*(unit or ()), *(given or ())))
                for operand in operands:
                    written = word == "READ" and isinstance(operand, Name | Element)
                    yield from self._write(operand) if written else self._read(operand)
            case Declare(word, kind, names):
                own = Kind.LOCATION if kind == "LOC" else None
                role = Role.READ if word == "GLOBAL" else Role.OWN
                for name in names:
                    yield from self._write(name, own, role)
            case Goto(label, condition):
                name = key(label.text) if isinstance(label, Name) else str(int(label.value))
                yield Use(name, Kind.LABEL, Role.READ, label.start, label.end)
                yield from self._read(condition)
            case For(target, first, last, increment):
                yield from self._write(target, Kind.VARIABLE)
                yield from self._items((first, last, increment))
            case CallStatement(program, arguments):
                yield from self._program(program)
                yield from self._items(arguments)
            case CallNamed(program, arguments):
                yield from self._read(program)
                yield from self._items(arguments)
            case _:
                yield from self._parts(node)

    def _simple(self, node: Simple) -> Iterator[Use]:
        word = node.word
        if word in _SYSTEM_WORDS:
            return
        if word in PROGRAM_WORDS and node.operands:
            yield from self._program(node.operands[0])
            yield from self._items(node.operands[1:])
            return
        wanted = INSTRUCTIONS[word].operands
        for number, operand in enumerate(node.operands):
            what = wanted[min(number, len(wanted) - 1)] if wanted else ""
            if word == "PROMPT" and isinstance(operand, Name | Element):
                yield from self._write(operand)
            elif word in _SIGNAL_WORDS:
                yield from self._items((operand,), signal=True)
            else:
                yield from self._read(operand, Kind.LOCATION if what == "a location" else None)

    def _program(self, node: Any) -> Iterator[Use]:
        if isinstance(node, Name) and node.text[:1] not in "$#":
            yield Use(key(node.text), Kind.PROGRAM, Role.READ, node.start, node.end)
        else:
            yield from self._read(node)

    def _write(self, node: Any, kind: Kind | None = None, role: Role = Role.WRITE) -> Iterator[Use]:
        if isinstance(node, Element):
            yield from self._items(node.subscripts)
            node = node.name
        if isinstance(node, Name):
            yield _variable(node.text, node.start, node.end, role, kind, self.dialect)
        else:
            yield from self._read(node, kind)

    def _items(self, nodes: tuple[Any, ...], *, signal: bool = False) -> Iterator[Use]:
        for node in nodes:
            number = node.operand if isinstance(node, Prefix) else node
            if signal and isinstance(number, Number) and number.value >= 1:
                name = f"{number.value:g}"
                yield Use(name, Kind.SIGNAL, Role.READ, number.start, number.end)
            else:
                yield from self._read(node)

    def _read(self, node: Any, kind: Kind | None = None) -> Iterator[Use]:
        match node:
            case Name(text, start, end):
                yield _variable(text, start, end, Role.READ, kind, self.dialect)
            case Element(name, subscripts):
                yield _variable(name.text, name.start, name.end, Role.READ, kind, self.dialect)
                yield from self._items(subscripts)
            case Application(name, arguments):
                yield from self._applied(name, arguments)
            case Infix(operator, left, right):
                inner = Kind.LOCATION if operator == ":" else None
                if operator in _ARITHMETIC and (_is_number(left) or _is_number(right)):
                    inner = Kind.VARIABLE
                yield from self._read(left, inner)
                yield from self._read(right, inner)
            case Parenthesised(inner):
                yield from self._read(inner, kind)
            case Prefix(_, operand):
                yield from self._read(operand, Kind.VARIABLE)
            case FormatItem() | None:
                pass
            case _:
                yield from self._parts(node)

    def _applied(self, name: Name, arguments: tuple[Any, ...]) -> Iterator[Use]:
        function = FUNCTIONS.get(name.text.lower())
        yield _variable(
            name.text, name.start, name.end, Role.READ, None, self.dialect, applied=True
        )
        if function is not None and function.name == "sig":
            yield from self._items(arguments, signal=True)
            return
        wanted = function.parameters if function is not None else ()
        for number, argument in enumerate(arguments):
            letter = wanted[min(number, len(wanted) - 1)][0] if wanted else ""
            if letter == "n":
                continue  # a switch or a parameter of the controller
            yield from self._read(argument, Kind.LOCATION if letter in ("p", "l") else None)

    def _parts(self, node: Any) -> Iterator[Use]:
        """Read whatever a node holds."""
        if isinstance(node, tuple):
            for part in node:  # pyright: ignore[reportUnknownVariableType]
                if isinstance(part, tuple):
                    yield from self._read(part)


def _is_number(node: Any) -> bool:
    if isinstance(node, Prefix):
        return True
    if isinstance(node, Infix):
        return node.operator in _ARITHMETIC and (_is_number(node.left) or _is_number(node.right))
    return isinstance(node, Number)
