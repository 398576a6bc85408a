"""The clearance of a run over time, sampled for charts."""

from dataclasses import replace

import numpy as np

from vrts.check.collision.clearance_curve import clearance_curve
from vrts.geometry.proposing.proposer import Proposer
from vrts.report.assessment import Assessment

CURVE_STEP = 0.15  # [s] between samples of the clearance, for charts
CURVE_MOST = 400  # samples


def with_curve(a: Assessment, proposer: Proposer | None = None) -> Assessment:
    """Return the assessment with the clearance of its run over time.

    The proposer helps to find distances and changes none; None: the best there is here.
    """
    if a.run is None or a.scene is None or a.run.horizon_s <= 0.0:
        return a
    count = min(int(a.run.horizon_s / CURVE_STEP) + 2, CURVE_MOST)
    times = np.linspace(0.0, a.run.horizon_s, count)
    values = clearance_curve(a.scene, a.run, times, a.task.near_miss if a.task else None, proposer)
    return replace(a, clearance=tuple(zip(times.tolist(), values.tolist(), strict=True)))
