"""The nursery as the server sees it: begun when it is needed, asked for sessions, begun again.

Where there is none, sessions begin in interpreters of their own: slower, and with more memory.
"""

import asyncio
import logging
import os
import socket
import sys
from contextlib import suppress
from typing import Final

import msgspec

from vrts.live.lasting.clock import steady
from vrts.live.nursery.forked import Forked
from vrts.live.nursery.line import ANSWER, BEGUN, ENDED, LONGEST, NOT_BEGUN, WORKS, Order
from vrts.live.session.channel.messages import Start

MODULE: Final = "vrts.live.nursery"
PATIENCE_S: Final = 30.0  # for a session; it has to load everything before the first one
REST_S: Final = 60.0  # without it, after it has failed
WITHOUT: Final = (
    "sessions begin in interpreters of their own, which takes longer and more memory: %s"
)
EARLY: Final = "the process that they are forked from has ended"
SLOW: Final = "the process that they are forked from does not answer"
_log = logging.getLogger("vrts.live")


class Nursery:
    """Forks sessions; everything of it happens in the event loop's thread."""

    def __init__(self, *, works: bool = WORKS) -> None:
        """Begin nothing yet; `works`: whether this system has what it takes."""
        self._works = works
        self._line: _Line | None = None
        self._beginning = asyncio.Lock()
        self._rests_until_s = 0.0
        self._said = False  # that sessions begin without it
        self._stopped = False

    @property
    def pid(self) -> int | None:
        """Number of its process; None: there is none now."""
        return None if self._line is None else self._line.process.pid

    async def prepare(self) -> None:
        """Have it begin, so that the first session need not wait for that."""
        await self._begun()

    async def fork(self, start: Start, errors: int) -> Forked | None:
        """Return a session that has begun; None: begin one otherwise.

        Args:
            start: What it will be told; here only its scene and task count.
            errors: File that it complains into.

        Raises:
            OSError: The system has no process or pipes to give.
        """
        line = await self._begun()
        if line is None:
            return None
        try:
            async with asyncio.timeout(PATIENCE_S):
                return await line.fork(start, errors)
        except TimeoutError:
            line.process.kill()
            self._rest(SLOW)
        except _Gone:
            self._rest(EARLY)
        return None

    def keep(self, start: Start) -> None:
        """Have a scene and task that a session has read kept for those that come."""
        if self._line is not None:
            self._line.keep(start)

    def stop(self) -> None:
        """Let it end; sessions that it has forked go on."""
        self._stopped = True
        if self._line is not None:
            self._line.hang_up()

    async def ended(self) -> None:
        """Wait until it has ended, after `stop`."""
        if self._line is not None:
            await self._line.process.wait()

    async def _begun(self) -> "_Line | None":
        """Return a connection with its process; begin one where there is none."""
        if not self._works or self._stopped:
            return None
        async with self._beginning:
            if self._line is not None and self._line.lost:
                self._line = None
            if self._line is None and steady() >= self._rests_until_s:
                try:
                    self._line = await _connected()
                except OSError as problem:
                    self._rest(problem.strerror or str(problem))
                if self._stopped and self._line is not None:
                    self._line.hang_up()
            return self._line

    def _rest(self, why: str) -> None:
        """Do without for a while; say so once."""
        self._rests_until_s = steady() + REST_S
        if not self._said and not self._stopped:
            self._said = True
            _log.warning(WITHOUT, why)


class _Gone(Exception):  # noqa: N818 -- names the situation
    """The process has ended before it answered."""


async def _connected() -> "_Line":
    """Begin the process.

    Raises:
        OSError: The system has none to give.
    """
    ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
    with theirs:
        try:
            process = await asyncio.create_subprocess_exec(
                sys.executable,
                "-m",
                MODULE,
                stdin=theirs.fileno(),
                stdout=asyncio.subprocess.DEVNULL,
                env=environment(),
                start_new_session=True,  # Ctrl-C is for the server
            )
        except OSError:
            ours.close()
            raise
    return _Line(ours, process)


class _Line:
    """A connection with one process."""

    def __init__(self, socket_: socket.socket, process: asyncio.subprocess.Process) -> None:
        self.process = process
        self.lost = False
        self._socket = socket_
        self._number = 0
        self._kept: set[bytes] = set()
        self._asked: dict[int, asyncio.Future[tuple[int, int]]] = {}
        self._forked: dict[int, Forked] = {}  # that have not ended, as far as is known
        self._loop = asyncio.get_running_loop()
        socket_.setblocking(False)
        self._loop.add_reader(socket_, self._hear)
        self._waiting = self._loop.create_task(process.wait())

    def keep(self, start: Start) -> None:
        """Have a scene and task kept, if that is not asked for already."""
        order = _order(0, start)
        if order not in self._kept and not self.lost:
            self._kept.add(order)
            with suppress(_Gone):
                self._say(order, [])

    async def fork(self, start: Start, errors: int) -> Forked:
        """Return a session that has begun.

        Raises:
            OSError: The system has no process or pipes to give.
            _Gone: The connection is lost.
        """
        asked, ask = os.pipe()
        told, tell = os.pipe()
        self._number += 1
        number = self._number
        answer: asyncio.Future[tuple[int, int]] = self._loop.create_future()
        self._asked[number] = answer
        try:
            self._say(_order(number, start), [asked, tell, errors])
            pid, ends = await answer
        except BaseException:
            os.close(ask)
            os.close(told)
            raise
        finally:
            self._asked.pop(number, None)
            os.close(asked)
            os.close(tell)
        forked = self._forked[number] = Forked(pid, ends)
        await forked.connect(ask, told)
        return forked

    def hang_up(self) -> None:
        """Let the process end."""
        if self.lost:
            return
        self.lost = True
        self._loop.remove_reader(self._socket)
        self._socket.close()
        for answer in self._asked.values():
            if not answer.done():
                answer.set_exception(_Gone())
        for forked in self._forked.values():
            forked.watch()
        self._forked.clear()

    def _say(self, order: bytes, streams: list[int]) -> None:
        try:
            socket.send_fds(self._socket, [order], streams)
        except OSError as problem:  # it has ended, or reads nothing
            self.hang_up()
            raise _Gone from problem

    def _hear(self) -> None:
        while not self.lost:
            try:
                said, ends, _, _ = socket.recv_fds(self._socket, ANSWER.size, 1)
            except BlockingIOError:
                return
            except ConnectionResetError:
                said, ends = b"", []
            if not said:
                self.hang_up()
                return
            what, number, about = ANSWER.unpack(said)
            self._take(what, number, about, ends)

    def _take(self, what: int, number: int, about: int, ends: list[int]) -> None:
        asked = self._asked.get(number)
        if what == ENDED and (forked := self._forked.pop(number, None)) is not None:
            forked.has_ended(about)
        if asked is None or asked.done():  # nobody waits any more: it hears nobody, and ends
            for end in ends:
                os.close(end)
        elif what == BEGUN:
            asked.set_result((about, ends[0]))
        elif what == NOT_BEGUN:
            asked.set_exception(OSError(about, os.strerror(about)))


def _order(number: int, start: Start) -> bytes:
    """Return an order.

    Raises:
        _Gone: It is too long for a packet.
    """
    order = Order(number, start.scene, start.task, start.lab, start.controller)
    data = msgspec.json.encode(order)
    if len(data) > LONGEST:
        raise _Gone
    return data


def environment() -> dict[str, str]:
    """Return the environment without what is not needed; numbers are crunched by one thread."""
    kept = ("PATH", "HOME", "LANG", "LC_ALL", "PYTHONPATH", "VIRTUAL_ENV", "TMPDIR", "SYSTEMROOT")
    own = {name: os.environ[name] for name in kept if name in os.environ}
    return {**own, "OPENBLAS_NUM_THREADS": "1", "PYTHONUNBUFFERED": "1"}
