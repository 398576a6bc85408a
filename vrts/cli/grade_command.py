"""`vrts grade`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.console import (
    FAULT,
    HOLDS,
    color_option,
    fail,
    guarded,
    lab_option,
    out,
    say,
    show_diagnostics,
)

if TYPE_CHECKING:
    from vrts.marking.grade import Marked
    from vrts.marking.submissions import Submission
    from vrts.pipeline.settings import Setting

EPILOG = """\b
Examples:
  vrts grade examples/01-cans-on-bases -o out
  vrts grade task.toml submissions/ -o out
  vrts grade task.toml anna.v2 ben.v2 --format json
  vrts grade lab1-student.zip mine.v2
  vrts grade lab1-staff.zip submissions/ -o out
"""


@click.command(name="grade", epilog=EPILOG)
@click.argument("task")
@click.argument("submissions", nargs=-1, type=click.Path(path_type=Path))
@click.option("-o", "--out", "folder", type=click.Path(path_type=Path), help="Folder for reports.")
@click.option("--format", "form", type=click.Choice(["full", "json"]), default="full")
@click.option("--recordings", is_flag=True, help="Write a Rerun recording of every run.")
@lab_option
@color_option
@guarded
def command(
    task: str,
    submissions: tuple[Path, ...],
    folder: Path | None,
    form: str,
    recordings: bool,
    lab: Path | None,
    color: str,
) -> None:
    """Mark SUBMISSIONS (files or folders) by TASK.

    TASK is a task.toml, its folder, a zip of `vrts task pack`, or the name of an example; an
    example without submissions marks its own solution and submissions.

    Every submission has two reports: `students/NAME` in the output is for the student alone,
    `staff/students/NAME` is for those who mark and has what is to be reviewed, the facts for an
    appeal, and hidden checks. A task with a folder `staff` is marked with its hidden checks: then
    the list of marks is in `staff` too, and `students` tells of the public checks only. Exit status
    0 when every row has a result.
    """
    setting, public, found = _what(task, submissions, lab)
    marks = folder if folder is None or public is None else folder / "staff"
    rows = _mark(setting, public, found, folder, recordings=recordings, quiet=form == "json")
    show_diagnostics(setting.stamps, color)
    if folder is not None and marks is not None:
        from vrts.marking.outputs import STAFF, write_class

        assert setting.task is not None
        pages = "students" if public is not None else f"{STAFF}/students"
        write_class(rows, marks, setting.task.title, pages=pages)
        say(f"wrote {marks / 'index.html'}")
        without = "" if public is None else ", without the hidden checks"
        say(f"wrote {folder / 'students'}, to be sent to each{without}")
    if form == "json":
        from vrts.report.json_form import results_json
        from vrts.report.json_text import json_text

        results = results_json(row.assessment for row in rows)
        out(json_text(results))
    sys.exit(FAULT if any(row.fault for row in rows) else HOLDS)


def _settings(task: str, folder: Path | None, lab: Path | None) -> "tuple[Setting, Setting | None]":
    """Return what is marked by, and the same without hidden checks; None where there are none."""
    from vrts.marking.packed import is_packed, load_zip
    from vrts.pipeline.settings import TASK_FILE, load_task

    path = folder / TASK_FILE if folder is not None else Path(task)
    load = load_zip if is_packed(path) else load_task
    whole = load(path, staff=True, lab=lab)
    return whole, load(path, staff=False, lab=lab) if whole.hidden else None


def _what(
    task: str, submissions: tuple[Path, ...], lab: Path | None
) -> "tuple[Setting, Setting | None, list[Submission]]":
    from vrts.marking.submissions import of_example, of_paths
    from vrts.pipeline.files import find_example

    folder = find_example(task)
    setting, public = _settings(task, folder, lab)
    if submissions:
        missing = [str(p) for p in submissions if not p.exists()]
        if missing:
            fail(f"there is no `{missing[0]}`")
        return setting, public, of_paths(submissions)
    if folder is None:
        fail("no submissions given", ("name files or folders after the task",))
    return setting, public, of_example(folder)


def _mark(
    setting: "Setting",
    public: "Setting | None",
    found: "list[Submission]",
    folder: Path | None,
    *,
    recordings: bool,
    quiet: bool,
) -> "list[Marked]":
    from vrts.marking.grade import mark, mark_all
    from vrts.marking.packed import public_answer
    from vrts.report.row_text import row_text

    count = 0

    def done(row: "Marked") -> None:
        nonlocal count
        count += 1
        if folder is not None:
            from vrts.marking.outputs import write_reports

            known = row if public is None else mark(row.submission, public)
            more = setting.hidden or setting.more
            write_reports(row, known, folder, recordings=recordings, more=more)
        if not quiet:
            out(row_text(row.assessment))
            answer = public_answer(row.assessment, setting)
            if answer is not None:
                out(f"      {answer}")
        if sys.stderr.isatty():
            click.echo(f"\r{count} of {len(found)}\r", nl=False, err=True)

    return mark_all(found, setting, done=done)
