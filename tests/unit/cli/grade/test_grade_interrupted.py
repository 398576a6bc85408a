"""Marking that ends early: Ctrl-C says how far it was; what is written can be purged at once."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.support_commands import vrts_text
from vrts.cli.main import vrts
from vrts.pipeline.files import CHECKOUT

VRTS = str(Path(sys.prefix) / "bin" / "vrts")
EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
GOOD = (EXAMPLE / "solution.v2").read_text()
SLOW = ".PROGRAM main\n x = 0\n10 x = x+1\nGOTO 10\n.END\n"
MANY = 40  # so slow ones that nobody waits until all are marked


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """Return a folder with a task, and a class that takes long, the first apart."""
    shutil.copytree(EXAMPLE, tmp_path / "task", ignore=shutil.ignore_patterns("submissions"))
    place = tmp_path / "download"
    place.mkdir()
    (place / "anna.v2").write_text(GOOD)
    for k in range(MANY):
        (place / f"ben{k}.v2").write_text(f"; {k}\n{SLOW}")
    return tmp_path


def only_anna(home: Path) -> None:
    """Take all others out of the class."""
    for path in (home / "download").glob("ben*.v2"):
        path.unlink()


COUNT = rf"interrupted: (1 of {MANY + 1} is|([2-9]|[1-3]\d|40) of {MANY + 1} are) marked; "


def ended_early(home: Path, number: int, *options: str) -> "subprocess.CompletedProcess[str]":
    """Mark until there is a row, then send a signal to the whole group, as terminals do."""
    command = [VRTS, "grade", "task", "download", "--jobs", "1", "--no-pages", *options]
    with subprocess.Popen(
        command,
        cwd=home,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    ) as process:
        assert process.stdout is not None
        first = process.stdout.readline()
        os.killpg(process.pid, number)
        out, err = process.communicate(timeout=60)
        return subprocess.CompletedProcess(command, process.wait(), first + out, err)


def purge(home: Path, *words: str) -> Result:
    return CliRunner().invoke(vrts, ["purge", str(home / "out"), *words])


@pytest.mark.thorough
def test_ctrl_c_says_how_far_it_was_and_the_same_call_goes_on(home: Path) -> None:
    told = ended_early(home, signal.SIGINT, "-o", "out")
    assert told.returncode == 130, told.stderr
    assert "10.0  anna" in told.stdout
    assert re.fullmatch(COUNT + "the same call goes on\n", told.stderr)
    assert not list((home / "out" / "staff" / ".staging").iterdir())
    evidence = CliRunner().invoke(
        vrts, ["grade", "evidence", "anna", "--from", str(home / "out"), "-o", str(home / "e.zip")]
    )
    assert evidence.exit_code == 1
    assert "note: it goes on, or was interrupted: the same call goes on" in evidence.stderr

    only_anna(home)
    made = (home / "out" / "students" / "anna" / "result.json").stat().st_mtime_ns
    again = vrts_text("grade", "task", "download", "--no-pages", "-o", "out", cwd=home)
    assert again.returncode == 0, again.stderr
    assert (home / "out" / "students" / "anna" / "result.json").stat().st_mtime_ns == made
    about = json.loads((home / "out" / "staff" / "marking.json").read_text())
    assert about["begun"] < about["finished"]


@pytest.mark.thorough
def test_without_a_folder_nothing_is_kept(home: Path) -> None:
    told = ended_early(home, signal.SIGINT)
    assert told.returncode == 130
    assert re.fullmatch(COUNT + "nothing is kept without `-o`\n", told.stderr)


@pytest.mark.thorough
def test_what_a_killed_marking_left_can_be_purged(home: Path) -> None:
    told = ended_early(home, signal.SIGKILL, "-o", "out")
    assert told.returncode == -signal.SIGKILL
    assert (home / "out" / "students" / "anna" / "result.json").is_file()
    young = purge(home, "--older-than", "1d", "-y")
    assert "begun, and not ended, today, not old enough" in young.stdout
    kept = purge(home, "--older-than", "0d", "-y", "--keep-statistics")
    assert kept.exit_code == 1
    assert "there is no `results.json` to make statistics of" in kept.stderr
    assert (home / "out" / "students" / "anna").is_dir()
    assert purge(home, "--older-than", "0d", "-y").exit_code == 0
    assert not (home / "out").exists()


def test_what_was_merged_can_be_purged(home: Path) -> None:
    only_anna(home)
    for words in (
        ("plan", "task", "download", "--no-pages"),
        ("run", "plan/shards/shard-01.json"),
        ("merge", "plan", "shard-01.zip", "-o", "out"),
    ):
        done = vrts_text("grade", *words, cwd=home)
        assert done.returncode == 0, done.stderr
    assert (home / "out" / "students" / "anna" / "result.json").is_file()
    assert "Cans on bases, marked today" in purge(home, "--older-than", "1d").stdout
    (home / "shard-01.zip").unlink()
    merged = vrts_text("grade", "merge", "plan", "-o", "part", cwd=home)
    assert merged.returncode == 1, "the only result is missing"
    part = CliRunner().invoke(vrts, ["purge", str(home / "part"), "--older-than", "1d"])
    assert "Cans on bases, begun, and not ended, today" in part.stdout
    assert purge(home, "--older-than", "0d", "-y").exit_code == 0
    assert not (home / "out").exists()
