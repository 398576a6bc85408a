"""Where a camera looked when: pan, tilt and zoom from a log."""

import re
from typing import NamedTuple

import numpy as np

from vrts.base.diagnostic import Diagnostic, Label, Rule, error
from vrts.base.units import DEG
from vrts.validate.camera.model import Array, View
from vrts.validate.log.log_table import LogTable, line_span, numbers, read_table

VIEW_COLUMNS = Rule("V903", "view-columns")

_NAMES = {
    "time": re.compile(r"t|time(?:[_ ]?s)?|time[ _]?stamp|seconds", re.IGNORECASE),
    "pan": re.compile(r"pan(?:[_ (\[]*deg[)\]]?)?", re.IGNORECASE),
    "tilt": re.compile(r"tilt(?:[_ (\[]*deg[)\]]?)?", re.IGNORECASE),
    "zoom": re.compile(r"zoom", re.IGNORECASE),
}
_OTHERWISE = {"pan": 0.0, "tilt": 0.0, "zoom": 1.0}


class Views(NamedTuple):
    """Where the camera looked, at times in order."""

    times: Array  # (n,) [s]
    rows: Array  # (n, 3) pan [rad], tilt [rad], zoom

    def at(self, time_s: float) -> View:
        """Return the view at a time, between two rows in proportion."""
        pan, tilt, zoom = (np.interp([time_s], self.times, self.rows[:, k])[0] for k in range(3))
        return View(float(pan), float(tilt), float(zoom))


STILL = Views(np.zeros(1), np.array([[0.0, 0.0, 1.0]]))


def read_views(data: bytes, name: str) -> Views | Diagnostic:
    """Return the views of a log with columns `time_s`, `pan_deg`, `tilt_deg` and `zoom`.

    Args:
        data: The bytes of the log.
        name: As shown.
    """
    table = read_table(data, name)
    if isinstance(table, Diagnostic):
        return table
    found: dict[str, Array] = {}
    for wanted, pattern in _NAMES.items():
        column = next(
            (k for k, cell in enumerate(table.header.cells) if pattern.fullmatch(cell)), None
        )
        if column is None:
            if wanted == "time":
                return _columns(table, "no column says the time")
            found[wanted] = np.full(len(table.rows), _OTHERWISE[wanted])
            continue
        values = numbers(table, column)
        if isinstance(values, Diagnostic):
            return values
        found[wanted] = values
    times = found["time"]
    rows = np.stack([found["pan"] * DEG, found["tilt"] * DEG, found["zoom"]], axis=1)
    known = np.isfinite(times) & np.isfinite(rows).all(axis=1)
    times, rows = times[known], rows[known]
    if not len(times) or (np.diff(times) <= 0).any():
        return _columns(table, "times do not grow from row to row")
    if (rows[:, 2] <= 0).any():
        return _columns(table, "a zoom is not more than 0")
    return Views(times, rows)


def _columns(table: LogTable, came: str) -> Diagnostic:
    return error(
        VIEW_COLUMNS,
        f"`{table.source.name}` does not say where the camera looked",
        Label(line_span(table.source, table.header.line), came),
        notes=(
            "expected columns `time_s`, and of `pan_deg`, `tilt_deg`, `zoom` those that change",
        ),
        help=("name the columns so in the first line; times grow from row to row",),
    )
