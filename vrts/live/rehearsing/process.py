"""The process of a rehearsal, as the server sees it: begun, asked, heard, ended."""

import asyncio
import logging
import os
import signal
import sys
from contextlib import suppress
from pathlib import Path
from typing import Final

import vrts
from vrts.live.rehearsing.asked import PassedOn, as_json

LONGEST: Final = 8 * 1024 * 1024  # bytes of an answer
BEHIND: Final = 1024 * 1024  # bytes that may wait for the process
LAST_WORDS: Final = 4096  # bytes of what it says when it fails
COMMAND: Final = ("-m", "vrts.live.rehearsing.child")

NO_MEMORY: Final = 71  # its exit status
TOO_LONG: Final = "the rehearsal took more computing than it may use, and was ended"
TOO_MUCH: Final = "the rehearsal needs more memory than it may use, and was ended"
DIED: Final = "the rehearsal's process ended: rehearse again"

_log = logging.getLogger("vrts.live")


class RehearsalProcess:
    """Owns the process. It is given an empty folder, and of the environment what it needs."""

    def __init__(self, process: asyncio.subprocess.Process) -> None:
        """Take a process that has begun."""
        self._process = process
        self._ended = False  # by who had it begun
        self._errors = asyncio.get_running_loop().create_task(self._listen())

    @property
    def pid(self) -> int:
        """Number of the process."""
        return self._process.pid

    @property
    def behind(self) -> bool:
        """Whether it does not read what it is asked."""
        assert self._process.stdin is not None
        return self._process.stdin.transport.get_write_buffer_size() > BEHIND

    @property
    def alive(self) -> bool:
        """Whether it has not ended."""
        return self._process.returncode is None

    def ask(self, question: PassedOn) -> None:
        """Ask something; it answers in the order in which it is asked."""
        assert self._process.stdin is not None
        if not self._process.stdin.is_closing():
            self._process.stdin.write(as_json(question) + b"\n")

    async def answer(self) -> bytes | None:
        """Return its next answer; None: none comes any more."""
        assert self._process.stdout is not None
        try:
            return (await self._process.stdout.readuntil(b"\n"))[:-1]
        except (asyncio.IncompleteReadError, asyncio.LimitOverrunError):
            return None

    async def why(self) -> str:
        """End it, and return in a sentence why it answers no more."""
        await self.end(killed=False)
        status = self._process.returncode
        if status == -signal.SIGXCPU:
            return TOO_LONG
        return TOO_MUCH if status == NO_MEMORY else DIED

    async def end(self, *, killed: bool = True) -> None:
        """End it at once; where it may have ended already, let it say with which status."""
        self._ended = killed
        if not killed:
            assert self._process.stdin is not None
            self._process.stdin.close()
            with suppress(TimeoutError):
                await asyncio.wait_for(self._process.wait(), 0.5)
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        await self._process.wait()
        await self._errors

    async def _listen(self) -> None:
        """Keep the last of what it says beside its answers, and log it when it fails."""
        assert self._process.stderr is not None
        last = b""
        while data := await self._process.stderr.read(LAST_WORDS):
            last = (last + data)[-LAST_WORDS:]
        status = await self._process.wait()
        if status > 0 and not self._ended:
            _log.warning("a rehearsal ended: %s", last.decode("utf-8", "replace"))


async def begun(folder: Path, *, warm: bool = False) -> RehearsalProcess:
    """Begin a process in an empty folder.

    Args:
        folder: It is begun there.
        warm: It has time to prepare, so that its first answer comes sooner.

    Raises:
        OSError: The system has no process to give.
    """
    process = await asyncio.create_subprocess_exec(
        sys.executable,
        *COMMAND,
        *(["warm"] if warm else []),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
        limit=LONGEST,
        cwd=folder,
        env=_environment(),
        start_new_session=True,
    )
    return RehearsalProcess(process)


def _environment() -> dict[str, str]:
    """Return the environment without what is not needed; numbers are crunched by one thread."""
    kept = ("PATH", "LANG", "LC_ALL", "VIRTUAL_ENV", "SYSTEMROOT")
    own = {name: os.environ[name] for name in kept if name in os.environ}
    package = str(Path(vrts.__file__).resolve().parent.parent)
    return {**own, "PYTHONPATH": package, "OPENBLAS_NUM_THREADS": "1"}
