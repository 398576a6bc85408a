"""`vrts prove` and `dispatch plan` on several cores: the same bytes, and Ctrl-C at a terminal."""

import json
import os
import select
import signal
import subprocess
import sys
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import TypeAlias

import pytest

from tests.places import ROOT
from tests.support_planted import planted
from tests.support_pty import PATIENCE, Child

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="workers are forks")

# of every verdict, and of every kind of what may go wrong
NAMES = (
    *("I01", "I02", "A06", "O04"),  # contacts, the last of several suspects
    *("I04", "A10", "P07"),  # run-time errors
    *("P01", "P06", "I06"),  # never ends
    *("P04", "Q04", "T15"),  # properties, a goal
    *("O08", "R19", "R02"),  # undetermined, and holds
)
CERTIFIED = ("T04", "O01")  # minutes of motion in all futures together
Held: TypeAlias = dict[Path, bytes]

TOLD = """
import hashlib, os, sys
from pathlib import Path
from click.testing import CliRunner
from tests.support_planted import planted
from vrts.cli.main import vrts

names, jobs, folder = sys.argv[1].split(), sys.argv[2], Path(sys.argv[3])
forks = []
os.register_at_fork(after_in_parent=lambda: forks.append(1))
for one in planted():
    if one.name not in names:
        continue
    own = folder / one.name
    own.mkdir()
    os.chdir(own)
    words = one.written(Path("."))
    for form in ("full", "json") if one.name in ("I02", "R02", "O08") else ("json",):
        bad = ("--counterexample", "bad.toml") if form == "json" else ()
        found = CliRunner().invoke(vrts, ["prove", *words, "--format", form, "--jobs", jobs, *bad])
        (own / form).write_text(found.stdout)
        (own / f"{form} stderr").write_text(found.stderr)
        (own / "status").write_text(str(found.exit_code))
print(len(forks))
"""


def told(folder: Path, names: tuple[str, ...], jobs: str, seed: str) -> tuple[Held, int]:
    """Return what is written of programs, by file, and how many processes were forked."""
    folder.mkdir()
    result = subprocess.run(
        [sys.executable, "-c", TOLD, " ".join(names), jobs, folder],
        capture_output=True,
        cwd=ROOT,
        env={**os.environ, "PYTHONHASHSEED": seed, "PYTHONPATH": str(ROOT)},
        check=False,
    )
    assert result.returncode == 0, result.stderr.decode()
    files = sorted(one for one in folder.rglob("*") if one.is_file())
    return {one.relative_to(folder): one.read_bytes() for one in files}, int(result.stdout)


@pytest.mark.thorough
def test_the_bytes_are_the_same_on_any_number_of_cores(tmp_path: Path) -> None:
    """Text, JSON, counterexamples, exit status; hashes are seeded differently, too."""
    (one, none), (two, some) = (told(tmp_path / k, NAMES, k, k) for k in ("1", "2"))
    assert one == two
    assert none == 0 < some
    found = [json.loads(one[Path(name, "json")]) for name in NAMES]
    assert {each["answer"] for each in found} == {"violated", "holds", "undetermined"}
    assert len({wrong["wrong"] for each in found for wrong in each["found"]}) >= 5
    assert sum(Path(name, "bad.toml") in one for name in NAMES) >= 10


@pytest.mark.thorough
def test_the_bytes_are_the_same_where_much_motion_is_certified(tmp_path: Path) -> None:
    """It is certified several times while the search goes on, on any number of cores."""
    every = [("1", "0"), ("2", "1"), ("3", "2"), ("2", "3")]
    found = [told(tmp_path / seed, CERTIFIED, jobs, seed) for jobs, seed in every]
    assert [held for held, _ in found[1:]] == [found[0][0]] * 3
    assert [forks > 8 for _, forks in found] == [False, True, True, True]


@contextmanager
def at_work(
    arguments: list[str], folder: Path, workers: int = 2
) -> Generator[tuple[Child, list[int]]]:
    """Start a command at a terminal; lend it and handles of its workers, once it has some."""
    child = Child(arguments, folder)
    try:
        yield child, [os.pidfd_open(pid) for pid in child.children(workers)]
    finally:
        child.close()


def all_ended(watched: list[int]) -> bool:
    """Return whether processes end; it waits for that."""
    ended = [bool(select.select([one], [], [], PATIENCE)[0]) for one in watched]
    for one in watched:
        os.close(one)
    return all(ended)


def test_ctrl_c_gives_replays_up_and_tells_what_is_known(tmp_path: Path) -> None:
    """Here something was confirmed before workers were asked, so the program goes wrong."""
    (one,) = (one for one in planted() if one.name == "T01")
    with at_work(["prove", *one.written(tmp_path), "--jobs", "2"], tmp_path) as (child, watched):
        child.send("\x03")
        child.expect("telling what is known so far")
        child.expect("violated")
        child.expect("not looked at")
        assert child.status() == 1
        assert all_ended(watched)


@pytest.mark.thorough
def test_ctrl_c_twice_leaves_a_search_that_others_certify_for(tmp_path: Path) -> None:
    """The first worker of this program is one that certifies while the search goes on."""
    (one,) = (one for one in planted() if one.name == "O01")
    words = ["prove", *one.written(tmp_path), "--jobs", "2"]
    with at_work(words, tmp_path, workers=1) as (child, watched):
        child.send("\x03")
        child.expect("telling what is known so far")
        child.send("\x03")
        assert child.status() == 130
        assert all_ended(watched)


@pytest.mark.thorough
def test_a_worker_that_is_killed_changes_nothing_of_a_proof(tmp_path: Path) -> None:
    (one,) = (one for one in planted() if one.name == "S07")
    words = ["prove", *one.written(tmp_path), "--jobs", "2"]
    with at_work(words, tmp_path) as (child, watched):
        signal.pidfd_send_signal(watched[0], signal.SIGKILL)
        child.expect("a worker process was ended by SIGKILL")
        child.expect("This can go wrong")
        assert child.status() == 1
        assert all_ended(watched)


@pytest.mark.thorough
def test_ctrl_c_ends_a_plan_and_its_workers(tmp_path: Path) -> None:
    program = str(ROOT / "examples" / "01-cans-on-bases" / "solution.v2")
    words = ["dispatch", "plan", program, "--profile", "mark2-val2", "-o", "x.bundle"]
    with at_work([*words, "--jobs", "2"], tmp_path) as (child, watched):
        child.send("\x03")
        assert child.status() == 130
        assert all_ended(watched)
    assert not (tmp_path / "x.bundle").exists()
