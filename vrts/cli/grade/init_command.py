"""`vrts grade init`."""

from pathlib import Path

import click

from vrts.cli.shared.console import guarded, say, write_file
from vrts.cli.shared.options import color_option, file_option

EPILOG = """\b
Examples:
  vrts grade init gradescope lab1 -o autograder.zip
  vrts grade init gradescope lab1-staff.zip --wheels dist/ -o autograder.zip

\b
Wheels for an image without network:
  pip download --dest wheels vrts-0.1.0-py3-none-any.whl --python-version 3.11 \\
    --only-binary :all:
"""


@click.group(name="init", epilog=EPILOG)
def command() -> None:
    """Write an autograder for a platform."""


@command.command(name="gradescope", epilog=EPILOG)
@click.argument("task", type=click.Path(path_type=Path))
@file_option(
    "-o",
    "--output",
    "target",
    default=Path("autograder.zip"),
    show_default=True,
    help="The zip to write.",
)
@file_option(
    "--wheels",
    "places",
    multiple=True,
    metavar="FILE|FOLDER",
    help="Wheels to pack: vrts and what it needs; without it from the package index.",
)
@color_option
@guarded
def gradescope(task: Path, target: Path, places: tuple[Path, ...], color: str) -> None:
    """Write a zip that Gradescope takes as an autograder of TASK.

    TASK is the folder of a task, or its zip for the staff. The hidden part is packed, too. The zip
    holds setup.sh, which installs this version of vrts, and run_autograder, which marks one
    submission and writes results/results.json: hidden checks as hidden tests, and the total when
    marks are published. If marking does not end in nine minutes, the result says so.
    """
    del color
    from vrts.marking.exports.autograders.autograder_zip import (
        autograder_zip,
        read_wheels,
        staff_task,
    )

    wheels = read_wheels(places)
    write_file(target, autograder_zip(staff_task(task), wheels))
    say(f"wrote {target}")
    if not wheels:
        say("note: without `--wheels` the image gets vrts from the package index")
