"""What was fitted, as text, as JSON, and as a lab that can be laid over any scene."""

import json
from collections.abc import Mapping

from vrts.base.units import DEG, MM
from vrts.controllers.model import FITTED
from vrts.report.plain import one_line
from vrts.validate.fitted import Estimate, FittedRobot

FORMAT = 1


def fitted_text(f: FittedRobot) -> str:
    """Return the numbers beside those that were assumed."""
    names = ", ".join(one_line(log.name) for log in f.logs)
    rows = [f"fitted from {names}: {f.motions} motions, servo lag {1e3 * f.lag_s:.1f} ms"]
    if any(log.synthetic for log in f.logs):
        rows.append("synthetic: a log was made by a computer, it is not of a real robot")
    rows += ["", f"  {'':22}{'assumed':>10}{'fitted':>10}   between"]
    for k, speed in enumerate(f.speeds):
        rows.append(_row(f"JT{k + 1} speed [deg/s]", f.arm.speed[k], speed, DEG, 2))
    rows.append(_row("line speed [mm/s]", f.arm.linear_speed, f.linear_speed, MM, 1))
    rows.append(_row("acceleration [s]", f.arm.acceleration_time, f.acceleration_time, 1.0, 4))
    blend = f.arm.blend_time or 2.0 * f.arm.acceleration_time
    rows.append(_row("rounded corner [s]", blend, f.blend_time, 1.0, 4))
    return "\n".join(rows)


def fitted_json(f: FittedRobot) -> Mapping[str, object]:
    """Return the numbers as a document."""
    return {
        "format": FORMAT,
        "robot": f.arm.name,
        "controller": f.controller,
        "logs": [log._asdict() for log in f.logs],
        "speed_deg_s": [_estimate(speed, DEG) for speed in f.speeds],
        "linear_mm_s": _estimate(f.linear_speed, MM),
        "acceleration_s": _estimate(f.acceleration_time, 1.0),
        "blend_s": _estimate(f.blend_time, 1.0),
        "servo_lag_s": round(f.lag_s, 5),
        "motions": f.motions,
    }


def lab_file(f: FittedRobot) -> str:
    """Return a lab with the numbers in place of the assumed ones; `--lab` lays it over a scene.

    Acceleration and corners are those that the controller counts, even numbers of ticks, and make
    a controller model of this laboratory [manual robots/controllers#fitted].
    """
    rows = ["# Robot data fitted by `vrts validate --fit`, to be laid over a scene: `--lab FILE`."]
    rows += [f"# fitted from {_words(log.name)}, sha256 {log.sha256}" for log in f.logs]
    if any(log.synthetic for log in f.logs):
        rows.append("# SYNTHETIC: a log was made by a computer; this describes no real robot.")
    title = f"the {f.arm.name} as fitted"
    rows += ["", "[lab]", f"title = {json.dumps(title)}", "", "[lab.robot]"]
    rows.append("speed_deg_s = [")
    for k, (speed, assumed) in enumerate(zip(f.speeds, f.arm.speed, strict=True), 1):
        value = assumed if speed is None else speed.value
        rows.append(f"  {value / DEG:.3f},  # JT{k}: {_source(speed, DEG)}")
    rows.append("]")
    if f.linear_speed is not None:
        value = f.linear_speed.value / MM
        rows.append(f"linear_mm_s = {value:.2f}  # {_source(f.linear_speed, MM)}")
    rows += ["", "[lab.controller]", f"model = {json.dumps(f.controller.removesuffix(FITTED))}"]
    rows.append(f"fitted_from = {json.dumps([log.sha256 for log in f.logs])}")
    tick = f.arm.tick
    acceleration = 2.0 * tick * max(round(0.5 * f.acceleration_time.value / tick), 1)
    rows.append(f"acceleration_s = {acceleration:.3f}  # {_source(f.acceleration_time, 1.0)}")
    if f.blend_time is not None:
        blend = max(2.0 * tick * round(0.5 * f.blend_time.value / tick), acceleration)
        rows.append(f"blend_s = {blend:.3f}  # {_source(f.blend_time, 1.0)}")
    return "\n".join(rows) + "\n"


def _row(name: str, assumed: float, found: Estimate | None, unit: float, decimals: int) -> str:
    begin = f"  {name:22}{assumed / unit:10.{decimals}f}"
    if found is None:
        return f"{begin}{'·':>10}   no motion tells"
    return (
        f"{begin}{found.value / unit:10.{decimals}f}"
        f"   {found.low / unit:.{decimals}f} and {found.high / unit:.{decimals}f}"
    )


def _source(found: Estimate | None, unit: float) -> str:
    if found is None:
        return "assumed; no motion told it"
    many = "motion" if found.motions == 1 else "motions"
    return (
        f"fitted {found.value / unit:.4f}, between {found.low / unit:.4f} and"
        f" {found.high / unit:.4f}, from {found.motions} {many}"
    )


def _estimate(found: Estimate | None, unit: float) -> dict[str, float] | None:
    if found is None:
        return None
    return {
        "value": round(found.value / unit, 5),
        "low": round(found.low / unit, 5),
        "high": round(found.high / unit, 5),
        "motions": found.motions,
    }


def _words(name: str) -> str:
    return "`" + one_line(name).replace("`", "'") + "`"
