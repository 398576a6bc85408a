"""Whether the numbers of a log are in the unit that its names say, as far as the run can tell.

The unit is judged by how far the arm goes: a log in radians that is taken for degrees would show an
arm that moves 57 times less than the program makes it.
"""

import math
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Label, Rule, Severity, error
from vrts.validate.log.log_columns import UNITS, Column, Role
from vrts.validate.log.log_table import LogTable, line_span

LOG_UNITS = Rule("V887", "log-units")
LOG_TAKEN_AS = Rule("V888", "log-taken-as")

Array = npt.NDArray[np.float64]

USUAL = {Role.TIME: "s", Role.JOINT: "deg", Role.POSITION: "mm"}
RIVALS = {Role.TIME: ("s", "ms"), Role.JOINT: ("deg", "rad"), Role.POSITION: ("mm", "m")}
WORDS = {Role.TIME: "time", Role.JOINT: "joints", Role.POSITION: "position"}
DOUBTFUL, CONVINCING = 8.0, 4.0  # times too far; times, when another unit explains it


class Extent(NamedTuple):
    """How far a run goes: what a log of it has to show, roughly."""

    time_s: float
    joint_rad: float  # of the joint that turns farthest
    position_m: float

    def of(self, role: Role) -> float:
        """Return the extent of what a column holds, in s, rad or m."""
        return {
            Role.TIME: self.time_s,
            Role.JOINT: self.joint_rad,
            Role.POSITION: self.position_m,
        }[role]


def in_units(
    table: LogTable, columns: tuple[Column, ...], values: Array, extent: Extent
) -> tuple[Array, list[Diagnostic]] | Diagnostic:
    """Return columns of one role in s, rad or m, with notes on units; or what is wrong with them.

    Args:
        table: The log.
        columns: Of one role.
        values: Their numbers, shape (n, columns).
        extent: Of the run.
    """
    role = columns[0].role
    told: list[Diagnostic] = []
    units = [column.unit for column in columns]
    if None in units:
        chosen = _likeliest(role, values, extent)
        units = [unit or chosen for unit in units]
        told.append(_taken(table, columns, role, chosen))
    factors = np.array([UNITS[role][unit or USUAL[role]] for unit in units])
    scaled = values * factors
    ratio = _reach(scaled) / extent.of(role) if extent.of(role) > 0.0 else 0.0
    if len(set(units)) == 1 and ratio > 0.0 and not told:
        rival = _rival(role, units[0] or USUAL[role], ratio)
        if rival is not None:
            return _wrong_unit(table, columns, values, extent, rival)
    return scaled, told


def _reach(values: Array) -> float:
    """Return how far apart the values of the column lie that goes farthest."""
    known = values[np.isfinite(values).all(axis=1)]
    return float(np.ptp(known, axis=0).max()) if len(known) else 0.0


def _likeliest(role: Role, values: Array, extent: Extent) -> str:
    reach = _reach(values)
    if reach == 0.0 or extent.of(role) == 0.0:
        return USUAL[role]
    return min(RIVALS[role], key=lambda u: abs(math.log(reach * UNITS[role][u] / extent.of(role))))


def _rival(role: Role, unit: str, ratio: float) -> str | None:
    """Return the unit that explains what the one named does not."""
    if 1.0 / DOUBTFUL < ratio < DOUBTFUL:
        return None
    for other in RIVALS[role]:
        explained = ratio * UNITS[role][other] / UNITS[role][unit]
        if other != unit and 1.0 / CONVINCING < explained < CONVINCING:
            return other
    return None


def _wrong_unit(
    table: LogTable, columns: tuple[Column, ...], values: Array, extent: Extent, rival: str
) -> Diagnostic:
    role = columns[0].role
    name = table.header.cells[columns[0].place]
    unit = columns[0].unit or USUAL[role]
    expected = extent.of(role) / UNITS[role][unit]
    return error(
        LOG_UNITS,
        f"the {WORDS[role]} in the log {'is' if role is not Role.JOINT else 'are'} not in {unit},"
        f" it seems, but in {rival}",
        Label(line_span(table.source, table.header.line), f"`{name}` says {unit}"),
        notes=(f"expected a range of about {expected:.4g} {unit}; it is {_reach(values):.4g}",),
        help=(f"write the unit into the name of the column: `… [{rival}]`",),
        data={"said": unit, "seems": rival, "range": _reach(values), "expected": expected},
    )


def _taken(table: LogTable, columns: tuple[Column, ...], role: Role, unit: str) -> Diagnostic:
    names = ", ".join(f"`{table.header.cells[c.place]}`" for c in columns if c.unit is None)
    return note(
        f"{WORDS[role]} without a unit: taken as {unit}",
        Label(line_span(table.source, table.header.line), f"{names}"[:80]),
    )


def note(headline: str, primary: Label | None = None) -> Diagnostic:
    """Return a note on how something in a log was taken."""
    return Diagnostic(LOG_TAKEN_AS, Severity.NOTE, headline, primary)
