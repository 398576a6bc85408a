"""Arguments of a CALL or a function exchanged, and one that keeps its value."""

import math
import re
from collections.abc import Iterator, Sequence
from itertools import pairwise

from vrts.lang.names import key
from vrts.lang.syntax.expressions import Application, Element, Item, Name, Number, Prefix
from vrts.lang.syntax.statements import CallStatement, Simple
from vrts.repair.edit import Candidate, Does, replacement
from vrts.repair.nodes import nodes, operands, parts
from vrts.repair.table.asked import Asked, target_of
from vrts.repair.table.numbers import value_of
from vrts.repair.written import WrittenStep

AS_ELSEWHERE = -0.6  # what speaks for arguments that others, or what is lost, say are exchanged
LETTERS = re.compile("[a-z]{2,}")
SHIFT = 4  # arguments of SHIFT
NEARLY = 1.0  # [mm] so near to what is lost a shift is the one that was meant


def arguments(asked: Asked, step: WrittenStep) -> Iterator[Candidate]:
    """Yield two arguments of a CALL or a function exchanged, and one that keeps its value."""
    lists: list[Sequence[Item | None]] = []
    if isinstance(step.statement, CallStatement):
        lists.append(step.statement.arguments)
        for argument in _changed_by_call(asked, step.statement):
            text = f"({asked.text_of(argument)})"
            yield asked.instead(Does.WORD, step.line, argument, text, unusual=-0.3)
    for item in operands(step.statement):
        lists += [part.arguments for part in parts(item) if isinstance(part, Application)]
    for given in lists:
        for k, one in enumerate(given):
            for other in given[k + 1 :]:
                if one is None or other is None or asked.text_of(one) == asked.text_of(other):
                    continue
                meant = _as_elsewhere(asked, step, given, one, other)
                meant = meant or _lacks(asked, given, one, other)
                yield swap(asked, step, one, other, AS_ELSEWHERE if meant else -0.2)
    if isinstance(step.statement, Simple) and step.statement.word == "DRAW":
        given = [each for each in step.statement.operands if each is not None]
        for one, other in pairwise(given):
            yield swap(asked, step, one, other, 0.2)


def _as_elsewhere(
    asked: Asked, step: WrittenStep, given: Sequence[Item | None], one: Item, other: Item
) -> bool:
    """Return whether two arguments of a CALL stand where other calls have the other kind of name.

    By words of the names: `base1_put` where others have `can1_grip`, and the other way round.
    """
    if not isinstance(step.statement, CallStatement):
        return False
    places = given.index(one), given.index(other)
    mine = [set(LETTERS.findall(asked.text_of(each).lower())) for each in (one, other)]
    for call in asked.written.steps:
        statement = call.statement
        if call is step or not isinstance(statement, CallStatement):
            continue
        if key(statement.program.text) != key(step.statement.program.text):
            continue
        theirs = [
            set(LETTERS.findall(asked.text_of(each).lower()))
            for at in places
            if at < len(statement.arguments) and (each := statement.arguments[at]) is not None
        ]
        if len(theirs) == 2 and mine[0] & theirs[1] and mine[1] & theirs[0]:
            return not (mine[0] & theirs[0] or mine[1] & theirs[1])
    return False


def _changed_by_call(asked: Asked, call: CallStatement) -> Iterator[Name]:
    """Yield the numbers given to a program that it changes: its caller's variables."""
    number = asked.callee(call)
    if number is None:
        return
    targets = [target_of(step) for step in asked.written.steps if step.program == number]
    changed = {key(target.text) for target in targets if isinstance(target, Name)}
    formals = asked.written.programs[number].formals
    for formal, argument in zip(formals, call.arguments, strict=False):
        if not isinstance(argument, Name) or not formal:
            continue
        if key(argument.text) in asked.numbers and key(formal.name.text) in changed:
            yield argument


def swap(asked: Asked, step: WrittenStep, one: Item, other: Item, unusual: float) -> Candidate:
    """Return two expressions of a step, or of two, in each other's place."""
    source = asked.written.source
    a, b = asked.text_of(one), asked.text_of(other)
    edits = (
        replacement(source, one.start, one.end, b),
        replacement(source, other.start, other.end, a),
    )
    size = min(nodes(one) + nodes(other), 2 * min(nodes(one), nodes(other)))
    if isinstance(one, Element) and isinstance(other, Element):
        alike = [asked.text_of(x)[len(x.name.text) :] for x in (one, other)]
        size = 2 if alike[0] == alike[1] else size
    return asked.candidate(
        Does.ORDER,
        step.line,
        edits,
        priced=min(size, 2),
        size=size,
        unusual=unusual,
        old=f"{a}, {b}",
        new=f"{b}, {a}",
    )


def _lacks(asked: Asked, given: Sequence[Item | None], one: Item, other: Item) -> bool:
    """Return whether something is just as far from right as a shift goes otherwise, exchanged."""
    if len(given) != SHIFT or not (_is_number(one) and _is_number(other)):
        return False
    by = value_of(other) - value_of(one)
    k, n = given.index(one) - 1, given.index(other) - 1
    if by == 0 or k < 0:
        return False
    wanted = [0.0, 0.0, 0.0]
    wanted[k], wanted[n] = by, -by
    return any(math.dist(wanted, residual) < NEARLY for residual in asked.blame.residuals)


def _is_number(item: Item) -> bool:
    return isinstance(item, Number) or (
        isinstance(item, Prefix) and item.operator == "-" and isinstance(item.operand, Number)
    )
