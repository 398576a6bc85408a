"""What a session says, as the server reads it: in pieces of any size, and sometimes late."""

import asyncio
import os
import stat
import sys
from pathlib import Path
from typing import Any

import pytest

from vrts.live.rooms.process import Head, SessionProcess
from vrts.live.session.channel.messages import LENGTH, Start
from vrts.live.session.views.frame import PoseFrame, packed, unpacked

SAYS = """\
import os, sys, time
sys.stdin.readline()
data = bytes.fromhex(open({path!r}).read())
for at in range(0, len(data), {size}):
    os.write(1, data[at : at + {size}])
    time.sleep({pause})
"""


def frame(number: int) -> bytes:
    return packed(PoseFrame(1, number, 0.02 * number, (0.0,) * 6, 0.0, 0, 0))


def stream(*messages: bytes) -> bytes:
    return b"".join(LENGTH.pack(len(message)) + message for message in messages)


def heard(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, data: bytes, *, size: int, pause: float
) -> tuple[list[str], str]:
    """Return what the server makes of a session that writes these bytes, and why it ended."""
    (tmp_path / "data").write_text(data.hex())
    (tmp_path / "says.py").write_text(
        SAYS.format(path=str(tmp_path / "data"), size=size, pause=pause)
    )
    python = tmp_path / "python"
    python.write_text(f"#!/bin/sh\nexec {sys.executable} {tmp_path / 'says.py'}\n")
    python.chmod(stat.S_IRWXU)
    monkeypatch.setattr(sys, "executable", os.fspath(python))
    took: list[str] = []

    def on_pose(payload: bytes) -> None:
        took.append(f"pose {unpacked(payload).sequence}")

    def on_message(head: Head, _: bytes) -> None:
        took.append(f"{head.type} {head.text}")

    process = SessionProcess(Start(1, str(tmp_path / "session")), on_pose, on_message)
    asyncio.run(process.run())
    return took, process.failure


def note(text: str) -> bytes:
    return b'{"type":"note","text":"%s"}' % text.encode()


def test_messages_in_pieces_are_whole_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data = stream(frame(1), note("a"), frame(2), note("b" * 100))
    took, failure = heard(tmp_path, monkeypatch, data, size=7, pause=0.002)
    assert [t for t in took if t.startswith("note")] == ["note a", "note " + "b" * 100]
    assert took[-2:] == ["pose 2", "note " + "b" * 100]
    assert failure == "its process ended with status 0"


def test_of_poses_that_were_not_read_in_time_only_the_last_is_taken(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    data = stream(frame(1), note("a"), frame(2), note("b"), frame(3), note("c"))
    took, _ = heard(tmp_path, monkeypatch, data, size=len(data), pause=0.0)
    assert took == ["note a", "note b", "pose 3", "note c"]


@pytest.mark.parametrize("length", [0, 2**31])
def test_what_is_no_message_ends_the_session(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, length: int
) -> None:
    data = stream(note("a")) + LENGTH.pack(length) + b"x"
    _, failure = heard(tmp_path, monkeypatch, data, size=len(data), pause=0.0)
    assert failure == "the session sent what cannot be read"


def test_a_session_that_is_stopped_before_it_began_says_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    took: list[str] = []

    def on_message(head: Head, _: bytes) -> None:
        took.append(head.type)

    def process() -> SessionProcess:
        start = Start(1, str(tmp_path / "session"))
        return SessionProcess(start, took.append, on_message)  # type: ignore[arg-type]

    async def before() -> None:
        session = process()
        session.stop()
        await session.run()

    asyncio.run(before())
    assert not (tmp_path / "session").exists(), "nothing was started"

    starts = asyncio.create_subprocess_exec
    session = process()

    async def slowly(*_: str, **how: Any) -> asyncio.subprocess.Process:
        session.stop()  # meanwhile
        program = "import sys; sys.exit(len(sys.stdin.read()))"
        return await starts(sys.executable, "-c", program, **how)

    monkeypatch.setattr(asyncio, "create_subprocess_exec", slowly)
    asyncio.run(session.run())
    assert session.failure == "its process ended with status 0", "nothing was asked of it"
    assert took == []
