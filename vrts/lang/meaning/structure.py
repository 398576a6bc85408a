"""Pairs the structure words and labels of a program."""

import heapq
import re
from collections.abc import Iterable

from vrts.base.diagnostic import Rule
from vrts.lang.decimal_commas import likeliest
from vrts.lang.meaning.blocks.borrowed_forms import mend_borrowed
from vrts.lang.meaning.blocks.pairing import (
    BARE_WHILE,
    ELSE_IF,
    OPENED,
    READINGS,
    Block,
    Reading,
    marks,
    pair,
    word_of,
)
from vrts.lang.meaning.blocks.unpaired import (
    CASE_LAYOUT,
    CONTROL_SAYS,
    MISSING_END,
    UNMATCHED,
    report_faults,
)
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name, Number
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Bad, Goto, Simple, Statement

_LETTERS = re.compile(r"^(?:[A-Za-z]+_?|#|\()(?=\d)", re.ASCII)  # `N100 MOVES part`

DUPLICATE_LABEL = Rule("V134", "duplicate-label")
UNDEFINED_LABEL = Rule("V135", "undefined-label")

__all__ = ["MISSING_END", "Block", "blocks", "word_of"]
_LEAVING = ("EXIT", "NEXT")
_CLOSED = frozenset({"IF", "WHILE", "FOR", "CASE", "DO", "END", "UNTIL"})


def blocks(program: ProgramText, problems: Problems) -> list[Block]:
    """Return the structures of a program; report words without their partner."""
    found = marks(program.steps)
    pairing = pair(found)
    if any(f.mark.word in ("VALUE", "ANY") and f.top is not None for f in pairing.unmatched):
        pairing = min(pairing, pair(found, Reading(group_closes=True)), key=lambda p: p.faults)
    if any(mark.word in (ELSE_IF, BARE_WHILE, *OPENED) for mark in found):
        readings = [(pair(found, reading), reading) for reading in READINGS]
        pairing, reading = min(readings, key=lambda read: read[0].faults)
        mend_borrowed(program, pairing, reading, problems)
    if pairing.faults:
        report_faults(program, pairing, problems)
    _check_cases(program, pairing.blocks, problems)
    return pairing.blocks


def label_key(node: Number | Name) -> int | str:
    """Return the label that a jump names."""
    return key(node.text) if isinstance(node, Name) else int(node.value)


def loops_of(node: Simple) -> int:
    """Return how many loops EXIT and NEXT mean; 0 when that is no whole number from 1."""
    if not node.operands:
        return 1
    count = node.operands[0]
    whole = isinstance(count, Number) and count.value >= 1 and count.value == int(count.value)
    return int(count.value) if isinstance(count, Number) and whole else 0


def exits(program: ProgramText, found: list[Block]) -> dict[int, Block | None]:
    """Return which loop each EXIT and NEXT means, by its place; None where there is none."""
    steps = [step.statement for step in program.steps]
    leaving = [node for node in steps if isinstance(node, Simple) and node.word in _LEAVING]
    if not leaving:
        return {}
    loops = {block.opener: block for block in found if block.word in ("FOR", "WHILE", "DO")}
    open_: list[Block] = []
    meant: dict[int, Block | None] = {}
    for at, step in enumerate(program.steps):
        while open_ and open_[-1].end <= at:
            open_.pop()
        node = step.statement
        if isinstance(node, Simple) and node.word in _LEAVING:
            count = loops_of(node)
            meant[at] = open_[-count] if 1 <= count <= len(open_) else None
        if at in loops:
            open_.append(loops[at])
    return meant


def check_exits(program: ProgramText, found: list[Block], problems: Problems) -> None:
    """Report EXIT and NEXT outside of loops, where the structures are known."""
    bad = [step for step in program.steps if isinstance(step.statement, Bad)]
    if any(word_of(step) in _CLOSED for step in bad):
        return
    for at, block in exits(program, found).items():
        node = program.steps[at].statement
        if block is not None or not isinstance(node, Simple):
            continue
        problems.error(
            UNMATCHED,
            f"{node.word} outside of a loop"
            if loops_of(node) == 1
            else f"there are not so many loops around this {node.word}",
            node.start,
            node.end,
            notes=(CONTROL_SAYS,),
            help=("EXIT and NEXT stand inside FOR, WHILE or DO",),
        )


def labels(
    program: ProgramText, problems: Problems, others: Iterable[ProgramText] = ()
) -> dict[int | str, int]:
    """Return the step number of every label; report duplicates and jumps to labels not there.

    `others` are the programs of the file, in which a label may stand instead.
    """
    known: dict[int | str, int] = {}
    places: dict[int | str, tuple[int, int]] = {}
    for step in program.steps:
        label = step.label
        if label is None:
            continue
        if label.number in known:
            problems.error(
                DUPLICATE_LABEL,
                f"label {label.number} stands twice in this program",
                label.start,
                label.end,
                secondary=(problems.label(*places[label.number], "first here"),),
                notes=("VAL-II says *Duplicate statement label*",),
                help=("give one of them another number",),
            )
            continue
        known[label.number] = step.number
        places[label.number] = (label.start, label.end)
    shown = ", ".join(heapq.nsmallest(8, map(str, known), key=lambda text: (len(text), text)))
    broken = [s.statement for s in program.steps if isinstance(s.statement, Bad)]
    standing: dict[int | str, str] | None = None  # the labels of others, asked for once
    for step in program.steps:
        if not isinstance(step.statement, (Goto, Simple)):
            continue
        wanted = _label_wanted(step.statement)
        if wanted is None or label_key(wanted) in known or problems.full:
            continue
        if _in_broken_line(broken, label_key(wanted), problems):
            continue  # said there
        if isinstance(step.statement, Simple) and _decimal_comma(problems, step.statement, wanted):
            continue
        if standing is None:
            standing = _standing(others)
        elsewhere = standing.get(label_key(wanted), "")
        here = "write the number at the start of the line to jump to"
        if known:
            here = f"labels of `{program.name}`: {shown}"
        problems.error(
            UNDEFINED_LABEL,
            f"there is no label {label_key(wanted)} in this program",
            wanted.start,
            wanted.end,
            f"it stands in `{elsewhere}`, and GOTO stays in its program" if elsewhere else "",
            notes=("VAL-II says *Branch to undefined label*",),
            help=(
                here,
                *(("RETURN goes back to the program that called this one",) if elsewhere else ()),
            ),
        )
    return known


def _decimal_comma(problems: Problems, node: Simple, label: Number | Name) -> bool:
    """Report `GRASP 12,5`: a decimal comma, behind which a label is looked for."""
    written = problems.source.text[node.start : node.end]
    pointed = likeliest(written, 1)
    if pointed is None:
        return False
    problems.error(
        UNDEFINED_LABEL,
        f"there is no label {label_key(label)}: behind the comma GRASP takes a label",
        label.start,
        label.end,
        notes=("VAL-II says *Branch to undefined label*",),
        help=(f"a comma is no decimal sign: write `{pointed.text}`",),
        fix=problems.replace(node.start, node.end, pointed.text),
    )
    return True


def _in_broken_line(broken: list[Bad], label: int | str, problems: Problems) -> bool:
    """Whether a line that nobody could read begins or ends with a label."""
    for node in broken:
        words = problems.source.text[node.start : node.end].split()
        first = _LETTERS.sub("", words[0].rstrip(":.)")) if words else ""
        if len(words) > 1 and str(label) in (first, words[-1]):
            return words[0].upper() not in ("GOTO", "IF")
    return False


def _standing(programs: Iterable[ProgramText]) -> dict[int | str, str]:
    """Return the first program that has each label."""
    found: dict[int | str, str] = {}
    for program in programs:
        for step in program.steps:
            if step.label is not None:
                found.setdefault(step.label.number, program.name)
    return found


def _label_wanted(node: Statement | None) -> Number | Name | None:
    """Return the label that a step jumps to."""
    if isinstance(node, Goto):
        return node.label
    if isinstance(node, Simple) and node.word == "GRASP" and len(node.operands) > 1:
        label = node.operands[1]
        return label if isinstance(label, Number) else None
    return None


def _check_cases(program: ProgramText, found: list[Block], problems: Problems) -> None:
    for block in found:
        if block.word != "CASE" or isinstance(program.steps[block.opener].statement, Bad):
            continue
        first = block.middles[0] if block.middles else block.end
        for i in range(block.opener + 1, first):
            node = program.steps[i].statement
            if node is not None and not isinstance(node, Bad):
                problems.error(
                    CASE_LAYOUT,
                    "a step between CASE and its first VALUE",
                    node.start,
                    node.end,
                    notes=(CONTROL_SAYS,),
                    help=("move it before CASE, or after a VALUE",),
                )
                break
