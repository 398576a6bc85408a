"""The program files of folders, read in the background with progress: open buffers come first."""

import asyncio
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from itertools import count

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer

from vrts.lsp.documents.documents import Documents

AT_ONCE_S = 0.1  # of reading, whatever the client does: small folders take no longer
QUIET_S = 0.2  # after the client said something, before a file is read
TOLD_S = 1.0  # reading that takes longer is shown
ANSWER_S = 5.0  # for the client to say that it shows progress


class Reading:
    """Reads the files of folders one after the other, and stands back while something is asked."""

    def __init__(
        self, server: LanguageServer, documents: Documents, done: Callable[[str], None]
    ) -> None:
        """Take what reading needs.

        Args:
            server: Tells the client of progress.
            documents: Keep what is read.
            done: Called with a folder in which there was something new.
        """
        self._server = server
        self._documents = documents
        self._done = done
        self._going: dict[str, asyncio.Task[None]] = {}
        self._worker = ThreadPoolExecutor(1, "read")
        self._asked_s = 0.0  # when the client said something last, by the clock of the loop
        self._tokens = count(1)

    def stand_back(self) -> None:
        """Let the client's questions go first for a while."""
        self._asked_s = asyncio.get_running_loop().time()

    def is_whole(self, folder: str) -> bool:
        """Return whether all files of a folder are known as they are now."""
        return not self._documents.unread(folder)

    async def whole(self, folder: str) -> None:
        """Return when all files of a folder are known."""
        await asyncio.shield(self.begin(folder))

    def begin(self, folder: str) -> asyncio.Task[None]:
        """Read what is new in a folder."""
        going = self._going.get(folder)
        if going is None or going.done():
            going = asyncio.get_running_loop().create_task(self._read(folder))
            self._going[folder] = going
        return going

    def stop(self) -> None:
        """Read no more."""
        for going in self._going.values():
            going.cancel()
        self._worker.shutdown(wait=False, cancel_futures=True)

    async def _read(self, folder: str) -> None:
        paths = self._documents.unread(folder)
        loop = asyncio.get_running_loop()
        began: float = loop.time()
        token: str | None = None  # nobody has asked the client yet
        for number, path in enumerate(paths):
            now = loop.time()
            if now - began > AT_ONCE_S and now - self._asked_s < QUIET_S:
                await asyncio.sleep(QUIET_S)
            await loop.run_in_executor(self._worker, self._documents.read, path)
            if token is None and loop.time() - began > TOLD_S:
                token = await self._shown(folder)
            if token:
                text = f"{number + 1} of {len(paths)} files"
                share = 100 * (number + 1) // len(paths)
                report = types.WorkDoneProgressReport(message=text, percentage=share)
                self._server.work_done_progress.report(token, report)
        if token:
            self._server.work_done_progress.end(token, types.WorkDoneProgressEnd())
        if paths:
            self._done(folder)

    async def _shown(self, folder: str) -> str:
        """Let the client show progress; return its token, empty where it does not."""
        window = self._server.client_capabilities.window
        if window is None or not window.work_done_progress:
            return ""
        progress, token = self._server.work_done_progress, f"vrts-read-{next(self._tokens)}"
        try:
            async with asyncio.timeout(ANSWER_S):
                await progress.create_async(token)  # pyright: ignore[reportUnknownMemberType]
        except (TimeoutError, JsonRpcException):
            return ""
        title = f"Reading the programs of {os.path.basename(folder)}"
        progress.begin(token, types.WorkDoneProgressBegin(title, percentage=0))
        return token
