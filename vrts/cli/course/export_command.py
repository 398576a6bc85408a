"""`vrts course export`."""

import os
from pathlib import Path

import click

from vrts.cli.shared.console import WRONG, fail, guarded, say
from vrts.cli.shared.options import file_option

EPILOG = """\b
Examples:
  vrts course export robotics-2026 "Ada Lind"
  vrts course export robotics-2026 "Ada Lind" -o ada.zip --folder /srv/vrts/live
"""


@click.command(name="export", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@click.argument("name")
@file_option("-o", "--output", help="Zip to write; without it NAME.zip.")
@file_option(
    "--folder",
    "server",
    default=Path("vrts-live"),
    show_default=True,
    help="Folder of the server, as with `vrts serve`.",
)
@guarded
def command(folder: Path, name: str, output: Path | None, server: Path) -> None:
    """Pack all that a course keeps of a person.

    That is what `vrts serve --export-user` packs, and every program that was handed in,
    what was published for them, and pages about programs. The server may run meanwhile.
    """
    from vrts.base.safe_names import safe
    from vrts.course.course_file import open_course
    from vrts.course.personal.handing_out import hand_out

    open_course(folder)  # so that a wrong folder is told, and not taken for an empty one
    require_server(server)
    path = output or Path(f"{safe(name)}.zip")
    part = path.with_name(f"{path.name}.part")
    try:
        with open(os.open(part, os.O_CREAT | os.O_TRUNC | os.O_RDWR, 0o600), "w+b") as file:
            found = hand_out(folder, server, name, file)
        if not found.server.accounts:
            fail(f"nothing is kept of `{name}`", status=WRONG)
        part.replace(path)
    finally:
        part.unlink(missing_ok=True)
    own = found.server
    say(
        f"{own.records} records, {own.programs} programs and {own.files} files of the server,"
        f" {found.files} files of the course in {path}"
    )


def require_server(server: Path) -> None:
    """End where there is no server's folder."""
    if not (server / "live.sqlite").is_file():
        fail(
            f"there is no server's database in `{server}`",
            ("give the folder that `vrts serve --folder` has",),
        )
