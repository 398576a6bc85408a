"""The real process of a session: its pipes, its beat, its end."""

import contextlib
import itertools
import math
import os
import select
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import msgspec
import psutil
import pytest

from vrts.live import actions as do
from vrts.live.session.channel.messages import (
    BEAT,
    LENGTH,
    Act,
    AskReach,
    Checked,
    Done,
    Failed,
    FromSession,
    Halt,
    News,
    Order,
    Output,
    Reached,
    Ready,
    Start,
    Stop,
)
from vrts.live.session.views.frame import RUNNING, PoseFrame, unpacked
from vrts.live.settings import HISTORY_QUOTA

ENDLESS = ".PROGRAM loop()\n 10 x = x + 1\n GOTO 10\n.END\n"


class Piped:
    """A session in its process."""

    def __init__(self, folder: Path, scene: str = "cans-on-bases") -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "vrts.live.session"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        assert self.process.stdout is not None
        self._from = self.process.stdout.fileno()
        self._data = bytearray()
        self.frames: list[tuple[float, PoseFrame]] = []  # with the time at which they came
        self.news: list[News] = []
        self._decoder = msgspec.json.Decoder(FromSession)
        self.send(Start(1, str(folder), scene))

    def send(self, order: Order) -> None:
        assert self.process.stdin is not None
        self.process.stdin.write(msgspec.json.encode(order) + b"\n")
        self.process.stdin.flush()

    def end(self) -> bytes:
        """End the process, if it has not ended; return what it wrote as an error."""
        self.process.kill()
        self.process.wait()
        pipes = (self.process.stdin, self.process.stdout, self.process.stderr)
        assert self.process.stderr is not None
        problems = self.process.stderr.read()
        for pipe in pipes:
            assert pipe is not None
            with contextlib.suppress(BrokenPipeError):
                pipe.close()
        return problems

    def listen(self, seconds: float) -> None:
        """Take messages for some time, or until the process ends."""
        end_s = time.monotonic() + seconds
        while (left := end_s - time.monotonic()) > 0.0 and self.listen_once(left):
            pass

    def listen_once(self, seconds: float) -> bool:
        """Take what comes next; return whether anything came in that time."""
        if not select.select([self._from], [], [], seconds)[0]:
            return False
        data = os.read(self._from, 1 << 16)
        self._data += data
        self._take()
        return bool(data)

    def until(
        self, kind: type[News], fits: Callable[[News], bool] = lambda _: True, seconds: float = 30.0
    ) -> News:
        """Listen until there is news of a kind that fits."""
        end_s = time.monotonic() + seconds
        while time.monotonic() < end_s:
            for news in self.news:
                if isinstance(news, kind) and fits(news):
                    return news
            if not self.listen_once(end_s - time.monotonic()):
                break
        raise AssertionError(f"no {kind.__name__} in {seconds} s: {self.news[-5:]}")

    def until_frame(self, fits: Callable[[PoseFrame], bool], seconds: float = 30.0) -> None:
        """Listen until another pose frame fits."""
        end_s, looked = time.monotonic() + seconds, len(self.frames)
        while not any(fits(frame) for _, frame in self.frames[looked:]):
            looked = len(self.frames)
            left = end_s - time.monotonic()
            assert left > 0.0, f"no such frame in {seconds} s"
            assert self.listen_once(left), f"no such frame in {seconds} s, or ever"

    def _take(self) -> None:
        while len(self._data) >= LENGTH.size:
            (length,) = LENGTH.unpack_from(self._data)
            end = LENGTH.size + length
            if len(self._data) < end:
                return
            message = bytes(self._data[LENGTH.size : end])
            del self._data[:end]
            if message[0] == 1:
                self.frames.append((time.monotonic(), unpacked(message)))
            else:
                self.news.append(self._decoder.decode(message))


def spent_s(piped: Piped) -> float:
    """Return the processor time that the process has used [s]."""
    times = psutil.Process(piped.process.pid).cpu_times()
    return times.user + times.system


@pytest.fixture
def piped(tmp_path: Path) -> Iterator[Piped]:
    session = Piped(tmp_path)
    yield session
    session.end()


def test_the_way_to_a_pose_is_told_beside_the_frames(piped: Piped) -> None:
    piped.send(AskReach(5, (0.95, -0.13, -0.2), (0.0, math.pi / 2, 0.0)))
    told = piped.until(Reached)
    assert isinstance(told, Reached)
    assert (told.ref, told.way, told.method) == (5, "touches", "certified")
    assert "touches base1" in told.touches[0].text


def at_the_table(news: News) -> bool:
    """Return whether it tells of a contact with the table."""
    assert isinstance(news, Checked)
    return any("table" in (row["first"], row["second"]) for row in news.contacts)


def now_of(ready: News) -> float:
    """Return session time, as the server stamps."""
    assert isinstance(ready, Ready)
    return time.monotonic() - ready.epoch_s


def test_an_endless_program_delays_no_beat_and_panic_ends_it(piped: Piped) -> None:
    ready = piped.until(Ready)
    assert isinstance(ready, Ready)
    assert ready.scene["name"] == "cans-on-bases"
    piped.send(Act(1, now_of(ready), "ada", do.Upload("loop.v2", ENDLESS)))
    piped.send(Act(2, now_of(ready), "ada", do.Typed("DO x = 0")))
    piped.send(Act(3, now_of(ready), "ada", do.Typed("EXECUTE loop")))
    piped.until_frame(lambda frame: bool(frame.flags & RUNNING))
    began, first = spent_s(piped), len(piped.frames)
    while len(piped.frames) < first + 100:
        piped.until_frame(lambda frame: bool(frame.flags & RUNNING))
    took_s = (spent_s(piped) - began) / (len(piped.frames) - first)
    times = [frame.time_s for _, frame in piped.frames[first:]]
    gaps = [later - earlier for earlier, later in itertools.pairwise(times)]
    assert any(abs(gap - BEAT) < 0.004 for gap in gaps), "now and then, on however busy a machine"
    assert took_s < 0.5 * BEAT, "of processor time, so that a beat is never late because of it"
    piped.send(Halt(4, now_of(ready)))
    piped.until_frame(lambda frame: not frame.flags & RUNNING)
    while "Program stopped at loop" not in "".join(
        n.text for n in piped.news if isinstance(n, Output)
    ):
        assert piped.listen_once(30.0)


def test_session_time_is_that_of_the_shared_clock(piped: Piped) -> None:
    ready = piped.until(Ready)
    assert isinstance(ready, Ready)
    shown = 0
    late_s = [math.inf]  # a busy machine brings some late, but none too early
    while min(late_s) > 0.2:
        piped.until_frame(lambda _: True)
        late_s += [came - ready.epoch_s - frame.time_s for came, frame in piped.frames[shown:]]
        shown = len(piped.frames)
    assert min(late_s) >= 0.0


@pytest.mark.thorough
def test_contacts_are_certified_beside_the_session(piped: Piped) -> None:
    ready = piped.until(Ready)
    down = (0.0, 1.5707963267948966, 0.0)
    piped.send(Act(1, now_of(ready), "ada", do.Go((0.75, -0.15, -0.36), down)))
    done = piped.until(Done)
    assert isinstance(done, Done)
    assert done.accepted, done.text
    checked = piped.until(Checked, at_the_table)  # others come while the arm is on its way
    assert isinstance(checked, Checked)
    assert all(row["depthMm"] > 0.2 for row in checked.contacts)  # type: ignore[operator]


def test_stop_and_the_end_of_input_end_the_process(piped: Piped) -> None:
    piped.until(Ready)
    limit, _ = psutil.Process(piped.process.pid).rlimit(psutil.RLIMIT_FSIZE)
    assert limit > HISTORY_QUOTA, "the quota is reached, and not the limit"
    piped.send(Stop())
    assert piped.process.wait(10.0) == 0


def test_the_end_of_input_ends_the_process(piped: Piped) -> None:
    piped.until(Ready)
    assert piped.process.stdin is not None
    piped.process.stdin.close()
    piped.listen(10.0)
    assert piped.process.wait(10.0) == 0


@pytest.mark.parametrize(
    ("scene", "line", "text"),
    [
        ("no-such-scene", b"", "no scene"),
        ("cans-on-bases", b'{"type":"act"}\n', "cannot be read"),
        ("cans-on-bases", b"x" * (1 << 21), "cannot be read"),
    ],
)
def test_what_cannot_be_done_is_said(tmp_path: Path, scene: str, line: bytes, text: str) -> None:
    piped = Piped(tmp_path, scene)
    assert piped.process.stdin is not None
    with contextlib.suppress(BrokenPipeError):  # it ends before it has read everything
        piped.process.stdin.write(line)
        piped.process.stdin.flush()
    failed = piped.until(Failed)
    assert isinstance(failed, Failed)
    assert text in failed.text
    piped.listen(5.0)
    assert piped.process.wait(10.0) != 0
    assert piped.end() == b""
