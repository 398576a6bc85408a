"""Keeps everybody else from writing into a marking: who marks, and who writes lists."""

import os
from collections.abc import Generator
from contextlib import contextmanager

from vrts.base.diagnostic import Rule, error
from vrts.marking.class_files import lists_alone
from vrts.marking.layout import AGAIN_LOCK, Layout
from vrts.marking.supervise.staging import LOCK, locked, remove_unused
from vrts.pipeline.refused import Refused

GOES_ON = Rule("V923", "marking-goes-on")


@contextmanager
def alone_in(layout: Layout) -> Generator[None]:
    """Hold a marking against whoever marks, and whoever writes its lists; a desk waits moments.

    Raises:
        Refused: Somebody marks.
    """
    held = os.open(layout.staff / AGAIN_LOCK, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o600)
    try:
        if locked(held) is False or _is_marked(layout):
            headline = f"a marking goes on in `{layout.root}`: nobody is forgotten"
            remedy = "wait until it has ended, or end it; then call this again"
            raise Refused((error(GOES_ON, headline, help=(remedy,)),))
        with lists_alone(layout):
            yield
    finally:
        os.close(held)


def _is_marked(layout: Layout) -> bool:
    """Return whether a marking of this machine holds one of its folders of drafts."""
    remove_unused(layout.staging)
    for lock in layout.staging.glob(f"*{LOCK}"):
        descriptor = os.open(lock, os.O_RDWR | os.O_CLOEXEC)
        try:
            if locked(descriptor) is False:
                return True
        finally:
            os.close(descriptor)
    return False
