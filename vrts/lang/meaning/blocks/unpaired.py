"""What is said of structure words without a partner: one diagnostic for one that is missing."""

import math
from collections.abc import Iterator

from vrts.base.diagnostic import Fix, Label, Rule
from vrts.lang.meaning.blocks.indentation import Missing, missing_ends
from vrts.lang.meaning.blocks.pairing import (
    Block,
    Crossed,
    Late,
    Mark,
    Pairing,
    Unmatched,
    marks,
    pair,
    word_of,
)
from vrts.lang.problems import LIMIT, Problems
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import Bad, Goto, Statement, Structure, Until

MISSING_END = Rule("V137", "missing-end")
UNMATCHED = Rule("V138", "unmatched-structure-word")
CASE_LAYOUT = Rule("V139", "case-layout")

CONTROL_SAYS = "VAL-II says *Control structure error*"


def report_faults(program: ProgramText, pairing: Pairing, problems: Problems) -> None:
    """Report words without their partner, but not what follows from a line that is no step."""
    unread = _unread(program)
    found = marks(program.steps)
    places = {mark: i for i, mark in enumerate(found)}
    faults = pair(found).faults if pairing.unmatched else 0
    followed = False  # a group without its structure: the END that follows is of the same cause
    for number, fault in enumerate(pairing.unmatched):
        explained = _explained(program, unread, fault.mark.at)
        early: Statement | None = None
        if fault.mark.word == "ELSE" and not explained and number < LIMIT:  # more are not shown
            early = _early_end(program, found, places[fault.mark], faults, problems)
        if early is not None:
            followed = True
            _too_early(program, fault, early, problems)
            continue
        if followed and fault.mark.word in ("END", "UNTIL"):
            continue
        followed = followed or fault.mark.word not in ("END", "UNTIL")
        if not explained:
            _unmatched(program, fault, problems)
    behind: set[int] = set()  # groups that are not the last of theirs: told once each
    for late in pairing.late:
        if late.last.at not in behind:
            behind.add(late.last.at)
            _late(program, late, problems)
    inside = [block for crossed in pairing.crossed for block in crossed.open]
    plain = not pairing.unmatched and not any(crossed.end for crossed in pairing.crossed)
    still = [
        block
        for block in (*inside, *pairing.open)
        if not isinstance(_node(program, block.opener), Bad)
        and not (unread and unread[-1] > block.opener)  # which may be its end
    ]
    columns = [
        _column(problems, step.statement) if step.statement is not None else 0
        for step in program.steps
    ]
    known = len(still) == len(inside) + len(pairing.open)
    told = missing_ends(program.steps, columns, len(still)) if plain and known else ()
    if told:
        for missing in told:
            _missing(program, missing, pairing, problems)
        return
    for crossed in pairing.crossed:
        _crossed(program, crossed, problems)
    if not known:
        return
    for block in pairing.open:
        _open(program, block, pairing, problems)


def _unread(program: ProgramText) -> list[int]:
    """Return the steps that nobody could read."""
    return [
        i
        for i, step in enumerate(program.steps)
        if isinstance(step.statement, Bad) and step.statement.word is None
    ]


def _explained(program: ProgramText, unread: list[int], at: int) -> bool:
    """Whether a line above that nobody could read may be what opens the structure."""
    above = bool(unread) and unread[0] <= at
    return above or isinstance(program.steps[at].statement, Bad)


def _above(program: ProgramText, at: int) -> Iterator[Statement]:
    """The steps above one, from there on."""
    steps = program.steps
    return (node for i in range(at - 1, -1, -1) if (node := steps[i].statement) is not None)


def _below(program: ProgramText, at: int) -> Iterator[Statement]:
    """The steps below one."""
    steps = program.steps
    return (node for i in range(at + 1, len(steps)) if (node := steps[i].statement) is not None)


def _node(program: ProgramText, at: int) -> Statement:
    node = program.steps[at].statement
    assert node is not None
    return node


def _column(problems: Problems, node: Statement) -> int:
    """Return where a step begins in its line, tabs counted as up to the next eighth column."""
    text = problems.source.text
    begin = text.rfind("\n", 0, node.start) + 1
    return len(text[begin : node.start].expandtabs(8))


def _line_end(problems: Problems, offset: int) -> int:
    finish = problems.source.text.find("\n", offset)
    return len(problems.source.text) if finish < 0 else finish


def _missing(program: ProgramText, missing: Missing, pairing: Pairing, problems: Problems) -> None:
    """A structure whose end is missing where the indentation goes back."""
    opener, last = _node(program, missing.opener), _node(program, missing.last)
    closer = "UNTIL" if missing.word == "DO" else "END"
    at = _line_end(problems, last.end)
    labels: list[Label] = []
    if missing.following is not None:
        following = _node(program, missing.following)
        labels.append(
            problems.label(following.start, following.end, f"its {closer} belongs above this line")
        )
        labels += _taken(program, missing, pairing, problems)
    else:
        labels.append(problems.label(*program.finish, "still open where the program ends"))
    fix: Fix | None = None
    if closer == "END":
        fix = problems.replace(at, at, f"\n{_line_start(problems, opener)}END")
    number = problems.span(last.start, last.end).line
    problems.error(
        MISSING_END,
        f"this {missing.word} has no {closer}",
        opener.start,
        opener.end,
        "opened here",
        secondary=tuple(labels),
        notes=(CONTROL_SAYS,),
        help=(f"write {closer} below line {number}, the last that is indented",),
        fix=fix,
        data={"below": number},
    )


def _taken(
    program: ProgramText, missing: Missing, pairing: Pairing, problems: Problems
) -> list[Label]:
    """The end that the controller takes for that of the structure, and whose it is."""
    block = next((b for b in pairing.blocks if b.opener == missing.opener), None)
    if block is None:
        return []
    end = _node(program, block.end)
    return [
        problems.label(
            end.start, end.end, f"the controller takes this for the end of the {missing.word}"
        )
    ]


def _open(program: ProgramText, block: Block, pairing: Pairing, problems: Problems) -> None:
    """A structure that is open where the program ends."""
    node = _node(program, block.opener)
    closer = "UNTIL" if block.word == "DO" else "END"
    inner = [b for b in pairing.blocks if b.opener > block.opener]
    labels = [problems.label(*program.finish, "still open where the program ends")]
    if inner and closer == "END":
        last = max(inner, key=lambda b: b.end)
        end = _node(program, last.end)
        line = problems.span(_node(program, last.opener).start, end.end).line
        labels.append(
            problems.label(end.start, end.end, f"this ends the {last.word} of line {line}")
        )
    problems.error(
        MISSING_END,
        f"this {block.word} has no {closer}",
        node.start,
        node.end,
        "opened here",
        secondary=tuple(labels),
        notes=(CONTROL_SAYS,),
        help=(f"write `{closer}` after its last step",)
        if closer == "END"
        else ("write `UNTIL condition` after its last step",),
    )


def _crossed(program: ProgramText, crossed: Crossed, problems: Problems) -> None:
    """An UNTIL or a VALUE while an IF or a FOR inside its structure is open: its END is above."""
    until = _node(program, crossed.mark.at)
    text = problems.source.text
    begin = text.rfind("\n", 0, until.start) + 1
    line = problems.span(until.start, until.end).line
    if crossed.end is not None:
        end, block = _node(program, crossed.end.at), crossed.open[0]
        opener = _node(program, block.opener)
        where = _line_start(problems, opener)
        without = _without_line(problems, end)
        edits = problems.replace(begin, begin, f"{where}END\n").edits
        problems.error(
            UNMATCHED,
            f"UNTIL ends the DO while the {block.word} inside it is still open",
            until.start,
            until.end,
            secondary=(problems.label(opener.start, opener.end, f"this {block.word} is open"),),
            notes=(CONTROL_SAYS,),
            help=(f"write the END of the {block.word} above the UNTIL, not below it",),
            fix=Fix.from_edits((*edits, *without.edits)) if without is not None else None,
        )
        return
    least, looked = math.inf, crossed.mark.at  # of the columns of the steps from there on
    for block in reversed(crossed.open):
        opener = _node(program, block.opener)
        for step in program.steps[block.opener + 1 : looked]:
            if step.statement is not None:
                least = min(least, _column(problems, step.statement))
        looked = block.opener + 1
        if isinstance(opener, Bad):
            continue
        closer = "UNTIL" if block.word == "DO" else "END"
        # where a line is less deep than the structure, its end may belong above that line
        deeper = least > _column(problems, opener)
        problems.error(
            MISSING_END,
            f"this {block.word} has no {closer}",
            opener.start,
            opener.end,
            "opened here",
            secondary=(
                problems.label(until.start, until.end, f"its {closer} belongs above this line"),
            ),
            notes=(CONTROL_SAYS,),
            help=(f"write {closer} above line {line}, before the {crossed.mark.word}",),
            fix=problems.replace(begin, begin, f"{_line_start(problems, opener)}END\n", sure=deeper)
            if closer == "END"
            else None,
        )


def _line_start(problems: Problems, node: Statement) -> str:
    """Return the blanks that a line begins with, a label counted as such."""
    text = problems.source.text
    before = text[text.rfind("\n", 0, node.start) + 1 : node.start]
    return before if not before.strip() else " " * len(before.expandtabs(8))


def _early_end(
    program: ProgramText, found: list[Mark], at: int, faults: int, problems: Problems
) -> Statement | None:
    """Return the END right above an ELSE without which all words up to the next have partners."""
    mark = found[at]
    end = next(_above(program, mark.at), None)
    if at == 0 or end is None or found[at - 1].word != "END":
        return None
    if program.steps[found[at - 1].at].statement is not end:
        return None
    if _column(problems, end) < _column(problems, _node(program, mark.at)):
        return None
    without = pair([*found[: at - 1], *found[at:]])
    return end if without.faults + 1 < faults else None


def _too_early(program: ProgramText, fault: Unmatched, end: Statement, problems: Problems) -> None:
    """An END between the steps of an IF and its ELSE."""
    node = _node(program, fault.mark.at)
    line = problems.span(end.start, end.end).line
    problems.error(
        UNMATCHED,
        "ELSE without IF: the END above it closes the IF too early",
        node.start,
        node.end,
        secondary=(problems.label(end.start, end.end, "this END closes the IF"),),
        notes=(CONTROL_SAYS,),
        help=(f"take out the END of line {line}: the one below the ELSE closes the IF",),
        fix=_without_line(problems, end),
    )


def _late(program: ProgramText, late: Late, problems: Problems) -> None:
    """A group behind the one that is the last of its structure: told at ANY, or at the ELSE."""
    node, last = _node(program, late.mark.at), _node(program, late.last.at)
    both = late.mark.word == late.last.word
    if both:
        headline, at, label = f"a second {late.mark.word}", node, "the first is here"
        other = last
        help_ = "an IF has one ELSE: for another condition write a new IF, with an END of its own"
        if late.mark.word == "ANY":
            help_ = "a CASE has one ANY: write a VALUE for what the other is for"
    else:
        headline, at, label = "ANY is not the last group of its CASE", last, "stands behind it"
        other = node
        help_ = "move ANY and its steps below the last VALUE, before END"
    problems.error(
        CASE_LAYOUT,
        headline,
        at.start,
        at.end,
        secondary=(problems.label(other.start, other.end, label),),
        notes=(CONTROL_SAYS,),
        help=(help_,),
    )


def _unmatched(program: ProgramText, fault: Unmatched, problems: Problems) -> None:
    node = _node(program, fault.mark.at)
    word, top = fault.mark.word, fault.top
    wanted = {"ELSE": "IF", "ELSEIF": "IF", "UNTIL": "DO", "END": ""}.get(word, "CASE")
    secondary: tuple[Label, ...] = ()
    if top is not None:
        opener = _node(program, top.opener)
        secondary = (problems.label(opener.start, opener.end, f"this {top.word} is open"),)
    headline = f"{word} without {wanted}" if wanted else f"{word} ends nothing"
    help_ = "take it out, or write the line that opens the structure"
    fix: Fix | None = None
    if wanted:
        help_ = f"write the {wanted} that it belongs to above it, or take it out"
    if word == "ELSE" and top is not None and top.word == "CASE":
        help_ = "a CASE has ANY for all other values: write `ANY`"
        fix = problems.replace(node.start, node.end, "ANY")
    if word == "END" and top is not None:
        headline, help_ = "a DO ends with UNTIL, not END", "write `UNTIL condition`"
    elif word == "UNTIL" and top is not None:
        headline = f"a {top.word} ends with END, not UNTIL"
        help_ = "write `END`; a loop that ends with UNTIL begins with DO"
        fix = problems.replace(node.start, node.end, "END", sure=False)
    elif word == "ELSE" and top is None:
        jump = _jump_above(program, fault.mark.at)
        if jump is not None:
            number = problems.span(jump.start, jump.end).line
            help_ = f"`IF ... GOTO` of line {number} takes no ELSE: write `IF ... THEN`"
            help_ += ", the GOTO on a line of its own, then ELSE"
    elif word == "END" and next(_below(program, fault.mark.at), None) is None:
        help_ = "take it out: `.END` alone ends a program"
        fix = _without_line(problems, node)
    elif word == "END" and isinstance(next(_below(program, fault.mark.at), None), Until):
        help_ = "take it out: UNTIL alone ends a DO"
        fix = _without_line(problems, node)
    elif word == "END" and _is_surplus(program, fault.mark.at, problems):
        help_ = "take it out: every structure above has its END"
        if _jump_above(program, fault.mark.at) is not None:
            help_ = "take it out: `IF ... GOTO` stands on one line and needs no END"
        fix = _without_line(problems, node)
    problems.error(
        UNMATCHED,
        headline,
        node.start,
        node.end,
        secondary=secondary,
        notes=(CONTROL_SAYS,),
        help=(help_,),
        fix=fix,
    )


def _is_surplus(program: ProgramText, at: int, problems: Problems) -> bool:
    """Whether what stands above an END belongs to no structure, as its indentation tells."""
    last = next(_above(program, at), None)
    if last is None:
        return True
    column = _column(problems, _node(program, at))
    ends = isinstance(last, Structure | Until) and word_of(Step(0, None, last)) != "ELSE"
    deep = _column(problems, last)
    return deep <= column if not ends else deep >= column


def _jump_above(program: ProgramText, at: int) -> Goto | None:
    """Return the `IF ... GOTO` that the lines above a word belong to, as its writer thinks."""
    for node in _above(program, at):
        if isinstance(node, Goto):
            return node if node.condition is not None else None
        if word_of(Step(0, None, node)) is not None:
            return None
    return None


def _without_line(problems: Problems, node: Statement) -> Fix | None:
    """Return a fix that takes out a line with nothing but a step."""
    text = problems.source.text
    begin, end = text.rfind("\n", 0, node.start) + 1, _line_end(problems, node.end)
    if text[begin:end].strip() != text[node.start : node.end]:
        return None
    return problems.replace(begin, min(end + 1, len(text)), "")
