"""`vrts course people`."""

from pathlib import Path

import click

from vrts.cli.shared.console import fail, guarded, note, out, show_diagnostics
from vrts.cli.shared.options import color_option, file_option

EPILOG = """\b
Examples:
  vrts course people robotics-2026
  vrts course people robotics-2026 --folder /srv/vrts/live
"""

server_option = file_option(
    "--folder",
    "server",
    default=Path("vrts-live"),
    show_default=True,
    help="Folder of the server, as with `vrts serve`.",
)


@click.command(name="people", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@server_option
@color_option
@guarded
def command(folder: Path, server: Path, color: str) -> None:
    """List who is in a course: rank, rooms, team, and when they were here last.

    Before the server has started once, it lists whom the files name.
    """
    from vrts.course.people.letters import standing
    from vrts.course.people.sources import read_people

    read = read_people(folder)
    show_diagnostics(read.faults, color)
    if read.missing:
        fail(read.missing, ("`vrts course new FOLDER` writes a course",))
    known = standing(server)
    if known:
        rows = known
    else:
        note("the server has not started yet: this is what the files say")
        rows = [
            (one.name, one.email, one.rank, ", ".join(one.rooms), one.team, "never", "")
            for one in read.people
        ]
    header = ("name", "e-mail", "rank", "rooms", "team", "was here last", "")
    table = [header, *rows]
    widths = [max(len(row[column]) for row in table) for column in range(len(header))]
    for row in table:
        out("  ".join(f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True)).rstrip())
