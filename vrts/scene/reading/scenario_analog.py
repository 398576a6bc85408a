"""Reads `[[analog]]` of a scenario: what analog inputs read, from which times on."""

from vrts.base.diagnostic import Label, Rule
from vrts.base.source import Span
from vrts.base.toml.reading import Table
from vrts.scene.reading.scenario_signals import (
    LATEST_S,
    MOST_CHANGES,
    MOST_ENTRIES,
    check_count,
    driven_once,
)

ANALOG_UNCLEAR = Rule("V565", "analog-input-unclear")

FIRST_CHANNEL, LAST_CHANNEL = 1, 8  # [assumed, manual language/signals#analog]
LEAST_COUNT, MOST_COUNT = -2048, 2047
Change = tuple[float, int, int]  # time [s], channel, counts


def read_analog(top: Table) -> tuple[Change, ...]:
    """Return the changes of analog inputs, by time."""
    tables = top.tables("analog")
    span = top.span_of("analog")
    few = check_count(top.problems, len(tables), MOST_ENTRIES, "analog", span)
    driven: dict[int, Span] = {}
    changes: list[Change] = []
    for table in tables if few else ():
        channel, own = _entry(table)
        if channel is not None and driven_once(table, "channel", channel, driven):
            changes += own
    what = "changes of analog inputs"
    few = check_count(top.problems, len(changes), MOST_CHANGES, what, span)
    return tuple(sorted(changes)) if few else ()


def read_channel(table: Table) -> int | None:
    """Return the number of the analog input that a table is about."""
    return table.integer("channel", minimum=FIRST_CHANNEL, maximum=LAST_CHANNEL, required=True)


def whole(table: Table, key: str, numbers: tuple[float, ...]) -> bool:
    """Return whether all numbers of a list are whole, as counts are; report the first that is not.

    Args:
        table: That holds the list.
        key: Of the list.
        numbers: In it.
    """
    for index, number in enumerate(numbers):
        if number != round(number):
            table.problems.error(
                ANALOG_UNCLEAR,
                f"an analog input cannot read {number:g}",
                table.element_span(key, index),
                "counts are whole numbers",
                help=(f"write {round(number)}",),
                data={"counts": number},
            )
            return False
    return True


def _entry(table: Table) -> tuple[int | None, list[Change]]:
    channel = read_channel(table)
    times = table.numbers("at_s", minimum=0.0, maximum=LATEST_S, required=True)
    counts = table.numbers("counts", minimum=LEAST_COUNT, maximum=MOST_COUNT, required=True)
    table.finish()
    if channel is None or times is None or counts is None or not whole(table, "counts", counts):
        return channel, []
    if len(times) != len(counts) or not times:
        many = f"{len(times)} time{'' if len(times) == 1 else 's'} and {len(counts)} of `counts`"
        table.problems.error(
            ANALOG_UNCLEAR,
            f"it is not clear what analog input {channel} reads",
            table.value_span("counts"),
            f"there are {many}",
            help=("give as many `counts` as times in `at_s`: what it reads from each on",),
            data={"times": len(times), "counts": len(counts)},
        )
        return channel, []
    known: dict[float, int] = {}
    for index, time_s in enumerate(times):
        if time_s in known:
            table.problems.error(
                ANALOG_UNCLEAR,
                f"analog input {channel} changes twice at {time_s:g} s",
                table.element_span("at_s", index),
                secondary=(Label(table.element_span("at_s", known[time_s]), "the first time"),),
                help=("leave out one of the two",),
            )
            return channel, []
        known[time_s] = index
    return channel, [(t, channel, round(n)) for t, n in zip(times, counts, strict=True)]
