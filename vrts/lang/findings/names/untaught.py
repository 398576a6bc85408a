"""Locations that nothing gives a value: one message for all of a file that teaches none.

Programs of students often leave their locations to the scene, or to the controller's memory; a
message for each would bury what is wrong.
"""

import re
from collections.abc import Sequence

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.lang.meaning.scope import Entry
from vrts.lang.problems import Problems

UNDEFINED_LOCATION = Rule("V204", "undefined-location")
TEACH = "give it a value in a .LOCATIONS section, or by SET or HERE"

_TEACH_ALL = "give them values in a .LOCATIONS section, or by SET or HERE"
_SECTION = re.compile(r"^[ \t]*\.LOC", re.IGNORECASE | re.MULTILINE)
_MOST = 8  # names that are told
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


def report_untaught(problems: Problems, entries: list[Entry]) -> None:
    """Report locations of which nothing better is known, together if the file teaches none."""
    found = sorted(entries, key=lambda entry: min(entry.reads))
    if not found:
        return
    if len(found) == 1 or _SECTION.search(problems.source.text):
        for entry in found:
            _one(problems, entry)
        return
    names = tuple(entry.name for entry in found)
    problems.warning(
        UNDEFINED_LOCATION,
        told_of(names),
        *min(found[0].reads),
        notes=(_NOT_GIVEN_ALL,),
        help=(_TEACH_ALL,),
        data={"name": names[0], "names": names},
    )


def _one(problems: Problems, entry: Entry) -> None:
    more = len(entry.reads) - 1
    problems.warning(
        UNDEFINED_LOCATION,
        told_of((entry.name,)),
        *min(entry.reads),
        notes=(
            *((f"used {more} more {'time' if more == 1 else 'times'}",) if more else ()),
            NOT_GIVEN,
        ),
        help=(TEACH,),
        data={"name": entry.name},
    )


def names_of(diagnostic: Diagnostic) -> tuple[str, ...]:
    """Return the names that a diagnostic is about; none where it is about no name."""
    names = diagnostic.data.get("names")
    if isinstance(names, tuple):
        return tuple(name for name in names if isinstance(name, str))
    name = diagnostic.data.get("name")
    return (name,) if isinstance(name, str) else ()
