"""Which instructions of a program some way leads to, where the conditions that are written hold."""

from collections.abc import Sequence
from typing import NamedTuple

from vrts.ir import instructions as i
from vrts.ir.instructions import jumps_of
from vrts.ir.module import Program
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.structure import Block
from vrts.lang.syntax.expressions import Expression, Infix, Name, Parenthesised, Prefix
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Until, While
from vrts.lang.vocabulary.functions import CONSTANTS

_LEADING = frozenset({i.Jump, i.JumpIf, i.TestFor, i.NextFor, i.TestCase, i.Grasp})
ENDING = frozenset(
    {i.Jump, i.NextFor, i.Stop, i.Halt, i.ReturnError, i.Return}
)  # no step below follows


class Endless(NamedTuple):
    """A WHILE or DO loop whose written condition always says to go on."""

    condition: Expression
    test: int  # its instruction
    goes_on: int  # what follows it always
    behind: int  # the first instruction that follows the loop


class Reached(NamedTuple):
    """What a program comes to, whatever its variables and signals are."""

    instructions: set[int]
    endless: tuple[Endless, ...]


def reached(text: ProgramText, program: Program, found: Sequence[Block]) -> Reached:
    """Return the instructions that some way from the first leads to."""
    endless = tuple(_endless(text, program, found))
    tests = {loop.test: loop for loop in endless}
    return Reached(reached_from(program, 0, tests), endless)


def reached_from(program: Program, start: int, tests: dict[int, Endless]) -> set[int]:
    """Return the instructions that some way from one of them leads to, itself included."""
    seen: set[int] = set()
    waiting = [start]
    code = program.instructions
    while waiting:
        at = waiting.pop()
        while at not in seen and at < len(code):
            seen.add(at)
            instruction = code[at]
            loop = tests.get(at)
            if loop is not None:
                at = loop.goes_on
                continue
            kind = type(instruction)
            if kind in _LEADING:
                waiting += jumps_of(instruction)
            if kind in ENDING:
                break
            at += 1
    return seen


def following(program: Program, at: int, tests: dict[int, Endless]) -> tuple[int, ...]:
    """Return where an instruction leads to."""
    if at in tests:
        return (tests[at].goes_on,)
    instruction = program.instructions[at]
    if type(instruction) in ENDING:
        return jumps_of(instruction)
    return (at + 1, *jumps_of(instruction))


def _endless(text: ProgramText, program: Program, found: Sequence[Block]) -> list[Endless]:
    loops: list[Endless] = []
    for block in found:
        if block.word not in ("WHILE", "DO"):
            continue
        step = text.steps[block.opener if block.word == "WHILE" else block.end]
        node = step.statement
        if not isinstance(node, While | Until):
            continue
        if written_truth(node.condition) is not isinstance(node, While):
            continue
        test = program.steps[step.number - 1]
        jump = program.instructions[test]
        assert isinstance(jump, i.JumpIf)
        if isinstance(node, While):
            loops.append(Endless(node.condition, test, test + 1, jump.target))
        else:
            loops.append(Endless(node.condition, test, jump.target, test + 1))
    return loops


def written_truth(node: Expression) -> bool | None:
    """Return whether a condition without variables holds; None for any other."""
    match node:
        case Parenthesised(inner):
            return written_truth(inner)
        case Prefix("NOT", operand):
            inner = written_truth(operand)
            return None if inner is None else not inner
        case Infix("==" | "<>" as operator, left, right):
            a, b = _number(left), _number(right)
            return None if a is None or b is None else (a == b) is (operator == "==")
        case _:
            value = _number(node)
            return None if value is None else value != 0.0


def _number(node: Expression) -> float | None:
    if isinstance(node, Name):
        return CONSTANTS.get(node.text.lower())
    return number_of(node)
