"""Names of folders of hand-ins: of people and of times, as marking reads them again."""

import hashlib
import re
from datetime import UTC, datetime, tzinfo
from typing import Final

from vrts.base.safe_names import safe
from vrts.course.facts import Facts
from vrts.marking.row import Row

PROGRAM: Final = "program.v2"
LONGEST: Final = 100  # characters of a person's folder
_FORM: Final = "%Y-%m-%d-%H-%M-%S"
_PLAIN: Final = re.compile(r"[\w+-][\w.+-]*(@[\w-][\w.-]*)?", re.ASCII)


def folder_of(key: str, email: str) -> str:
    """Return the name of a person's folder: the e-mail address, or what else the lists call them.

    Two people never have the same one: what cannot stand in a name is told apart by a digest.
    """
    called = (email or key.replace(" ", "-", 1)).casefold()  # "canvas 4711" has a blank
    if _PLAIN.fullmatch(called) and len(called) <= LONGEST and not called.endswith("."):
        return called
    return f"{safe(called)[:60]}-{hashlib.sha256(called.encode()).hexdigest()[:8]}"


def folder_in(row: Row) -> str:
    """Return the folder of whose a row of a marking is: of the hand-in, else as it is made."""
    first = row.handed_in.file.split("/")[0] if "/" in row.handed_in.file else ""
    student = row.student
    number = next(iter(student.ids.values()), "")
    named = folder_of(f"id {number}" if number else row.id, student.email)
    return first if first and first not in (".", "..") and "\\" not in first else named


def page_of(digest: str, variant: str) -> str:
    """Return the name of the page about a program: marked by another variant it has another one."""
    return f"{digest}-{variant}.html" if variant else f"{digest}.html"


def zone_of(facts: Facts) -> tzinfo:
    """Return the zone in which folders tell times: that of the deadline, as marking takes it."""
    return (facts.due.tzinfo if facts.due is not None else None) or UTC


def stamp_of(at: float, zone: tzinfo) -> str:
    """Return the name of the folder of an attempt; `at` is Unix time, in whole seconds."""
    return datetime.fromtimestamp(at, zone).strftime(_FORM)


def time_of(stamp: str, zone: tzinfo) -> float | None:
    """Return the Unix time that a folder tells; None: it is none of an attempt."""
    try:
        return datetime.strptime(stamp, _FORM).replace(tzinfo=zone).timestamp()
    except ValueError:
        return None
