"""What is surely a slip, whether it earns anything alone or not: to look for a second beside it."""

from collections.abc import Iterator
from statistics import median_high

from vrts.lang.syntax.statements import SpeedStatement
from vrts.repair.edit import Candidate, Does
from vrts.repair.table.asked import Asked, written_number
from vrts.repair.table.numbers import numbers_of, value_of
from vrts.repair.table.rows import as_taught

CRAWLS = 5.0  # per cent: nobody means a speed below it
USUAL = 30.0  # per cent: a speed, where the program has no other


def surely(asked: Asked) -> Iterator[Candidate]:
    """Yield locations as the scene says that differ by a slip, and speeds that crawl as others."""
    yield from as_taught(asked)
    speeds = [step for step in asked.steps if isinstance(step.statement, SpeedStatement)]
    for step in speeds:
        said = [value_of(item) for item, _ in numbers_of(step.statement)]
        for item, _ in numbers_of(step.statement):
            if len(said) != 1 or said[0] >= CRAWLS or "PS" in step.text.upper().split()[-1]:
                continue
            others = [
                value_of(other)
                for each in speeds
                if step.text.upper().endswith("ALWAYS") == each.text.upper().endswith("ALWAYS")
                for other, _ in numbers_of(each.statement)
                if value_of(other) >= CRAWLS
            ]
            text = written_number(median_high(others) if others else USUAL)
            yield asked.instead(Does.NUMBER, step.line, item, text)
