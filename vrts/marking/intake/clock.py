"""Times that a clock on the wall tells: of which zone, and what an hour means that comes twice.

When clocks are set back an hour of the night comes twice. Where a mark depends on which of the two
is meant, nobody knows when that hand-in came.
"""

from dataclasses import replace
from datetime import datetime, tzinfo
from typing import NamedTuple

from vrts.check.task.late_rules import LateRules
from vrts.marking.intake.row import Attempt, Intake, Row
from vrts.marking.lateness import lateness

ASK_ZONE = (
    "clocks change between the times of the task, so times without a zone do not count: say which"
    " zone they are of, such as `--zone Europe/Vienna`"
)


class Readings(NamedTuple):
    """What a time may mean: the same instant twice, where there is no doubt."""

    first: datetime
    second: datetime  # before the first one: clocks were set forward, and it never was


def zone_of(rules: LateRules | None) -> tzinfo | None:
    """Return the zone of times that name none: that of the times of a task; None: these differ."""
    if rules is None:
        return None
    times = [time for time in (rules.due, rules.opens, rules.closed) if time is not None]
    return rules.due.tzinfo if len({time.utcoffset() for time in times}) == 1 else None


def settled(intake: Intake, rules: LateRules | None, zone: tzinfo | None) -> Intake:
    """Return what was found without times that may mean two instants, as far as it matters which.

    Args:
        intake: As it was found.
        rules: Of the task; None: what matters is not known, so every such time is left out.
        zone: Of the times that name none, if that is known.
    """
    found: list[Row] = []
    remarks: list[str] = []
    for row in intake.rows:
        doubtful = _doubtful(row, rules)
        if doubtful is None:
            found.append(_in_utc_offsets(row))
            continue
        remarks.append(f"`{row.identifier}`: {_words(doubtful)}")
        found.append(_without(row))
    untimed = any(row.file and row.received is None for row in intake.rows)
    ask = (ASK_ZONE,) if untimed and zone is None and rules is not None else ()
    return intake._replace(rows=tuple(found), remarks=(*ask, *intake.remarks, *remarks))


def readings(time: datetime) -> Readings:
    """Return the instants that a time on the wall may mean, each with its offset from UTC."""
    return Readings(_fixed(time.replace(fold=0)), _fixed(time.replace(fold=1)))


def _words(time: Readings) -> str:
    first, second = time
    when = f"{first:%H:%M} on {first:%Y-%m-%d}"
    if second < first:
        return f"{when} never was in that zone, so when this came is not known: is the zone right?"
    either = f"{first.isoformat()} or {second.isoformat()}"
    return f"{when} came twice, so when this came is not known: {either}"


def _doubtful(row: Row, rules: LateRules | None) -> Readings | None:
    """Return a time of a row that may mean two instants, where it matters; None: there is none."""
    times = [readings(time) for time in _times(row)]
    twice = [time for time in times if time.first != time.second]
    if not twice:
        return None
    if rules is None:
        return twice[0]
    for one in twice:
        if one.second < one.first or _costs(one.first, rules) != _costs(one.second, rules):
            return one
    if rules.is_exam and (rules.attempts is None or len(row.attempts) <= rules.attempts):
        return None
    for one in twice:  # which came first decides, too
        if any(one.first <= two.second and two.first <= one.second for two in times if two != one):
            return one
    return None


def _costs(time: datetime, rules: LateRules) -> tuple[object, ...]:
    late = lateness(rules, time)
    return late.points, late.closed


def _times(row: Row) -> list[datetime]:
    every = (row.received, *(attempt.received for attempt in row.attempts))
    return list(dict.fromkeys(time for time in every if time is not None))


def _without(row: Row) -> Row:
    """Return a row without the times that may mean two instants."""
    attempts = tuple(Attempt(one.file, _sure(one.received)) for one in row.attempts)
    return replace(row, received=_sure(row.received), attempts=attempts)


def _sure(time: datetime | None) -> datetime | None:
    if time is None:
        return None
    found = readings(time)
    return found.first if found.first == found.second else None


def _in_utc_offsets(row: Row) -> Row:
    attempts = tuple(
        Attempt(one.file, None if one.received is None else readings(one.received).first)
        for one in row.attempts
    )
    received = None if row.received is None else readings(row.received).first
    return replace(row, received=received, attempts=attempts)


def _fixed(time: datetime) -> datetime:
    """Return the same time with an offset from UTC that does not depend on the day."""
    return datetime.fromisoformat(time.isoformat())
