"""How many cores a command uses, and what it says when a process beside it is lost."""

import os

from vrts.base.workers import Workers
from vrts.cli.shared.console import warn


def one_thread_each() -> None:
    """Let libraries start no threads: call this before numpy is loaded."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # threads do not fork


def workers_of(jobs: int | None) -> Workers:
    """Return as many workers as are asked for; None: one a core."""
    return Workers(jobs or os.cpu_count() or 1, _lost)


def _lost(words: str) -> None:
    warn(f"note: {words}")
