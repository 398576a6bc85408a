"""Where declarations of V+ stand, and what groups of a SCASE of AS begin with."""

import re
from collections.abc import Sequence

from vrts.base.diagnostic import Edit, Fix
from vrts.lang.meaning.blocks.pairing import Block
from vrts.lang.meaning.blocks.unpaired import CASE_LAYOUT
from vrts.lang.problems import Problems
from vrts.lang.steps.other_forms import INVALID_EXPRESSION
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Bad, Declare, Statement, ValueGroup

_WORD = re.compile(r"[A-Za-z]+")
_WORDS = {"CASE": "VALUE", "SCASE": "SVALUE"}  # what the groups of each begin with


def check_declarations(problems: Problems, program: ProgramText) -> None:
    """Report the first AUTO, LOCAL or GLOBAL that stands behind a step."""
    if not problems.dialect.is_vplus:
        return
    first: Statement | None = None
    for step in program.steps:
        node = step.statement
        if isinstance(node, Declare) and first is not None:
            _late(problems, node, first)
            return
        if node is None or isinstance(node, Bad | Declare):
            continue
        first = first or node


def _late(problems: Problems, node: Declare, first: Statement) -> None:
    source = problems.source.text
    line, after = source.rfind("\n", 0, node.start) + 1, source.find("\n", node.end) + 1
    begin = source.rfind("\n", 0, first.start) + 1
    alone = not source[line : node.start].strip() and not source[node.end : after].strip()
    fix = None
    if alone and after and not source[begin : first.start].strip():
        moved = problems.span(begin, begin), source[line:after]
        taken = problems.span(line, after), ""
        fix = Fix.from_edits((Edit(*moved), Edit(*taken)))
    problems.error(
        INVALID_EXPRESSION,
        f"{node.word} stands before the first step of its program",
        node.start,
        node.end,
        secondary=(problems.label(first.start, first.end, "the first step"),),
        help=("move it to the top, below `.PROGRAM`",),
        fix=fix,
    )


def check_groups(problems: Problems, program: ProgramText, found: Sequence[Block]) -> None:
    """Report VALUE in a SCASE, and SVALUE in a CASE."""
    if not problems.dialect.is_as:
        return
    for block in found:
        opener = program.steps[block.opener].statement
        if block.word != "CASE" or opener is None or isinstance(opener, Bad):
            continue
        word = _written(problems, opener)
        for at in block.middles:
            node = program.steps[at].statement
            if not isinstance(node, ValueGroup):
                continue
            written = _written(problems, node)
            wanted = _WORDS.get(word)
            if written not in _WORDS.values() or wanted is None or written == wanted:
                continue
            problems.error(
                CASE_LAYOUT,
                f"{written} is no group of {word}",
                node.start,
                node.start + len(written),
                secondary=(problems.label(opener.start, opener.end, "this begins it"),),
                help=(f"write `{wanted}` instead of `{written}`",),
                fix=problems.replace(node.start, node.start + len(written), wanted),
            )


def _written(problems: Problems, node: Statement) -> str:
    match = _WORD.match(problems.source.text, node.start)
    return match.group().upper() if match is not None else ""
