"""A server with all its features, from the first message of a client to its end."""

import gc
import sys
from typing import BinaryIO, cast

from vrts.base.stack import DEPTH
from vrts.lsp.server import colours, helping, mending, outlining, referring, running, syncing
from vrts.lsp.server.session import Session
from vrts.lsp.server.stream import Bounded

SWITCH_S = 0.001  # how soon the thread that checks lets an answer through
RARELY = (50_000, 50, 50)  # collections: summaries are many, live long and have no cycles


def serve(incoming: BinaryIO, outgoing: BinaryIO) -> None:
    """Serve one client until it leaves or is gone."""
    sys.setrecursionlimit(DEPTH)  # once for all threads: it counts for the whole process
    sys.setswitchinterval(SWITCH_S)
    gc.set_threshold(*RARELY)
    session = session_with_features()
    try:
        session.start_io(cast(BinaryIO, Bounded(incoming)), outgoing)
    finally:
        session.leave()


def session_with_features() -> Session:
    """Return a server that answers everything it can."""
    session = Session()
    for features in (syncing, outlining, helping, referring, colours, mending, running):
        features.register(session)
    return session
