"""What may be kept of a class when everything about persons is deleted."""

from collections import Counter
from typing import Annotated, Literal

import msgspec
from msgspec import Meta

from vrts.marking.about import About
from vrts.marking.result import Kind, Mark, Record
from vrts.marking.row import Class

NAME = "statistics.json"


class CheckCounts(Record, frozen=True):
    """How often one check had which answer."""

    id: str
    title: str
    answers: Annotated[dict[str, int], Meta(description="students, by answer")]


class Statistics(Record, frozen=True):
    """Marks without students: sorted, so that their order tells nothing."""

    schema: Literal["vrts.statistics/1"]
    title: str
    task: str
    day: Annotated[str, Meta(description="of the marking; ISO 8601")]
    vrts: str
    students: int
    marks: Annotated[tuple[Mark, ...], Meta(description="final marks, sorted")]
    kinds: Annotated[dict[str, int], Meta(description="students, by what became of their work")]
    checks: tuple[CheckCounts, ...]


def statistics_of(rows: Class, about: About) -> Statistics:
    """Return the statistics of a class."""
    results = [row.result for row in rows.rows]
    kinds = Counter(result.kind for result in results)
    titles: dict[str, str] = {}
    answers: dict[str, Counter[str]] = {}
    for result in results:
        for check in result.checks:
            titles.setdefault(check.id, check.title)
            answers.setdefault(check.id, Counter())[check.answer] += 1
    return Statistics(
        "vrts.statistics/1",
        rows.title,
        results[0].task.name if results else "",
        about.when.date().isoformat(),
        about.vrts,
        len(results),
        tuple(sorted(row.final for row in rows.rows if row.final is not None)),
        {kind.value: kinds[kind] for kind in Kind if kinds[kind]},
        tuple(
            CheckCounts(name, titles[name], dict(sorted(counts.items())))
            for name, counts in answers.items()
        ),
    )


def to_bytes(statistics: Statistics) -> bytes:
    """Return statistics as JSON, laid out for people."""
    return msgspec.json.format(msgspec.json.encode(statistics), indent=1) + b"\n"
