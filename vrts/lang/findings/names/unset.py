"""Variables of each call that are looked at before anything gives them a value.

Only AUTO of V+ and `.x` of AS: they are certainly empty when a call begins. What a global holds
then may be left from an earlier run, or be loaded, so of these nothing is certain.
"""

from bisect import bisect_right
from collections.abc import Iterator

from vrts.lang.findings.names.misused_words import UNDEFINED_VARIABLE
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.meaning.scope import Entry
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    Bad,
    Case,
    Declare,
    For,
    Goto,
    If,
    Rest,
    Simple,
    Statement,
    Structure,
    Until,
    ValueGroup,
    While,
)

_PARTS = (Case, For, Goto, If, Structure, Until, ValueGroup, While)  # where ways part or meet
_LEAVE = frozenset({"RETURN", "RETURNE", "STOP", "HALT", "PAUSE"})


def check_unset(resolver: Resolver, program: ProgramText) -> None:
    """Warn of each such variable that is read on the straight way from the start of a program."""
    waiting = [entry for entry in resolver.scope.formals[program.name].values() if _asks(entry)]
    nodes = list(_straight(program)) if waiting else []
    starts = [node.start for node in nodes]
    for entry in waiting:
        read = min(entry.reads, default=None)
        given = min((*entry.writes, *(passed.at for passed in entry.passed)))
        first = given if read is None else min(read, given)
        k = bisect_right(starts, first[0]) - 1
        if read is None or k < 0 or first[0] >= nodes[k].end:
            continue  # it is not on that way
        gives = given[0] < nodes[k].end
        if read[0] < nodes[k].end and (not gives or isinstance(nodes[k], Assignment)):
            _report(resolver, entry, read)


def _asks(entry: Entry) -> bool:
    """Whether a variable is of each call, is a single one, and is given a value somewhere."""
    single = entry.automatic and entry.array is None
    return single and not entry.asked and len(entry.writes) > 0


def _straight(program: ProgramText) -> Iterator[Statement]:
    """Yield the statements that each call passes first, up to one where ways part or meet."""
    for step in program.steps:
        node = step.statement
        if step.label is not None or isinstance(node, Bad | Rest):
            return
        if node is None or isinstance(node, Declare):
            continue
        yield node
        if isinstance(node, _PARTS) or (isinstance(node, Simple) and node.word in _LEAVE):
            return


def _report(resolver: Resolver, entry: Entry, read: tuple[int, int]) -> None:
    problems = resolver.problems
    if problems.source.line_of(read[0]) in resolver.wrong_lines:
        return  # the line was reported
    first = min(entry.writes)
    own = problems.source.line_of(first[0]) == problems.source.line_of(read[0])
    problems.warning(
        UNDEFINED_VARIABLE,
        f"`{entry.name}` has no value yet where it is looked at",
        *read,
        secondary=() if own else (problems.label(*first, "gets its first value here"),),
        notes=("a variable of its own is empty whenever the program begins",),
        help=(f"give it a value before, as in `{entry.name} = 0`",)
        if not entry.name.startswith(("$", "#"))
        else ("give it a value before",),
        data={"name": entry.name},
    )
