"""`vrts grade [TASK] --session FILE`."""

import os
import sys
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.grade.options import again_option, no_pages_option, results_option
from vrts.cli.grade.what_to_mark import require_folder
from vrts.cli.shared.console import FAULT, HOLDS, fail, guarded, out, say, show_diagnostics
from vrts.cli.shared.options import (
    color_option,
    engine_option,
    file_option,
    form_option,
    jobs_option,
    lab_option,
    no_collisions_option,
)
from vrts.cli.shared.progress import Progress

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vrts.live.logs.class_sessions import RoomSession
    from vrts.live.logs.session_marker import SessionMarker
    from vrts.marking.about import About
    from vrts.marking.layout import Layout
    from vrts.marking.row import Class

EPILOG = """\b
Examples:
  vrts grade --session log-3f2a90bc.jsonl -o out
  vrts grade task.toml --session vrts-live -o out
  vrts grade lab1-staff.zip --session monday.sqlite --format json
  vrts grade task.toml --session "Group 3" --folder vrts-live
"""


@click.command(name="session", epilog=EPILOG)
@click.argument("task", required=False)
@click.option(
    "--session",
    "given",
    multiple=True,
    required=True,
    metavar="FILE|ID",
    help="A log, a server's folder or database (one row per room), or a room's name or id.",
)
@file_option(
    "--folder",
    "server",
    default=Path("vrts-live"),
    show_default=True,
    help="Folder of the server whose rooms you name.",
)
@results_option
@jobs_option("Sessions at a time; without it one per core.")
@again_option
@no_pages_option()
@no_collisions_option
@engine_option()
@form_option("full", "json")
@lab_option
@color_option
@guarded
def command(
    task: str | None,
    given: tuple[str, ...],
    server: Path,
    folder: Path | None,
    jobs: int | None,
    again: bool,
    no_pages: bool,
    no_collisions: bool,
    engine: str | None,
    form: str,
    lab: Path | None,
    color: str,
) -> None:
    """Mark sessions of the live server like submissions, by TASK or by the task of their room.

    In each room the last session counts in which something was done, from its last reset on. The
    chain of its log is checked, the session is repeated exactly, and what has begun is finished.
    Everything that was done is judged as one run, whoever did it and with whatever means: monitor,
    pointer, pendant or programs. Time counts only while a program executes, or the arm or the hand
    moves: thinking costs nothing. Hidden scenes do not count, since nobody could act in them.

    Results and pages are those of `vrts grade`; they show what was done as a program. A room in
    which nothing was done, or whose log was changed or purged, has a row without a mark.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.live.logs.class_sessions import sessions_in
    from vrts.live.logs.session_marker import SessionMarker
    from vrts.marking.by_hand.by_hand import all_lapses, load_by_hand
    from vrts.marking.exports.unsafe_marks import after_marking
    from vrts.marking.layout import Layout
    from vrts.marking.submission.one import Wanted
    from vrts.marking.submission.setting import Place

    require_folder(folder)
    rooms = sessions_in(given, server)
    path = _task(task, rooms)
    place = Place(str(path), lab=None if lab is None else str(lab))
    marker = SessionMarker(place, Wanted(not no_collisions, engine, bool(folder) and not no_pages))
    layout = None if folder is None else Layout(folder)
    about = _about(marker, given)
    _say_as_written(marker)
    progress = Progress()
    with progress.interruptible("the same call goes on" if layout else "nothing is kept"):
        rows = _mark(
            marker,
            rooms,
            layout,
            about,
            progress,
            jobs=jobs or os.cpu_count() or 1,
            again=again,
            quiet=form == "json",
        )
    show_diagnostics(marker.whole.stamps, color)
    if layout is not None:
        _write(rows, about, layout)
        changes = load_by_hand(layout, [row.id for row in rows.rows], rows.total)
        told = (*all_lapses(rows.rows, changes), *after_marking(rows, layout.root))
        show_diagnostics(told, color)
    if form == "json":
        from vrts.marking.row import class_to_bytes

        out(class_to_bytes(rows).decode().rstrip("\n"))
    sys.exit(FAULT if any(row.result.is_fault for row in rows.rows) else HOLDS)


def _task(task: str | None, rooms: "Sequence[RoomSession]") -> Path:
    """Return the task to mark by: the one given, else that of the rooms."""
    from vrts.live.places import places_of
    from vrts.pipeline.files import TASK_FILE, find_example

    if task is not None:
        example = find_example(task)
        path = example / TASK_FILE if example is not None else Path(task)
        if not path.exists():
            fail(f"there is no task `{task}`")
        return path
    scenes = {room.session.scene for room in rooms if room.session is not None}
    if len(scenes) != 1:
        what = "have different tasks" if scenes else "have no session"
        fail(f"the rooms {what}", ("name the task to mark by: `vrts grade TASK --session FILE`",))
    (scene,) = scenes
    if find_example(scene) is None:
        fail(
            f"the task of the room, `{scene}`, is not among the examples",
            ("name it: `vrts grade TASK --session FILE`",),
        )
    found = places_of((scene,))[0].task
    if not found:
        fail(f"the room had the scene `{scene}` without a task", ("name a task to mark by",))
    return Path(found)


def _say_as_written(marker: "SessionMarker") -> None:
    if marker.has_variants:
        say("note: rooms had the task as it is written, and are marked by that, not by variants")


def _about(marker: "SessionMarker", given: "Sequence[str]") -> "About":
    from vrts import __version__
    from vrts.marking.about import About

    assert marker.whole.task is not None
    return About(
        "vrts.marking/1",
        marker.whole.task.title,
        marker.place,
        tuple(given),
        marker.wanted,
        __version__,
        tuple(sys.argv),
        None,
        begun=datetime.now(UTC),
    )


def _mark(
    marker: "SessionMarker",
    rooms: "Sequence[RoomSession]",
    layout: "Layout | None",
    about: "About",
    progress: Progress,
    *,
    jobs: int,
    again: bool,
    quiet: bool,
) -> "Class":
    """Mark, and say each row as it is done."""
    from vrts.live.logs.session_rows import mark_sessions
    from vrts.marking.class_files import begin_class
    from vrts.marking.row import Class, Row
    from vrts.marking.row_words import row_words

    if layout is not None:
        begin_class(about, layout)
    progress.begin(len(rooms))
    rows: dict[str, Row] = {}
    for row, reused in mark_sessions(marker, rooms, layout, jobs=jobs, again=again):
        progress.step(reused=reused)
        rows[row.id] = row
        if not quiet:
            progress.clear()
            out(row_words(row, row.student.name))
        progress.show()
    progress.clear()
    ordered = tuple(rows[room.identifier] for room in rooms)
    return Class("vrts.class/1", about.title, ordered)


def _write(rows: "Class", about: "About", layout: "Layout") -> None:
    import msgspec

    from vrts.marking.renewing.renewed import write_marked

    about = msgspec.structs.replace(about, finished=datetime.now(UTC))
    write_marked(rows, about, layout)
    say(f"wrote {layout.overview}")
    say(f"wrote {layout.root / 'students'}, to be given to the rooms")
