"""VALUE twice with the same number in one CASE: the second one is never chosen."""

from vrts.lang.findings.flow import UNREACHABLE
from vrts.lang.findings.ways.branches import shape
from vrts.lang.meaning.constants import number_of
from vrts.lang.meaning.structure import Block
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Item
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import ValueGroup

_MOST_VALUES = 500  # of one CASE


def check_values(problems: Problems, program: ProgramText, blocks: list[Block]) -> None:
    """Warn of each value of a CASE that stands above it, too."""
    for block in blocks:
        if block.word == "CASE":
            _check(problems, program, block)


def _check(problems: Problems, program: ProgramText, block: Block) -> None:
    text = problems.source.text
    seen: list[tuple[object, Item]] = []
    for at in block.middles:
        group = program.steps[at].statement
        if not isinstance(group, ValueGroup):
            continue
        for value in group.values[:_MOST_VALUES]:
            if value is None or len(seen) >= _MOST_VALUES:
                continue
            number = number_of(value)
            said = shape(value) if number is None else number
            first = next((node for other, node in seen if other == said), None)
            if first is None:
                seen.append((said, value))
                continue
            written = text[value.start : value.end]
            here = group.start <= first.start
            alone = len(group.values) == 1
            problems.warning(
                UNREACHABLE,
                f"`{written}` stands twice in this VALUE"
                if here
                else f"for `{written}` this VALUE is never chosen: it stands in one above",
                value.start,
                value.end,
                "" if here else "CASE does the steps of the first VALUE that fits",
                secondary=(problems.label(first.start, first.end, "it stands here first"),),
                help=(
                    f"write another value than `{written}`, or take "
                    + ("this VALUE and its steps out" if alone else "it out"),
                ),
            )
