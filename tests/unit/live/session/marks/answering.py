"""Waits for the process that checks a session, and for nothing else."""

from vrts.live.session.marks.checker import Checker
from vrts.marking.supervise.forked import wait

PATIENCE = 60.0  # [s] on a busy machine


def answered(checker: Checker) -> None:
    """Return when what is being checked has its answer; the next beat takes it."""
    child = checker.aside.child
    while child is not None and not child.ended():
        wait([child], PATIENCE)
