"""Questions about the reach of the arm, asked of a process beside the server."""

import json
import subprocess
import sys

from vrts.base.pose import Pose
from vrts.lsp.channel.reach import reach_line
from vrts.lsp.documents.setting_files import task_file


class Reaching:
    """The process that answers, begun with the first question. Asked by one thread."""

    def __init__(self) -> None:
        self.process: subprocess.Popen[bytes] | None = None

    def text(self, path: str, X_WT: Pose) -> str:
        """Return whether and how the tool gets to a pose; takes its time.

        Nothing where no task says in which scene, or where the process did not live to answer;
        then the next question begins another one.

        Args:
            path: Of the program.
            X_WT: Pose of the tool in the world; translation in m.
        """
        if task_file(path) is None:
            return ""
        process = self.process = self.process or _begun()
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            process.stdin.write(reach_line(path, X_WT))
            process.stdin.flush()
        except BrokenPipeError:
            pass  # its output has ended too
        line = process.stdout.readline()
        if not line:
            self.stop()
            return ""
        return str(json.loads(line))

    def stop(self) -> None:
        """End the process."""
        process, self.process = self.process, None
        if process is not None:
            process.kill()
            process.communicate()  # closes its pipes, and waits


def _begun() -> subprocess.Popen[bytes]:
    return subprocess.Popen(
        (sys.executable, "-m", "vrts.lsp.runs.reaching"),
        stdin=subprocess.PIPE,  # where it ends, so does the process
        stdout=subprocess.PIPE,
    )
