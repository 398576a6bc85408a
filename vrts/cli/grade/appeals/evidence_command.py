"""`vrts grade evidence`."""

import os
from pathlib import Path

import click

from vrts.cli.grade.options import marking_option
from vrts.cli.shared.console import guarded, out, warn, write_file
from vrts.cli.shared.options import color_option, file_option

EPILOG = """\b
Examples:
  vrts grade evidence anna --from out
  vrts grade evidence anna@uni.example --from out -o anna.zip
  vrts grade evidence anna --from out --submissions ~/backup/download.zip --task lab1-staff.zip
"""


@click.command(name="evidence", epilog=EPILOG)
@click.argument("student")
@marking_option
@file_option("-o", "--output", "target", help="The zip to write; without it evidence-ID.zip.")
@file_option(
    "--submissions",
    help="Where the download is now, if it was moved.",
)
@file_option("--task", help="Where the task is now.")
@color_option
@guarded
def command(
    student: str,
    folder: Path,
    target: Path | None,
    submissions: Path | None,
    task: Path | None,
    color: str,
) -> None:
    """Pack everything that the mark of STUDENT rests on, for an appeal.

    STUDENT is an id, or a name or address that only one student has. The zip holds the program
    exactly as handed in, its line of the table of hand-ins, the task with its hidden part, result,
    reports and recording, changes by hand, the command, versions, and a sha256 of every file. It
    holds nothing of any other student. It is for those who decide: students must not see hidden
    checks.

    Task and program must be those that were marked, byte for byte, or nothing is packed. `vrts
    grade reproduce` marks the program in the zip again, on any machine.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from vrts.marking.appeals.pack_evidence import pack_evidence
    from vrts.marking.appeals.written import read_written
    from vrts.marking.renewing.renewed import brought_up_to_date

    brought_up_to_date(read_written(folder))  # pages in it say what is decided
    row, data = pack_evidence(read_written(folder), student, task=task, download=submissions)
    path = target or Path(f"evidence-{row.id}.zip")
    write_file(path, data)
    mark = "no mark" if row.final is None else f"{row.final:.1f} of {row.result.total:g}"
    out(f"{path}: {row.id}, {mark}")
    warn("it has the hidden part of the task in it: not for students")
