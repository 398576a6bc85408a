"""How much of what would mend a program its author may be told."""

from dataclasses import replace
from enum import IntEnum

from vrts.base.diagnostic import Diagnostic
from vrts.base.toml.reading import Table


class Hints(IntEnum):
    """What may be told, from least to most: each tells what the ones before it tell, too."""

    NOTHING = 0
    PLACE = 1  # the line
    DIRECTION = 2  # "too low"
    NUMBER = 3  # the number, and the range that would do
    EDIT = 4  # the whole change


LEVELS = {level.name.lower(): level for level in Hints}


def read_hints(top: Table) -> Hints:
    """Return what the section `[hints]` of a task allows; without one everything may be told."""
    section = top.table("hints")
    if section is None:
        return Hints.EDIT
    said = section.string("level", required=True, choices=LEVELS)
    section.finish()
    return LEVELS.get(said or "", Hints.NOTHING)


def without_remedy(d: Diagnostic) -> Diagnostic:
    """Return a diagnostic that tells what is wrong, and nothing of what would mend it."""
    return d if not d.help and d.fix is None else replace(d, help=(), fix=None)
