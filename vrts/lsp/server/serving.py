"""A server with all its features, from the first message of a client to its end."""

import gc
import signal
import sys
from collections.abc import Generator
from contextlib import contextmanager
from typing import BinaryIO, cast

from vrts.base.stack import DEPTH
from vrts.lsp.server import colours, helping, mending, outlining, referring, running, syncing
from vrts.lsp.server.session import Session
from vrts.lsp.server.stream import Bounded

SWITCH_S = 0.001  # how soon the thread that checks lets an answer through
RARELY = (50_000, 50, 50)  # collections: summaries are many, live long and have no cycles


def serve(incoming: BinaryIO, outgoing: BinaryIO, *, runs: bool = True) -> None:
    """Serve one client until it leaves or is gone.

    Args:
        incoming: What the client says.
        outgoing: What it is told.
        runs: Whether programs are run in the background, in processes beside this one.

    Raises:
        KeyboardInterrupt: Ctrl-C ended it.
    """
    sys.setrecursionlimit(DEPTH)  # once for all threads: it counts for the whole process
    sys.setswitchinterval(SWITCH_S)
    gc.set_threshold(*RARELY)
    session = session_with_features(runs=runs)
    try:
        with _interruptible():
            session.start_io(cast(BinaryIO, Bounded(incoming)), outgoing)
    finally:
        session.leave()


@contextmanager
def _interruptible() -> Generator[None]:
    """Let Ctrl-C end what is inside, and say so afterwards: pygls takes it for a usual end."""
    interrupted: list[int] = []

    def interrupt(number: int, _frame: object) -> None:
        interrupted.append(number)
        raise KeyboardInterrupt

    before = signal.getsignal(signal.SIGINT)
    if before is not signal.default_int_handler:  # whoever started this wants it otherwise
        yield
        return
    signal.signal(signal.SIGINT, interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if interrupted:
        raise KeyboardInterrupt


def session_with_features(*, runs: bool = True) -> Session:
    """Return a server that answers everything it can."""
    session = Session(runs=runs)
    for features in (syncing, outlining, helping, referring, colours, mending, running):
        features.register(session)
    return session
