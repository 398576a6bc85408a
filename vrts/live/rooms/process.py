"""The process of one session, as the server sees it: started, fed, read, ended."""

import asyncio
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import IO, Final

import msgspec

from vrts.live.actions import Action, Number
from vrts.live.nursery.forked import Forked
from vrts.live.nursery.nursery import Nursery, environment
from vrts.live.session.channel.messages import (
    LENGTH,
    Act,
    AskBlock,
    AskProgram,
    AskReach,
    AskSnapshot,
    AskState,
    Halt,
    Pace,
    Sleep,
    Start,
    Stop,
    ToSession,
)

LONGEST: Final = 16 * 1024 * 1024  # bytes of a message from a session
CHUNK: Final = 256 * 1024  # bytes read at once
BEHIND: Final = 1024 * 1024  # bytes that may wait for a session
ENDED: Final = "the session ended before it answered"
END_S: Final = 3.0  # how long a session may take to end

_POSE = 1  # first byte of a pose frame


class StateAnswer(msgspec.Struct, frozen=True):
    """What the server reads of the session's `Left`."""

    data: str
    why: str


class Head(msgspec.Struct, frozen=True):
    """What the server reads of a message; the rest is passed on as it is."""

    type: str
    ref: int = 0
    epoch_s: float = 0.0
    at_s: float = 0.0
    accepted: bool = True
    counts: bool = True
    text: str = ""
    row: str = ""
    task: msgspec.Raw = msgspec.Raw()
    scene: msgspec.Raw = msgspec.Raw()
    carried_s: float | None = None
    anew: str = ""
    sha256: str = ""
    controller: str = ""
    controller_sha256: str = ""


_heads = msgspec.json.Decoder(Head)
_states = msgspec.json.Decoder(StateAnswer)
_encode = msgspec.json.Encoder().encode

OnPose = Callable[[bytes], None]
OnMessage = Callable[[Head, bytes], None]
_Process = asyncio.subprocess.Process | Forked


class SessionProcess:
    """Owns a process that runs `vrts.live.session`."""

    def __init__(
        self,
        start: Start,
        on_pose: OnPose,
        on_message: OnMessage,
        nursery: Nursery | None = None,
    ) -> None:
        """Say what the session is about, who is told what it says, and who forks its process."""
        self.start = start
        self._on_pose = on_pose
        self._on_message = on_message
        self._nursery = nursery
        self._process: _Process | None = None
        self._epoch = 0.0
        self._ref = 0
        self.ready = False
        self.first_snapshot = 0  # number of the snapshot that everybody is sent
        self.scene = b""  # JSON of what is drawn
        self.failure = ""  # why it ended
        self._ready_at = 0.0
        self._stopped = False  # it was asked to end, begun or not
        self.seldom = False  # fewer frames will do at rest
        self.slept = False  # it ends because its room sleeps
        self.unfit = ""  # why the state in its folder is none to wake with
        self._sleeps: dict[int, asyncio.Future[Head]] = {}  # by reference of the order
        self._states: dict[int, asyncio.Future[StateAnswer]] = {}  # by reference of the question

    async def run(self) -> None:
        """Start the process and read it until it ends; one that was stopped before is none."""
        if self._stopped:
            return
        folder = Path(self.start.folder)
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        with (folder / "stderr.txt").open("ab") as errors:
            self._process = await self._begun(errors)
        try:
            if not self._stopped:  # while it was started
                self._send(self.start)
                await self._read(self._process)
        finally:
            self.ready = False
            await self._end()

    def act(self, owner: str, action: Action) -> int:
        """Pass an action on, stamped now; return the number its answer will have."""
        self._ref += 1
        self._send(Act(self._ref, self._now(), owner, action))
        return self._ref

    def halt(self) -> int:
        """Pass a panic on."""
        self._ref += 1
        self._send(Halt(self._ref, self._now()))
        return self._ref

    def ask_reach(
        self,
        position_m: tuple[Number, Number, Number],
        oat_rad: tuple[Number, Number, Number],
        *,
        straight: bool,
        asker: str,
    ) -> int:
        """Ask whether the tool can go somewhere, and what the way touches."""
        self._ref += 1
        self._send(AskReach(self._ref, position_m, oat_rad, straight, asker))
        return self._ref

    def ask_program(self, name: str) -> int:
        """Ask for what was done as a program."""
        self._ref += 1
        self._send(AskProgram(self._ref, name))
        return self._ref

    def ask_block(self, number: int) -> int:
        """Ask for a block of the past."""
        self._ref += 1
        self._send(AskBlock(self._ref, number))
        return self._ref

    async def state(self) -> StateAnswer:
        """Return the state of now, as the session tells it; it may take its time."""
        self._ref += 1
        ref, coming = self._ref, asyncio.get_running_loop().create_future()
        self._states[ref] = coming
        self._send(AskState(ref))
        try:
            return await coming
        finally:
            self._states.pop(ref, None)

    async def sleep(self) -> Head:
        """Have it get ready to end with everything kept; return what it answers."""
        self._ref += 1
        ref, coming = self._ref, asyncio.get_running_loop().create_future()
        if self._process is None:
            return Head("slept", text=ENDED)
        self._sleeps[ref] = coming
        self._send(Sleep(ref))
        try:
            return await coming
        finally:
            self._sleeps.pop(ref, None)

    def set_pace(self, rate: int, *, seldom: bool = False) -> None:
        """Have so many pose frames made a second; fewer will do at rest where `seldom` is set."""
        self.seldom = seldom
        self._send(Pace(rate, seldom))

    def ask_snapshot(self) -> int:
        """Ask for everything that is now."""
        self._ref += 1
        self._send(AskSnapshot(self._ref))
        return self._ref

    @property
    def behind(self) -> bool:
        """Whether the session does not read what it is told."""
        pipe = None if self._process is None else self._process.stdin
        return pipe is not None and pipe.transport.get_write_buffer_size() > BEHIND

    def stop(self) -> None:
        """Ask the session to end, begun or not; `run` then returns."""
        self._stopped = True
        if self._process is not None and self._process.stdin is not None:
            self._send(Stop())
            self._process.stdin.close()

    @property
    def pid(self) -> int | None:
        """Number of its process; None: there was none yet."""
        return None if self._process is None else self._process.pid

    def went_on_s(self) -> float:
        """Return for how long it has been ready [s]."""
        return time.monotonic() - self._ready_at if self._ready_at else 0.0

    def _now(self) -> float:
        """Return the session time of now [s]."""
        return max(0.0, time.monotonic() - self._epoch)

    def _send(self, order: ToSession) -> None:
        pipe = None if self._process is None else self._process.stdin
        if pipe is not None and not pipe.is_closing():
            pipe.write(_encode(order) + b"\n")

    async def _begun(self, errors: IO[bytes]) -> _Process:
        """Return its process: forked from one that has loaded everything, if that is possible."""
        nursery = self._nursery
        forked = None if nursery is None else await nursery.fork(self.start, errors.fileno())
        return forked or await asyncio.create_subprocess_exec(
            sys.executable,
            "-m",
            "vrts.live.session",
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            stderr=errors,
            env=environment(),
            start_new_session=True,  # Ctrl-C is for the server, which ends its sessions
        )

    async def _read(self, process: _Process) -> None:
        assert process.stdout is not None
        begun = bytearray()
        try:
            while data := await process.stdout.read(CHUNK):
                begun += data
                self._take_all(_whole(begun))
        except (msgspec.DecodeError, _BadLength):
            self.failure = "the session sent what cannot be read"

    def _take_all(self, messages: list[bytes]) -> None:
        """Take messages; of several pose frames the last, so that who is late shows what is now."""
        poses = [number for number, message in enumerate(messages) if message[0] == _POSE]
        for number, message in enumerate(messages):
            if message[0] != _POSE:
                self._take(message)
            elif number == poses[-1]:
                self._on_pose(message)

    def _take(self, message: bytes) -> None:
        head = _heads.decode(message)
        if head.type == "ready":
            self._epoch = head.epoch_s
            self.scene = bytes(head.scene)
            self.ready = True
            self._ready_at = time.monotonic()
            if self._nursery is not None:
                self._nursery.keep(self.start)
        elif head.type == "failed":
            self.failure = head.text
        elif head.type == "left":
            self._answer_state(head.ref, _states.decode(message))
            return
        elif head.type == "slept":
            self._answer_sleep(head.ref, head)
            return
        elif head.type == "unfit":
            self.unfit = head.text
            return
        self._on_message(head, message)

    def _answer_state(self, ref: int, answer: StateAnswer) -> None:
        coming = self._states.get(ref)
        if coming is not None and not coming.done():
            coming.set_result(answer)

    def _answer_sleep(self, ref: int, answer: Head) -> None:
        coming = self._sleeps.get(ref)
        if coming is not None and not coming.done():
            coming.set_result(answer)

    async def _end(self) -> None:
        for ref in list(self._sleeps):
            self._answer_sleep(ref, Head("slept", text=ENDED))
        for ref in list(self._states):
            self._answer_state(ref, StateAnswer("", ENDED))
        process = self._process
        if process is None:
            return
        if process.stdin is not None:
            process.stdin.close()
        try:
            await asyncio.wait_for(process.wait(), END_S)
        except TimeoutError:
            process.kill()
            await process.wait()
        self.failure = self.failure or _ending(process.returncode)


class _BadLength(Exception):  # noqa: N818 -- names the situation
    """What comes is no message."""


def _ending(status: int | None) -> str:
    """Return in words how a process ended; None: nobody knows."""
    if status is None:
        return "its process ended"
    if status >= 0:
        return f"its process ended with status {status}"
    known = {int(one): one.name for one in signal.Signals}
    return f"its process was killed by {known.get(-status, f'signal {-status}')}"


def _whole(begun: bytearray) -> list[bytes]:
    """Take all messages that are whole off the front of what has come.

    Raises:
        _BadLength: A message is too long, or has no content.
    """
    found: list[bytes] = []
    at = 0
    while len(begun) - at >= LENGTH.size:
        (length,) = LENGTH.unpack_from(begun, at)
        if not 0 < length <= LONGEST:
            raise _BadLength
        end = at + LENGTH.size + length
        if len(begun) < end:
            break
        found.append(bytes(begun[at + LENGTH.size : end]))
        at = end
    del begun[:at]
    return found
