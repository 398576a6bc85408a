"""Marks some or all of a class again, and writes what follows: as `vrts grade` would."""

import os
from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path

from msgspec.structs import replace

from vrts import __version__
from vrts.base.diagnostic import Rule, error
from vrts.controllers.models import FIRST
from vrts.controllers.values import digest
from vrts.desk.again.asked import again
from vrts.desk.book.book import found_out
from vrts.desk.book.opened import Opened, open_marking
from vrts.live.lasting.clock import wall
from vrts.marking.about import Late
from vrts.marking.class_files import begin_class
from vrts.marking.layout import Layout
from vrts.marking.marking import Done
from vrts.marking.privacy.pseudonyms import read_names
from vrts.marking.renewing.renewed import link_compared, write_marked
from vrts.marking.result import SCORING
from vrts.marking.row import Class, Row, class_from_bytes
from vrts.marking.similarity.corpus import read_corpora
from vrts.marking.similarity.files import compare_class
from vrts.marking.submission.marker import Marker
from vrts.marking.variants.of_class import MarkerOfClass, marker_for
from vrts.marking.whole_class import Marked, mark_whole_class
from vrts.pipeline.refused import Refused

CHANGED = Rule("V855", "cannot-mark-some")
HALF = "the task has changed, and some only are marked by it: the list of marks stays as it was"


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
    # now: marking writes variants anew
    unlike = {r.id for r in opened.rows.rows if not is_as_now(r, marker, layout)}
    if students is not None:
        _require_same_task(opened, unlike)
        names = read_names(layout)
        only = frozenset(names[name]["id"] if name in names else name for name in students)
        asked = asked._replace(how=asked.how._replace(only=only))
    corpora = read_corpora(asked.corpora, layout.root) if students is None else None
    done: dict[str, Row] = {}
    every: list[str] = []

    def begun(names: Sequence[str]) -> None:
        begin_class(replace(about, begun=_now(), finished=None, vrts=__version__), layout)
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
    task = marker.whole.task
    late = None if task is None else Late.of(task.late)
    after = replace(about, finished=_now(), late=late, vrts=__version__)
    if marked is not None and students is None:
        rows, after = marked.rows, replace(after, intake_sha256=marked.intake_sha256)
    else:
        rows = together(_listed(layout), done)
        if unlike - done.keys():
            raise _cannot(HALF, "mark all again, to the end")
    written = write_marked(rows, after, layout, done)
    if marked is not None and corpora is not None:
        compare_class(marked, marker, layout, corpora)
        link_compared(written, after, layout)
    return len(done)


def _listed(layout: Layout) -> Class:
    return class_from_bytes(layout.results.read_bytes())


def together(rows: Class, done: Mapping[str, Row]) -> Class:
    """Return the rows of before with those that are marked anew; whoever is new comes last."""
    known = {row.id for row in rows.rows}
    new = tuple(row for name, row in done.items() if name not in known)
    return replace(rows, rows=(*(done.get(row.id, row) for row in rows.rows), *new))


def _require_same_task(opened: Opened, unlike: Collection[str]) -> None:
    """Check that some are not marked by another task than the others.

    Args:
        opened: The marking.
        unlike: Ids of rows that would be marked by another one now.

    Raises:
        Refused: They would be.
    """
    remedy = "mark all again, so that one task holds for everybody"
    if opened.about.finished is None:
        raise _cannot("a marking of the class has begun and not ended", remedy)
    if unlike:
        raise _cannot("the task has changed since the class was marked", remedy)


def is_as_now(row: Row, marker: Marker, layout: Layout) -> bool:
    """Return whether a row was marked by the task, scene, model and vrts that mark now.

    Args:
        row: Of the list of marks.
        marker: That marks now.
        layout: Where variants are.
    """
    result = found_out(row)
    versions = result.versions
    if (versions.vrts, versions.scoring) != (__version__, SCORING):
        return False
    if isinstance(marker, MarkerOfClass) and result.variant is not None:
        return marker.is_as_before(row, layout)
    model = digest(FIRST) if result.controller is None else result.controller.sha256
    return (result.task.sha256, result.scene.sha256, model) in {
        (one.task.digest, one.scene.digest, digest(one.scene.controller))
        for one in (marker.whole, *marker.whole.variants)
        if one.task is not None
    }


def _cannot(headline: str, remedy: str) -> Refused:
    return Refused((error(CHANGED, headline, help=(remedy,)),))


def _now() -> datetime:
    return datetime.fromtimestamp(wall(), UTC)
