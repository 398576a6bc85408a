"""The page of a session with a replay, made of its log in a process of its own."""

import asyncio
import sys
from typing import Final

import msgspec

from vrts.live.logs.voices import Said
from vrts.live.settings import Place

LONGEST_S: Final = 120.0  # of making a page


class Order(msgspec.Struct, frozen=True):
    """What is to be shown."""

    name: str  # of the room
    log: bytes  # as it is exported
    places: tuple[Place, ...]  # the set of scenes
    chat: tuple[Said, ...] = ()  # what everybody in the room could read


class NoPage(Exception):  # noqa: N818 -- names the situation
    """There is no page, and why."""


async def replay_page(order: Order) -> bytes:
    """Return the page of the last session of a log in which something was done.

    Raises:
        NoPage: The log holds none, cannot be replayed, or it takes too long.
    """
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "vrts.live.logs.replay_process"),
        stdin=asyncio.subprocess.PIPE,
        stdout=asyncio.subprocess.PIPE,
        stderr=asyncio.subprocess.PIPE,
    )
    try:
        told = process.communicate(msgspec.json.encode(order))
        page, problem = await asyncio.wait_for(told, LONGEST_S)
    except TimeoutError as late:
        raise NoPage("the session is too long for a page made here") from late
    finally:
        if process.returncode is None:
            process.kill()
            await process.wait()
    if process.returncode:
        raise NoPage(problem.decode(errors="replace").strip().splitlines()[-1])
    return page
