"""Locations that nothing gives a value: a note for all of a file without a section of locations.

Programs are often written for locations that a scene or the controller's memory holds: in a file
without .LOCATIONS nothing is wrong. Where it has some, those that are left out are a warning each.
"""

import re
from collections.abc import Sequence

from vrts.base.diagnostic import Diagnostic, Rule, Severity
from vrts.lang.meaning.scope import Entry
from vrts.lang.problems import Problems
from vrts.lang.spelling import edit_distance, nearest

UNDEFINED_LOCATION = Rule("V204", "undefined-location")
TEACH = "give it a value in a .LOCATIONS section, or by SET or HERE"

_TEACH_ALL = "give them values in a .LOCATIONS section, or by SET or HERE"
_SECTION = re.compile(r"^[ \t]*\.LOC", re.IGNORECASE | re.MULTILINE)
_MOST = 8  # names that are told
_VERY_LONG = 9  # letters of names in which two slips are likely
_LONG = 5  # letters of a name that may be a slip for another
NOT_GIVEN = "the controller stops here with *Undefined value* unless it has one from before"
_NOT_GIVEN_ALL = "the controller stops there with *Undefined value* unless it has them from before"


def told_of(names: Sequence[str]) -> str:
    """Return what is told of locations without values."""
    if len(names) == 1:
        return f"the location `{names[0]}` is never given a value in this file"
    quoted = [f"`{name}`" for name in names]
    more = len(quoted) - _MOST
    last = f"{more} more" if more > 0 else quoted[-1]
    shown = quoted[:_MOST] if more > 0 else quoted[:-1]
    return f"the locations {', '.join(shown)} and {last} are never given values in this file"


def teaches(problems: Problems) -> bool:
    """Return whether a file has a section of locations."""
    return _SECTION.search(problems.source.text) is not None


def report_untaught(problems: Problems, entries: list[Entry]) -> None:
    """Report locations of which nothing better is known, together if the file teaches none."""
    found = sorted(entries, key=lambda entry: min(entry.reads))
    for slip, meant in _slips(found):
        _one(problems, slip, meant)
        found.remove(slip)
    if not found:
        return
    if teaches(problems):
        for entry in found:
            _one(problems, entry)
        return
    names = tuple(entry.name for entry in found)
    one = len(names) == 1
    problems.error(
        UNDEFINED_LOCATION,
        told_of(names),
        *min(found[0].reads),
        notes=(NOT_GIVEN if one else _NOT_GIVEN_ALL,),
        help=(TEACH if one else _TEACH_ALL,),
        data={"name": names[0], "names": names},
        severity=Severity.NOTE,
    )


def _slips(entries: list[Entry]) -> list[tuple[Entry, str]]:
    """Return the names that are used once and hardly differ from one that is used more often."""
    often = [entry.name for entry in entries if len(set(entry.reads)) > 1]
    found: list[tuple[Entry, str]] = []
    for entry in entries:
        if len(set(entry.reads)) > 1 or len(entry.name) < _LONG:
            continue
        meant = nearest(entry.name, often)
        if meant is not None and _is_slip(meant, entry.name) and not _counts(meant, entry.name):
            found.append((entry, meant))
    return found


def _is_slip(a: str, b: str) -> bool:
    """Return whether one slip parts two names, or two in long ones: `feature` is no `fixture`."""
    slips = 2 if min(len(a), len(b)) >= _VERY_LONG else 1
    return edit_distance(a, b, slips) <= slips or sorted(a) == sorted(b)


def _counts(a: str, b: str) -> bool:
    """Return whether two names are of two places: `p1` and `p2`, `rack_a` and `rack_b`."""
    without = [re.sub(r"\d+", "", name) for name in (a, b)]
    return without[0] == without[1] or without[0][:-1] == without[1][:-1]


def _one(problems: Problems, entry: Entry, meant: str | None = None) -> None:
    more = len(entry.reads) - 1
    at = min(entry.reads)
    problems.warning(
        UNDEFINED_LOCATION,
        told_of((entry.name,)),
        *at,
        notes=(
            *((f"used {more} more {'time' if more == 1 else 'times'}",) if more else ()),
            NOT_GIVEN,
        ),
        help=(f"did you mean `{meant}`?" if meant else TEACH,),
        fix=problems.replace(*at, meant, sure=False) if meant else None,
        data={"name": entry.name},
    )


def names_of(diagnostic: Diagnostic) -> tuple[str, ...]:
    """Return the names that a diagnostic is about; none where it is about no name."""
    names = diagnostic.data.get("names")
    if isinstance(names, tuple):
        return tuple(name for name in names if isinstance(name, str))
    name = diagnostic.data.get("name")
    return (name,) if isinstance(name, str) else ()
