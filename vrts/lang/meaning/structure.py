"""Pairs the structure words and labels of a program."""

import heapq
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name, Number
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import (
    Bad,
    Case,
    For,
    Goto,
    If,
    Simple,
    Statement,
    Structure,
    Until,
    ValueGroup,
    While,
)

DUPLICATE_LABEL = Rule("V134", "duplicate-label")
UNDEFINED_LABEL = Rule("V135", "undefined-label")
MISSING_END = Rule("V137", "missing-end")
UNMATCHED = Rule("V138", "unmatched-structure-word")
CASE_LAYOUT = Rule("V139", "case-layout")

_SAYS = "VAL-II says *Control structure error*"
_WORDS = frozenset({"IF", "WHILE", "FOR", "CASE", "DO", "END", "UNTIL"})
_OPENERS: dict[type, str] = {If: "IF", While: "WHILE", For: "FOR", Case: "CASE"}


class Block(NamedTuple):
    """One structure: indices into the steps of its program."""

    word: str  # IF, WHILE, FOR, CASE, DO
    opener: int
    middles: list[int]  # ELSE, or VALUE and ANY
    end: int


def word_of(step: Step) -> str | None:
    """Return the structure word of a step, also of one that did not parse."""
    node = step.statement
    if isinstance(node, Structure):
        return node.word
    if isinstance(node, Bad):
        return node.word
    if isinstance(node, Until):
        return "UNTIL"
    if isinstance(node, ValueGroup):
        return "VALUE"
    return _OPENERS.get(type(node)) if node is not None else None


def blocks(program: ProgramText, problems: Problems) -> list[Block]:
    """Return the structures of a program; report words without their partner."""
    found: list[Block] = []
    open_: list[Block] = []
    for i, step in enumerate(program.steps):
        word = word_of(step)
        if word is None or step.statement is None:
            continue
        top = open_[-1] if open_ else None
        if word in ("IF", "WHILE", "FOR", "CASE", "DO"):
            open_.append(Block(word, i, [], -1))
        elif word in ("ELSE", "VALUE", "ANY"):
            wanted = "IF" if word == "ELSE" else "CASE"
            if top is None or top.word != wanted:
                _unmatched(program, step, word, wanted, top, problems)
            elif top.middles and word_of(program.steps[top.middles[-1]]) in ("ELSE", "ANY"):
                last = program.steps[top.middles[-1]].statement
                assert last is not None
                problems.error(
                    CASE_LAYOUT,
                    f"{word} after {word_of(program.steps[top.middles[-1]])}",
                    step.statement.start,
                    step.statement.end,
                    secondary=(problems.label(last.start, last.end, "the last group is here"),),
                    notes=(_SAYS,),
                    help=("an IF has one ELSE; ANY is the last group of a CASE",),
                )
            else:
                top.middles.append(i)
        elif word in ("END", "UNTIL"):
            if top is None or (top.word == "DO") != (word == "UNTIL"):
                _unmatched(program, step, word, "DO" if word == "UNTIL" else "", top, problems)
                if top is not None and word == "END":
                    open_.pop()  # a DO closed by END: said once
            else:
                found.append(open_.pop()._replace(end=i))
        elif top is not None and top.word == "CASE" and not top.middles:
            pass
    bad = any(isinstance(program.steps[b.opener].statement, Bad) for b in (*found, *open_))
    for block in open_ if not bad else ():  # a bad opener may have taken the END of another
        step = program.steps[block.opener].statement
        assert step is not None
        closer = "UNTIL" if block.word == "DO" else "END"
        problems.error(
            MISSING_END,
            f"this {block.word} has no {closer}",
            step.start,
            step.end,
            "opened here",
            secondary=(problems.label(*program.finish, "still open where the program ends"),),
            notes=(_SAYS,),
            help=(f"write {closer} after its last step",),
        )
    _check_cases(program, found, problems)
    return found


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
    loops = {block.opener: block for block in found if block.word in ("FOR", "WHILE", "DO")}
    open_: list[Block] = []
    meant: dict[int, Block | None] = {}
    for at, step in enumerate(program.steps):
        while open_ and open_[-1].end <= at:
            open_.pop()
        node = step.statement
        if isinstance(node, Simple) and node.word in ("EXIT", "NEXT"):
            count = loops_of(node)
            meant[at] = open_[-count] if 1 <= count <= len(open_) else None
        if at in loops:
            open_.append(loops[at])
    return meant


def check_exits(program: ProgramText, found: list[Block], problems: Problems) -> None:
    """Report EXIT and NEXT outside of loops, where the structures are known."""
    if any(isinstance(step.statement, Bad) and word_of(step) in _WORDS for step in program.steps):
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
            notes=(_SAYS,),
            help=("EXIT and NEXT stand inside FOR, WHILE or DO",),
        )


def labels(program: ProgramText, problems: Problems) -> dict[int | str, int]:
    """Return the step number of every label; report duplicates and jumps to labels not there."""
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
    for step in program.steps:
        wanted = _label_wanted(step.statement)
        if wanted is not None and label_key(wanted) not in known:
            problems.error(
                UNDEFINED_LABEL,
                f"there is no label {label_key(wanted)} in this program",
                wanted.start,
                wanted.end,
                notes=("VAL-II says *Branch to undefined label*",),
                help=(
                    f"labels of `{program.name}`: {shown}"
                    if known
                    else "write the number at the start of the line to jump to",
                ),
            )
    return known


def _label_wanted(node: Statement | None) -> Number | Name | None:
    """Return the label that a step jumps to."""
    if isinstance(node, Goto):
        return node.label
    if isinstance(node, Simple) and node.word == "GRASP" and len(node.operands) > 1:
        label = node.operands[1]
        return label if isinstance(label, Number) else None
    return None


def _unmatched(
    program: ProgramText,
    step: Step,
    word: str,
    wanted: str,
    top: Block | None,
    problems: Problems,
) -> None:
    node = step.statement
    assert node is not None
    if isinstance(node, Bad):
        return  # reported as it is
    secondary = ()
    if top is not None:
        opener = program.steps[top.opener].statement
        assert opener is not None
        secondary = (problems.label(opener.start, opener.end, f"this {top.word} is open"),)
    headline = f"{word} without {wanted}" if wanted else f"{word} ends nothing"
    help_ = "take it out, or write the line that opens the structure"
    if word == "END" and top is not None:
        headline, help_ = "a DO ends with UNTIL, not END", "write `UNTIL condition`"
    problems.error(
        UNMATCHED,
        headline,
        node.start,
        node.end,
        secondary=secondary,
        notes=(_SAYS,),
        help=(help_,),
    )


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
                    notes=(_SAYS,),
                    help=("move it before CASE, or after a VALUE",),
                )
                break
