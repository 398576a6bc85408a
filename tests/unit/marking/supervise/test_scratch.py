"""Folders for a while: what a killed marking left vanishes with the next, what is used stays."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import pytest

from vrts.marking.supervise.scratch import scratch_folder

HOLD = """
import sys
from vrts.marking.supervise.scratch import scratch_folder
with scratch_folder() as folder:
    (folder / "name of a student").write_text("half")
    print(folder, flush=True)
    sys.stdin.read()
"""
pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="there names tell no user")


def holder(place: Path) -> "subprocess.Popen[str]":
    return subprocess.Popen(
        [sys.executable, "-c", HOLD],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        env={**os.environ, "TMPDIR": str(place)},
    )


def folder_of(process: "subprocess.Popen[str]") -> Path:
    assert process.stdout is not None
    return Path(process.stdout.readline().strip())


def test_what_a_killed_one_left_vanishes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    with holder(tmp_path) as killed, holder(tmp_path) as living:
        left, used = folder_of(killed), folder_of(living)
        killed.kill()
        killed.wait()
        assert left.is_dir()
        with scratch_folder() as own:
            assert not left.exists()
            assert (used.is_dir(), own.is_dir()) == (True, True)
            assert own.parent.stat().st_mode & 0o777 == 0o700
        living.communicate("")
    assert not used.exists()


@pytest.mark.parametrize("taken", ["open to all", "a link"])
def test_a_place_that_is_not_ours_alone_is_not_used(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, taken: str
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    home = tmp_path / f"vrts-of-{os.getuid()}"
    if taken == "a link":
        (tmp_path / "elsewhere").mkdir()
        home.symlink_to(tmp_path / "elsewhere")
    else:
        home.mkdir()
        home.chmod(0o777)
    with scratch_folder() as own:
        assert own.parent == tmp_path
    assert not own.exists()
    assert list(home.iterdir()) == []
