"""Starts the process that marks a shard; what workers of a cluster do, and all that they do.

VAL-II programs never run in the worker itself: the child supervises a process for each, so limits
are the same whoever schedules the work.
"""

import os
import signal
import subprocess
import sys

_LAST_WORDS = 2000  # characters
_START_S = 300.0  # for loading everything from a slow disk


class ChildFailed(RuntimeError):  # noqa: N818 -- names the situation
    """The process gave no results; the text says why as far as it is known."""


def mark_in_child(shard: bytes, longest_s: float, jobs: int = 1) -> bytes:
    """Return the results of a shard, marked by a process of its own.

    Args:
        shard: Bytes of its file.
        longest_s: How long it may take at most, start not included.
        jobs: Processes at a time.

    Raises:
        ChildFailed: There are none.
    """
    command = [sys.executable, "-m", "vrts.marking.remote.alone", str(jobs), str(os.getpid())]
    with subprocess.Popen(  # noqa: S603 -- our own command
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"},  # threads do not fork
    ) as process:
        try:
            found, said = process.communicate(shard, timeout=_START_S + longest_s)
        except subprocess.TimeoutExpired as late:
            _end(process)
            raise ChildFailed("the shard was not marked in time") from late
        except BaseException:
            _end(process)
            raise
    if process.returncode != 0:
        words = said.decode("utf-8", "replace")[-_LAST_WORDS:].strip()
        raise ChildFailed(words or f"the process ended with status {process.returncode}")
    return found


def _end(process: "subprocess.Popen[bytes]") -> None:
    """End it; it ends what it has started itself."""
    process.send_signal(signal.SIGTERM)
    try:
        process.wait(10.0)
    except subprocess.TimeoutExpired:
        process.kill()
