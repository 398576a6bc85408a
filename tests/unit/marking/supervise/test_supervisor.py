"""Real hogs, hangs, crashes and liars among those that do their work."""

import ctypes
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import psutil
import pytest

from tests.places import ROOT
from vrts.marking.supervise.limits import Limits, impose
from vrts.marking.supervise.outcome import Answer, Loss, Lost
from vrts.marking.supervise.supervisor import CAN_FORK, Finished, Supervisor

LIMITS = Limits(cpu_s=1, wall_s=5.0, memory=400_000_000, file=1_000_000, files=64, answer=100_000)
# where processes can be forked, what starts anew is shown in `--all`
SPAWNED = (pytest.mark.thorough,) if CAN_FORK else ()
WAYS = [pytest.param(False, id="spawned", marks=SPAWNED)]
if CAN_FORK:
    WAYS.append(pytest.param(True, id="forked"))


class Deed(NamedTuple):
    """What a process is to do."""

    number: int
    what: str


def do(what: str, folder: Path) -> bytes:
    """Do a deed."""
    match what:
        case "hog":
            return bytes(len(bytearray(900_000_000)))
        case "grow":
            (folder.parent.parent / "grows").write_text(str(os.getpid()))
            found: list[bytearray] = []
            while True:
                found.append(bytearray(b"x") * 8_000_000)
        case "loop":
            while True:
                pass
        case "nap":  # until whoever grows was ended: then both were looked at
            (folder.parent.parent / "naps").touch(exist_ok=False)  # not again, where it was ended
            place = folder.parent.parent / "grows"
            while not place.exists() or not place.read_text() or goes_on(int(place.read_text())):
                time.sleep(0.01)
        case "hang":
            time.sleep(60)
        case "segfault":
            ctypes.string_at(0)
        case "flood":
            return b"x" * 10_000_000
        case "children":
            child = subprocess.Popen([sys.executable, "-c", "import time; time.sleep(60)"])
            (folder.parent.parent / "grandchild").write_text(str(child.pid))
            time.sleep(60)
        case "big file":
            with (folder / "big").open("wb") as file:
                for _ in range(100):
                    file.write(bytes(100_000))
        case "raise":
            raise ValueError("no reason")
        case "stop itself":
            os.kill(os.getpid(), signal.SIGSTOP)
        case _:
            (folder / "note.txt").write_text(what)
    return what.encode()


def goes_on(number: int) -> bool:
    """Return whether there is a process of this number, or one that nobody has waited for."""
    try:
        os.kill(number, 0)
    except ProcessLookupError:
        return False
    return True


class Doer:
    """Does deeds."""

    def __init__(self) -> None:
        self.warm = 0

    def warm_up(self) -> None:
        """Count."""
        self.warm += 1

    def rest(self) -> None:
        """Keep nothing."""

    def work(self, order: Deed, folder: Path) -> bytes:
        """Do it."""
        return do(order.what, folder)

    def command(self, order: Deed, folder: Path) -> tuple[list[str], bytes]:
        """Return this file as a command."""
        data = json.dumps({"what": order.what, "folder": str(folder)}).encode()
        return [sys.executable, "-m", "tests.unit.marking.supervise.test_supervisor"], data


def run(
    tmp_path: Path, *deeds: str, fork: bool, limits: Limits = LIMITS
) -> dict[str, Finished[Deed]]:
    """Do deeds under supervision."""
    supervisor = Supervisor(Doer(), tmp_path / "staging", jobs=3, limits=limits, fork=fork)
    orders = [Deed(k, what) for k, what in enumerate(deeds)]
    found = {done.order.what: done for done in supervisor.run(orders)}
    assert found.keys() == set(deeds)
    assert not any((tmp_path / "staging").iterdir()), "every folder is emptied"
    return found


@pytest.fixture(autouse=True)
def _home(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONPATH", str(ROOT))


@pytest.mark.thorough
@pytest.mark.parametrize("fork", WAYS)
def test_answers_come_back_and_losses_are_told_apart(tmp_path: Path, fork: bool) -> None:
    deeds = ["good", "hog", "segfault", "flood", "raise", "loop", "big file", "fine"]
    found = run(tmp_path, *deeds, fork=fork)
    assert found["good"].outcome == Answer(b"good")
    assert found["fine"].outcome == Answer(b"fine")
    lost = {what: done.outcome for what, done in found.items() if isinstance(done.outcome, Lost)}
    assert {what: end.loss for what, end in lost.items()} == {
        "hog": Loss.MEMORY,
        "segfault": Loss.CRASH,
        "flood": Loss.ANSWER,
        "raise": Loss.ANSWER,
        "loop": Loss.TIME,
        "big file": Loss.ANSWER,
    }
    assert "no reason" in lost["raise"].detail
    assert "Segmentation fault" in lost["segfault"].detail
    assert "File too large" in lost["big file"].detail


@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_what_a_parent_has_loaded_is_not_counted(tmp_path: Path) -> None:
    loaded = bytearray(b"x") * (LIMITS.memory + 50_000_000)
    limits = replace(LIMITS, cpu_s=10, wall_s=60.0)
    found = run(tmp_path, "nap", "grow", fork=True, limits=limits)
    assert len(loaded) > LIMITS.memory
    assert found["nap"].outcome == Answer(b"nap")
    assert isinstance(found["grow"].outcome, Lost)
    assert found["grow"].outcome.loss is Loss.MEMORY


@pytest.mark.parametrize("fork", WAYS)
def test_whoever_takes_too_long_is_ended_with_all_it_started(tmp_path: Path, fork: bool) -> None:
    limits = replace(LIMITS, wall_s=2.0 if fork else 12.0)  # what is begun anew loads first
    found = run(tmp_path, "hang", "children", "stop itself", fork=fork, limits=limits)
    ends = {
        what: done.outcome.loss for what, done in found.items() if isinstance(done.outcome, Lost)
    }
    assert ends == {
        "hang": Loss.WALL,
        "children": Loss.WALL,
        "stop itself": Loss.WALL,
    }
    grandchild = int((tmp_path / "grandchild").read_text())
    assert not psutil.pid_exists(grandchild) or psutil.Process(grandchild).status() == "zombie"


@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_memory_taken_bit_by_bit_is_noticed(tmp_path: Path) -> None:
    begun = psutil.Process().memory_info().rss
    done = run(tmp_path, "grow", fork=True, limits=replace(LIMITS, cpu_s=10))["grow"]
    assert isinstance(done.outcome, Lost)
    assert done.outcome.loss is Loss.MEMORY
    assert 350_000_000 < done.peak < begun + 1_000_000_000


@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_who_is_lost_beside_others_may_try_once_more_alone(tmp_path: Path) -> None:
    class Moody(Doer):
        def work(self, order: Deed, folder: Path) -> bytes:
            mark = tmp_path / "tried"
            if order.what == "moody" and not mark.exists():
                mark.touch()
                ctypes.string_at(0)
            return b"done"

    worker = Moody()
    supervisor = Supervisor(worker, tmp_path / "staging", jobs=2, limits=LIMITS, fork=True)
    found = list(supervisor.run([Deed(0, "moody"), Deed(1, "good")]))
    assert [(done.order.what, done.outcome) for done in found] == [
        ("good", Answer(b"done")),
        ("moody", Answer(b"done")),
    ]
    assert worker.warm == 1


@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_a_supervisor_that_is_left_ends_its_processes(tmp_path: Path) -> None:
    supervisor = Supervisor(Doer(), tmp_path / "staging", jobs=3, limits=LIMITS, fork=True)
    others = {child.pid for child in psutil.Process().children()}  # of other tests
    finished = supervisor.run([Deed(0, "hang"), Deed(1, "hang"), Deed(2, "good")])
    assert next(finished).order.what == "good"
    ours = {child.pid for child in psutil.Process().children()} - others
    assert ours
    finished.close()
    assert not ours & {child.pid for child in psutil.Process().children()}


ORPHAN = """
import sys
from pathlib import Path
from tests.unit.marking.supervise.test_supervisor import Deed, Doer
from vrts.marking.supervise.supervisor import Supervisor
deeds = [Deed(0, "good"), Deed(1, "hang")]
for done in Supervisor(Doer(), Path(sys.argv[1])).run(deeds):
    print(done.order.what, flush=True)
"""


@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_no_child_outlives_a_parent_that_is_killed(tmp_path: Path) -> None:
    command = [sys.executable, "-c", ORPHAN, str(tmp_path)]
    parent = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert parent.stdout is not None
    assert parent.stdout.readline() == "good\n"
    deadline = time.monotonic() + 10.0
    while not (children := psutil.Process(parent.pid).children()):
        assert time.monotonic() < deadline
    parent.kill()
    parent.wait()
    parent.stdout.close()
    while any(child.is_running() and child.status() != "zombie" for child in children):
        assert time.monotonic() < deadline
        time.sleep(0.02)


@pytest.mark.skipif(not CAN_FORK, reason="nothing is forked here")
def test_a_child_inherits_no_open_file(tmp_path: Path) -> None:
    class Looker(Doer):
        def work(self, order: Deed, folder: Path) -> bytes:
            return " ".join(
                sorted(os.readlink(f"/proc/self/fd/{n}") for n in (0, 1, 2))
            ).encode() + (str(len(os.listdir("/proc/self/fd"))).encode())

    with (tmp_path / "secret").open("w") as secret:
        assert secret.fileno() > 2
        supervisor = Supervisor(Looker(), tmp_path / "staging", limits=LIMITS, fork=True)
        (done,) = supervisor.run([Deed(0, "look")])
    assert isinstance(done.outcome, Answer)
    words = done.outcome.data.decode()
    assert words.startswith("/dev/null ")
    assert words.count("child.log") == 2
    assert words.endswith("5")  # input, log twice, the way to the parent, the folder it looks into


def _main() -> None:
    order = json.loads(sys.stdin.buffer.read())
    impose(LIMITS)
    import faulthandler

    faulthandler.enable()
    try:
        answer = do(order["what"], Path(order["folder"]))
    except MemoryError:
        sys.exit(71)
    sys.stdout.buffer.write(answer)


if __name__ == "__main__":
    _main()


@pytest.mark.skipif(not CAN_FORK, reason="processes are started anew here")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_who_is_interrupted_while_a_process_begins_leaves_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    begun: list[int] = []
    fork = os.fork

    def interrupted() -> int:
        pid = fork()
        if pid:
            begun.append(pid)
            signal.raise_signal(number)
        return pid

    def end(number: int, frame: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fork", interrupted)
    before = signal.signal(number, end)
    try:
        with pytest.raises(KeyboardInterrupt):
            list(Supervisor(Doer(), tmp_path / "staging", limits=LIMITS).run([Deed(1, "hang")]))
    finally:
        signal.signal(number, before)
    assert len(begun) == 1
    assert not psutil.pid_exists(begun[0])
    assert not list((tmp_path / "staging").iterdir())
