"""`vrts grade intake`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.grade.options import roster_option, zone_option
from vrts.cli.shared.console import HOLDS, WRONG, fail, guarded, out, say, write_file
from vrts.cli.shared.options import file_option
from vrts.cli.shared.zones import zone_named

if TYPE_CHECKING:
    from vrts.check.task.task import Task
    from vrts.marking.intake.row import Intake

EPILOG = """\b
Examples:
  vrts grade intake download.zip --task lab1
  vrts grade intake submissions/ --entry pick -o intake.csv
"""


@click.command(name="intake", epilog=EPILOG)
@click.argument("place", type=click.Path(path_type=Path))
@file_option("--task", help="The task, which says which program runs.")
@click.option(
    "--entry", "program", metavar="NAME", help="The program to look for, if you give no task."
)
@roster_option(", and with Moodle when the work came")
@zone_option
@file_option("-o", "--output", "target", help="The table to write.")
@click.option("--overwrite", is_flag=True, help="Write the table even if it exists already.")
@click.option(
    "--delimiter",
    type=click.Choice([",", ";"]),
    default=",",
    show_default=True,
    help="Separator of fields in the table; spreadsheets of many languages want `;`.",
)
@guarded
def command(
    place: Path,
    task: Path | None,
    program: str | None,
    class_list: Path | None,
    zone: str | None,
    target: Path | None,
    overwrite: bool,
    delimiter: str,
) -> None:
    """List who handed in which program in PLACE, and what is wrong.

    PLACE is a folder or a zip: a download of Moodle, Canvas or Gradescope, a folder for each
    student, or files side by side. Rows with a problem are shown first. Exit status 1 when there
    is one.

    It writes the table intake.csv into the folder or beside the zip; -o names another place. You
    may edit the table, and `vrts grade` obeys it: give another file, another id, the student's own
    deadline in `due`, or `excused` as the problem. Its column `download` says which download it is
    about. If a table of another download is there, the new one is called NAME-intake.csv.
    """
    from vrts.marking.intake.clock import settled, zone_of
    from vrts.marking.intake.tables.intake_table import write_rows
    from vrts.marking.intake.tables.own_table import place_of_table
    from vrts.marking.intake.tables.roster import read_roster
    from vrts.marking.intake.take_in import take_in
    from vrts.pipeline.files import read_bytes

    table = target or place_of_table(place)
    if table.exists() and not overwrite:
        fail(f"`{table}` is there already", ("`--overwrite` writes it again; edits are lost",))
    asked = _task(task)
    rules = None if asked is None else asked.late
    times = zone_named(zone) if zone else zone_of(rules)
    roster = (
        None if class_list is None else read_roster(read_bytes(class_list), class_list.name, times)
    )
    wanted = program or (None if asked is None else asked.program)
    given = _given(task)
    found = take_in(place, program=wanted, zone=times, roster=roster, given=given)
    intake = settled(found, rules, times)
    out(_text(intake))
    write_file(table, write_rows(intake.rows, delimiter, place.absolute().name))
    for remark in intake.remarks:
        say(f"note: {remark}")
    obeys = f"vrts grade {task or 'TASK'} {place}{'' if target is None else f' --intake {table}'}"
    say(f"wrote {table}: change what is not right, and `{obeys}` obeys it")
    sys.exit(WRONG if any(row.problem for row in intake.rows) else HOLDS)


def _task(path: Path | None) -> "Task | None":
    """Return the task, without its hidden part."""
    if path is None:
        return None
    from vrts.assignments.packed import is_packed, load_zip
    from vrts.pipeline.settings import load_task

    file = _file_of(path)
    return (load_zip if is_packed(file) else load_task)(file, staff=False).task


def _given(path: Path | None) -> frozenset[str]:
    """Return the programs that students of a task are given."""
    if path is None:
        return frozenset()
    from vrts.marking.intake.given import given_to_all

    return given_to_all(_file_of(path))


def _file_of(path: Path) -> Path:
    from vrts.pipeline.files import TASK_FILE, find_example

    folder = find_example(str(path))
    return folder / TASK_FILE if folder is not None else path


def _text(intake: "Intake") -> str:
    """Return the rows for the terminal: those with a problem first, else in their order."""
    from vrts.report.plain import one_line, width

    lines = [("id", "file", "why, or what is wrong")]
    for row in sorted(intake.rows, key=lambda row: row.problem is None):
        found = row.problem
        words = row.why if found is None else f"{found.kind.value}: {found.sentence}"
        lines.append((one_line(row.identifier), one_line(row.title or "-"), one_line(words)))
    columns = [min(40, max(width(line[k]) for line in lines)) for k in (0, 1)]
    shown = [
        "  ".join(text + " " * (columns[k] - width(text)) for k, text in enumerate(line[:2]))
        + f"  {line[2]}"
        for line in lines
    ]
    bad = sum(row.problem is not None for row in intake.rows)
    one = "1 hand-in" if len(intake.rows) == 1 else f"{len(intake.rows)} hand-ins"
    first = ", shown first" if 0 < bad < len(intake.rows) else ""
    shown += ["", f"{intake.layout}: {one}, {bad or 'none'} with a problem{first}"]
    return "\n".join(shown)
