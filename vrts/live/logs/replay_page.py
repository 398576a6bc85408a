"""The page of a session with a replay, made of its log in a process of its own.

The process reads an `Order` as JSON and writes the page; what is wrong goes to its standard error.
"""

import asyncio
import os
import sys
from typing import Final

import msgspec

from vrts.live.settings import Place

LONGEST_S: Final = 120.0  # of making a page
MORE_S: Final = 10.0  # how long a session goes on after the last thing done
NOTHING: Final = "nothing was done in this room yet"


class Order(msgspec.Struct, frozen=True):
    """What is to be shown."""

    name: str  # of the room
    log: bytes  # as it is exported
    places: tuple[Place, ...]  # the set of scenes


class NoPage(Exception):  # noqa: N818 -- names the situation
    """There is no page, and why."""


async def replay_page(order: Order) -> bytes:
    """Return the page of the last session of a log in which something was done.

    Raises:
        NoPage: The log holds none, cannot be replayed, or it takes too long.
    """
    process = await asyncio.create_subprocess_exec(
        *(sys.executable, "-m", "vrts.live.logs.replay_page"),
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


def page_of(order: Order) -> bytes:
    """Return the page.

    Raises:
        NoPage: The log holds no session, or what it holds cannot be replayed.
    """
    from vrts.base.source import SourceFile
    from vrts.check.judge import judge
    from vrts.live.logs.log_file import read_log
    from vrts.live.logs.logged_sessions import LogFault
    from vrts.live.session.again.replay import replay
    from vrts.live.session.channel.messages import Start
    from vrts.live.session.views.program import as_program
    from vrts.pipeline.assess import with_curve
    from vrts.report.assessment import Assessment
    from vrts.report.page.page import page
    from vrts.report.page.stills import page_stills

    try:
        eventful = [session for session in read_log(order.log) if session.entries]
    except LogFault as problem:
        raise NoPage(str(problem)) from problem
    if not eventful:
        raise NoPage(NOTHING)
    session = eventful[-1]
    place = next((place for place in order.places if place.id == session.scene), None)
    if place is None:
        raise NoPage(f"the scene `{session.scene}` is not in the set any more")
    start = Start(session.number, "", place.scene, place.task, place.lab)
    try:
        run = replay(start, session.entries, session.entries[-1].at_s + MORE_S)
    except ValueError as problem:
        raise NoPage(f"the log does not fit: {problem}") from problem
    source = SourceFile("session.v2", as_program(run, "session"))
    judgement = judge(run.scene, run, None)
    found = Assessment(
        *("session", order.name, source, ()),
        module=run.module,
        scene=run.scene,
        run=run,
        judgement=judgement,
    )
    found = with_curve(found)
    return page(found, page_stills(found)).encode()


def main() -> None:
    """Do what is ordered on standard input."""
    if hasattr(os, "nice"):
        os.nice(10)  # frames come first
    order = msgspec.json.decode(sys.stdin.buffer.read(), type=Order)
    try:
        sys.stdout.buffer.write(page_of(order))
    except NoPage as problem:
        sys.stderr.write(f"{problem}\n")
        raise SystemExit(1) from problem


if __name__ == "__main__":
    main()
