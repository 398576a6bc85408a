"""A comparison as JSON: the numbers of the text, rounded as reports are."""

from collections.abc import Mapping, Sequence

from vrts.base.units import DEG, MM
from vrts.report.formats.diagnostic_json import diagnostic_json
from vrts.validate.comparison import Comparison
from vrts.validate.errors import Errors, Measures
from vrts.validate.reports.comparison_text import joint_rows, path_rows

FORMAT = 1


def comparison_json(c: Comparison) -> Mapping[str, object]:
    """Return a comparison as a document."""
    o = c.offsets
    positions = c.log.positions is not None
    offsets: dict[str, object] = {"time_s": _round(o.time_s, 4)}
    if c.wanted.base and positions:
        offsets["base_mm"] = _scaled(o.base_m, MM, 3)
        offsets["base_turn_deg"] = _scaled(o.base_rad, DEG, 4)
    if c.wanted.tool and positions:
        offsets["tool_mm"] = _scaled(o.tool_m, MM, 3)
    return {
        "format": FORMAT,
        "log": {
            "name": c.log.name,
            "sha256": c.log.sha256,
            "synthetic": c.log.synthetic,
            "samples": len(c.log.times),
            "compared": len(c.after.times),
            "path_from": "joints" if c.after.from_joints else "positions",
        },
        "before": {"clock_shift_s": _round(c.shift_s, 4), **_errors(c, c.before)},
        "after": {"offsets": offsets, **_errors(c, c.after)},
        "motions": [
            {
                "line": t.line,
                "instruction": t.words,
                "start_s": _round(t.start_s, 3),
                "end_s": _round(t.end_s, 3),
                "late_s": [None if v is None else _round(v, 4) for v in t.late],
            }
            for t in c.timings
        ],
        "diagnostics": [diagnostic_json(d) for d in c.findings],
    }


def _errors(c: Comparison, errors: Errors) -> dict[str, object]:
    path = {name.replace(" ", "_").lower(): _measures(m, "mm") for name, m in path_rows(c, errors)}
    if errors.joints is None:
        return {"path": path}
    return {"path": path, "joints": {n.lower(): _measures(m, "deg") for n, m in joint_rows(errors)}}


def _measures(m: Measures, unit: str) -> dict[str, float]:
    return {
        f"mean_{unit}": _round(m.mean, 4),
        f"mean_square_{unit}2": _round(m.mean_square, 6),
        f"rms_{unit}": _round(m.rms, 4),
        f"max_{unit}": _round(m.largest, 4),
    }


def _scaled(values: Sequence[float], unit: float, decimals: int) -> list[float]:
    return [_round(value / unit, decimals) for value in values]


def _round(value: float, decimals: int) -> float:
    return round(value, decimals) + 0.0
