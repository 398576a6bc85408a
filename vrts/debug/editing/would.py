"""The value that would do in place of one literal: as `vrts.repair` finds it, told as allowed."""

from vrts.debug.console import Console
from vrts.debug.debugger import Debugger
from vrts.debug.editing.text import request_of
from vrts.debug.evaluating import CannotTell
from vrts.ir.data import Assign
from vrts.ir.module import Module
from vrts.lang.names import key
from vrts.pipeline.mending.behaviour import Mended, mended
from vrts.repair.edit import Candidate, Does
from vrts.repair.search import Budget
from vrts.repair.telling import sentence

MOST = 90  # executions of one search
_LITERALS = (Does.NUMBER, Does.ROW)


def would(console: Console, debugger: Debugger, text: str) -> list[str]:
    """Return which value of a literal would earn the full mark, as far as the task allows.

    Args:
        console: Knows how the program was read, and in which task.
        debugger: Its present text is asked about, not what was changed by hand.
        text: A variable or location that literals give a value; or a line.

    Raises:
        CannotTell: There is no such literal, or nothing may or can be looked for.
        Interrupted: Somebody wants no answer any more.
    """
    request = request_of(console, debugger)
    lines = _lines(debugger.run.module, text, request.program.name)
    found = mended(
        request,
        Budget(executions=MOST, one=MOST, alone=MOST, more=20),
        reaching=True,
        only=lambda candidate: _is_there(candidate, lines),
        hear=debugger.hear,
    )
    if found.refused is not None:
        raise CannotTell(found.refused)
    return [_said(found, lines)]


def _said(found: Mended, lines: frozenset[int]) -> str:
    task, grade = found.assessment.task, found.assessment.grade
    assert task is not None
    assert grade is not None
    if grade.mark == grade.total:
        return f"the text earns the full mark as it is: {float(grade.mark):g}"
    said = sentence(found.repairs, task.hints, found.reach)
    if said is not None:
        return said
    where = " and ".join(map(str, sorted(lines)[:3]))
    many = f"of {found.executions} that were tried"
    return f"no other value in line {where} alone earns the full mark, {many}"


def _is_there(candidate: Candidate, lines: frozenset[int]) -> bool:
    change = candidate.change
    return change.does in _LITERALS and all(edit.span.line in lines for edit in change.edits)


def _lines(module: Module, text: str, file: str) -> frozenset[int]:
    """Return the lines whose literals are asked about."""
    wanted = text.strip()
    if wanted.isdecimal() and len(wanted) < 8:
        return frozenset({int(wanted)})
    name = key(wanted.replace(" ", "").partition("[")[0])
    if not name:
        raise CannotTell("`would` takes a name, or a line: `would base2_put`, `would 12`")
    found = {d.span.line for d in module.data if d.name == name and d.span.source.name == file}
    for program in module.programs.values():
        for instruction, origin in zip(program.instructions, program.origins, strict=True):
            given = isinstance(instruction, Assign) and instruction.place.variable.name == name
            if given and origin.span.source.name == file:
                found.add(origin.span.line)
    if not found:
        raise CannotTell(f"no literal gives `{wanted[:60]}` a value: a name, or a line")
    return frozenset(found)
