"""A comparison as text for a terminal."""

from collections.abc import Sequence

import numpy as np

from vrts.base.units import DEG, MM
from vrts.report.plain import one_line
from vrts.validate.comparison import Comparison
from vrts.validate.errors import Errors, Measures, along_and_across, lengths, measures
from vrts.validate.offsets import Offsets

AXES = ("X", "Y", "Z")
SYNTHETIC = "synthetic: this log was made by a computer, it is not of a real robot"


def comparison_text(c: Comparison) -> str:
    """Return everything that was found, tables of errors first."""
    rows = [f"{one_line(c.log.name)} beside the run: {len(c.after.times):,} samples"]
    if c.log.synthetic:
        rows.append(SYNTHETIC)
    rows += ["", *_path_table(c)]
    if c.after.joints is not None:
        rows += ["", *_joint_table(c)]
    rows += ["", "offsets of the real robot", *offset_lines(c)]
    rows += ["", *_timing_table(c)]
    return "\n".join(rows)


def path_rows(c: Comparison, errors: Errors) -> list[tuple[str, Measures]]:
    """Return what the path errors come to, in mm and mm²: X, Y, Z, their length, along, beside."""
    rows = [(axis, measures(errors.path[:, k] / MM)) for k, axis in enumerate(AXES)]
    along, across = along_and_across(c.run, errors)
    return [
        *rows,
        ("length", measures(lengths(errors) / MM)),
        ("along the path", measures(along / MM)),
        ("beside the path", measures(across / MM)),
    ]


def joint_rows(errors: Errors) -> list[tuple[str, Measures]]:
    """Return what the joint errors come to, in degrees and their square."""
    assert errors.joints is not None
    return [(f"JT{k + 1}", measures(errors.joints[:, k] / DEG)) for k in range(6)]


def offset_lines(c: Comparison) -> list[str]:
    """Return the offsets in words, each with one standard deviation."""
    o: Offsets = c.offsets
    lines: list[str] = []
    if c.wanted.time:
        lines.append(f"  clock  {_signed(o.time_s, 5)} s  ± {o.sigma[0]:.5f}")
    else:
        lines.append(f"  clock  {_signed(o.time_s, 5)} s, not fitted")
    if c.wanted.base and c.log.positions is not None:
        lines.append(f"  base   X Y Z {_three(o.base_m, MM, 3)} mm  ± {_three_plain(o, 1, MM, 3)}")
        lines.append(
            f"         turn about X Y Z {_three(o.base_rad, DEG, 4)} deg"
            f"  ± {_three_plain(o, 4, DEG, 4)}"
        )
    if c.wanted.tool and c.log.positions is not None:
        lines.append(f"  tool   X Y Z {_three(o.tool_m, MM, 3)} mm  ± {_three_plain(o, 7, MM, 3)}")
    return lines


def _path_table(c: Comparison) -> list[str]:
    source = "worked out from the joints" if c.after.from_joints else "as logged"
    rows = [f"path error of the tool, {source}; before and after the fit"]
    rows.append(f"  {'':16}{'mean square [mm²]':>23}{'RMS [mm]':>20}{'maximum [mm]':>20}")
    pairs = zip(path_rows(c, c.before), path_rows(c, c.after), strict=True)
    for (name, a), (_, b) in pairs:
        rows.append(
            f"  {name:16}{a.mean_square:12.3f} {b.mean_square:10.3f}"
            f" {a.rms:10.3f} {b.rms:8.3f} {a.largest:10.3f} {b.largest:8.3f}"
        )
    return rows


def _joint_table(c: Comparison) -> list[str]:
    rows = ["joint errors; before and after the fit"]
    rows.append(f"  {'':16}{'RMS [deg]':>21}{'maximum [deg]':>19}")
    for (name, a), (_, b) in zip(joint_rows(c.before), joint_rows(c.after), strict=True):
        rows.append(f"  {name:16}{a.rms:12.4f}{b.rms:9.4f}{a.largest:10.4f}{b.largest:9.4f}")
    return rows


def _timing_table(c: Comparison) -> list[str]:
    rows = ["lateness of the real arm after the fit [ms], at 10 %, 50 % and 90 % of each motion"]
    for t in c.timings:
        late = "".join(f"{late_words(value):>9}" for value in t.late)
        rows.append(f"{late}   line {t.line}  {one_line(t.words)[:50]}")
    known = [v for t in c.timings for v in t.late if v is not None]
    if known:
        spread = measures(np.array(known) * 1e3)
        rows.append(f"  RMS {spread.rms:.1f} ms, maximum {spread.largest:.1f} ms")
    return rows


def late_words(value: float | None) -> str:
    """Return a lateness in milliseconds; a dot where there is none."""
    return "·" if value is None else _signed(1e3 * value, 1)


def _signed(value: float, decimals: int) -> str:
    return f"{round(value, decimals) + 0.0:+.{decimals}f}"


def _three(values: Sequence[float], unit: float, decimals: int) -> str:
    return " ".join(_signed(value / unit, decimals) for value in values)


def _three_plain(o: Offsets, first: int, unit: float, decimals: int) -> str:
    return " ".join(f"{value / unit:.{decimals}f}" for value in o.sigma[first : first + 3])
