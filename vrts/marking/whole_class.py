"""The marking of a class from the download to the list of marks."""

from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.check.late_rules import Keep
from vrts.check.task import Task
from vrts.marking.class_marks import Mark, class_row, entries, with_best_attempts
from vrts.marking.intake.edited_table import read_rows
from vrts.marking.intake.intake_table import NAME as TABLE
from vrts.marking.intake.intake_table import write_rows
from vrts.marking.intake.row import Intake
from vrts.marking.intake.row import Row as Found
from vrts.marking.intake.take_in import take_in_tree
from vrts.marking.intake.tree import Tree, open_place
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.marker import Marker
from vrts.marking.marking import Done, Entry, mark_class
from vrts.marking.remote.backend import Backend
from vrts.marking.remote.mark_on_dask import mark_on_dask
from vrts.marking.row import Change, Class
from vrts.pipeline.files import read_bytes
from vrts.pipeline.settings import Refused


class HowTo(NamedTuple):
    """How a class is marked."""

    jobs: int = 1
    again: bool = False  # also what is marked already
    table: Path | None = None  # intake.csv as edited; None: the one in the folder, if there is one
    backend: Backend | None = None  # a cluster; None: this machine


class Marked(NamedTuple):
    """A class that is marked."""

    rows: Class
    done: tuple[Done, ...]  # in the order of the rows
    remarks: tuple[str, ...]  # of the intake
    warnings: tuple[Diagnostic, ...]  # of the edited table, and of the cluster


def mark_whole_class(
    marker: Marker,
    submissions: Path | Sequence[Path],
    layout: Layout | None,
    how: HowTo,
    *,
    begun: Callable[[Sequence[str]], None] = lambda _: None,
    told: Callable[[Done], None] = lambda _: None,
) -> Marked:
    """Mark a class, and write for every submission what belongs to it.

    Args:
        marker: Of the task.
        submissions: A folder, a zip, or a list of files.
        layout: Where the results go; None: nowhere.
        how: Processes, what to mark again, the edited table, on which cluster.
        begun: Told the ids of all submissions, in the order of the rows.
        told: Told each submission as it is done.

    Raises:
        CannotRead: There is nothing of the kind.
        Refused: The edited table has errors, or there is no such cluster.
    """
    said: list[Diagnostic] = []
    task = marker.whole.task
    assert task is not None
    with open_place(submissions) as tree, TemporaryDirectory(prefix="vrts-") as staging:

        def mark(asked: Sequence[Entry], place: Layout | None) -> Iterable[Done]:
            if how.backend is not None and place is not None:
                return mark_on_dask(
                    marker,
                    asked,
                    place,
                    how.backend,
                    jobs=how.jobs,
                    again=how.again,
                    said=said.append,
                )
            return mark_class(
                marker,
                asked,
                place,
                jobs=how.jobs,
                again=how.again,
                staging=Path(staging),
            )

        table = table_for(submissions, layout, how)
        found, remarks, warnings = take_in_class(task, tree, table, lambda asked: mark(asked, None))
        begun([row.identifier for row in found])
        done: dict[str, Done] = {}
        for one in mark(tuple(entries(tree, found)), layout):
            done[one.entry.identifier] = one
            told(one)
    if layout is not None:
        write_atomically(layout.intake, write_rows(found))
    rows = tuple(
        class_row(row, done[row.identifier].result, task.late, NO_CHANGES) for row in found
    )
    return Marked(
        Class("vrts.class/1", task.title, rows),
        tuple(done[row.identifier] for row in found),
        remarks,
        (*warnings, *said),
    )


class TakenIn(NamedTuple):
    """Who handed in what, as the teacher wants it marked."""

    rows: tuple[Found, ...]
    remarks: tuple[str, ...]  # of the intake
    warnings: tuple[Diagnostic, ...]  # of the edited table


def take_in_class(task: Task, tree: Tree, table: Path | None, mark: Mark) -> TakenIn:
    """Return the rows of a class: those of the edited table, with the attempts that count.

    Args:
        task: What it is marked by.
        tree: The download.
        table: As edited; None: there is none.
        mark: Marks attempts without writing anything.

    Raises:
        CannotRead: The table is not there.
        Refused: It has errors.
    """
    intake = take_in_tree(tree, program=task.program)
    found, warnings = _as_edited(tree, intake, table)
    if task.keep is Keep.BEST:
        found = with_best_attempts(tree, found, task.late, mark)
    return TakenIn(found, intake.remarks, warnings)


NO_CHANGES: dict[str, Change] = {}


def table_for(submissions: Path | Sequence[Path], layout: Layout | None, how: HowTo) -> Path | None:
    """Return the edited table: the one given, beside the download, or of an earlier marking."""
    if how.table is not None:
        return how.table
    if not isinstance(submissions, Path):
        return None
    home = submissions if submissions.is_dir() else submissions.parent
    places = [home / TABLE] + ([] if layout is None else [layout.intake])
    return next((place for place in places if place.is_file()), None)


def _as_edited(
    tree: Tree, intake: Intake, table: Path | None
) -> tuple[tuple[Found, ...], tuple[Diagnostic, ...]]:
    if table is None:
        return intake.rows, ()
    edited = read_rows(read_bytes(table), table.name, tree, intake)
    if edited.rows is None:
        raise Refused(edited.diagnostics)
    return edited.rows, edited.diagnostics
