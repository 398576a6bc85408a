"""The process of the editor, watched: a server never outlives the one that it serves."""

import asyncio
import os
import sys

from lsprotocol import types
from pygls.exceptions import JsonRpcInvalidParams

from vrts.lsp.server.session import Session

EVERY_S = 1.0  # between looks, where the system does not tell of the end of a process


def register(session: Session) -> None:
    """Follow the process that the client names when it begins."""

    @session.feature(types.INITIALIZE)
    def begins(server: Session, params: types.InitializeParams) -> None:
        for offer in server.offers:
            offer(params)
        number = params.process_id
        if number is None:
            return
        if number <= 0:
            raise JsonRpcInvalidParams(f"`initialize`: processId is {number}, no process")
        server.in_background(_watch(number, server.gone))


async def _watch(number: int, gone: "asyncio.Future[int]") -> None:
    """Say when a process has ended: at once if it is none, as the protocol wants it."""
    if hasattr(os, "pidfd_open") and sys.platform == "linux":
        await _told(number)
    elif os.name == "posix":
        while _lives(number):
            await asyncio.sleep(EVERY_S)
    else:
        return  # the end of its input tells it
    if not gone.done():
        sys.stderr.write(f"the editor, process {number}, is gone: so is its server\n")
        gone.set_result(1)


async def _told(number: int) -> None:
    """Return when the system says that a process has ended."""
    try:
        handle = os.pidfd_open(number)
    except OSError:
        return  # there is none
    loop = asyncio.get_running_loop()
    ended: asyncio.Future[None] = loop.create_future()

    def end() -> None:
        if not ended.done():
            ended.set_result(None)

    try:
        loop.add_reader(handle, end)
        await ended
    finally:
        loop.remove_reader(handle)
        os.close(handle)


def _lives(number: int) -> bool:
    try:
        os.kill(number, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True
