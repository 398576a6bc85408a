"""Marks a shard in a process that was started for it: the shard comes in, its results go out.

`python -m vrts.marking.remote.alone JOBS PARENT`; see `child`. It ends with whoever started it.
"""

import ctypes
import os
import signal
import sys
from types import FrameType

from vrts.marking.remote.run_shard import run_shard
from vrts.marking.remote.shard import read_shard
from vrts.marking.supervise.scratch import scratch_folder
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

REFUSED = 1  # exit status
_PR_SET_PDEATHSIG = 1  # [linux/prctl.h]


def main() -> None:
    """Read a shard from standard input, mark it, and write the zip to standard output."""
    jobs, parent = int(sys.argv[1]), int(sys.argv[2])
    end_with(parent)
    data = sys.stdin.buffer.read()
    try:
        with scratch_folder() as folder:
            found = run_shard(read_shard(data), data, folder, jobs=jobs)
    except Refused as refused:
        _refuse("; ".join(d.headline for d in refused.diagnostics))
    except CannotRead as problem:
        _refuse(problem.message)
    else:
        sys.stdout.buffer.write(found)


def end_with(parent: int) -> None:
    """End this process, tidily, when its parent has ended; only Linux can tell it."""
    signal.signal(signal.SIGTERM, _leave)
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGTERM)
        if os.getppid() != parent:
            sys.exit(REFUSED)  # it has ended already


def _leave(number: int, frame: FrameType | None) -> None:
    signal.signal(number, signal.SIG_IGN)  # once is enough: what is under way is tidied up
    sys.exit(128 + number)


def _refuse(words: str) -> None:
    sys.stderr.write(f"{words}\n")
    sys.exit(REFUSED)


if __name__ == "__main__":
    main()
