"""A language server in a process of its own: begun, told, heard, ended."""

import asyncio
from collections.abc import AsyncGenerator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, Final

from vrts.live.editing import owned_process
from vrts.live.editing.owned_process import LONGEST, OwnedProcess
from vrts.live.editing.told import Answer, answer_of, as_json

COMMAND: Final = ("-m", "vrts.live.editing.limited")


class Helper(OwnedProcess):
    """A language server. It sees no file of anybody."""

    NAME = "a language server"

    def tell(self, message: Mapping[str, Any]) -> None:
        """Send a message of the protocol."""
        data = as_json({"jsonrpc": "2.0", **message})
        self.write(b"Content-Length: %d\r\n\r\n" % len(data) + data)

    async def heard(self) -> AsyncGenerator[Answer]:
        """Return its messages, until it ends or says what cannot be read."""
        with suppress(asyncio.IncompleteReadError, asyncio.LimitOverrunError, ValueError):
            while True:
                head = await self._out.readuntil(b"\r\n\r\n")
                lengths = [
                    int(line.split(b":")[1])
                    for line in head.split(b"\r\n")
                    if line.lower().startswith(b"content-length:")
                ]
                if len(lengths) != 1 or not 0 < lengths[0] <= LONGEST:
                    return
                yield answer_of(await self._out.readexactly(lengths[0]))


async def begun(folder: Path) -> Helper:
    """Begin a language server in an empty folder."""
    return Helper(await owned_process.begun(COMMAND, folder, {"PYTHONUNBUFFERED": "1"}))
