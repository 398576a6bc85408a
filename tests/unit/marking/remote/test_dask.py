"""A class marked on a real cluster of two worker processes, one of which is killed."""

import io
import shutil
import signal
import subprocess
import sys
import time
import zipfile
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import dask.config
import psutil
import pytest
from distributed import LocalCluster

from tests.unit.marking import proven_task
from tests.unit.marking.remote.support import CLASS, GOOD, configured, files, task
from vrts import __version__
from vrts.base.diagnostic import Diagnostic
from vrts.base.zips import packed
from vrts.marking.layout import Layout
from vrts.marking.marking import Entry, mark_class
from vrts.marking.remote import dask_cluster
from vrts.marking.remote import mark_on_dask as mark_on_dask_module
from vrts.marking.remote.backend import Backend, Scheduler, read_backend
from vrts.marking.remote.child import ChildFailed, mark_in_child
from vrts.marking.remote.dask_cluster import DaskCluster, Outcome, queue_cluster
from vrts.marking.remote.mark_on_dask import mark_on_dask
from vrts.marking.remote.plan import make_plan
from vrts.marking.remote.run_shard import run_shard
from vrts.marking.remote.shard import Cut, read_shard
from vrts.marking.result import Kind, from_bytes
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

MANY = tuple(Entry(f"n{k}", f"n{k}.v2", GOOD) for k in range(7))
NOWHERE = Backend(Scheduler.DASK, "tcp://127.0.0.1:9")


class Workers(NamedTuple):
    """A cluster, and how to reach it."""

    cluster: LocalCluster
    backend: Backend

    def processes(self) -> list[psutil.Process]:
        """Return the worker processes."""
        return [psutil.Process(nanny.pid) for nanny in self.cluster.workers.values()]

    def busy(self) -> psutil.Process:
        """Return a worker that is at work."""
        end = time.monotonic() + 30.0
        while time.monotonic() < end:
            for worker in self.processes():
                for child in worker.children():
                    if "vrts.marking.remote.alone" in child.cmdline():
                        return worker
            time.sleep(0.01)
        raise AssertionError("no worker is at work")


def start(folder: Path, count: int = 2) -> LocalCluster:
    return LocalCluster(
        n_workers=count,
        threads_per_worker=1,
        processes=True,
        host="127.0.0.1",
        dashboard_address="127.0.0.1:0",
        silence_logs=50,
        local_directory=str(folder),
    )


@pytest.fixture
def workers(tmp_path: Path) -> Iterator[Workers]:
    """Yield a cluster of two worker processes."""
    cluster = start(tmp_path / "dask")
    yield Workers(cluster, read_backend(f"dask:{cluster.scheduler_address}"))
    cluster.close()


@pytest.fixture(scope="module")
def marker(tmp_path_factory: pytest.TempPathFactory) -> Marker:
    """Return the marker of a task with a hidden check."""
    home = tmp_path_factory.mktemp("home")
    return Marker(Place(task(home / "lab")), Wanted(pages=False))


@pytest.mark.thorough
def test_a_worker_that_dies_costs_nothing(workers: Workers, marker: Marker, tmp_path: Path) -> None:
    said: list[Diagnostic] = []
    entries = (*CLASS, *MANY)
    out = Layout(tmp_path / "out")
    found = mark_on_dask(marker, entries, out, workers.backend, size=3, said=said.append)
    done = [next(found), next(found), next(found)]  # two of them are no programs
    workers.busy().kill()
    done += found
    assert said == []
    assert sorted(d.entry.identifier for d in done) == sorted(e.identifier for e in entries)
    assert all(d.entry in entries for d in done)
    list(mark_class(marker, entries, Layout(tmp_path / "here"), jobs=2))
    assert files(tmp_path / "out") == files(tmp_path / "here")
    again = list(mark_on_dask(marker, entries, out, NOWHERE))
    assert [d.entry.identifier for d in again if not d.reused] == ["dora", "gina"]


@pytest.mark.thorough
def test_every_future_is_proven_elsewhere_as_at_home(workers: Workers, tmp_path: Path) -> None:
    place = str(proven_task.written(tmp_path / "lab") / "task.toml")
    marker = Marker(Place(place), Wanted(pages=True))
    texts = (proven_task.GOOD, proven_task.FITTED)
    entries = [Entry(f"s{k}", f"s{k}.v2", texts[k % 2].encode()) for k in range(6)]
    said: list[Diagnostic] = []
    far = Layout(tmp_path / "out")
    done = list(mark_on_dask(marker, entries, far, workers.backend, size=2, said=said.append))
    assert said == []
    list(mark_class(marker, entries, Layout(tmp_path / "here"), jobs=2))
    assert files(tmp_path / "out") == files(tmp_path / "here")
    marks = {one.entry.identifier: one.result.mark for one in done}
    assert {marks[f"s{k}"] for k in (0, 2, 4)} == {10.0}
    (fitted,) = {marks[f"s{k}"] for k in (1, 3, 5)}
    assert fitted is not None
    assert fitted <= 7.0


@pytest.mark.thorough
def test_a_shard_that_kills_workers_is_marked_here(marker: Marker, tmp_path: Path) -> None:
    with dask.config.set({"distributed.scheduler.allowed-failures": 0}):
        cluster = start(tmp_path / "dask")
    workers = Workers(cluster, Backend(Scheduler.DASK, cluster.scheduler_address))
    said: list[Diagnostic] = []
    found = mark_on_dask(marker, MANY, None, workers.backend, size=2, said=said.append)
    done = [next(found)]
    workers.busy().kill()
    done += found
    cluster.close()
    assert [d.rule.code for d in said] == ["V729"]
    assert said[0].notes == ("the cluster gave no results: the workers that marked it died",)
    assert {d.entry for d in done} == set(MANY)
    assert {d.result.kind for d in done} == {Kind.GRADED}


@pytest.mark.thorough
def test_a_scheduler_that_goes_away_costs_nothing(
    workers: Workers, marker: Marker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dask_cluster, "CONNECT_S", 1.0)
    said: list[Diagnostic] = []
    found = mark_on_dask(marker, MANY, None, workers.backend, size=2, said=said.append)
    done = [next(found)]
    workers.cluster.close()
    done += found
    assert {d.rule.code for d in said} == {"V729"}
    assert {d.entry for d in done} == set(MANY)
    assert {d.result.mark for d in done} == {done[0].result.mark}


def test_a_scheduler_that_does_not_answer_is_told(
    marker: Marker, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dask_cluster, "CONNECT_S", 0.5)
    with pytest.raises(Refused) as refused:
        list(mark_on_dask(marker, MANY, None, NOWHERE))
    (finding,) = refused.value.diagnostics
    assert finding.rule.code == "V727"
    assert finding.headline == "no Dask scheduler answers at `tcp://127.0.0.1:9`"


@pytest.mark.thorough
def test_a_cluster_without_workers_is_not_waited_for(
    marker: Marker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dask_cluster, "ALONE_S", 0.2)
    monkeypatch.setattr(dask_cluster, "_COUNT", 0.1)
    cluster = start(tmp_path, 0)
    backend = Backend(Scheduler.DASK, cluster.scheduler_address)
    said: list[Diagnostic] = []
    done = list(mark_on_dask(marker, MANY[:2], None, backend, said=said.append))
    cluster.close()
    assert [d.notes[0] for d in said] == ["the cluster gave no results: no worker came"]
    assert {d.result.kind for d in done} == {Kind.GRADED}


class Spoiled:
    """A cluster that marks, and damages a page of one submission in every shard on the way."""

    def __init__(self, _backend: Backend, _jobs: int) -> None:
        """Start nothing."""

    def __enter__(self) -> "Spoiled":
        return self

    def __exit__(self, *_: object) -> None:
        """Stop nothing."""

    def run(self, cuts: Sequence[Cut]) -> Iterator[Outcome]:
        """Yield what comes home."""
        for cut in cuts:
            with TemporaryDirectory() as work:
                results = run_shard(read_shard(cut.data), cut.data, Path(work))
            with zipfile.ZipFile(io.BytesIO(results)) as archive:
                members = {name: archive.read(name) for name in archive.namelist()}
            members[f"{cut.names[0].pseudonym}/student/result.json"] = b"{}"
            yield Outcome(cut, packed(members, 0o600))


@pytest.mark.thorough
@pytest.mark.parametrize("here", [True, False], ids=["marked here", "lost"])
def test_one_refused_row_costs_no_other(
    here: bool, marker: Marker, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    again: list[int] = []

    def child(data: bytes, _longest_s: float, _jobs: int) -> bytes:
        again.append(len(read_shard(data).pieces))
        if not here:
            raise ChildFailed("it is broken")
        return run_shard(read_shard(data), data, tmp_path / "work")

    monkeypatch.setattr(dask_cluster, "DaskCluster", Spoiled)
    monkeypatch.setattr(mark_on_dask_module, "mark_in_child", child)
    said: list[Diagnostic] = []
    out = Layout(tmp_path / "out")
    done = list(mark_on_dask(marker, MANY[:3], out, NOWHERE, size=3, said=said.append))
    assert sorted(one.entry.identifier for one in done) == ["n0", "n1", "n2"]
    assert again == [1], "only what is missing is marked again"
    assert [d.headline for d in said] == [
        "1 submission is marked on this machine and not on the cluster"
    ]
    kinds = {one.entry.identifier: one.result.kind for one in done}
    assert kinds == {
        "n0": Kind.GRADED if here else Kind.RESOURCE,
        "n1": Kind.GRADED,
        "n2": Kind.GRADED,
    }
    for one in done:
        assert (
            from_bytes((out.grader(one.entry.identifier) / "result.json").read_bytes())
            == one.result
        )


def test_a_worker_with_another_vrts_says_so(marker: Marker) -> None:
    data = make_plan(marker, MANY[:1], 1).cuts[0].data
    other = data.replace(f'"vrts":"{__version__}"'.encode(), b'"vrts":"9.9.9"')
    with pytest.raises(ChildFailed, match=r"^the shard is for vrts 9\.9\.9, and this is vrts"):
        mark_in_child(other, 60.0)


INTERRUPT = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may have started us deaf to it
from vrts.marking.remote.backend import Scheduler
from vrts.marking.remote.dask_cluster import queue_cluster
from vrts.pipeline.refused import Refused
try:
    queue_cluster(Scheduler.SLURM)
except Refused:
    signal.raise_signal(signal.SIGINT)
"""


@pytest.mark.thorough
def test_ctrl_c_interrupts_also_with_queues_loaded() -> None:
    told = subprocess.run(
        [sys.executable, "-c", INTERRUPT], capture_output=True, text=True, check=False
    )
    assert "KeyboardInterrupt\n" in told.stderr
    assert told.returncode == -signal.SIGINT


JOB = {"cores": 2, "memory": "4GB", "processes": 1, "interface": "lo"}


def test_jobs_of_slurm_are_as_dask_is_configured() -> None:
    ours = {**JOB, "queue": "teaching", "walltime": "00:20:00", "account": "robotics"}
    with configured(Scheduler.SLURM, ours):
        cluster = queue_cluster(Scheduler.SLURM)
        script = cluster.job_script()
        cluster.close()
    for line in (
        "#SBATCH -p teaching",
        "#SBATCH -A robotics",
        "#SBATCH --cpus-per-task=2",
        "#SBATCH --mem=4G",
        "#SBATCH -t 00:20:00",
    ):
        assert line in script.splitlines()
    assert "distributed.cli.dask_worker tcp://127.0.0.1:" in script


def test_jobs_of_htcondor_are_as_dask_is_configured() -> None:
    with configured(Scheduler.HTCONDOR, {**JOB, "disk": "2GB"}):
        cluster = queue_cluster(Scheduler.HTCONDOR)
        script = cluster.job_script()
        cluster.close()
    assert "RequestCpus = MY.DaskWorkerCores" in script
    assert "MY.DaskWorkerDisk = 2000000000" in script
    assert "distributed.cli.dask_worker tcp://127.0.0.1:" in script


@pytest.mark.parametrize("scheduler", [Scheduler.SLURM, Scheduler.HTCONDOR])
def test_a_queue_that_is_not_configured_is_told(scheduler: Scheduler) -> None:
    with pytest.raises(Refused) as refused:
        queue_cluster(scheduler)
    (finding,) = refused.value.diagnostics
    assert finding.rule.code == "V727"
    assert f"Dask is not configured for {scheduler.value}" in finding.headline
    assert "jobqueue.yaml" in finding.help[0]


@pytest.mark.skipif(shutil.which("condor_submit") is not None, reason="HTCondor is installed")
def test_a_machine_without_a_queue_is_told() -> None:
    with pytest.raises(Refused) as refused:
        DaskCluster(Backend(Scheduler.HTCONDOR), 1)
    assert "there is no command `condor_submit`" in refused.value.diagnostics[0].headline


def test_backends_are_read() -> None:
    assert read_backend("dask") == Backend(Scheduler.DASK)
    assert read_backend("dask:tcp://10.0.0.1:8786").address == "tcp://10.0.0.1:8786"
    assert read_backend("dask:node7:8786").address == "node7:8786"
    assert read_backend("dask:tls://[::1]:8786").address == "tls://[::1]:8786"
    assert read_backend("slurm").scheduler.has_a_queue
    for text in ("", "ray", "dask:", "dask:node7", "slurm:node7:1", "dask:tcp://a b:1"):
        with pytest.raises(CannotRead):
            read_backend(text)


@pytest.mark.thorough
def test_workers_of_our_own_listen_to_nobody_else(marker: Marker, tmp_path: Path) -> None:
    out = Layout(tmp_path)
    found = mark_on_dask(marker, MANY, out, read_backend("dask"), jobs=2, size=2)
    done = [next(found)]
    listening = [c for c in psutil.Process().net_connections() if c.status == psutil.CONN_LISTEN]
    done += found
    assert {c.laddr.ip for c in listening} == {"127.0.0.1"}
    assert {d.entry for d in done} == set(MANY)
    assert not any(out.staging.iterdir())
