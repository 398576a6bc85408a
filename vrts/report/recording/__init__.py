"""Recordings for the Rerun viewer: the only door to rerun, imported only when one is written.

Everything is sent in columns, never frame by frame. Time is in seconds on the timeline "t". Static
things are logged once; links, hand and bodies get poses only while they move.
"""

from pathlib import Path

import numpy as np
import rerun as rr

from vrts.base.units import mm
from vrts.engine.run import Run
from vrts.report.assessment import Assessment
from vrts.report.plain import one_line
from vrts.report.recording.blueprint import blueprint
from vrts.report.recording.lanes import send_lanes
from vrts.report.recording.markers import send_markers
from vrts.report.recording.motion import send_motion
from vrts.report.recording.names import Array
from vrts.report.recording.plots import send_plots
from vrts.report.recording.program_log import log_summary, send_log
from vrts.report.recording.shapes import log_shapes, prepare_shapes

__all__ = ["RATE_HZ", "prepare_shapes", "write_recording"]

APPLICATION = "vrts"
RATE_HZ = 50.0  # poses a second, as the original system broadcast them


def write_recording(a: Assessment, path: Path) -> None:
    """Write a recording of a run. It holds no path of this machine and no time of day.

    Raises:
        ValueError: There is no run to record.
    """
    if a.run is None or a.scene is None:
        raise ValueError("nothing was run")
    stream = rr.RecordingStream(
        APPLICATION, recording_id=one_line(a.identifier), send_properties=False
    )
    with stream:
        opening_max = a.scene.robot.gripper.opening_max
        stream.save(path, default_blueprint=blueprint(a.run.horizon_s, mm(opening_max)))
        log_shapes(a)
        log_summary(a)
        times = times_of(a)
        states, rates = _coordinates(a.run, times)
        send_motion(a, times, states)
        send_markers(a)
        send_plots(a, times, states, rates)
        send_lanes(a)
        send_log(a)
    stream.flush()
    stream.disconnect()


def times_of(a: Assessment) -> Array:
    """Return the instants that are recorded: at a steady rate, and the end."""
    assert a.run is not None
    end = a.run.horizon_s
    steady = np.arange(0.0, end, 1.0 / RATE_HZ)
    return np.unique(np.concatenate([steady, [end]]))


def _coordinates(run: Run, times: Array) -> tuple[Array, Array]:
    """Return joints [rad] and hand opening [m], shape (n, 7), and their rates."""
    if not run.timeline.segments:  # it ended before any time passed
        state = run.at(0.0)
        still = np.array([(*state.configuration, state.hand_opening)])
        return np.repeat(still, len(times), axis=0), np.zeros((len(times), still.shape[1]))
    return run.timeline.batch.values(times), run.timeline.batch.rates(times)
