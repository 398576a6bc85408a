"""`vrts grade desk`."""

import sys
import webbrowser
from pathlib import Path

import click

from vrts.cli.shared.console import WRONG, fail, guarded, say, warn

EPILOG = """\b
Examples:
  vrts grade desk out --who "R. Huber"
  vrts grade desk out --who "S. Mayr" --port 8100 --no-browser
"""


@click.command(name="desk", epilog=EPILOG)
@click.argument("folder", metavar="OUT", type=click.Path(path_type=Path))
@click.option(
    "--who", metavar="NAME", required=True, help="Who marks: your name, as people know it."
)
@click.option(
    "--port",
    type=click.IntRange(0, 65_535),
    default=0,
    help="Port; without it any that is free.",
)
@click.option("--no-browser", is_flag=True, help="Print the address, and open no browser.")
@guarded
def command(folder: Path, who: str, port: int, no_browser: bool) -> None:
    """Go through a marked class on one page.

    OUT is the folder that `vrts grade` wrote with `-o`. The page shows what to look at next, each
    program beside its replay and its lost points, and which programs are alike. You write
    comments, give rubric items, change marks, give extensions and excuses, assign rows to graders
    and mark again.

    All that you decide goes into OUT/staff/decisions, into a file of your own, to which vrts only
    ever adds. You can undo everything. Several graders may work on the same folder at once, each
    with a desk of their own: what they decide differently is shown, and counts when somebody
    decides which one holds.

    Only this machine can reach the page, and only with the address that is printed. Ctrl-C ends it.
    What you have decided is on the disk before the page says so.
    """
    if sys.platform == "win32":
        hint = "start it in the Windows Subsystem for Linux, at the same folder"
        fail("the desk does not run on Windows", (hint,), WRONG)
    try:
        from vrts.desk.serving import serve_desk
    except ModuleNotFoundError as missing:
        hint = "install them with `pip install 'vrts[live]'`"
        fail(f"the desk needs the package {missing.name}", (hint,), WRONG)

    def open_link(link: str) -> None:
        if not no_browser and not webbrowser.open(link):
            warn("no browser was found here: open the address in one")

    serve_desk(folder, who, port, warn, open_link)
    say("the desk is closed")
