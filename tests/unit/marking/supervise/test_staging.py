"""Staging folders vanish with whoever used them, and never one that is in use."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from vrts.marking.supervise import staging
from vrts.marking.supervise.staging import remove_unused, staging_folder
from vrts.marking.supervise.supervisor import CAN_FORK

HOLD = """
import os, sys
from pathlib import Path
from vrts.marking.supervise.staging import staging_folder
with staging_folder(Path(sys.argv[1])) as folder:
    (folder / "draft").write_text("half")
    if sys.argv[2:]:  # a child, as one that marks
        ready, told = os.pipe()
        if os.fork() == 0:
            print(folder, os.getpid(), flush=True)
            sys.stdin.read()
            os._exit(0)
    else:
        print(folder, flush=True)
    sys.stdin.read()
"""
needs_fork = pytest.mark.skipif(not CAN_FORK, reason="processes are forked on Linux only")


def holder(home: Path, *words: str) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", HOLD, str(home), *words],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )


def told(process: "subprocess.Popen[str]") -> list[str]:
    assert process.stdout is not None
    return process.stdout.readline().split()


def test_a_folder_and_its_lock_are_there_only_while_they_are_used(tmp_path: Path) -> None:
    with staging_folder(tmp_path / "home") as one, staging_folder(tmp_path / "home") as other:
        assert one != other
        remove_unused(tmp_path / "home")
        assert (one.is_dir(), other.is_dir()) == (True, True)
    assert list((tmp_path / "home").iterdir()) == []
    remove_unused(tmp_path / "nowhere")


def test_what_a_killed_process_left_vanishes_and_what_is_used_stays(tmp_path: Path) -> None:
    with holder(tmp_path) as killed, holder(tmp_path) as living:
        left, used = Path(*told(killed)), Path(*told(living))
        remove_unused(tmp_path)
        assert (left.is_dir(), used.is_dir()) == (True, True)
        killed.kill()
        killed.wait()
        assert left.is_dir(), "it had no time to tidy up"
        remove_unused(tmp_path)
        assert (left.exists(), used.is_dir()) == (False, True)
        assert (used / "draft").read_text() == "half"
        assert not left.with_name(f"{left.name}.lock").exists()
        living.communicate("")
    assert list(tmp_path.iterdir()) == []


@needs_fork
def test_a_folder_is_in_use_as_long_as_a_forked_process_lives(tmp_path: Path) -> None:
    fcntl = pytest.importorskip("fcntl")  # Windows has none
    with holder(tmp_path, "fork") as parent:
        folder, child = told(parent)
        parent.kill()
        parent.wait()
        remove_unused(tmp_path)
        assert Path(folder).is_dir()
        os.kill(int(child), signal.SIGKILL)
        with Path(f"{folder}.lock").open() as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # waits for the end of the child
    remove_unused(tmp_path)
    assert list(tmp_path.iterdir()) == []


def left_by(home: Path, machine: str) -> Path:
    """Write what a killed marking leaves on a machine."""
    folder = home / f"{machine}-1-abcd"
    folder.mkdir(parents=True)
    folder.with_name(f"{folder.name}.lock").touch()
    return folder


def test_a_lock_of_another_user_stays_and_stops_nobody(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    theirs = left_by(tmp_path, staging.machine())
    opened = os.open

    def guarded(path: "str | Path", flags: int, mode: int = 0o777) -> int:
        if Path(path).name == f"{theirs.name}.lock":
            raise PermissionError(13, "Permission denied", str(path))
        return opened(path, flags, mode)

    monkeypatch.setattr(os, "open", guarded)
    remove_unused(tmp_path)
    assert theirs.is_dir()
    monkeypatch.undo()
    remove_unused(tmp_path)
    assert list(tmp_path.iterdir()) == []


def test_what_another_machine_of_a_share_writes_stays(tmp_path: Path) -> None:
    far = left_by(tmp_path, "0123456789ab")
    remove_unused(tmp_path)
    assert far.is_dir()
    with staging_folder(tmp_path) as own:
        assert own.name.startswith(f"{staging.machine()}-")


def test_folders_of_an_earlier_vrts_go_with_their_process(tmp_path: Path) -> None:
    ended = subprocess.Popen([sys.executable, "-c", ""])
    ended.wait()
    for name in (str(ended.pid), str(os.getpid()), "mine"):
        (tmp_path / name).mkdir()
    remove_unused(tmp_path)
    assert {path.name for path in tmp_path.iterdir()} == {str(os.getpid()), "mine"}
