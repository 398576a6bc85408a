"""What a robot for each student costs: at work, awake at rest, asleep, and waking; printed.

Run by hand: `python -m pytest tests/bench/test_bench_live_robots.py -s -p no:xdist`.
`VRTS_ROOMS=60`, `VRTS_WORKING=10`, `VRTS_ASLEEP=20`, `VRTS_WAKES=20` and `VRTS_COMMANDS=10,1000`
make it smaller.

At work: a server with so many rooms and an operator by a WebSocket in each; a looping program
moves the arm in some of them, and commands are given in one more. Memory is PSS, of the server
and all its processes together. Asleep and waking: the application is called as uvicorn calls it,
its sessions are processes as always.
"""

import asyncio
import os
import select
import statistics
import threading
import time
from pathlib import Path
from typing import Any

import psutil
import pytest

from tests.bench.live_socket import LiveSocket
from tests.bench.live_stage import LOOP, Operator, Stage
from tests.bench.machine import used
from tests.bench.test_bench_live import answered
from tests.bench.usual import slowness
from tests.unit.live.rooms.test_asleep import Serving, served
from vrts.live.limits import Bucket
from vrts.live.rooms import opening
from vrts.live.rooms.room import Room

ROOMS = int(os.environ.get("VRTS_ROOMS", "200"))
WORKING = int(os.environ.get("VRTS_WORKING", "30"))
ASLEEP = int(os.environ.get("VRTS_ASLEEP", "100"))
WAKES = int(os.environ.get("VRTS_WAKES", "100"))
LENGTHS = tuple(map(int, os.environ.get("VRTS_COMMANDS", "10,1000,10000").split(",")))
COMMANDS = 40
AT_ONCE = 12  # commands that are under way
REST_S = 5.0


def pss(processes: list[psutil.Process]) -> float:
    """Return the memory of processes [MB], what they share counted once."""
    found = 0.0
    for process in processes:
        try:
            lines = Path(f"/proc/{process.pid}/smaps_rollup").read_text().splitlines()
        except (FileNotFoundError, ProcessLookupError):
            continue  # gone meanwhile
        found += sum(int(line.split()[1]) for line in lines if line.startswith("Pss:")) / 1024
    return found


def all_of(server: psutil.Process) -> list[psutil.Process]:
    """Return a server and all its processes."""
    return [server, *server.children(recursive=True)]


class Attending(Stage):
    """A stage whose operators read what comes while others are still on their way, as pages do.

    Who reads nothing answers no ping, and the server ends the connection.
    """

    def __init__(self, folder: Path, rooms: int, *, module: str) -> None:
        """Begin with an operator in each room."""
        self._poll = select.epoll()
        self._links: dict[int, LiveSocket] = {}  # that the thread reads
        self._lock = threading.Lock()
        self.reading_s = 0.0  # processor time of the thread
        self._ends = threading.Event()
        self._reader = threading.Thread(target=self._read)
        self._reader.start()
        try:
            super().__init__(folder, rooms, moving=False, module=module)
        except BaseException:
            self._end()
            raise

    def __enter__(self) -> "Attending":
        """Give the stage."""
        return self

    def leave(self, operator: Operator) -> Operator:
        """Have the thread read one no more, but who measures; return it with the control right.

        It is asked for only now: who does nothing for two minutes loses it, and where there are
        many the others take longer to come.
        """
        with self._lock:
            self._poll.unregister(operator.socket)
            del self._links[operator.socket.fileno()]
        return operator._replace(lease=operator.socket.take_control())

    def read(self, operator: Operator) -> None:
        """Have the thread read one, too."""
        with self._lock:
            self._links[operator.socket.fileno()] = operator.socket
            self._poll.register(operator.socket, select.EPOLLIN)

    def __exit__(self, *about: Any) -> None:
        """End the reading first."""
        self._end()
        super().__exit__(*about)

    def _operator(self, number: int, room: str) -> Operator:
        operator = super()._operator(number, room)
        self.read(operator)
        return operator

    def _in_control(self, link: LiveSocket, room: str) -> Operator:
        return Operator(link, "", room, 0.0)  # not yet, and nobody asks when the session began

    def _read(self) -> None:
        while not self._ends.is_set():
            for number, _ in self._poll.poll(0.2):
                with self._lock:
                    if number in self._links:
                        self._links[number].take()
                self.reading_s = time.thread_time()

    def _end(self) -> None:
        self._ends.set()
        self._reader.join()


def test_all_awake_and_some_at_work(tmp_path: Path) -> None:
    slow = slowness()
    with Attending(tmp_path, ROOMS, module="tests.bench.live_robots_server") as stage:
        measured, *others = stage.operators
        time.sleep(REST_S)
        begin = used(stage.process)
        time.sleep(REST_S)
        rest = used(stage.process).since(begin)
        resting = pss(all_of(stage.process))
        for operator in map(stage.leave, others[:WORKING]):
            operator.socket.command(operator.lease, "upload", name="loop.v2", text=LOOP)
            operator.socket.command(operator.lease, "line", line="EXECUTE loop,-1")
            operator.socket.send("rate", rate=50)
            stage.read(operator)
        measured = stage.leave(measured)
        measured.socket.send("rate", rate=50)
        time.sleep(REST_S)
        begin, reading_s = used(stage.process), stage.reading_s
        given = [answered(measured, n) for n in range(COMMANDS)]
        times = sorted(given)
        spent = used(stage.process).since(begin)
        reading = (stage.reading_s - reading_s) / spent.at_s
        working = pss(all_of(stage.process))
    slow = 0.5 * (slow + slowness())
    p95 = times[int(0.95 * COMMANDS)]
    print("\nin order [ms]: " + " ".join(f"{one:.0f}" for one in given))
    print(
        f"\n{ROOMS} rooms awake: {resting:.0f} MB (PSS);"
        f" server {100 * rest.server:.0f} %, sessions {100 * rest.sessions / ROOMS:.2f} % of a core"
        f" each here\n{WORKING} of them at work: {working:.0f} MB, asked 2048 MB;"
        f" server {100 * spent.server:.0f} %, sessions {100 * spent.sessions:.0f} % of a core;"
        f" command to frame: median {statistics.median(times):.0f} ms, p95 {p95:.0f} ms here,"
        f" {p95 / slow:.0f} ms on a usual machine, asked 100 ms (this one: {slow:.2f} times slower;"
        f" others use {100 * (spent.all - spent.server - spent.sessions):.0f} % of a core, of"
        f" which {100 * reading:.0f} % reading what comes)"
    )


async def long_log(live: Serving, commands: int) -> None:
    """Give a room so many commands."""
    member = next(iter(live.room.members.values()))
    member.messages = Bucket(1e9, 1e9)
    given = [live.command("line", line="WHERE") for _ in range(min(AT_ONCE, commands))]
    for number in range(len(given), commands):
        await live.boss.wait("result", of=given.pop(0))
        given.append(live.command("line", line=f"LISTR a[{number}]"))
    for one in given:
        await live.boss.wait("result", of=one)


async def awake(room: Room) -> None:
    """Wait until a session is ready."""
    while room.process is None or not room.process.ready or room.rest != "awake":
        await asyncio.sleep(0.001)


@pytest.mark.parametrize("commands", LENGTHS)
def test_waking_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, commands: int) -> None:
    folder = tmp_path / "live"
    folder.mkdir()
    times: list[float] = []
    falls: list[float] = []

    async def all_of_it() -> None:
        async with served(folder, monkeypatch) as live:
            await live.come()
            await awake(live.room)
            await long_log(live, commands)
            for _ in range(WAKES):
                begun = time.monotonic()
                await live.at_rest()
                falls.append(time.monotonic() - begun)
                process = live.room.process
                while process is not None and process.ready:
                    await asyncio.sleep(0.001)
                begun = time.monotonic()
                live.sessions.wake(live.room)
                await awake(live.room)
                times.append(time.monotonic() - begun)

    slow = slowness()
    asyncio.run(all_of_it())
    slow = 0.5 * (slow + slowness())
    times.sort()
    p50, p95 = statistics.median(times), times[int(0.95 * len(times))]
    print(
        f"\n{commands} commands, {WAKES} times: awake after {1e3 * p50:.0f} ms, p95"
        f" {1e3 * p95:.0f} ms here, {1e3 * p95 / slow:.0f} ms on a usual machine, asked 1000 ms"
        f" (this one: {slow:.2f} times slower); asleep after"
        f" {1e3 * statistics.median(falls):.0f} ms;"
        f" {60 / (p50 + statistics.median(falls)):.0f} a minute one after the other"
    )


def test_asleep(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "live"
    folder.mkdir()
    monkeypatch.setattr(opening, "MOST_ROOMS", ASLEEP + 1)

    async def all_of_it() -> None:
        async with served(folder, monkeypatch) as live:
            await live.come()
            await awake(live.room)
            me = psutil.Process()
            rooms = [
                await opening.make_room(live.hub, f"Room {n}", "cans-on-bases")
                for n in range(ASLEEP)
            ]
            begin, spent = pss([me]), time.process_time()
            await asyncio.sleep(REST_S)
            before = time.process_time() - spent
            for room in rooms:
                live.sessions.begin(room)
            for room in rooms:
                await awake(room)
                while room.rest != "asleep":
                    await live.sessions.sleep(room)
            while len(all_of(me)) > 3:  # this one, the nursery, and the session of the first room
                await asyncio.sleep(0.01)
            spent = time.process_time()
            await asyncio.sleep(REST_S)
            after = time.process_time() - spent
            files = sum(f.stat().st_size for f in folder.glob("sessions/*/*") if f.is_file())
            print(
                f"\n{ASLEEP} rooms asleep: {len(all_of(me)) - 3} processes more;"
                f" {1e3 * (pss([me]) - begin) / ASLEEP:.0f} kB each in the server (what its"
                f" allocator keeps too), {1e2 * (after - before) / REST_S:.2f} % of a core more"
                f" here, {files / 1e3 / ASLEEP:.0f} kB of files each"
            )

    asyncio.run(all_of_it())
