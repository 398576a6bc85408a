"""Sessions forked from a process that has everything loaded: they begin, they end, it ends."""

import asyncio
import json
import os
import select
import shutil
import signal
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import psutil
import pytest

from tests.places import ROOT
from vrts.live.nursery import nursery as module
from vrts.live.nursery.nursery import Nursery
from vrts.live.rooms.process import Head, SessionProcess
from vrts.live.session.channel.messages import Start

PATIENCE_S = 60.0
CANS = ROOT / "scenes" / "cans-on-bases"


class Begun:
    """A session that has begun, as the server has it."""

    def __init__(self, folder: Path, nursery: Nursery, scene: str = str(CANS)) -> None:
        self.drawn = ""
        self.ready = asyncio.Event()
        start = Start(1, str(folder), scene)
        self.session = SessionProcess(start, lambda _: None, self._hear, nursery)
        self._run = asyncio.ensure_future(self.session.run())

    async def begin(self) -> psutil.Process:
        """Wait until it is ready; return its process."""
        ready = asyncio.ensure_future(self.ready.wait())
        await asyncio.wait([ready, self._run], return_when="FIRST_COMPLETED")
        assert ready.done(), self.session.failure
        assert self.session.pid is not None
        return psutil.Process(self.session.pid)

    async def end(self) -> str:
        """Wait until it has ended; return how."""
        await self._run
        return self.session.failure

    def _hear(self, head: Head, _: bytes) -> None:
        if head.type == "ready":
            self.drawn = json.dumps(json.loads(bytes(head.scene)))
            self.ready.set()


def with_nursery(work: Callable[[Nursery], Coroutine[Any, Any, None]]) -> None:
    """Do something with a nursery, and end it."""

    async def all_of_it() -> None:
        nursery = Nursery()
        try:
            async with asyncio.timeout(PATIENCE_S):
                await work(nursery)
        finally:
            nursery.stop()
            await nursery.ended()

    asyncio.run(all_of_it())


async def until_gone(pid: int) -> None:
    """Wait until a process has ended; asyncio asks how."""
    ends = os.pidfd_open(pid)
    await asyncio.to_thread(select.select, [ends], [], [], PATIENCE_S)
    os.close(ends)


@pytest.mark.thorough
def test_sessions_are_forked_and_end_as_processes_of_their_own(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    scene = tmp_path / "scene"
    shutil.copytree(CANS, scene)

    async def work(nursery: Nursery) -> None:
        first = Begun(tmp_path / "first", nursery, str(scene))
        process = await first.begin()
        assert process.ppid() == nursery.pid
        assert os.getsid(process.pid) == process.pid, "Ctrl-C is for the server"
        assert process.num_threads() == 1

        second = Begun(tmp_path / "second", nursery, str(scene))
        other = await second.begin()
        assert other.ppid() == nursery.pid
        assert second.drawn == first.drawn
        streams = _streams(other)
        turns = streams.pop(3)
        assert streams == {0: "pipe", 1: "pipe", 2: str(tmp_path / "second/stderr.txt")}
        assert _streams(process)[3] == turns, "both take turns at one file"
        other.kill()
        assert await second.end() == "its process was killed by SIGKILL"

        text = (scene / "scene.toml").read_text()
        (scene / "scene.toml").write_text(text.replace("can1", "tin1"))
        third = Begun(tmp_path / "third", nursery, str(scene))
        await third.begin()
        assert "tin1" in third.drawn, "what is kept is not told once the file is another one"
        third.session.stop()
        assert await third.end() == "its process ended with status 0"

        assert nursery.pid is not None
        before = nursery.pid
        os.kill(before, signal.SIGKILL)
        await until_gone(before)
        assert first.session.ready
        fourth = Begun(tmp_path / "fourth", nursery, str(scene))
        await fourth.begin()
        assert nursery.pid != before, "another one has begun"
        process.kill()
        assert await first.end() == "its process ended", "nobody can tell how"
        fourth.session.stop()
        await fourth.end()

    with_nursery(work)
    assert not caplog.records
    told = [path.read_text() for path in tmp_path.glob("*/stderr.txt")]
    assert told == [""] * 4


def test_without_a_nursery_sessions_begin_all_the_same_and_that_is_said_once(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "MODULE", "vrts.live.no_nursery")
    monkeypatch.setattr(module, "REST_S", 0.0)

    async def work(nursery: Nursery) -> None:
        begun = [Begun(tmp_path / str(n), nursery) for n in range(2)]
        for one in begun:
            process = await one.begin()
            assert process.ppid() == os.getpid()
        for one in begun:
            one.session.stop()
            assert await one.end() == "its process ended with status 0"

    with_nursery(work)
    assert [record.getMessage() for record in caplog.records] == [module.WITHOUT % module.EARLY]


def _streams(process: psutil.Process) -> dict[int, str]:
    """Return what is open in a session, beside what it has opened itself."""
    found: dict[int, str] = {}
    for link in Path(f"/proc/{process.pid}/fd").iterdir():
        leads = os.readlink(link)
        found[int(link.name)] = "pipe" if leads.startswith("pipe:") else leads
    return found
