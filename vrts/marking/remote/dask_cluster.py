"""The door to Dask: gives shards to the workers of a cluster.

The scheduler keeps the shards, so whatever a worker was doing when it died another one does again.
Workers run nothing but `mark_in_child`. Dask starts threads: nothing is forked beside it.
"""

import logging
import shutil
import signal
import time
import warnings
from collections.abc import Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import ExitStack, suppress
from tempfile import TemporaryDirectory
from types import TracebackType
from typing import TYPE_CHECKING, NamedTuple

import dask.config
from distributed import Client, Future, KilledWorker, LocalCluster, as_completed

from vrts.base.diagnostic import Rule, error
from vrts.marking.remote.backend import Backend, Scheduler
from vrts.marking.remote.child import mark_in_child
from vrts.marking.remote.shard import Cut
from vrts.pipeline.refused import Refused

if TYPE_CHECKING:
    from dask_jobqueue import JobQueueCluster

NO_CLUSTER = Rule("V727", "no-cluster")

LOCAL = "127.0.0.1:0"  # where the dashboard is: not for other machines
CONNECT_S = 20.0  # to wait for a scheduler
ALONE_S = 300.0  # to wait for a worker where none has to queue
_LOOK = 0.05  # [s] between looks at what is done
_COUNT = 5.0  # [s] between looks at who works
_SUBMIT = {Scheduler.SLURM: "sbatch", Scheduler.HTCONDOR: "condor_submit"}  # commands


class Outcome(NamedTuple):
    """A shard that is over."""

    cut: Cut
    results: bytes | None  # the zip; None: there is none
    words: str = ""  # why not


class DaskCluster:
    """Workers that mark shards."""

    def __init__(self, backend: Backend, workers: int) -> None:
        """Connect to a cluster, or start one of our own.

        Args:
            backend: Which.
            workers: How many to start, where they are ours to start.

        Raises:
            Refused: It cannot be had.
        """
        self._queue = backend.scheduler.has_a_queue
        self._left = ExitStack()  # what ends with this
        address = backend.address or dask.config.get("scheduler-address", None)
        cluster: JobQueueCluster | LocalCluster | None = None
        if self._queue:
            _require_command(backend.scheduler)
            cluster = queue_cluster(backend.scheduler)
            self._left.callback(cluster.close)
            cluster.scale(jobs=workers)
        elif address is None:
            folder = self._left.enter_context(TemporaryDirectory(prefix="vrts-"))
            cluster = _own_workers(workers, folder)
            self._left.callback(cluster.close)
        try:
            self._client = Client(cluster or address, timeout=CONNECT_S, set_as_default=False)
        except (OSError, ValueError) as problem:
            self._left.close()
            raise _refused(f"no Dask scheduler answers at `{address}`", _START) from problem

    def __enter__(self) -> "DaskCluster":
        """Nothing more to do."""
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        value: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        """Leave the cluster; what was started for this ends."""
        with suppress(OSError), self._left:  # whoever is gone need not be told that we go
            self._client.close()

    def run(self, cuts: Sequence[Cut]) -> Iterator[Outcome]:
        """Yield every shard as it is over, with its results or without."""
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", message="Sending large graph")
            futures = {self._submit(cut): cut for cut in cuts}
        done = as_completed(list(futures), loop=self._client.loop)
        counted = worked = time.monotonic()
        words = "no worker came"
        try:
            while not done.is_empty():
                if done.has_ready():
                    future = next(done)
                    yield _outcome(future, futures.pop(future))
                    future.release()
                    continue
                time.sleep(_LOOK)
                now = time.monotonic()
                if now - counted < _COUNT:
                    continue
                counted = now
                try:
                    worked = now if self._client.nthreads() else worked
                except OSError:
                    words = "the scheduler is gone"
                    break
                if now - worked > ALONE_S and not self._queue:
                    break
            for cut in futures.values():
                yield Outcome(cut, None, words)
        finally:
            with suppress(OSError):  # where the scheduler is gone there is nothing to give up
                self._client.cancel(list(futures), force=True)

    def _submit(self, cut: Cut) -> "Future[bytes]":
        return self._client.submit(mark_in_child, cut.data, cut.longest_s, pure=False)


def queue_cluster(scheduler: Scheduler) -> "JobQueueCluster":
    """Return the cluster of a queueing system, from Dask's own configuration; no job is queued yet.

    Raises:
        Refused: The configuration does not say what a job needs.
    """
    kinds = _queue_clusters()
    name = scheduler.value
    wanted = ("cores", "memory", "disk") if scheduler is Scheduler.HTCONDOR else ("cores", "memory")
    missing = [key for key in wanted if dask.config.get(f"jobqueue.{name}.{key}", None) is None]
    if missing:
        headline = f"Dask is not configured for {name}: it has no `{missing[0]}`"
        raise _refused(headline, _example(name))
    options = dask.config.get(f"jobqueue.{name}.scheduler-options", {})
    return kinds[scheduler](scheduler_options={"dashboard_address": LOCAL, **options})


def _queue_clusters() -> "dict[Scheduler, type[JobQueueCluster]]":
    """Import dask-jobqueue, which takes Ctrl-C for itself, and give that back."""
    before = signal.getsignal(signal.SIGINT)
    from dask_jobqueue import HTCondorCluster, SLURMCluster  # when its effect can be undone

    if before is not None:
        signal.signal(signal.SIGINT, before)
    return {Scheduler.SLURM: SLURMCluster, Scheduler.HTCONDOR: HTCondorCluster}


def _require_command(scheduler: Scheduler) -> None:
    command = _SUBMIT[scheduler]
    if shutil.which(command) is None:
        remedy = f"call `vrts grade` on a machine from which {scheduler.value} jobs are submitted"
        raise _refused(f"there is no command `{command}` on this machine", remedy)


def _outcome(future: "Future[bytes]", cut: Cut) -> Outcome:
    try:
        if future.status == "finished":
            return Outcome(cut, future.result())
        problem = future.exception() if future.status == "error" else None
    except (OSError, CancelledError) as gone:  # with the machine that had it
        problem = gone
    if isinstance(problem, KilledWorker):
        return Outcome(cut, None, "the workers that marked it died")
    if problem is None:
        return Outcome(cut, None, f"the cluster calls it {future.status}")
    return Outcome(cut, None, str(problem) or type(problem).__name__)


def _own_workers(count: int, folder: str) -> LocalCluster:
    """Return workers in threads, which start the processes that mark.

    They talk without sockets: whoever reaches the port of a Dask scheduler can run anything.
    """
    return LocalCluster(
        n_workers=max(1, count),
        threads_per_worker=1,
        processes=False,
        dashboard_address=LOCAL,
        worker_dashboard_address=LOCAL,
        silence_logs=logging.CRITICAL,
        local_directory=folder,
    )


_START = "start one with `dask scheduler`, workers with `dask worker ADDRESS --nthreads 1`"


def _example(name: str) -> str:
    disk = " disk: 2GB," if name == Scheduler.HTCONDOR.value else ""
    return (
        f"write `jobqueue: {{{name}: {{cores: 1, memory: 2GB,{disk} processes: 1}}}}` into"
        " `~/.config/dask/jobqueue.yaml`"
    )


def _refused(headline: str, remedy: str) -> Refused:
    return Refused((error(NO_CLUSTER, headline, help=(remedy,)),))
