"""`GOTO` without a label, and `GOTO k` with a number `k`: a label is written, not computed."""

from dataclasses import replace

from vrts.ir.values import Type
from vrts.lang.grammar.shapes import LABEL_EXPECTED
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.names import key
from vrts.lang.syntax.program import ProgramText

_MOST_LABELS = 8  # more are not listed


def mend_jumps_by_number(resolver: Resolver, programs: list[ProgramText]) -> None:
    """Say which labels a jump without one can have, and how a number chooses among labels."""
    problems = resolver.problems
    for at, told in enumerate(problems.found):
        if told.rule != LABEL_EXPECTED or told.primary is None:
            continue
        name = told.primary.span.text
        if not name.strip():
            help_ = _labels_around(told.primary.span.start, programs)
            if help_ is not None:
                problems.found[at] = replace(told, help=(help_,))
            continue
        entry = resolver.scope.entries.get(key(name))
        if entry is None or entry.type is not Type.REAL or not entry.writes:
            continue
        help_ = (
            f"a label is a written number: to choose by `{name}` write `IF {name} == 10 GOTO 10`"
            f" for each label, or `CASE {name} OF`"
        )
        problems.found[at] = replace(told, help=(help_,))


def _labels_around(place: int, programs: list[ProgramText]) -> str | None:
    """Return which labels the program around a place has, or None without any."""
    for program in programs:
        if program.start <= place <= program.finish[1]:
            labels = [str(s.label.number) for s in program.steps if s.label is not None]
            if not labels or len(labels) > _MOST_LABELS:
                return None
            if len(labels) == 1:
                return f"the one label of this program is {labels[0]}: write `GOTO {labels[0]}`"
            return f"labels of this program: {', '.join(labels)}"
    return None
