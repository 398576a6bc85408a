"""`python -m vrts.live.editing.limited`: limits itself, then becomes a language server."""

import ctypes
import os
import signal
import sys

from vrts.marking.supervise.limits import Limits, impose

LIMITS = Limits(cpu_s=900, memory=500_000_000, file=16_000_000, files=64)
YIELDS = 5  # niceness: sessions and the server go first
_ASKED_BY_PARENT = 1  # PR_SET_PDEATHSIG


def _end_with_parent() -> None:
    """Have the system kill this process when the server is gone, however that went."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_ASKED_BY_PARENT, signal.SIGKILL)


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is the server's
    _end_with_parent()
    if hasattr(os, "nice"):
        os.nice(YIELDS)
    impose(LIMITS)
    words = (sys.executable, "-m", "vrts.cli.main", "lsp", "--no-runs")
    os.execv(sys.executable, words)  # noqa: S606 -- nothing that somebody typed is in it
