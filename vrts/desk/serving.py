"""The desk as a process: the socket it listens at, the words it begins with, its end."""

import errno
import os
import socket
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType
from typing import Final

import uvicorn

from vrts.desk.again.marking import Marking
from vrts.desk.desk import Desk
from vrts.desk.following import follow, is_behind
from vrts.desk.front.app import Way, application
from vrts.desk.front.door import ON
from vrts.desk.front.events import Events
from vrts.desk.told import GraderTold
from vrts.desk.upkeep import Upkeep
from vrts.live.callers.patient import PatientProtocol
from vrts.live.callers.pieces import InPieces
from vrts.live.tokens import new_token
from vrts.marking.by_hand.decisions.files import grader_in
from vrts.marking.layout import Layout
from vrts.pipeline.files import CannotRead

HOST: Final = "127.0.0.1"  # nobody else's machine can reach it
MOST_WAYS: Final = 64  # pages of killed desks that are looked at
LOOK_S: Final = 0.5  # until a desk of this machine has taken a connection


def serve_desk(
    folder: Path,
    who: str,
    port: int,
    say: Callable[[str], None],
    open_link: Callable[[str], None],
) -> None:
    """Serve until interrupted; then what is still to be written is written.

    Args:
        folder: The output of a marking.
        who: Who marks, as people write it.
        port: 0: any that is free.
        say: Writes a line of words.
        open_link: Takes the address of a file that leads a browser to the desk, and in. The token
            is in the file, which only its owner may read: command lines of browsers are public.

    Raises:
        CannotRead: There is no such folder, a file of it cannot be read, or the port is taken.
        Refused: It is no marking, something in it has errors, or `who` is no name.
    """
    grader = grader_in(Layout(folder).decisions, who)
    desk = Desk(folder, GraderTold(grader.id, grader.name))
    shown = desk.now()
    with _listener(port) as listener:
        real = int(listener.getsockname()[1])
        token, events = new_token(), Events()
        marking, upkeep = Marking(folder), Upkeep(lambda: follow(folder))
        if is_behind(shown.book):
            upkeep.wanted()
        app = application(desk, marking, upkeep, Way(token, real), events)
        address = f"http://{HOST}:{real}/"
        say(f"the desk of {grader.name} for {shown.book.rows.title}: {address}?token={token}")
        say("only this machine can reach it; Ctrl-C ends it")
        for problem in shown.book.problems:
            say(f"note: {problem}")
        config = uvicorn.Config(
            InPieces(app),
            http=PatientProtocol,
            ws="none",
            lifespan="on",
            log_config=None,
            access_log=False,
            server_header=False,
            date_header=False,  # `Guard` tells the time
            proxy_headers=False,
            timeout_graceful_shutdown=5,
        )
        opening = way_in(Layout(folder), f"{address}?token={token}", real)
        # how it ends
        with opening as file, suppress(KeyboardInterrupt):
            open_link(file.absolute().as_uri())
            _Server(config, events).run(sockets=[listener])


@contextmanager
def way_in(layout: Layout, address: str, port: int) -> Generator[Path]:
    """Keep a page that goes on to an address, as long as the desk runs.

    Raises:
        CannotRead: The folder cannot be written.
    """
    place = layout.decisions / f".desk-{port}.html"
    page = ON.format("The desk", f'<meta http-equiv="refresh" content="0;url={address}">', "")
    try:
        place.parent.mkdir(exist_ok=True)
        _forget_dead(place.parent)
        place.unlink(missing_ok=True)
        descriptor = os.open(place, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with os.fdopen(descriptor, "w", encoding="utf-8") as file:
            file.write(page)
    except OSError as problem:
        reason = (problem.strerror or str(problem)).lower()
        raise CannotRead(f"cannot write into `{place.parent}`: {reason}") from problem
    try:
        yield place
    finally:
        place.unlink(missing_ok=True)


def _forget_dead(folder: Path) -> None:
    """Delete the pages of desks that were killed: they lead nowhere."""
    for place in sorted(folder.glob(".desk-*.html"))[:MOST_WAYS]:
        port = place.stem.removeprefix(".desk-")
        if port.isdecimal() and not _listens(int(port)):
            place.unlink(missing_ok=True)


def _listens(port: int) -> bool:
    try:
        socket.create_connection((HOST, port), LOOK_S).close()
    except TimeoutError:  # somebody is there, and busy
        return True
    except (OSError, OverflowError):  # nobody is, or it is no port
        return False
    return True


class _Server(uvicorn.Server):
    """uvicorn's own server; who listens to events is sent away first when it ends."""

    def __init__(self, config: uvicorn.Config, events: Events) -> None:
        super().__init__(config)
        self._events = events

    def handle_exit(self, sig: int, frame: FrameType | None) -> None:
        """Begin to end."""
        self._events.end()
        super().handle_exit(sig, frame)


def _listener(port: int) -> socket.socket:
    """Return the socket that is listened at.

    Raises:
        CannotRead: It cannot be had.
    """
    try:
        return socket.create_server((HOST, port), backlog=128)
    except OSError as problem:
        if problem.errno == errno.EADDRINUSE:
            hint = "end it, or choose another port: without `--port` any is taken that is free"
            raise CannotRead(
                f"another program listens at port {port} already", (hint,)
            ) from problem
        reason = (problem.strerror or str(problem)).lower()
        raise CannotRead(f"cannot listen at {HOST}, port {port}: {reason}") from problem
