"""Which numbers matter: the expressions that the controller takes only some numbers for."""

from collections.abc import Iterator
from typing import NamedTuple

from vrts.lang.dialect import Dialect
from vrts.lang.findings.values import complaints
from vrts.lang.findings.values.complaints import Complain
from vrts.lang.meaning.name_uses import Asked
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Element,
    FormatItem,
    Infix,
    Item,
    Name,
    Parenthesised,
    Prefix,
)
from vrts.lang.syntax.statements import For, Put, ReactStatement, Simple, Statement

DIVISIONS = frozenset({"/", "MOD"})  # operators of which the right operand is divided by


class Question(NamedTuple):
    """Can this expression be what the controller takes here?"""

    program: str
    step: int  # offset of its step
    node: Item
    complain: Complain


def questions(asked: Asked, dialect: Dialect) -> Iterator[Question]:
    """Return the questions about a place.

    Relatives have other robots, and more signals and timers: nothing is asked about those.
    """
    if asked.program is None:
        return
    for operand, complain in _about(asked.node, ours=not dialect.tolerant):
        if operand is not None and not isinstance(operand, FormatItem):
            yield Question(asked.program, asked.step, operand, complain)


def _about(node: Item | Statement, *, ours: bool) -> Iterator[tuple[Item | None, Complain]]:
    if isinstance(node, Element):
        for subscript in node.subscripts:
            yield subscript, complaints.subscript
    elif isinstance(node, Application):
        name = node.name.text.lower()
        if name == "sqrt":
            yield node.arguments[0], complaints.root
        elif ours and name in _ARGUMENTS:
            yield from _applied(name, node.arguments)
    elif ours:
        yield from _instruction(node)
    elif isinstance(node, Simple) and node.word in ("SIGNAL", "PULSE"):
        for operand in node.operands if node.word == "SIGNAL" else node.operands[:1]:
            yield operand, complaints.set_input


def _applied(
    name: str, arguments: tuple[Item | None, ...]
) -> Iterator[tuple[Item | None, Complain]]:
    asked = _ARGUMENTS[name]
    for at, argument in enumerate(arguments):
        yield argument, asked[min(at, len(asked) - 1)]


def _instruction(node: object) -> Iterator[tuple[Item | None, Complain]]:
    if isinstance(node, Simple) and node.word == "SIGNAL":
        for operand in node.operands:
            yield operand, complaints.set_signal
    elif isinstance(node, Simple) and node.word in _FIRST_OPERAND and node.operands:
        yield node.operands[0], _FIRST_OPERAND[node.word]
    elif isinstance(node, Put) and node.word == "BITS":
        yield node.target, complaints.set_signal
        yield node.length, complaints.bits_count
    elif isinstance(node, Put) and node.word == "TIMER":
        yield node.target, complaints.timer_set
    elif isinstance(node, ReactStatement) and node.word == "IGNORE" and node.operands:
        yield node.operands[0], complaints.ignored_signal
    elif isinstance(node, ReactStatement) and node.word in ("REACT", "REACTI") and node.operands:
        yield node.operands[0], complaints.watched_signal
        if len(node.operands) > _PRIORITY:
            yield node.operands[_PRIORITY], complaints.reaction


_PRIORITY = 2  # of the operands of REACT
_ARGUMENTS: dict[str, tuple[Complain, ...]] = {  # the last one again for all that follow
    "sig": (complaints.read_signal,),
    "bits": (complaints.read_signal, complaints.bits_count),
    "timer": (complaints.timer_read,),
}
_FIRST_OPERAND: dict[str, Complain] = {
    "DRIVE": complaints.joint,
    "LOCK": complaints.priority,
}


def asked_names(what: Question | Asked) -> Iterator[str]:
    """Return the plain variables that a question is about, by their keys."""
    node = what.node
    if isinstance(node, For):
        for part in (node.first, node.last, node.increment):
            yield from variables(part)
    elif isinstance(what, Question):
        yield from variables(what.node)


def variables(node: Item | None) -> Iterator[str]:
    """Return the plain variables in an expression, by their keys."""
    waiting = [node]
    while waiting:
        part = waiting.pop()
        match part:
            case Name(text) if text[0] not in "$#":
                yield key(text)
            case Infix(_, left, right):
                waiting += [right, left]
            case Prefix(_, inner) | Parenthesised(inner):
                waiting.append(inner)
            case Application(_, arguments):
                waiting += arguments
            case _:
                pass
