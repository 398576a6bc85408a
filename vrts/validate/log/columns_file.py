"""A file that says which columns of a log hold what, for logs whose names nobody can guess.

```toml
time = "stamp [ms]"        # the name of a column, or its number from 1; a unit in brackets
joints = ["a1 [rad]", "a2 [rad]", "a3 [rad]", "a4 [rad]", "a5 [rad]", "a6 [rad]"]
position = ["px [m]", "py [m]", "pz [m]"]

[count]                    # how the robot counts its joints beside VAL
sign = [1, -1, 1, 1, 1, 1]
add_deg = [0, 90, 0, 0, 0, 0]   # VAL's angle = sign * angle + this
```
"""

import re
from difflib import get_close_matches
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.source import SourceFile, Span
from vrts.base.toml.reading import Table, read_toml
from vrts.base.units import DEG
from vrts.validate.log.log_columns import (
    AXES,
    JOINTS,
    LOG_COLUMNS,
    SPELLINGS,
    UNITS,
    Column,
    Columns,
    Role,
)
from vrts.validate.log.log_table import LogTable

COLUMNS_FILE = Rule("V896", "columns-file")

MOST_SHOWN = 12  # names of columns in a message
UNCHANGED = (1.0,) * JOINTS
_UNIT = re.compile(r"(?P<name>.*\S)\s*\[\s*(?P<unit>[^\]]*?)\s*\]")


class Named(NamedTuple):
    """A column as the file names it."""

    name: str
    unit: str | None  # a key of `UNITS`; None: the file does not say
    span: Span


class ChosenColumns(NamedTuple):
    """What the file says."""

    time: Named
    joints: tuple[Named, ...]  # six or none
    position: tuple[Named, ...]  # three or none
    sign: tuple[float, ...] = UNCHANGED
    add: tuple[float, ...] = (0.0,) * JOINTS  # to each joint [rad]


def read_columns(source: SourceFile) -> ChosenColumns | tuple[Diagnostic, ...]:
    """Return what a file says, or everything that is wrong with it."""
    top, problems = read_toml(source)
    if top is None:
        return problems.in_order()
    time = _named(top, "time", Role.TIME, top.string("time", required=True), top.value_span("time"))
    joints = _list(top, "joints", Role.JOINT, JOINTS)
    position = _list(top, "position", Role.POSITION, AXES)
    sign, add = _count(top.table("count"))
    top.finish()
    if not problems.any_error and not joints and not position:
        problems.error(
            COLUMNS_FILE,
            "the file names no joints and no position",
            top.span,
            help=('write `joints = ["…", …]` with six names, `position` with three, or both',),
        )
    if problems.any_error or time is None:
        return problems.in_order()
    return ChosenColumns(time, joints, position, sign, tuple(value * DEG for value in add))


def chosen(table: LogTable, wanted: ChosenColumns) -> Columns | Diagnostic:
    """Return the columns of a log that a file names, or the first name that no column has."""
    names = [cell.strip().lower() for cell in table.header.cells]
    asked = [
        (Role.TIME, (wanted.time,)),
        (Role.JOINT, wanted.joints),
        (Role.POSITION, wanted.position),
    ]
    found: dict[Role, list[Column]] = {role: [] for role in Role}
    for role, columns in asked:
        for number, column in enumerate(columns):
            place = _place(column.name.lower(), names)
            if place is None:
                return _missing(table, column)
            found[role].append(Column(place, role, number, column.unit))
    return Columns(found[Role.TIME][0], tuple(found[Role.JOINT]), tuple(found[Role.POSITION]), ())


def _place(name: str, names: list[str]) -> int | None:
    """Return which column is meant: by its name, or else by its number from 1."""
    if name in names:
        return names.index(name)
    if name.isdecimal() and 1 <= int(name[:6]) <= len(names):
        return int(name[:6]) - 1
    return None


def _list(top: Table, key: str, role: Role, count: int) -> tuple[Named, ...]:
    names = top.strings(key, ())
    if not names:
        return ()
    if len(names) != count:
        top.problems.error(
            COLUMNS_FILE,
            f"`{key}` names {len(names)} columns, not {count}",
            top.value_span(key),
        )
        return ()
    found = [_named(top, key, role, name, top.element_span(key, k)) for k, name in enumerate(names)]
    return tuple(column for column in found if column is not None)


def _named(top: Table, key: str, role: Role, text: str | None, span: Span) -> Named | None:
    if text is None:
        return None
    match = _UNIT.fullmatch(text.strip())
    if match is None:
        return Named(text.strip(), None, span)
    unit = SPELLINGS.get(match["unit"].lower(), match["unit"].lower())
    if unit not in UNITS[role]:
        known = ", ".join(f"`{name}`" for name in UNITS[role])
        top.problems.error(
            COLUMNS_FILE,
            f"`{match['unit'][:20]}` is no unit of `{key}`",
            span,
            help=(f"units here: {known}",),
        )
        return None
    return Named(match["name"], unit, span)


def _count(section: Table | None) -> tuple[tuple[float, ...], tuple[float, ...]]:
    if section is None:
        return UNCHANGED, (0.0,) * JOINTS
    sign = section.numbers("sign", count=JOINTS) or UNCHANGED
    add = section.numbers("add_deg", count=JOINTS) or (0.0,) * JOINTS
    section.finish()
    if any(value not in (1.0, -1.0) for value in sign):
        section.problems.error(COLUMNS_FILE, "a sign is 1 or -1", section.value_span("sign"))
    return sign, add


def _missing(table: LogTable, column: Named) -> Diagnostic:
    cells = table.header.cells
    close = get_close_matches(column.name, cells, 1, 0.6)
    more = f" and {len(cells) - MOST_SHOWN} more" if len(cells) > MOST_SHOWN else ""
    return error(
        LOG_COLUMNS,
        f"the log has no column `{column.name}`",
        Label(column.span, "named here"),
        notes=(f"its columns: {', '.join(cells[:MOST_SHOWN])}{more}",),
        help=(f"did you mean `{close[0]}`?",) if close else (),
        data={"column": column.name},
    )
