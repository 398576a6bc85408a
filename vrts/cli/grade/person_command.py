"""`vrts grade person`."""

import os
from pathlib import Path

import click

from vrts.cli.shared.console import guarded, out, warn, write_file
from vrts.cli.shared.options import color_option, file_option

EPILOG = """\b
Examples:
  vrts grade person out --student anna
  vrts grade person out 2025w/* --student anna -o anna.zip
"""


@click.command(name="person", epilog=EPILOG)
@click.argument(
    "folders", metavar="OUT...", nargs=-1, required=True, type=click.Path(path_type=Path)
)
@click.option(
    "--student",
    required=True,
    metavar="ID",
    help="Whom it is about: id or pseudonym, or a name that only one has.",
)
@file_option("-o", "--output", "target", help="The zip to write; without it person-ID.zip.")
@color_option
@guarded
def command(folders: tuple[Path, ...], student: str, target: Path | None, color: str) -> None:
    """Pack all that the markings OUT keep of one student, to be handed out.

    The zip holds pages, results and recordings, the student's line of every table, what graders
    decided, changes by hand, the program, and how much others are like it. Its README.txt says what
    is kept, what for, and how long. Nobody else is named but graders where the student's report
    names them. Private comments of graders are left out, and counted.

    To forget a student, see `vrts purge --student`.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy: threads do not fork
    from vrts.base.safe_names import safe
    from vrts.marking.personal.hand_out import hand_out

    found = hand_out(tuple(dict.fromkeys(folders)), student)
    path = target or Path(f"person-{safe(student)}.zip")
    write_file(path, found.data, private=True)
    markings = "1 marking" if len(found.found) == 1 else f"{len(found.found)} markings"
    out(f"{path}: {found.files} files of {markings}")
    if found.private:
        one = found.private == 1
        comments = "1 private comment" if one else f"{found.private} private comments"
        warn(f"{comments} of graders {'is' if one else 'are'} left out: look into the desk")
    warn("staff/result.json tells of hidden checks: hand it out when the task is over")
