"""Internal signals that a file asks for and never sets: a wait for one of them never ends."""

import re
from collections.abc import Iterator
from typing import Any

from vrts.base.diagnostic import Rule
from vrts.ir.ranges import INTERNAL
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.scope import Scope
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Item
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Bad, CallNamed, CallStatement, Put, ReactStatement, Rest
from vrts.lang.syntax.statements import Simple as Instruction

SIGNAL_NEVER_SET = Rule("V271", "signal-never-set")

_WRITTEN = re.compile(r"2(?<![\w.]2)\d{3}(?![\w.])")  # the digit first: it is found quickly
_SHOWN = 3  # signals that a help names


def check_internal_signals(problems: Problems, scope: Scope, programs: list[ProgramText]) -> None:
    """Warn of each internal signal that is read, where all that are set are known."""
    if problems.dialect.tolerant or _WRITTEN.search(problems.source.text) is None:
        return
    asked: dict[int, Item] = {}
    given: set[int] = set()
    for program in programs:
        for step in program.steps:
            node = step.statement
            if node is None:
                continue
            if _unknown(node, scope):
                return
            for operand in _set_by(node):
                number = number_of(operand)
                if number is None:
                    return
                given.add(abs(round(number)))
            for operand in _asked_by(node):
                number = number_of(operand)
                if number is not None and abs(round(number)) in INTERNAL:
                    asked.setdefault(abs(round(number)), operand)
    ours = sorted(number for number in given if number in INTERNAL)
    for number, operand in asked.items():
        if number not in given:
            _report(problems, number, operand, [n for n in ours if n not in asked])


def _unknown(node: Any, scope: Scope) -> bool:
    """Whether a step may set signals that nobody sees here."""
    if isinstance(node, CallStatement):
        return key(node.program.text) not in scope.programs
    if isinstance(node, Put):
        return node.word == "BITS"
    return isinstance(node, Bad | Rest | CallNamed)


def _set_by(node: Any) -> Iterator[Item]:
    if isinstance(node, Instruction) and node.word == "SIGNAL":
        yield from (operand for operand in node.operands if operand is not None)


def _asked_by(node: Any) -> Iterator[Item]:
    """Yield the operands of SIG anywhere in a step, and what REACT watches."""
    if isinstance(node, ReactStatement) and node.operands and node.operands[0] is not None:
        yield node.operands[0]
        return
    waiting = [node]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Application) and part.name.text.upper() == "SIG":
            yield from (argument for argument in part.arguments if argument is not None)
        elif isinstance(part, tuple):
            waiting.extend(part)  # pyright: ignore[reportUnknownArgumentType]


def _report(problems: Problems, number: int, operand: Item, others: list[int]) -> None:
    """Say of one signal that nothing sets it; `others` are set and never asked for."""
    shown = ", ".join(f"`{n}`" for n in others[:_SHOWN])
    helps = [f"set it in another program, as by `SIGNAL {number}`"]
    if others:
        helps.insert(0, f"did you mean {shown}, which this file sets and never asks for?")
    helps.append("to ask for an input write a number from 1001 to 1032")
    problems.warning(
        SIGNAL_NEVER_SET,
        f"nothing in this file sets the internal signal {number}",
        operand.start,
        operand.end,
        "it stays off",
        notes=("to signals from 2001 on nothing is wired: programs set them, and operators",),
        help=tuple(helps),
        data={"signal": number},
    )
