"""`vrts course purge`."""

from pathlib import Path

import click

from vrts.cli.course.export_command import require_server
from vrts.cli.shared.console import WRONG, fail, guarded, say, warn
from vrts.cli.shared.options import file_option

EPILOG = """\b
Examples:
  vrts course purge robotics-2026 "Ada Lind"
"""


@click.command(name="purge", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path))
@click.argument("name")
@file_option(
    "--folder",
    "server",
    default=Path("vrts-live"),
    show_default=True,
    help="Folder of the server, as with `vrts serve`.",
)
@click.option("--mentions", is_flag=True, help="Also forget others' texts that hold the name.")
@click.option(
    "--still-listed",
    is_flag=True,
    help="Forget also people who are on the list: they get a new, empty account.",
)
@file_option("--log-key", help="File with the key that signs the logs, outside of the folder.")
@guarded
def command(
    folder: Path,
    name: str,
    server: Path,
    mentions: bool,
    still_listed: bool,
    log_key: Path | None,
) -> None:
    """Forget a person in a course: account, hand-ins, marks, what was published for them.

    What a team handed in stays with the others of the team. The server may run meanwhile. Take the
    person off the class list first: the server makes a new account for everybody on it, so nothing
    is forgotten while the name stands there. What `vrts grade` wrote about the class stays, and
    this person in it: `vrts purge OUT --older-than 0d` deletes a whole marking.
    """
    from vrts.course.course_file import open_course
    from vrts.course.personal.forgetting import forget
    from vrts.course.personal.still_listed import still_listed as where_listed

    open_course(folder)
    require_server(server)
    listed = where_listed(folder, server, name)
    if listed.places and not still_listed:
        fail(
            f"`{name}` still stands in {' and '.join(listed.places)},"
            " and would get a new account: nothing was forgotten",
            (
                "take the line out, save the file, and call this again",
                "`--still-listed` forgets them all the same, and the new account is empty",
            ),
            WRONG,
        )
    found = forget(folder, server, name, log_key, mentions=mentions)
    if not found.server.accounts:
        fail(f"nothing is kept of `{name}`", status=WRONG)
    say(f"accounts forgotten: {found.server.accounts}; files of the course removed: {found.files}")
    for copy in found.server.copies:
        say(f"removed an older copy of the database: {copy}")
    if found.server.mentions:
        warn(
            f"`{name}` still stands in {found.server.mentions} texts of others;"
            " `--mentions` forgets these too"
        )
    if found.server.left:
        warn(found.server.left)
    if listed.places:
        warn(f"{' and '.join(listed.places)} gives them a new, empty account as long as it stands")
    elif listed.fault and found.listed:
        warn(f"`{name}` may still be listed, and gets a new account then: {listed.fault}")
    warn(
        "what `vrts grade` wrote about the class stays, and this person in it:"
        " `vrts purge OUT --older-than 0d` deletes a whole marking"
    )
