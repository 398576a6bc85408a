"""`vrts course new`."""

from pathlib import Path

import click

from vrts.cli.shared.console import fail, guarded, say, write_file
from vrts.cli.shared.options import color_option

EPILOG = """\b
Examples:
  vrts course new robotics-2026
  vrts course check robotics-2026
  vrts serve robotics-2026
"""


@click.command(name="new", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@click.option("--title", help="Title of the course; without it the name of the folder.")
@color_option
@guarded
def command(folder: Path, title: str | None, color: str) -> None:
    """Write the files of a course into FOLDER, and replace nothing.

    You get `course.toml` with a comment for everything that can stand there, an example of the list
    of the class, and a first task.
    """
    from vrts.cli.authoring.new_command import task
    from vrts.course.begun import EXAMPLE_TASK, course_files

    files = course_files(title or folder.resolve().name.replace("-", " "))
    for name in files:
        if (folder / name).exists():
            fail(f"`{folder / name}` is there already", ("choose another folder",))
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files.items():
        write_file(folder / name, text.encode())
    assert task.callback is not None, "the command is there"
    name, origin = EXAMPLE_TASK
    task.callback(name=folder / name, origin=origin, title=None, color=color)
    say(f"wrote {folder}: correct `course.toml`, then `vrts course check {folder}`")
