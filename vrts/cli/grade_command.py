"""`vrts grade`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.console import FAULT, HOLDS, color_option, fail, guarded, out, say

if TYPE_CHECKING:
    from vrts.marking.grade import Marked
    from vrts.marking.submissions import Submission
    from vrts.pipeline import Setting

EPILOG = """\b
Examples:
  vrts grade examples/01-cans-on-bases -o out
  vrts grade task.toml submissions/ -o out
  vrts grade task.toml anna.v2 ben.v2 --format json
"""


@click.command(name="grade", epilog=EPILOG)
@click.argument("task")
@click.argument("submissions", nargs=-1, type=click.Path(path_type=Path))
@click.option("-o", "--out", "folder", type=click.Path(path_type=Path), help="Folder for reports.")
@click.option("--format", "form", type=click.Choice(["full", "json"]), default="full")
@click.option("--recordings", is_flag=True, help="Write a Rerun recording of every run.")
@color_option
@guarded
def command(
    task: str,
    submissions: tuple[Path, ...],
    folder: Path | None,
    form: str,
    recordings: bool,
    color: str,
) -> None:
    """Mark SUBMISSIONS (files or folders) by TASK.

    TASK is a task.toml, its folder, or the name of an example; an example without submissions marks
    its own solution and submissions. Exit status 0 when every row has a result.
    """
    setting, found = _what(task, submissions)
    rows = _mark(setting, found, folder, recordings=recordings, quiet=form == "json")
    if folder is not None:
        from vrts.marking.outputs import write_class

        assert setting.task is not None
        write_class(rows, folder, setting.task.title)
        say(f"wrote {folder / 'index.html'}")
    if form == "json":
        from vrts.report.json_form import results_json
        from vrts.report.json_text import json_text

        results = results_json(row.assessment for row in rows)
        out(json_text(results))
    sys.exit(FAULT if any(row.fault for row in rows) else HOLDS)


def _what(task: str, submissions: tuple[Path, ...]) -> "tuple[Setting, list[Submission]]":
    from vrts.marking.submissions import of_example, of_paths
    from vrts.pipeline import TASK_FILE, find_example, load_task

    folder = find_example(task)
    path = folder / TASK_FILE if folder is not None else Path(task)
    setting = load_task(path)
    if submissions:
        missing = [str(p) for p in submissions if not p.exists()]
        if missing:
            fail(f"there is no `{missing[0]}`")
        return setting, of_paths(submissions)
    if folder is None:
        fail("no submissions given", ("name files or folders after the task",))
    return setting, of_example(folder)


def _mark(
    setting: "Setting",
    found: "list[Submission]",
    folder: Path | None,
    *,
    recordings: bool,
    quiet: bool,
) -> "list[Marked]":
    from vrts.marking.grade import mark_all
    from vrts.report.row_text import row_text

    count = 0

    def done(row: "Marked") -> None:
        nonlocal count
        count += 1
        if folder is not None:
            from vrts.marking.outputs import write_student

            write_student(row, folder, recordings=recordings)
        if not quiet:
            out(row_text(row.assessment))
        if sys.stderr.isatty():
            click.echo(f"\r{count} of {len(found)}\r", nl=False, err=True)

    return mark_all(found, setting, done=done)
