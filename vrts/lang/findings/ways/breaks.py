"""BREAK within an IF within a loop, where other languages leave the loop by it."""

from collections.abc import Iterator, Sequence
from typing import Any, cast

from vrts.base.diagnostic import Edit, Fix, Rule
from vrts.lang.meaning.structure import Block
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Element, Expression, Infix, Name
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import (
    Assignment,
    CallNamed,
    CallStatement,
    For,
    Goto,
    If,
    Simple,
    Statement,
)

BREAK_IN_LOOP = Rule("V167", "break-in-loop")

_LOOPS = frozenset({"FOR", "WHILE", "DO"})
_MOVES = frozenset(
    {"MOVE", "MOVES", "MOVET", "MOVEST", "APPRO", "APPROS", "DEPART", "DEPARTS", "DRIVE"}
    | {"READY", "ALIGN", "DRAW", "NEST"}
)
_CHANGING = frozenset(  # what asks for something that the program does not set
    {"sig", "bits", "timer", "distance", "dx", "dy", "dz", "defined", "random", "adc", "latched"}
)
_FIRST_LABEL = 100


def check_breaks(problems: Problems, program: ProgramText, blocks: list[Block]) -> None:
    """Warn of a BREAK that waits for the arm, where leaving the loop is surely meant.

    It is meant where the IF asks for what changes while the loop runs, such as a signal. A BREAK
    at every third point, or where a flag says so, makes the arm stop there, and that is what it is
    for.
    """
    loops = [block for block in blocks if block.word in _LOOPS]
    for block in blocks:
        if block.word != "IF" or block.middles:
            continue
        around = [loop for loop in loops if loop.opener < block.opener and block.end < loop.end]
        steps = program.steps
        opener = steps[block.opener].statement
        last = steps[block.end - 1].statement
        if not around or not isinstance(opener, If) or not _is_break(last):
            continue
        inner = max(around, key=lambda loop: loop.opener)
        body = [step.statement for step in steps[block.opener + 1 : block.end - 1]]
        if any(_moves(node) for node in body):
            continue
        if _may_change(opener.condition, steps, inner):
            _warn(problems, program, (block, inner), cast("Simple", last))


def _is_break(node: Statement | None) -> bool:
    return isinstance(node, Simple) and node.word == "BREAK"


def _moves(node: Statement | None) -> bool:
    if isinstance(node, CallStatement | CallNamed | Goto):
        return True
    return isinstance(node, Simple) and node.word in _MOVES


def _may_change(condition: Expression, steps: Sequence[Step], loop: Block) -> bool:
    """Return whether a condition asks for something that changes while the loop runs."""
    opener = steps[loop.opener].statement
    counted = ""
    if isinstance(opener, For) and isinstance(opener.target, Name):
        counted = key(opener.target.text)
    given = {
        key(node.target.text)
        for step in steps[loop.opener + 1 : loop.end]
        if isinstance(node := step.statement, Assignment) and isinstance(node.target, Name)
    }
    parts = list(_parts(condition))
    if any(isinstance(part, Infix) and part.operator == "MOD" for part in parts):
        return False  # at every third point
    for part in parts:
        if isinstance(part, Application) and part.name.text.lower() in _CHANGING:
            return True
        if isinstance(part, Name) and key(part.text) in given - {counted}:
            return True
    return False


def _parts(node: object) -> Iterator[object]:
    """Yield an expression and all in it, but not what indexes an array."""
    yield node
    if isinstance(node, Element):
        yield from _parts(node.name)
    elif isinstance(node, tuple):
        for part in cast("tuple[Any, ...]", node):
            if isinstance(part, tuple):
                yield from _parts(cast("object", part))


def _warn(problems: Problems, program: ProgramText, at: tuple[Block, Block], node: Simple) -> None:
    block, loop = at
    text = problems.source.text
    steps = program.steps
    opener = steps[block.opener].statement
    first = steps[loop.opener].statement
    assert isinstance(opener, If)
    assert first is not None
    following = steps[loop.end + 1] if loop.end + 1 < len(steps) else None
    condition = text[opener.condition.start : opener.condition.end]
    label = _waiting(program, loop)
    where = ""
    fix: Fix | None = None
    if label is None:
        label = following.label.number if following is not None and following.label else None
        if label is None:
            label = _free(program)
            where = f", with the label {label} before the step behind the loop's END"
        if following is not None and following.statement is not None:
            edits = [Edit(problems.span(node.start, node.end), f"GOTO {label}")]
            if where:
                start = following.statement.start
                edits.append(Edit(problems.span(start, start), f"{label} "))
            fix = Fix.from_edits(edits, sure=False)
    else:
        edits = [Edit(problems.span(node.start, node.end), f"GOTO {label}")]
        fix = Fix.from_edits(edits, sure=False)
    alone = block.end - block.opener == 2
    instead = f"IF {condition} GOTO {label}" if alone else f"GOTO {label}"
    problems.warning(
        BREAK_IN_LOOP,
        "BREAK does not leave the loop: it waits until the arm stands still",
        node.start,
        node.end,
        "the loop goes on behind this",
        secondary=(problems.label(first.start, first.end, "this loop"),),
        help=(f"to leave the loop write `{instead}`{where}",),
        fix=fix,
    )


def _waiting(program: ProgramText, loop: Block) -> int | str | None:
    """Return the label behind a loop that nothing jumps to, if there is one."""
    used = {
        node.label.text if isinstance(node.label, Name) else int(node.label.value)
        for step in program.steps
        if isinstance(node := step.statement, Goto)
    }
    for step in program.steps[loop.end + 1 :]:
        if step.label is not None and step.label.number not in used:
            return step.label.number
    return None


def _free(program: ProgramText) -> int:
    taken = {step.label.number for step in program.steps if step.label is not None}
    label = _FIRST_LABEL
    while label in taken:
        label += 10
    return label
