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
  pip download --dest wheels dist/vrts-0.1.0-py3-none-any.whl --python-version 3.11 \\
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
    help="Wheels to pack: vrts and what it needs; without it vrts as it is here.",
)
@color_option
@guarded
def gradescope(task: Path, target: Path, places: tuple[Path, ...], color: str) -> None:
    """Write a zip that Gradescope takes as an autograder of TASK.

    TASK is the folder of a task, or its zip for the staff. The hidden part is packed, too. The zip
    holds a wheel of this vrts, setup.sh, which installs it, and run_autograder, which marks one
    submission and writes results/results.json: hidden checks as hidden tests, and the total when
    marks are published. If marking does not end in nine minutes, the result says so.

    vrts never comes from a package index, where anybody could take its name. What it needs does,
    unless you give all of it with --wheels.
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
    if not places:
        say("note: without `--wheels` the image gets what vrts needs from the package index")
