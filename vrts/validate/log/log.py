"""A log of a real robot: where its joints and its tool were, and when."""

import hashlib
from dataclasses import dataclass
from typing import NamedTuple, TypeVar

import numpy as np
import numpy.typing as npt

from vrts.base.diagnostic import Diagnostic, Label, Rule, error, warning
from vrts.pipeline.refused import Refused
from vrts.validate.log.columns_file import ChosenColumns, chosen
from vrts.validate.log.log_columns import Column, Columns, find_columns
from vrts.validate.log.log_formats import table_of
from vrts.validate.log.log_table import LogTable, line_span, numbers
from vrts.validate.log.log_units import Extent, in_units, note

LOG_TIME = Rule("V885", "log-time")
LOG_GAP = Rule("V886", "log-gap")

Array = npt.NDArray[np.float64]
Value = TypeVar("Value")

GAP_STEPS, GAP_S = 5.0, 0.1  # a gap is this many usual steps, and this long [s]
MOST_GAPS = 3  # that are told one by one
FEWEST = 10  # rows
MOSTLY = 0.5  # of the time of a run
SYNTHETIC = "synthetic"  # in a comment: not of a real robot


@dataclass(frozen=True, slots=True)
class RobotLog:
    """What was logged, in s, rad and m; NaN where a value is missing."""

    name: str
    sha256: str
    times: Array  # shape (n,), increasing, by the log's own clock [s]
    joints: Array | None  # shape (n, 6) [rad]
    positions: Array | None  # of the tool in W, shape (n, 3) [m]
    synthetic: bool  # it says so
    findings: tuple[Diagnostic, ...]  # warnings and notes

    @property
    def step_s(self) -> float:
        """The usual time between two rows [s]."""
        return float(np.median(np.diff(self.times)))


class GivenLog(NamedTuple):
    """A log as it was given."""

    name: str  # as shown
    files: tuple[bytes, ...]  # one, or those of a bag
    columns: ChosenColumns | None = None  # which of its columns hold what; None: by their names


def read_log(given: GivenLog, extent: Extent) -> RobotLog:
    """Return a log.

    Args:
        given: Its bytes.
        extent: How far the run goes that the log is to be compared with.

    Raises:
        Refused: It cannot be read; the diagnostics say what was expected and what came.
    """
    table, columns = _table(given)
    told = list(columns.findings)
    if table.decimal_comma:
        told.append(note("commas taken as decimal signs"))
    times = _values(table, (columns.time,), extent, told)[:, 0]
    kept = _kept(table, columns, times, told)
    if times[kept[-1]] - times[kept[0]] < MOSTLY * extent.time_s:
        extent = Extent(extent.time_s, 0.0, 0.0)  # a part of the motion tells nothing of units
    joints = _values(table, columns.joints, extent, told) if columns.joints else None
    if joints is not None and given.columns is not None:
        joints = joints * np.array(given.columns.sign) + np.array(given.columns.add)
    positions = _values(table, columns.position, extent, told) if columns.position else None
    times, joints, positions = (
        times[kept],
        None if joints is None else joints[kept],
        None if positions is None else positions[kept],
    )
    told += _missing(joints, positions)
    told += _gaps(times)
    digest = hashlib.sha256(b"".join(given.files)).hexdigest()
    synthetic = any(SYNTHETIC in words.lower() for words in table.comments)
    return RobotLog(given.name, digest, times, joints, positions, synthetic, tuple(told))


def _table(given: GivenLog) -> tuple[LogTable, Columns]:
    numbered = given.columns is not None
    table = _accepted(table_of(given.files, given.name, numbered=numbered))
    if given.columns is not None:
        return table, _accepted(chosen(table, given.columns))
    return table, _accepted(find_columns(table))


def _accepted(found: "Value | Diagnostic") -> "Value":
    if isinstance(found, Diagnostic):
        raise Refused((found,))
    return found


def _values(
    table: LogTable, columns: tuple[Column, ...], extent: Extent, told: list[Diagnostic]
) -> Array:
    parts = [_accepted(numbers(table, column.place)) for column in columns]
    found = in_units(table, columns, np.column_stack(parts), extent)
    if isinstance(found, Diagnostic):
        raise Refused((found,))
    told += found[1]
    return found[0]


def _kept(
    table: LogTable, columns: Columns, times: Array, told: list[Diagnostic]
) -> npt.NDArray[np.intp]:
    """Return the rows with a time later than that of the row before."""
    kept = np.flatnonzero(np.isfinite(times))
    steps = np.diff(times[kept])
    back = np.flatnonzero(steps < 0.0)
    if len(back):
        row = table.rows[int(kept[back[0] + 1])]
        raise Refused(
            (
                error(
                    LOG_TIME,
                    "the time in the log goes backward",
                    Label(
                        line_span(table.source, row.line),
                        f"{times[kept[back[0] + 1]]:.6g} s after {times[kept[back[0]]]:.6g} s",
                    ),
                    notes=("expected time stamps that grow from row to row",),
                    help=("cut the log where its clock was set, and compare the parts",),
                    data={"line": row.line},
                ),
            )
        )
    repeated = int((steps == 0.0).sum())
    if repeated:
        told.append(note(f"{repeated} rows with the time stamp of the row before: left out"))
        kept = kept[np.concatenate([[True], steps > 0.0])]
    if len(kept) < FEWEST:
        raise Refused(
            (
                error(
                    LOG_TIME,
                    f"the log has {len(kept)} rows with a time",
                    Label(line_span(table.source, table.header.line)),
                    notes=(f"expected at least {FEWEST} rows with time stamps that grow",),
                    data={"column": table.header.cells[columns.time.place]},
                ),
            )
        )
    return kept


def _missing(joints: Array | None, positions: Array | None) -> list[Diagnostic]:
    told: list[Diagnostic] = []
    for values, words in ((joints, "joints"), (positions, "positions of the tool")):
        if values is None:
            continue
        lost = int((~np.isfinite(values)).any(axis=1).sum())
        if lost:
            told.append(note(f"{words} are incomplete in {lost} of {len(values)} rows: left out"))
    return told


def _gaps(times: Array) -> list[Diagnostic]:
    steps = np.diff(times)
    usual = float(np.median(steps))
    wide = np.flatnonzero(steps > max(GAP_STEPS * usual, GAP_S))
    if not len(wide):
        return []
    places = [f"{times[k]:.3f} to {times[k + 1]:.3f} s" for k in wide[:MOST_GAPS]]
    more = f" and {len(wide) - MOST_GAPS} more" if len(wide) > MOST_GAPS else ""
    return [
        warning(
            LOG_GAP,
            f"the log has {len(wide)} gap{'s' if len(wide) > 1 else ''}",
            notes=(
                f"expected a row every {1e3 * usual:.3g} ms; none from {', '.join(places)}{more}",
                "nothing is made up in a gap: what the arm did there is not compared",
            ),
            data={"gaps": len(wide), "longest_s": float(steps.max())},
        )
    ]
