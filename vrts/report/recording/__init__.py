"""Recordings for the Rerun viewer: the only door to rerun, imported when one is written.

In: an assessment, or two runs. Out: a `.rrd` file, sent in columns, never frame by frame.
Decides nothing.
"""

from pathlib import Path

import rerun as rr
import rerun.blueprint as rrb

from vrts.base.units import mm
from vrts.report.assessment import Assessment
from vrts.report.plain import one_line
from vrts.report.poses.sampled import coordinates, times_of
from vrts.report.recording.blueprint import blueprint
from vrts.report.recording.lanes import send_lanes
from vrts.report.recording.markers import send_markers
from vrts.report.recording.motion import send_motion
from vrts.report.recording.plots import prepare_plots, send_plots
from vrts.report.recording.program_log import send_log, send_summary
from vrts.report.recording.shapes import prepare_shapes, send_shapes
from vrts.scene.model import Scene

__all__ = ["APPLICATION", "prepare", "write_recording"]

APPLICATION = "vrts"


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
        stream.save(path, default_blueprint=_blueprint(a.scene))
        send_shapes(a)
        send_summary(a)
        times = times_of(a.run)
        states, rates = coordinates(a.run, times)
        send_motion(a, times, states)
        send_markers(a)
        send_plots(a, times, states, rates)
        send_lanes(a)
        send_log(a)
    stream.disconnect()


def prepare(scene: Scene) -> None:
    """Make what all recordings of a scene have in common, which is kept.

    No recording is opened, no thread started.
    """
    _blueprint(scene)
    prepare_shapes(scene)
    prepare_plots()


def _blueprint(scene: Scene) -> rrb.Blueprint:
    return blueprint(mm(scene.robot.gripper.opening_max))
