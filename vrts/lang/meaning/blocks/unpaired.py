"""What is said of structure words without a partner: one diagnostic for one that is missing."""

from vrts.base.diagnostic import Fix, Label, Rule
from vrts.lang.meaning.blocks.indentation import Missing, missing_ends
from vrts.lang.meaning.blocks.pairing import Block, Late, Pairing, Unmatched
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Bad, Statement

MISSING_END = Rule("V137", "missing-end")
UNMATCHED = Rule("V138", "unmatched-structure-word")
CASE_LAYOUT = Rule("V139", "case-layout")

CONTROL_SAYS = "VAL-II says *Control structure error*"


def report_faults(program: ProgramText, pairing: Pairing, problems: Problems) -> None:
    """Report words without their partner, but not what follows from a line that is no step."""
    followed = False  # a group without its structure: the END that follows is of the same cause
    for fault in pairing.unmatched:
        if followed and fault.mark.word in ("END", "UNTIL"):
            continue
        followed = followed or fault.mark.word not in ("END", "UNTIL")
        if not _explained(program, fault.mark.at):
            _unmatched(program, fault, problems)
    for late in pairing.late:
        _late(program, late, problems)
    still = [
        block
        for block in pairing.open
        if not isinstance(_node(program, block.opener), Bad) and not _unread_below(program, block)
    ]
    if len(still) < len(pairing.open):
        return
    columns = [
        _column(problems, step.statement) if step.statement is not None else 0
        for step in program.steps
    ]
    told = () if pairing.unmatched else missing_ends(program.steps, columns, len(still))
    if told:
        for missing in told:
            _missing(program, missing, pairing, problems)
        return
    for block in still:
        _open(program, block, pairing, problems)


def _explained(program: ProgramText, at: int) -> bool:
    """Whether a line above that nobody could read may be what opens the structure."""
    steps = program.steps[: at + 1]
    return any(isinstance(s.statement, Bad) and s.statement.word is None for s in steps) or (
        isinstance(program.steps[at].statement, Bad)
    )


def _unread_below(program: ProgramText, block: Block) -> bool:
    """Whether a line below the opener that nobody could read may be its end."""
    steps = program.steps[block.opener + 1 :]
    return any(isinstance(s.statement, Bad) and s.statement.word is None for s in steps)


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
        text = problems.source.text
        begin = text.rfind("\n", 0, opener.start) + 1
        before = text[begin : opener.start]
        indent = before if not before.strip() else " " * len(before.expandtabs(8))
        fix = problems.replace(at, at, f"\n{indent}END")
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
        help=(f"write {closer} after its last step",),
    )


def _late(program: ProgramText, late: Late, problems: Problems) -> None:
    node, last = _node(program, late.mark.at), _node(program, late.last.at)
    problems.error(
        CASE_LAYOUT,
        f"{late.mark.word} after {late.last.word}",
        node.start,
        node.end,
        secondary=(problems.label(last.start, last.end, "the last group is here"),),
        notes=(CONTROL_SAYS,),
        help=("an IF has one ELSE; ANY is the last group of a CASE",),
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
    elif word == "END" and all(s.statement is None for s in program.steps[fault.mark.at + 1 :]):
        help_ = "take it out: `.END` alone ends a program"
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


def _without_line(problems: Problems, node: Statement) -> Fix | None:
    """Return a fix that takes out a line with nothing but a step."""
    text = problems.source.text
    begin, end = text.rfind("\n", 0, node.start) + 1, _line_end(problems, node.end)
    if text[begin:end].strip() != text[node.start : node.end]:
        return None
    return problems.replace(begin, min(end + 1, len(text)), "")
