"""Marks a class on a cluster, with the meaning of marking at home."""

import importlib.util
from collections.abc import Callable, Iterator, Sequence
from math import ceil

from vrts.base.diagnostic import Diagnostic, Rule, error, warning
from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry, reusable, without_program, write_marks
from vrts.marking.remote.backend import Backend
from vrts.marking.remote.child import ChildFailed, mark_in_child
from vrts.marking.remote.marked import MarkedShard
from vrts.marking.remote.merge import take
from vrts.marking.remote.plan import Key, make_plan, rest_of
from vrts.marking.remote.shard import Cut
from vrts.marking.submission.marker import Marker, Marks
from vrts.marking.submission.one import Order
from vrts.marking.supervise.limits import Limits
from vrts.pipeline.refused import Refused

NOT_INSTALLED = Rule("V728", "cluster-packages-missing")
AT_HOME = Rule("V729", "marked-at-home")

SIZE = 8  # submissions in a shard: few, so that progress shows
_PACKAGES = ("dask", "distributed", "dask_jobqueue")


def mark_on_dask(
    marker: Marker,
    entries: Sequence[Entry],
    layout: Layout | None,
    backend: Backend,
    *,
    jobs: int = 1,
    limits: Limits | None = None,
    again: bool = False,
    size: int = SIZE,
    said: Callable[[Diagnostic], None] = lambda _: None,
) -> Iterator[Done]:
    """Yield every submission once, as soon as its files are written; see `mark_class`.

    What the cluster cannot do is marked here in the end, in a process of its own.

    Args:
        marker: Of the task.
        entries: What to mark.
        layout: Where the results go; None: nowhere.
        backend: The cluster.
        jobs: Workers or jobs to start, where they are ours to start; processes at a time here.
        limits: Of the process of each submission.
        again: Whether to mark also what is there already.
        size: Submissions that a worker gets at a time.
        said: Told about shards that were not marked by the cluster.

    Raises:
        CannotRead: The task cannot be taken along.
        Refused: There is no such cluster.
    """
    _require_packages()
    fresh: list[Entry] = []
    for entry in entries:
        if entry.data is None:
            yield without_program(marker, entry, layout)
            continue
        found = None if again or layout is None else reusable(marker, entry, layout)
        if found is None:
            fresh.append(entry)
        else:
            yield found
    if fresh:
        plan = make_plan(marker, fresh, ceil(len(fresh) / size), limits)
        yield from _Shards(marker, fresh, plan.key, layout, said).mark(plan.cuts, backend, jobs)


class _Shards:
    """The shards of one plan."""

    def __init__(
        self,
        marker: Marker,
        entries: Sequence[Entry],
        key: Key,
        layout: Layout | None,
        said: Callable[[Diagnostic], None],
    ) -> None:
        self._marker = marker
        self._entries = {entry.identifier: entry for entry in entries}
        self._key = key
        self._layout = layout
        self._said = said

    def mark(self, cuts: Sequence[Cut], backend: Backend, jobs: int) -> Iterator[Done]:
        from vrts.marking.remote.dask_cluster import DaskCluster  # Dask is optional

        left: dict[str, list[tuple[Cut, Key]]] = {}  # by why the cluster has not marked them
        with DaskCluster(backend, jobs) as cluster:
            for outcome in cluster.run(cuts):
                found, words = list[Done](), outcome.words
                if outcome.results is not None:
                    found, words = self._taken(outcome.results, outcome.cut, self._key)
                yield from found
                missing = _missing(outcome.cut, found)
                if missing:
                    rest = rest_of(self._key, outcome.cut, missing)
                    left.setdefault(words, []).append(rest)
        for words, rests in left.items():
            self._said(_at_home([cut for cut, _ in rests], words))
            for cut, key in rests:
                yield from self._here(cut, key, jobs)

    def _taken(self, results: bytes, cut: Cut, key: Key) -> tuple[list[Done], str]:
        """Return the rows of a shard that can be taken, written; and why the others cannot."""
        try:
            taken = take(MarkedShard(results, f"shard {cut.number}"), key, self._layout)
        except Refused as refused:
            return [], "; ".join(d.headline for d in refused.diagnostics)
        found = [
            Done(
                self._entries[row.naming.identifier],
                row.marks.staff,
                row.marks.student,
                False,
                row.seconds,
                row.peak,
            )
            for row in taken.rows
        ]
        return found, "; ".join(d.headline for d in taken.findings)

    def _here(self, cut: Cut, key: Key, jobs: int) -> Iterator[Done]:
        """Mark a shard on this machine; whatever happens, there is a row for everything."""
        try:
            found, words = self._taken(mark_in_child(cut.data, cut.longest_s, jobs), cut, key)
        except ChildFailed as problem:
            found, words = list[Done](), str(problem)
        yield from found
        for identifier in _missing(cut, found):
            entry = self._entries[identifier]
            assert entry.data is not None
            order = Order(entry.identifier, entry.title, entry.data)
            marks: Marks = self._marker.lost(order, f"its shard was not marked: {words}")
            if self._layout is not None:
                write_marks(marks, self._layout)
            yield Done(entry, marks.staff, marks.student, False, 0.0, 0)


def _missing(cut: Cut, found: Sequence[Done]) -> list[str]:
    """Return the identifiers of a shard that have no row."""
    there = {done.entry.identifier for done in found}
    return [naming.identifier for naming in cut.names if naming.identifier not in there]


def _at_home(cuts: Sequence[Cut], words: str) -> Diagnostic:
    count = sum(len(cut.names) for cut in cuts)
    what = "1 submission is" if count == 1 else f"{count} submissions are"
    return warning(
        AT_HOME,
        f"{what} marked on this machine and not on the cluster",
        notes=(f"the cluster gave no results: {' '.join(words.split())}",),
    )


def _require_packages() -> None:
    missing = [name for name in _PACKAGES if importlib.util.find_spec(name) is None]
    if missing:
        missing = [name.replace("_", "-") for name in missing]
        names = " and ".join(f"`{name}`" for name in missing)
        headline = f"marking on a cluster needs {names}, which {_is(len(missing))} not installed"
        remedy = f"pip install {' '.join(missing)}"
        raise Refused((error(NOT_INSTALLED, headline, help=(remedy,)),))


def _is(count: int) -> str:
    return "is" if count == 1 else "are"
