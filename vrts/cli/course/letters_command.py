"""`vrts course letters`."""

from pathlib import Path

import click

from vrts.cli.course.people_command import server_option
from vrts.cli.shared.console import WRONG, fail, guarded, say, show_diagnostics, write_file
from vrts.cli.shared.options import color_option, file_option

EPILOG = """\b
Examples:
  vrts course letters robotics-2026 --address https://lab.example.org -o letters.csv
  vrts course letters robotics-2026 --again "Anna Berg" -o anna.csv
"""


@click.command(name="letters", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@server_option
@click.option(
    "--address", help="Where browsers find the server; without it, where they did last time."
)
@click.option("--again", "names", multiple=True, metavar="NAME", help="Only for these, new ones.")
@file_option("-o", "--output", "target", required=True, help="Table to write; `-`: stdout.")
@color_option
@guarded
def command(
    folder: Path,
    server: Path,
    address: str | None,
    names: tuple[str, ...],
    target: Path,
    color: str,
) -> None:
    """Write a table with a personal link for everybody who has not come in yet.

    A link works once, for 60 days: it leads to choosing a password. People who have a link that
    works, or a password, get none. `--again` makes a new one for somebody, by name or e-mail
    address, and ends the one before. The server keeps digests only, so nobody can read the links
    there: send those in this table, and delete it. The server may run meanwhile.
    """
    from vrts.course.people.letters import NoSuchPerson, kept_address, letters, table_of, take_back
    from vrts.course.people.sources import read_people

    read = read_people(folder)
    show_diagnostics(read.faults, color)
    if read.missing:
        fail(read.missing, ("`vrts course new FOLDER` writes a course",))
    if not read.good:
        raise SystemExit(WRONG)
    where = (address or kept_address(server)).rstrip("/")
    if not where:
        hint = "such as `--address https://lab.example.org`"
        fail("where will browsers find the server?", (hint,))
    try:
        made = letters(read, server, names)
    except NoSuchPerson as problem:
        fail(str(problem), (f"`vrts course people {folder}` lists them",))
    try:
        write_file(target, table_of(made, where), private=True)
    except OSError:
        take_back(server, made)  # nobody has seen them: the next table has others
        raise
    say(f"{len(made)} links" if len(made) != 1 else "1 link")
