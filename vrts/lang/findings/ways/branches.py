"""IF whose two branches do the same, and structures between whose words no step stands."""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, cast

from vrts.base.diagnostic import Edit, Fix, Rule
from vrts.lang.meaning.structure import Block
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import ProgramText, Step
from vrts.lang.syntax.statements import Bad, Statement, Structure, ValueGroup

SAME_BRANCHES = Rule("V247", "same-branches")
EMPTY_BLOCK = Rule("V248", "empty-block")

MOST_COMPARED = 50  # steps of a branch; longer ones are not compared
_POSITIONS = frozenset({"start", "end", "operator_start"})  # fields that tell only where it stands


def check_branches(problems: Problems, program: ProgramText, found: Sequence[Block]) -> list[Block]:
    """Warn of structures that decide nothing, or do nothing; return those that are empty."""
    empty: list[Block] = []
    for block in found:
        opener = program.steps[block.opener].statement
        if opener is None or isinstance(opener, Bad):
            continue
        if block.word == "IF" and len(block.middles) == 1:
            _same(problems, program, block, opener)
        if _empty(problems, program, block, opener):
            empty.append(block)
    return empty


def _same(problems: Problems, program: ProgramText, block: Block, opener: Statement) -> None:
    """`IF c THEN / SIGNAL 5 / ELSE / SIGNAL 5 / END`."""
    middle = block.middles[0]
    first = program.steps[block.opener + 1 : middle]
    second = program.steps[middle + 1 : block.end]
    if len(first) != len(second) or not 0 < len(first) <= MOST_COMPARED:
        return
    if not all(_equal(a, b) for a, b in zip(first, second, strict=True)):
        return
    else_ = program.steps[middle].statement
    assert else_ is not None
    problems.warning(
        SAME_BRANCHES,
        "both branches of this IF do the same",
        opener.start,
        opener.end,
        secondary=(problems.label(else_.start, else_.end, "the same steps follow here"),),
        help=("change one of the branches, or write the steps once without IF, ELSE and END",),
    )


def _equal(a: Step, b: Step) -> bool:
    if a.label is not None or b.label is not None or type(a.statement) is not type(b.statement):
        return False
    return not isinstance(a.statement, Bad) and shape(a.statement) == shape(b.statement)


def shape(node: Any) -> object:
    """Return what a node says, wherever it stands."""
    if isinstance(node, Name):
        return key(node.text)
    fields: tuple[str, ...] | None = getattr(node, "_fields", None)
    if fields is not None:
        said: list[object] = [type(node).__name__]
        said += [shape(getattr(node, name)) for name in fields if name not in _POSITIONS]
        return said
    if type(node) is tuple:
        return [shape(part) for part in cast("tuple[object, ...]", node)]
    return node


def _empty(problems: Problems, program: ProgramText, block: Block, opener: Statement) -> bool:
    """Warn of `IF c THEN / END`, and of other structures whose END stands too early."""
    steps = program.steps
    words = [block.opener, *block.middles, block.end]
    if block.word == "CASE":
        _falling_through(problems, steps, words)
        return False
    if words[-1] - words[-2] > 1 or block.word == "DO":
        return False
    end = steps[block.end].statement
    if end is None or problems.source.text.find(";", opener.start, end.start) >= 0:
        return False  # a remark tells why
    stray = _too_early(problems, steps, block)
    nothing = all(b - a == 1 for a, b in pairwise(words))
    if not stray and not (nothing and block.word in ("IF", "FOR")):
        return False  # an ELSE of which nothing comes, and WHILE that waits for a signal
    word = "ELSE" if block.middles else block.word
    above = steps[words[-2]].statement
    assert above is not None
    other = "remove ELSE" if word == "ELSE" else f"remove {word} and END"
    if word == "FOR" and not stray:
        other = "to wait write `DELAY 2`, in seconds"
    problems.warning(
        EMPTY_BLOCK,
        f"nothing stands between {word} and END: this {word} is empty",
        above.start,
        above.end,
        "no step belongs to it",
        secondary=(problems.label(end.start, end.end, "it ends here"),),
        help=(
            "move END below the steps that belong to it",
            f"or {other}" if other[0] == "r" else other,
        ),
        fix=_moved(problems, end, stray),
    )
    return True


def _too_early(problems: Problems, steps: Sequence[Step], block: Block) -> list[Step]:
    """Return the steps behind an END that are indented as if they stood in the structure."""
    opener = steps[block.opener].statement
    assert opener is not None
    margin = _column(problems, opener)
    found: list[Step] = []
    for at in range(block.end + 1, len(steps)):  # no slice: there may be many structures
        step = steps[at]
        node = step.statement
        if node is None or isinstance(node, Bad | Structure) or step.label is not None:
            break
        if _column(problems, node) <= margin:
            break
        found.append(step)
    return found


def _moved(problems: Problems, end: Statement, stray: Sequence[Step]) -> Fix | None:
    """Return the edit that puts an END below the steps that are indented like its own."""
    last = stray[-1].statement if stray else None
    text = problems.source.text
    start = text.rfind("\n", 0, end.start) + 1
    finish = text.find("\n", end.end) + 1
    if last is None or not finish or text[end.end : finish].strip():
        return None
    below = text.find("\n", last.end) + 1
    if not below:
        return None
    removed = problems.replace(start, finish, "", sure=False)
    return removed._replace(
        more=(Edit(problems.span(below, below), text[start:finish]),),
    )


def _falling_through(problems: Problems, steps: Sequence[Step], words: Sequence[int]) -> None:
    """Warn of `VALUE 1: / VALUE 2:`, where C goes on below."""
    row: list[ValueGroup] = []  # groups that follow each other without a step between
    last = -1
    for at in words[1:]:
        group = steps[at].statement
        falls = row and at - last == 1 and isinstance(group, ValueGroup)
        if not falls or _remark(problems, row[-1], group):
            _report_row(problems, row)
            row = []
        if isinstance(group, ValueGroup):
            row.append(group)
        last = at


def _remark(problems: Problems, group: ValueGroup, below: Statement | None) -> bool:
    end = below.start if below is not None else group.end
    return problems.source.text.find(";", group.start, end) >= 0


def _report_row(problems: Problems, row: Sequence[ValueGroup]) -> None:
    if len(row) < 2:
        return
    text = problems.source.text
    first, last = row[0], row[-1]
    values = (text[n.start : n.end].rstrip().removesuffix(":")[len("VALUE") :] for n in row)
    written = f"VALUE {', '.join(value.strip() for value in values)}:"
    problems.warning(
        EMPTY_BLOCK,
        "nothing stands between this VALUE and the next: for it nothing is done",
        first.start,
        first.end,
        "no step belongs to it",
        notes=("CASE does the steps of one VALUE only, and does not go on to the next",),
        help=(f"write several values before the steps: `{written}`",),
        fix=problems.replace(first.start, last.end, written, sure=False),
    )


def _column(problems: Problems, node: Statement) -> int:
    text = problems.source.text
    begin = text.rfind("\n", 0, node.start) + 1
    return len(text[begin : node.start].expandtabs(8))
