"""A window of the Rerun viewer that is told where to stand in time."""

import socket
import subprocess
import time
from collections.abc import Sequence
from pathlib import Path

PATIENCE = 30.0  # [s] until the viewer has opened and read the recording
TURN = 0.1  # [s]


class RerunWindow:
    """At most one viewer, which ends with this."""

    def __init__(self, options: Sequence[str] = ()) -> None:
        """Start nothing yet; `options` are for the viewer."""
        self._options = options
        self._process: subprocess.Popen[bytes] | None = None
        self.port = 0

    @property
    def is_open(self) -> bool:
        """Whether the viewer is there: its user may have closed it."""
        return self._process is not None and self._process.poll() is None

    def show(self, recording: Path, time_s: float) -> bool:
        """Open a recording at a time [s]; return whether the viewer could."""
        from vrts.report.recording.viewer import viewer_program

        self.close()
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        place = ("--bind", "127.0.0.1", "--port", str(self.port))
        self._process = subprocess.Popen(  # noqa: S603 -- our own file
            [viewer_program(), *self._options, *place, recording],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        return self.stand_at(time_s)

    def stand_at(self, time_s: float) -> bool:
        """Go to another time [s] of the recording; return whether the viewer could."""
        from vrts.report.recording.viewer import stand_at

        until = time.monotonic() + PATIENCE
        while self.is_open and time.monotonic() < until:
            if stand_at(self.port, time_s):
                return True
            time.sleep(TURN)
        self.close()
        return False

    def close(self) -> None:
        """End the viewer."""
        if self._process is not None:
            self._process.terminate()
            self._process.wait()
            self._process = None
