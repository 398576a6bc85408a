"""A server with all its features, from the first message of a client to its end."""

import asyncio
import gc
import logging
import signal
import sys
from collections.abc import Generator
from concurrent.futures import CancelledError
from contextlib import contextmanager
from threading import Thread
from typing import BinaryIO, cast

from vrts.base.stack import DEPTH
from vrts.lsp.server import (
    colours,
    commanding,
    editor,
    helping,
    mending,
    outlining,
    referring,
    running,
    syncing,
)
from vrts.lsp.server.beside import locations, showing
from vrts.lsp.server.messages.stream import Broken, Messages, Outgoing
from vrts.lsp.server.session import Session

SWITCH_S = 0.001  # how soon the thread that checks lets an answer through
AHEAD = 16  # messages that are read before one is carried out
RARELY = (50_000, 50, 50)  # collections: summaries are many, live long and have no cycles


def serve(incoming: BinaryIO, outgoing: BinaryIO, *, runs: bool = True) -> int:
    """Serve one client until it leaves or is gone; return the status to exit with.

    That is 1 where the client said `exit` without `shutdown`, or where its process is gone.

    Args:
        incoming: What the client says: a file of the system.
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
            return asyncio.run(_follow(session, incoming, outgoing))
    finally:
        session.leave()


async def _follow(session: Session, incoming: BinaryIO, outgoing: BinaryIO) -> int:
    """Carry out what a client says, until it leaves or is gone."""
    loop = asyncio.get_running_loop()
    told: asyncio.Queue[bytes | Broken | None] = asyncio.Queue(AHEAD)
    gone: asyncio.Future[int] = loop.create_future()
    session.begin(gone)
    session.followed.set_writer(Outgoing(outgoing, gone))
    Thread(target=_listen, args=(incoming, loop, told), daemon=True).start()
    following = asyncio.create_task(_carry_out(session, told))
    await asyncio.wait({following, gone}, return_when=asyncio.FIRST_COMPLETED)
    return following.result() if following.done() else gone.result()


async def _carry_out(session: Session, told: "asyncio.Queue[bytes | Broken | None]") -> int:
    while session.followed.status is None:
        said = await told.get()
        if said is None:
            return 0
        session.followed.take(said)
    return session.followed.status


def _listen(
    incoming: BinaryIO,
    loop: asyncio.AbstractEventLoop,
    told: "asyncio.Queue[bytes | Broken | None]",
) -> None:
    """Read what a client says: in a thread that nobody waits for, as no word may come any more."""
    with open(incoming.fileno(), "rb", buffering=0, closefd=False) as stream:  # without a lock
        messages = Messages(cast(BinaryIO, stream))
        said: bytes | Broken | None = b""
        while said is not None:
            said = messages.next()
            put = told.put(said)
            try:
                asyncio.run_coroutine_threadsafe(put, loop).result()
            except (RuntimeError, CancelledError):  # the session has ended meanwhile
                put.close()
                return


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
    logging.getLogger("pygls").addHandler(logging.NullHandler())  # refusals are no tracebacks
    logging.getLogger("pygls").propagate = False
    session = Session(runs=runs)
    rooms = (
        editor,
        syncing,
        outlining,
        helping,
        referring,
        colours,
        mending,
        running,
        commanding,
        locations,
        showing,
    )
    for features in rooms:
        features.register(session)
    return session
