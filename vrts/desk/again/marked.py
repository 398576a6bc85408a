"""Marks some or all of a class again, and writes what follows: as `vrts grade` would."""

import os
from collections.abc import Callable, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path

from msgspec.structs import replace

from vrts.base.diagnostic import Rule, error
from vrts.desk.again.asked import again
from vrts.desk.again.going_on import writing_alone
from vrts.desk.book.deciding import decided_now
from vrts.desk.book.opened import Opened, open_marking
from vrts.live.lasting.clock import wall
from vrts.marking.about import Late
from vrts.marking.class_files import begin_class, write_class, write_overview
from vrts.marking.exports.write import write_feedback
from vrts.marking.layout import Layout
from vrts.marking.marking import Done
from vrts.marking.privacy.pseudonyms import read_names
from vrts.marking.renewing.renewed import write_sections
from vrts.marking.row import Class, Row, class_from_bytes
from vrts.marking.similarity.corpus import read_corpora
from vrts.marking.similarity.files import compare_class
from vrts.marking.submission.marker import Marker
from vrts.marking.variants.of_class import MarkerOfClass, marker_for
from vrts.marking.whole_class import Marked, mark_whole_class
from vrts.pipeline.refused import Refused

CHANGED = Rule("V855", "cannot-mark-some")


class Stopped(Exception):  # noqa: N818 -- names the situation
    """Somebody wants the marking to end; what is marked already is kept."""


def mark_again(
    folder: Path,
    students: Sequence[str] | None,
    told: Callable[[int, int], None],
    stopped: Callable[[], bool] = lambda: False,
) -> int:
    """Mark again, and return how many submissions were marked.

    Args:
        folder: The output of a marking.
        students: Whom; None: everybody, with whoever has handed in since.
        told: Told how many are done, and of how many.
        stopped: Whether to end after the submission that is being marked.

    Raises:
        CannotRead: The submissions are not to be read.
        Refused: Task, tables or decisions have errors, or have moved.
    """
    opened = open_marking(folder)
    layout, about = opened.layout, opened.about
    asked = again(about, layout, os.cpu_count() or 1)
    if any(row.of_session for row in opened.rows.rows):
        remedy = "mark sessions with `vrts grade --session`, into the same folder"
        raise _cannot("these are sessions of the live server, which the desk does not mark", remedy)
    marker = marker_for(about.place, about.wanted, asked.how.roster, asked.how.variants_key)
    if students is not None:
        _require_same_task(opened, marker, students)
        names = read_names(layout)
        only = frozenset(names[name]["id"] if name in names else name for name in students)
        asked = asked._replace(how=asked.how._replace(only=only))
    done: dict[str, Row] = {}
    every: list[str] = []

    def begun(names: Sequence[str]) -> None:
        begin_class(replace(about, begun=_now(), finished=None), layout)
        every.extend(names)
        told(0, len(every))

    def step(one: Done, row: Row) -> None:
        done[one.entry.identifier] = row
        told(len(done), len(every))
        if stopped():
            raise Stopped

    marked: Marked | None = None
    with suppress(Stopped):  # what is done is kept
        marked = mark_whole_class(
            marker, asked.submissions, layout, asked.how, begun=begun, told=step
        )
    whole = marked is not None and students is None
    with writing_alone(folder):
        rows = marked.rows if marked is not None and whole else _with(_listed(layout), done)
        intake = marked.intake_sha256 if marked is not None and whole else about.intake_sha256
        task = marker.whole.task
        late = None if task is None else Late.of(task.late)
        after = replace(about, finished=_now(), intake_sha256=intake, late=late)
        rows, _ = decided_now(Opened(layout, rows, after))  # also what was decided meanwhile
        write_sections([row for row in rows.rows if row.id in done], layout)
        write_feedback(rows, layout)
        write_class(rows, after, layout)  # last: whatever is interrupted before is made up for
    if marked is not None and whole:
        compare_class(marked, marker, layout, read_corpora(asked.corpora, layout.root))
        with writing_alone(folder):
            write_overview(rows, after, layout)  # again: it links to what was compared
    return len(done)


def _listed(layout: Layout) -> Class:
    return class_from_bytes(layout.results.read_bytes())


def _with(rows: Class, done: dict[str, Row]) -> Class:
    return replace(rows, rows=tuple(done.get(row.id, row) for row in rows.rows))


def _require_same_task(opened: Opened, marker: Marker, students: Sequence[str]) -> None:
    """Check that some are not marked by another task than the others.

    Raises:
        Refused: They would be.
    """
    asked = set(students)
    if isinstance(marker, MarkerOfClass):  # each has an own task
        rows = (row for row in opened.rows.rows if row.id in asked)
        changed = any(not marker.is_as_before(row, opened.layout) for row in rows)
    else:
        changed = _has_changed(opened, marker, asked)
    if changed:
        remedy = "mark all again, so that one task holds for everybody"
        raise _cannot("the task has changed since the class was marked", remedy)


def _has_changed(opened: Opened, marker: Marker, asked: set[str]) -> bool:
    settings = (marker.whole, *marker.whole.variants)
    now = {setting.task.digest for setting in settings if setting.task is not None}
    return any(row.result.task.sha256 not in now for row in opened.rows.rows if row.id in asked)


def _cannot(headline: str, remedy: str) -> Refused:
    return Refused((error(CHANGED, headline, help=(remedy,)),))


def _now() -> datetime:
    return datetime.fromtimestamp(wall(), UTC)
