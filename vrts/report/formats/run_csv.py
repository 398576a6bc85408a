"""A run as a table of comma-separated values: arm, tool, hand, program and signals over time.

Numbers have fixed decimals and a point, whatever the machine's language; lengths in mm, angles in
degrees.
"""

from bisect import bisect_right
from collections.abc import Iterator

import numpy as np
import numpy.typing as npt

from vrts.base.units import DEG, MM
from vrts.engine.batch import batch_of
from vrts.engine.memory.events import SignalChanged
from vrts.engine.memory.records import Lie
from vrts.engine.run import Run
from vrts.report.formats.csv_field import text_field
from vrts.report.poses.tool import oat_deg, tool_frames
from vrts.robots.built import shown_off

Array = npt.NDArray[np.float64]

JOINTS = 6
CHUNK = 5_000  # rows worked out at once
END = "\n"
DECIMALS = (3, *(3,) * JOINTS, *(2,) * JOINTS, *(2,) * 3, *(3,) * 3, 2)  # of the numbers in a row
INSTANT = 1e-9  # [s]


def run_csv(run: Run, rate_hz: float) -> Iterator[str]:
    """Return the table in pieces that end with a line: a header, then a row every 1 / rate.

    Args:
        run: The run, up to its horizon.
        rate_hz: Rows a second [Hz].
    """
    changes = _signal_changes(run)
    yield _header(changes) + END
    count = int(run.horizon_s * rate_hz + INSTANT) + 1
    for begin in range(0, count, CHUNK):
        times = np.arange(begin, min(begin + CHUNK, count)) / rate_hz
        yield _rows(run, np.minimum(times, run.horizon_s), changes)


def _header(changes: dict[int, tuple[list[float], list[bool]]]) -> str:
    joints = range(1, JOINTS + 1)
    names = ["time_s", *(f"jt{k}_deg" for k in joints), *(f"v{k}_deg_s" for k in joints)]
    names += ["x_mm", "y_mm", "z_mm", "o_deg", "a_deg", "t_deg", "hand_mm"]
    names += ["held", "program", "step", *(f"signal_{number}" for number in changes)]
    return ",".join(names)


def _rows(run: Run, times: Array, changes: dict[int, tuple[list[float], list[bool]]]) -> str:
    batch = batch_of(run.timeline)
    values, rates = batch.values(times), batch.rates(times)
    rotations, origins = tool_frames(run, times, values[:, :JOINTS])
    numbers = np.column_stack(
        (
            times,
            (values[:, :JOINTS] + np.array(shown_off(run.scene.robot.arm))) / DEG,
            rates[:, :JOINTS] / DEG,
            origins / MM,
            oat_deg(rotations),
            values[:, JOINTS] / MM,
        )
    )
    for k, decimals in enumerate(DECIMALS):
        numbers[:, k] = np.round(numbers[:, k], decimals) + 0.0  # no minus before zero
    angles = numbers[:, -4:-1]
    angles[angles == -180.0] = 180.0  # as VAL writes it
    form = ",".join(f"%.{decimals}f" for decimals in DECIMALS)
    held = _held(run)
    rows: list[str] = []
    for time_s, row in zip(times.tolist(), numbers.tolist(), strict=True):
        cause = run.at(time_s).cause
        place = f"{text_field(cause.program)},{cause.step}" if cause is not None else ","
        signals = "".join(f",{int(_is_on(change, time_s))}" for change in changes.values())
        rows.append(f"{form % tuple(row)},{text_field(_holds(held, time_s))},{place}{signals}{END}")
    return "".join(rows)


def _signal_changes(run: Run) -> dict[int, tuple[list[float], list[bool]]]:
    """Return when every signal that ever changes does so, and to what."""
    found: dict[int, tuple[list[float], list[bool]]] = {}
    for event in run.events:
        if isinstance(event, SignalChanged):
            times, states = found.setdefault(event.signal, ([], []))
            times.append(event.time_s)
            states.append(event.on)
    return dict(sorted(found.items()))


def _is_on(change: tuple[list[float], list[bool]], time_s: float) -> bool:
    times, states = change
    found = bisect_right(times, time_s)
    return states[found - 1] if found else False


def _held(run: Run) -> list[tuple[float, float, str]]:
    """Return from when to when the hand holds what, in time order."""
    return sorted(
        (p.start_s, p.end_s, p.body)
        for track in run.placements.values()
        for p in track
        if p.lie is Lie.HELD and p.support is None
    )


def _holds(held: list[tuple[float, float, str]], time_s: float) -> str:
    found = bisect_right(held, time_s, key=lambda interval: interval[0])
    return held[found - 1][2] if found and time_s < held[found - 1][1] else ""
