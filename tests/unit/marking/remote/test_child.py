"""The process that marks a shard ends with whoever started it, and leaves nothing behind."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from tests.unit.marking.remote.support import GOOD, task
from vrts.marking.marking import Entry
from vrts.marking.remote.child import ChildFailed, mark_in_child
from vrts.marking.remote.plan import make_plan
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.pipeline.files import CHECKOUT

WORKER = """
import sys
from pathlib import Path
from vrts.marking.remote.child import mark_in_child
mark_in_child(Path(sys.argv[1]).read_bytes(), 600.0)
"""
SOON = 5.0  # [s]


@pytest.fixture(scope="module")
def shard(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Return a shard that takes much longer than `SOON`."""
    marker = Marker(Place(task(tmp_path_factory.mktemp("home") / "lab")), Wanted(pages=False))
    entries = [Entry(f"n{k}", f"n{k}.v2", GOOD) for k in range(150)]
    return make_plan(marker, entries, 1).cuts[0].data


def marking(worker: psutil.Process) -> list[psutil.Process]:
    """Return the processes that mark for a worker, once they have begun with programs."""
    end = time.monotonic() + 30.0
    while time.monotonic() < end:
        found = worker.children(recursive=True)
        if len(found) > 1:
            return found
        time.sleep(0.01)
    raise AssertionError("nothing is marked")


@pytest.mark.thorough
@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells when a parent has ended")
def test_nothing_outlives_a_worker_that_is_killed(shard: bytes, tmp_path: Path) -> None:
    (tmp_path / "shard.json").write_bytes(shard)
    home = tmp_path / "temporary"
    home.mkdir()
    worker = subprocess.Popen(
        [sys.executable, "-c", WORKER, str(tmp_path / "shard.json")],
        env={**os.environ, "TMPDIR": str(home)},
        cwd=CHECKOUT,
    )
    found = marking(psutil.Process(worker.pid))
    assert any(home.iterdir())
    worker.send_signal(signal.SIGKILL)
    worker.wait()
    _, left = psutil.wait_procs(found, timeout=SOON)
    assert left == []
    (own,) = home.iterdir()
    assert own.name.startswith("vrts-of-"), "where the next marking looks for what is left"
    assert list(own.iterdir()) == []


def test_a_shard_that_takes_too_long_is_ended(
    shard: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("vrts.marking.remote.child._START_S", 0.0)
    others = psutil.Process().children(recursive=True)
    before = time.monotonic()
    with pytest.raises(ChildFailed, match="was not marked in time"):
        mark_in_child(shard, 1.5)
    assert time.monotonic() - before < 1.5 + SOON
    assert set(psutil.Process().children(recursive=True)) <= set(others)
