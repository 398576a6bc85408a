"""`GOTO k` where `k` holds a number: a label is written in the program, and never computed."""

from dataclasses import replace

from vrts.ir.values import Type
from vrts.lang.grammar.shapes import LABEL_EXPECTED
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.names import key


def mend_jumps_by_number(resolver: Resolver) -> None:
    """Say of jumps to a variable that holds a number how a number chooses among labels."""
    problems = resolver.problems
    for at, told in enumerate(problems.found):
        if told.rule != LABEL_EXPECTED or told.primary is None:
            continue
        name = told.primary.span.text
        entry = resolver.scope.entries.get(key(name))
        if entry is None or entry.type is not Type.REAL or not entry.writes:
            continue
        help_ = (
            f"a label is a written number: to choose by `{name}` write `IF {name} == 10 GOTO 10`"
            f" for each label, or `CASE {name} OF`"
        )
        problems.found[at] = replace(told, help=(help_,))
