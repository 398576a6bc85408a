"""What touched and where it was closest, marked in the scene."""

import numpy as np
import rerun as rr

from vrts.check.verdict import Clearance
from vrts.report.assessment import Assessment
from vrts.report.page.replay_data import contact_sentence
from vrts.report.plain import one_line
from vrts.report.quantities import millimetres
from vrts.report.recording.names import at_times

CONTACT_COLOR = (225, 29, 42)
GRAZE_COLOR = (245, 159, 0)
CLOSEST_COLOR = (72, 199, 142)
RADIUS_M = 0.02
LINE_RADIUS_M = 0.002
MOST = 100  # markers of a kind
CLOSEST_S = 0.3  # before and after the closest moment
SHORTEST_S = 0.2  # a marker stays long enough to be seen


def send_markers(a: Assessment) -> None:
    """Mark contacts, grazes and near misses while they last, and where it was closest."""
    report = a.judgement.collisions if a.judgement else None
    if report is None:
        return
    for kind, events, color in (
        ("contacts", report.contacts, CONTACT_COLOR),
        ("grazes", report.grazes, GRAZE_COLOR),
    ):
        for number, c in enumerate(events[:MOST], start=1):
            ball = rr.Points3D.columns(
                positions=[c.point], radii=[RADIUS_M], colors=[color], labels=[contact_sentence(c)]
            )
            _show(f"world/{kind}/{number}", ball, c.start_s, c.end_s)
    for number, miss in enumerate(report.near_misses[:MOST], start=1):
        label = _distance(miss.parts, miss.distance_m)
        _show(
            f"world/near_misses/{number}",
            rr.LineStrips3D.columns(
                strips=[np.array(miss.witnesses, np.float32)],
                radii=[LINE_RADIUS_M],
                colors=[GRAZE_COLOR],
                labels=[label],
            ),
            miss.start_s,
            miss.end_s,
        )
    if report.clearance is not None:
        _closest(report.clearance)


def _show(path: str, columns: rr.ComponentColumnList, start_s: float, end_s: float) -> None:
    """Show a marker from one time to another [s]."""
    rr.send_columns(path, at_times([start_s]), columns)
    gone = max(end_s, start_s + SHORTEST_S)
    rr.send_columns(path, at_times([gone]), rr.Clear.columns(is_recursive=[False]))


def _closest(clearance: Clearance) -> None:
    words = _distance(clearance.bodies, clearance.distance_m)
    line = rr.LineStrips3D.columns(
        strips=[np.array(clearance.witnesses, np.float32)],
        colors=[CLOSEST_COLOR],
        radii=[LINE_RADIUS_M],
        labels=[f"closest: {words}"],
    )
    begin = max(clearance.time_s - CLOSEST_S, 0.0)
    _show("world/closest", line, begin, clearance.time_s + CLOSEST_S)


def _distance(names: tuple[str, str], distance_m: float) -> str:
    """Return `hand to table, 3.1 mm`."""
    first, second = (one_line(name) for name in names)
    return f"{first} to {second}, {millimetres(distance_m):g} mm"
