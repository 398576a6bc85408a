"""Times as Moodle writes them in some languages: "Tuesday, 21 October 2025, 3:45 PM"."""

import re
from datetime import datetime, tzinfo

_MONTHS = (  # how their names begin in English, German, French, Spanish, Italian, Dutch, Portuguese
    ("jan", "jän", "ene", "gen"),
    ("feb", "fév", "fev"),
    ("mar", "mär", "maa"),
    ("apr", "avr", "abr"),
    ("may", "mai", "mag", "mei"),
    ("jun", "juin", "giu"),
    ("jul", "juil", "lug"),
    ("aug", "aoû", "ago"),
    ("sep", "set"),
    ("oct", "okt", "ott", "out"),
    ("nov",),
    ("dec", "dez", "déc", "dic"),
)
_CLOCK = r",? (?:\D{1,4} )?(?P<hour>\d{1,2})[:.](?P<minute>\d\d)(?:\s?(?P<half>[AaPp])\.?[Mm])?"
_FORMS = tuple(
    re.compile(date + _CLOCK)
    for date in (
        r"(?P<day>\d{1,2})\.? (?:de )?(?P<month>[^\W\d_]{3,})\.? (?:de )?(?P<year>\d{4})",
        r"(?P<month>[^\W\d_]{3,}) (?P<day>\d{1,2}), (?P<year>\d{4})",
    )
)


def local_time(text: str, zone: tzinfo) -> datetime | None:
    """Return the time a text tells, to the minute; None where it is not understood.

    Args:
        text: As in a table of Moodle.
        zone: In which the platform shows its times.
    """
    plain = " ".join(text.replace("\u202f", " ").split())
    for form in _FORMS:
        found = form.search(plain)
        month = 0 if found is None else _month(found["month"])
        if found is None or not month:
            continue
        hour = int(found["hour"])
        if found["half"]:
            hour = hour % 12 + (12 if found["half"] in "Pp" else 0)
        try:
            return datetime(
                int(found["year"]),
                month,
                int(found["day"]),
                hour,
                int(found["minute"]),
                tzinfo=zone,
            )
        except ValueError:
            return None
    return None


def _month(name: str) -> int:
    """Return the number of a month, 0 for no month."""
    lower = name.casefold()
    fitting = [
        (len(start), number)
        for number, starts in enumerate(_MONTHS, 1)
        for start in starts
        if lower.startswith(start)
    ]
    return max(fitting)[1] if fitting else 0
