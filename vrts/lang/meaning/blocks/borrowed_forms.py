"""ELSE IF and IF on one line, which VAL-II does not have, as steps that it has.

What takes their place depends on where the ENDs of a program are, so it is found here and not
with the line.
"""

from dataclasses import replace
from typing import Any

from vrts.base.diagnostic import Edit, Fix
from vrts.lang.meaning.blocks.pairing import ELSE_IF, OPENED, Block, Pairing, Reading, word_of
from vrts.lang.problems import Problems
from vrts.lang.steps.idioms.wording import opposite
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Bad


def mend_borrowed(
    program: ProgramText, pairing: Pairing, reading: Reading, problems: Problems
) -> None:
    """Give the diagnostics of such lines the fix that goes with the blocks around them."""
    if pairing.faults:
        return
    if reading.while_closes:
        for block in pairing.blocks:
            end = program.steps[block.end].statement
            if block.word == "DO" and isinstance(end, Bad) and end.word == "WHILE":
                _until(problems, end)
    ends: dict[int, int] = {}  # how many ENDs the ELSE IFs before a step still need
    for at, step in enumerate(program.steps):
        node = step.statement
        if not isinstance(node, Bad) or node.meant is None:
            continue
        indent = _indent(problems, node.start)
        rows = node.meant.split("\n")
        if word_of(step) == ELSE_IF:
            edits = [_edit(problems, node.start, node.end, f"ELSE\n{indent}{rows[0]}")]
            block = _around(pairing, at)
            if block is not None and not reading.else_if_opens:
                ends[block.end] = ends.get(block.end, 0) + 1
                end = program.steps[block.end].statement
                assert end is not None
                start = problems.source.text.rfind("\n", 0, end.start) + 1
                edits.append(_edit(problems, start, start, f"{_indent(problems, end.start)}END\n"))
        elif word_of(step) in OPENED:
            inner = f"\n{indent}".join(rows)
            end_ = "" if reading.one_line_opens else f"\n{indent}END"
            edits = [_edit(problems, node.start, node.end, inner + end_)]
        else:
            continue
        _give(problems, node, Fix.from_edits(edits))


def _until(problems: Problems, node: Bad) -> None:
    """`WHILE k <> 0` at the end of a DO, as in C."""
    condition = problems.source.text[node.start : node.end][len("WHILE") :].strip(" \t;")
    while condition[:1] == "(" and condition[-1:] == ")" and "(" not in condition[1:]:
        condition = condition[1:-1].strip()
    instead = f"UNTIL {opposite(condition)}"
    fix = Fix.from_edits([_edit(problems, node.start, node.end, instead)])
    _give(
        problems,
        node,
        fix,
        headline="a DO ends with UNTIL, not with WHILE",
        help=(f"write `{instead}`: the loop goes on until this is true",),
    )


def _around(pairing: Pairing, at: int) -> Block | None:
    """Return the innermost IF around a step."""
    around = [b for b in pairing.blocks if b.word == "IF" and b.opener < at < b.end]
    return max(around, key=lambda block: block.opener, default=None)


def _edit(problems: Problems, start: int, end: int, text: str) -> Edit:
    return Edit(problems.span(start, end), text)


def _indent(problems: Problems, offset: int) -> str:
    text = problems.source.text
    before = text[text.rfind("\n", 0, offset) + 1 : offset]
    return before if not before.strip() else " " * len(before.expandtabs(8))


def _give(problems: Problems, node: Bad, fix: Fix, **said: Any) -> None:
    """Put a fix into the error that was reported of a line, and what else is to be said."""
    source, first, last = problems.span(node.start, node.end)
    for at, told in enumerate(problems.found):
        span = told.primary.span if told.primary is not None else None
        if span is None or not told.is_error or span.source is not source:
            continue
        if first <= span.start <= last:
            problems.found[at] = replace(told, fix=fix, **said)
            return
