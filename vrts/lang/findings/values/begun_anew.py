"""Loops that set their counter back in every pass: `WHILE n < 5 DO`, `n = 0`, ..., `n = n+1`."""

from collections.abc import Callable, Sequence

from vrts.lang.findings.endless import ENDLESS_LOOP
from vrts.lang.findings.values.evaluate import evaluate
from vrts.lang.findings.values.intervals import ANY, Interval, point, truth
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.scope import Scope
from vrts.lang.meaning.structure import Block, label_key
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Expression, Infix, Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    CallNamed,
    CallStatement,
    For,
    Goto,
    Rest,
    Simple,
    Until,
    While,
)

MOST_STEPS = 300  # of a loop; longer ones are not looked into


def check_begun_anew(
    problems: Problems,
    scope: Scope,
    program: ProgramText,
    found: Sequence[Block],
    changed_by: Callable[[str], frozenset[str] | None],
) -> None:
    """Warn of loops whose counter begins again in each pass, so that they never end."""
    for first, last, condition, goes_on in _loops(program, found):
        if last - first > MOST_STEPS:
            continue
        for name in dict.fromkeys(_names(condition)):
            node = _anew(program, found, first, last, name, changed_by)
            if node is None or scope.entry(program.name, name).slot is not None:
                continue
            begun, counted = node
            value = number_of(begun.value)
            if value is None:
                continue
            step = _step(counted, name) or 0.0
            if _holds(condition, name, value + step) is not goes_on:
                continue
            written = problems.source.text[begun.start : begun.end]
            problems.warning(
                ENDLESS_LOOP,
                f"`{name}` begins again in each pass: this loop never ends",
                begun.start,
                begun.end,
                f"`{name}` is {value:g} again",
                secondary=(problems.label(condition.start, condition.end, "never ends it"),),
                help=(f"write `{written}` once, above the loop",),
            )
            return


def _loops(program: ProgramText, found: Sequence[Block]) -> list[tuple[int, int, Expression, bool]]:
    """Return the first and last step of each loop, its condition, and whether that goes on."""
    loops: list[tuple[int, int, Expression, bool]] = []
    for block in found:
        opener, end = (program.steps[at].statement for at in (block.opener, block.end))
        if isinstance(opener, While):
            loops.append((block.opener + 1, block.end, opener.condition, True))
        elif isinstance(end, Until):
            loops.append((block.opener + 1, block.end, end.condition, False))
    steps = enumerate(program.steps)
    labels = {step.label.number: at for at, step in steps if step.label is not None}
    for at, step in enumerate(program.steps):
        node = step.statement
        if isinstance(node, Goto) and node.condition is not None:
            first = labels.get(label_key(node.label))
            if first is not None and first < at:
                loops.append((first, at, node.condition, True))
    return loops


def _anew(
    program: ProgramText,
    found: Sequence[Block],
    first: int,
    last: int,
    name: str,
    changed_by: Callable[[str], frozenset[str] | None],
) -> tuple[Assignment, Assignment] | None:
    """Return the steps that set a variable and that count it, if each pass does just these."""
    given: list[Assignment] = []
    for at in range(first, last):
        node = program.steps[at].statement
        if isinstance(node, Rest | CallNamed | Goto):
            return None
        if isinstance(node, CallStatement):
            changed = changed_by(key(node.program.text))
            passed = {key(a.text) for a in node.arguments if isinstance(a, Name)}
            if changed is None or name in changed or name in passed:
                return None
        if isinstance(node, Simple) and any(
            isinstance(operand, Name) and key(operand.text) == name
            for operand in node.operands
            if node.word == "PROMPT"
        ):
            return None
        target = getattr(node, "target", None)
        if not isinstance(target, Name) or key(target.text) != name:
            continue
        inner = any(first <= block.opener < at < block.end <= last for block in found)
        if inner or isinstance(node, For) or not isinstance(node, Assignment):
            return None
        given.append(node)
    if len(given) != 2:
        return None
    begun, counted = given
    if number_of(begun.value) is None or not _step(counted, name):
        return None
    return begun, counted


def _step(node: Assignment, name: str) -> float | None:
    """Return by how much `n = n+1` counts."""
    value = node.value
    if not isinstance(value, Infix) or value.operator not in ("+", "-"):
        return None
    by = number_of(value.right)
    if not isinstance(value.left, Name) or key(value.left.text) != name or by is None:
        return None
    return by if value.operator == "+" else -by


def _holds(condition: Expression, name: str, value: float) -> bool | None:
    def known(asked: str) -> Interval:
        return point(value) if asked == name else ANY

    return truth(evaluate(condition, known))


def _names(node: Expression) -> list[str]:
    """Return the plain variables of a condition."""
    if isinstance(node, Name):
        return [key(node.text)]
    parts = [getattr(node, part, None) for part in ("left", "right", "inner", "operand")]
    return [name for part in parts if part is not None for name in _names(part)]
