"""When a shared robot can be booked: slots of a length, on some days, by the clock of the course.

Each slot is an instant and lasts as long as it says, also on the days on which clocks are changed:
a day has fewer or more of them then.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, datetime, time, timedelta
from typing import Final, NamedTuple
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table

DAYS: Final = ("mon", "tue", "wed", "thu", "fri", "sat", "sun")
MOST: Final = 2000  # slots that are shown
_HOURS: Final = re.compile(r"([01]\d|2[0-3]):([0-5]\d)-([01]\d|2[0-4]):([0-5]\d)\Z")


class Slot(NamedTuple):
    """Somebody's time, or nobody's yet."""

    starts: float  # Unix time [s]
    ends: float


@dataclass(frozen=True, slots=True)
class SlotRules:
    """When one room can be booked."""

    room: str  # name
    zone: str  # such as Europe/Berlin
    minutes: int = 30
    days: tuple[int, ...] = (0, 1, 2, 3, 4)  # Monday is 0
    begins: int = 8 * 60  # minutes after midnight
    ends: int = 18 * 60
    ahead: int = 2  # slots that one may have before one
    weeks: int = 2  # how far ahead one may book

    def of_day(self, day: date) -> Iterator[Slot]:
        """Return the slots of a day, in order."""
        if day.weekday() not in self.days:
            return
        starts, end = self._instant(day, self.begins), self._instant(day, self.ends)
        length_s = 60.0 * self.minutes
        while starts + length_s <= end:
            yield Slot(starts, starts + length_s)
            starts += length_s

    def coming(self, now: float) -> list[Slot]:
        """Return the slots that can be booked, the one that goes on now too; `now` is Unix time."""
        zone = ZoneInfo(self.zone)
        today = datetime.fromtimestamp(now, zone).date()
        until = now + self.weeks * 7 * 86_400.0
        days = (today + timedelta(days=number) for number in range(-1, 7 * self.weeks + 1))
        found = [slot for day in days for slot in self.of_day(day)]
        return [slot for slot in found if now < slot.ends and slot.starts < until][:MOST]

    def _instant(self, day: date, minutes: int) -> float:
        """Return when it is so late on a day [Unix time, s]; in a gap of the clock, after it."""
        day, minutes = day + timedelta(days=minutes // 1440), minutes % 1440
        local = datetime.combine(day, time(minutes // 60, minutes % 60), ZoneInfo(self.zone))
        return local.timestamp()


def read_slots(
    top: Table, problems: Problems, rule: Rule, rooms: tuple[str, ...]
) -> SlotRules | None:
    """Return what `[slots]` says; None: there are none, or it has errors."""
    table = top.table("slots")
    if table is None:
        return None
    room = table.string("room", rooms[0] if rooms else "")
    zone = table.string("time_zone", required=True)
    minutes = table.integer("minutes", 30, minimum=5, maximum=1440)
    days = table.strings("days") or DAYS[:5]
    hours = table.string("hours", "08:00-18:00")
    ahead = table.integer("ahead", 2, minimum=1, maximum=100)
    weeks = table.integer("weeks", 2, minimum=1, maximum=8)
    table.finish()

    def wrong(key: str, text: str, *help_: str) -> None:
        problems.error(rule, text, table.value_span(key), help=help_)

    if room not in rooms:
        wrong("room", f"there is no room `{room}`", f"rooms of this course: {', '.join(rooms)}")
    unknown = [day for day in days if day not in DAYS]
    if unknown:
        wrong("days", f"`{unknown[0]}` is no day", f"days: {', '.join(DAYS)}")
    known = _HOURS.match(hours)
    numbers = (0, 0, 0, 0) if known is None else tuple(int(part) for part in known.groups())
    begins, ends = 60 * numbers[0] + numbers[1], 60 * numbers[2] + numbers[3]
    if known is None or ends > 1440:
        wrong("hours", f"`{hours}` is no span of hours", 'write it as `"08:00-18:00"`')
    elif ends - begins < minutes:
        wrong("hours", f"no slot of {minutes} minutes fits into `{hours}`")
    if zone is None:
        return None
    if not _known(zone):
        wrong("time_zone", f"there is no time zone `{zone}`", "such as `Europe/Berlin`")
    numbered = tuple(DAYS.index(day) for day in days if day in DAYS)
    return SlotRules(room, zone, minutes, numbered, begins, ends, ahead, weeks)


def _known(zone: str) -> bool:
    try:
        ZoneInfo(zone)
    except (ZoneInfoNotFoundError, ValueError, OSError):  # such as a path
        return False
    return True
