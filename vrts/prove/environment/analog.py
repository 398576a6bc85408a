"""Reads `[[analog]]` of an environment: what analog inputs may read, in every tick anew."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from vrts.base.source import Span
from vrts.base.toml.reading import Table
from vrts.ir.ranges import LEAST_COUNT, MOST_COUNT
from vrts.prove.environment.environment import Counts
from vrts.scene.reading.scenario_analog import (
    ANALOG_UNCLEAR,
    read_channel,
    whole,
)
from vrts.scene.reading.scenario_signals import driven_once


def read_counts(tables: Iterable[Table]) -> Mapping[int, Counts]:
    """Return what analog inputs may read, by channel."""
    found: dict[int, Counts] = {}
    driven: dict[int, Span] = {}
    for table in tables:
        channel = read_channel(table)
        counts = _counts(table)
        if (
            channel is not None
            and driven_once(table, "channel", channel, driven)
            and counts is not None
        ):
            found[channel] = counts
    return MappingProxyType(found)


def _counts(table: Table) -> Counts | None:
    ends = table.numbers("range", count=2, minimum=LEAST_COUNT, maximum=MOST_COUNT)
    values = table.numbers("counts", minimum=LEAST_COUNT, maximum=MOST_COUNT)
    both_or_none = ("range" in table) is ("counts" in table)
    table.finish()
    if both_or_none or values == () or (ends is not None and ends[0] > ends[1]):
        table.problems.error(
            ANALOG_UNCLEAR,
            "it is not clear what an analog input may read",
            table.span,
            help=("give either `range = [0, 2047]` or `counts = [0, 350]`",),
        )
        return None
    if ends is not None and whole(table, "range", ends):
        return Counts(round(ends[0]), round(ends[1]))
    if values is not None and whole(table, "counts", values):
        listed = tuple(sorted({round(value) for value in values}))
        return Counts(listed[0], listed[-1], listed)
    return None
