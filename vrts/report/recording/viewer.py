"""The Rerun viewer while it shows a recording: where it stands in time."""

import sys
from pathlib import Path

import rerun_cli
from rerun.experimental import ViewerClient

from vrts.report.recording.names import TIMELINE


def viewer_program() -> Path:
    """Return the viewer itself: ending the script of that name would leave it running."""
    name = "rerun.exe" if sys.platform == "win32" else "rerun"
    return Path(rerun_cli.__file__).parent / name


def stand_at(port: int, time_s: float) -> bool:
    """Let the viewer that listens at a port of this machine stand still at a time of its recording.

    Args:
        port: At which the viewer was started.
        time_s: Of the run [s].

    Returns:
        Whether it stands there; not before it has read the recording.
    """
    try:
        client = ViewerClient.connect(f"rerun+http://127.0.0.1:{port}/proxy")
        state = client.get_state()
        if state.loading or not state.recordings:
            return False
        client.set_time(TIMELINE, duration=time_s, play_state="paused")
    except (RuntimeError, ConnectionError):  # it is not there yet, or has been closed
        return False
    return True
