"""The real process of a session: its pipes, its beat, its end."""

import contextlib
import itertools
import os
import select
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import msgspec
import pytest

from vrts.live import actions as do
from vrts.live.session.channel.messages import (
    LENGTH,
    Act,
    Checked,
    Done,
    Failed,
    FromSession,
    Halt,
    News,
    Order,
    Output,
    Ready,
    Start,
    Stop,
)
from vrts.live.session.views.frame import RUNNING, PoseFrame, unpacked

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
        while (left := end_s - time.monotonic()) > 0.0:
            if not select.select([self._from], [], [], left)[0]:
                return
            data = os.read(self._from, 1 << 16)
            if not data:
                return
            self._data += data
            self._take()

    def until(self, kind: type[News], seconds: float = 30.0) -> News:
        """Listen until there is news of a kind."""
        end_s = time.monotonic() + seconds
        while time.monotonic() < end_s:
            for news in self.news:
                if isinstance(news, kind):
                    return news
            self.listen(0.05)
        raise AssertionError(f"no {kind.__name__} in {seconds} s: {self.news[-5:]}")

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


@pytest.fixture
def piped(tmp_path: Path) -> Iterator[Piped]:
    session = Piped(tmp_path)
    yield session
    session.end()


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
    piped.listen(0.3)
    piped.frames.clear()
    piped.listen(1.5)
    idle = len(piped.frames)  # 75 are due; a busy machine has fewer, and will have fewer below
    piped.send(Act(3, now_of(ready), "ada", do.Typed("EXECUTE loop")))
    piped.listen(0.5)
    piped.frames.clear()
    piped.listen(3.0)
    running = [frame for _, frame in piped.frames if frame.flags & RUNNING]
    assert len(running) >= 0.8 * 2 * idle
    times = [frame.time_s for frame in running]
    gaps = sorted(b - a for a, b in itertools.pairwise(times))
    assert gaps[len(gaps) // 2] == pytest.approx(0.020, abs=0.004)
    piped.send(Halt(4, now_of(ready)))
    until = time.monotonic() + 10.0
    while piped.frames[-1][1].flags & RUNNING and time.monotonic() < until:
        piped.listen(0.2)
    assert not piped.frames[-1][1].flags & RUNNING
    outputs = "".join(n.text for n in piped.news if isinstance(n, Output))
    assert "Program stopped at loop" in outputs


def test_session_time_is_that_of_the_shared_clock(piped: Piped) -> None:
    ready = piped.until(Ready)
    piped.listen(0.3)
    came, frame = piped.frames[-1]
    assert isinstance(ready, Ready)
    assert 0.0 <= came - ready.epoch_s - frame.time_s < 0.2


def test_contacts_are_certified_beside_the_session(piped: Piped) -> None:
    ready = piped.until(Ready)
    down = (0.0, 1.5707963267948966, 0.0)
    piped.send(Act(1, now_of(ready), "ada", do.Go((0.75, -0.15, -0.36), down)))
    checked = piped.until(Checked)
    assert isinstance(checked, Checked)
    done = next(n for n in piped.news if isinstance(n, Done))
    assert done.accepted, done.text
    bodies = {row["second"] for row in checked.contacts} | {
        row["first"] for row in checked.contacts
    }
    assert "table" in bodies
    assert all(row["depthMm"] > 0.2 for row in checked.contacts)  # type: ignore[operator]


def test_stop_and_the_end_of_input_end_the_process(piped: Piped) -> None:
    piped.until(Ready)
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
