"""A comparison as a recording: the real robot drawn over the simulated one."""

from pathlib import Path

import numpy as np

from vrts.base.units import DEG, MM
from vrts.engine.batch import batch_of
from vrts.report.recording.overlay import Real, write_overlay
from vrts.validate.comparison import Comparison
from vrts.validate.reports.comparison_text import comparison_text
from vrts.validate.seen_run import assessment_of


def write_both(c: Comparison, name: str, path: Path) -> None:
    """Write a recording of a run and of the log that was compared with it.

    Args:
        c: The comparison.
        name: Of the program, as shown.
        path: The file.
    """
    a = assessment_of(c.run, name, "validate")
    e = c.after
    joints = errors = None
    times, tool, path_errors = e.times, e.real, e.path / MM
    if e.joints is not None:
        known = np.isfinite(e.joints).all(axis=1)
        times, tool, path_errors = times[known], tool[known], path_errors[known]
        joints = e.joints[known] + batch_of(c.run.timeline).values(times)[:, :6]
        errors = e.joints[known] / DEG
    write_overlay(a, Real(times, tool, path_errors, joints, errors), comparison_text(c), path)
