"""What is surely a slip, whether it earns anything alone or not: to look for a second beside it."""

from collections.abc import Iterator
from statistics import median_high

from vrts.lang.syntax.expressions import Number
from vrts.lang.syntax.statements import Level, SpeedStatement
from vrts.repair.edit import Candidate, Does
from vrts.repair.table.asked import Asked, written_number
from vrts.repair.table.rows import as_taught
from vrts.repair.written import WrittenStep

CRAWLS = 5.0  # per cent: nobody means a speed below it
USUAL = 30.0  # per cent: a speed, where the program has no other


def surely(asked: Asked) -> Iterator[Candidate]:
    """Yield locations as the scene says that differ by a slip, and speeds that crawl as others."""
    yield from as_taught(asked)
    speeds = list(_percents(asked))
    for step, always, number in speeds:
        if number.value >= CRAWLS:
            continue
        others = [
            other.value for _, too, other in speeds if too == always and other.value >= CRAWLS
        ]
        text = written_number(median_high(others) if others else USUAL)
        yield asked.instead(Does.NUMBER, step.line, number, text)


def _percents(asked: Asked) -> Iterator[tuple[WrittenStep, bool, Number]]:
    """Yield the steps of SPEED that say one number and no unit, and whether they say ALWAYS."""
    for step in asked.steps:
        match step.statement:
            case SpeedStatement("SPEED", (Level(Number() as number, None),), always):
                yield step, always, number
            case _:
                pass
