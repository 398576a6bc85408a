"""TOML files of scenes, tasks and the like that are open: read beside the server as they change."""

import asyncio
import json
import os
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

from vrts.base.source import SourceFile
from vrts.lsp.server.background.own_process import OwnProcess
from vrts.schemas import kind_of

DELAY_S = 0.3  # after the last key
PATIENCE_S = 90.0


class SettingFile(NamedTuple):
    """A buffer."""

    path: str
    uri: str
    kind: str  # one of `vrts.schemas.KINDS`
    source: SourceFile
    version: int | None


class Looked(NamedTuple):
    """What the process has found of a text."""

    of: SettingFile
    rows: tuple[tuple[int, int, str, str, str], ...]  # start, end, severity, code, message
    recording: str | None  # of the scene, to be shown; None: it cannot be read, or there is none


class SettingFiles:
    """Buffers by their paths; what was found last, and the last scene that could be read."""

    def __init__(
        self,
        begin: Callable[[Any], asyncio.Task[None]],
        tell: Callable[[Looked], None],
        *,
        runs: bool,
    ) -> None:
        """Take what begins work in the background, and who is told of what was found."""
        self.open: dict[str, SettingFile] = {}
        self.last_good: dict[str, Looked] = {}  # with a recording
        self.bodies: dict[str, tuple[str, ...]] = {}  # of the last scene that could be read
        self._begin, self._tell, self._runs = begin, tell, runs
        self._going: dict[str, asyncio.Task[None]] = {}

    def take(self, path: str, uri: str, text: str, version: int | None) -> bool:
        """Take a buffer, if its name says that it is such a file; return whether it is."""
        kind = kind_of(path)
        if kind is None:
            return False
        source = SourceFile(path, text.replace("\r\n", "\n").replace("\r", "\n"))
        file = self.open[path] = SettingFile(path, uri, kind, source, version)
        self._end(path)
        if self._runs and os.path.isabs(path):
            self._going[path] = self._begin(self._look(file))
        return True

    def forget(self, path: str) -> bool:
        """Forget a buffer; return whether there was one."""
        self._end(path)
        self.last_good.pop(path, None)
        self.bodies.pop(path, None)
        return self.open.pop(path, None) is not None

    def stop(self) -> None:
        """Read no more."""
        for path in list(self._going):
            self._end(path)

    def _end(self, path: str) -> None:
        going = self._going.pop(path, None)
        if going is not None:
            going.cancel()

    async def _look(self, file: SettingFile) -> None:
        await asyncio.sleep(DELAY_S)
        asked = json.dumps([file.path, file.source.text]).encode() + b"\n"
        line = b""
        with OwnProcess("vrts.lsp.runs.scenes") as process, suppress(TimeoutError):
            async with asyncio.timeout(PATIENCE_S):
                line = await process.answer(asked)
        if self.open.get(file.path) is not file:
            return  # there is another text by now
        found: dict[str, Any] = json.loads(line) if line else _given_up()
        rows = tuple((*row,) for row in found["rows"])
        looked = Looked(file, rows, found["recording"])  # type: ignore[arg-type]
        if looked.recording is not None:
            self.last_good[file.path] = looked
            self.bodies[file.path] = tuple(found["bodies"])
        self._tell(looked)


def _given_up() -> dict[str, Any]:
    why = "this file could not be read to its end: `vrts scene check` says more"
    return {"rows": [[0, 0, "warning", "", why]], "recording": None, "bodies": []}
