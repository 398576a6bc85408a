"""`vrts teach`."""

import sys
import time
from pathlib import Path

import click

from vrts.cli.shared.console import INTERRUPTED, WRONG, fail, guarded, say, warn, write_file
from vrts.cli.shared.options import file_option, lab_option, no_open_option, overwrite_option
from vrts.pipeline.where import Where

EPILOG = """\b
Examples:
  vrts teach cans-on-bases -o points.v2
  vrts teach cans-on-bases -o points.v2 --terminal
"""


@click.command(name="teach", epilog=EPILOG)
@click.argument("scene")
@file_option("-o", "--output", required=True, help="File for the locations.")
@lab_option
@click.option("--terminal", is_flag=True, help="Use the keys of the terminal as the pendant.")
@overwrite_option("Replace the file if it exists already.")
@no_open_option("Print the link, and open no browser.")
@click.option(
    "--port", type=click.IntRange(0, 65_535), default=0, help="Port of the page; 0 takes any."
)
@guarded
def command(
    scene: str,
    output: Path,
    lab: Path | None,
    terminal: bool,
    overwrite: bool,
    no_open: bool,
    port: int,
) -> None:
    """Move the arm in SCENE, record locations, write them as `.LOCATIONS`.

    The page in the browser has a virtual pointer, a pendant and the monitor, for one user on this
    machine. The link lets one browser in, once. Every location is in the file as soon as you record
    it. You can reset the scene, or go back to an earlier moment and go on from there; what you
    recorded stays. Ctrl-C ends it.
    """
    if output.exists() and not overwrite:
        if terminal and not _at_terminal():
            fail("the pendant needs a terminal")
        fail(f"`{output}` is there already", ("give another name, or `--overwrite`",))
    if terminal:
        _by_keys(scene, lab, output)
    else:
        _in_browser(scene, lab, output, port, opens=not no_open)


def _at_terminal() -> bool:
    return sys.stdin.isatty() and sys.stdout.isatty()


def _by_keys(scene: str, lab: Path | None, output: Path) -> None:
    from vrts.monitor.opening import opened
    from vrts.monitor.pendant import points_text

    if not _at_terminal():
        fail("the pendant needs a terminal")
    from vrts.monitor.screens.pendant_screen import teach

    dialogue, _ = opened((), Where(scene, lab=lab), "val2", asks=False)
    pendant = teach(dialogue, time.monotonic)
    if pendant.done == "write" and pendant.recorded:
        write_file(output, points_text(pendant).encode())
        say(_written(len(pendant.recorded), output))
    else:
        say("nothing is written")


def _in_browser(scene: str, lab: Path | None, output: Path, port: int, *, opens: bool) -> None:
    try:
        from vrts.live.teaching import teach
    except ModuleNotFoundError as missing:
        hints = ("install them with `pip install 'vrts[live]'`", "`--terminal` needs none of them")
        fail(f"teaching in the browser needs the package {missing.name}", hints, WRONG)
    count = teach(scene, output, port, say, warn, lab=lab, opens=opens)
    say(_written(count, output) if count else "nothing is written")
    sys.exit(INTERRUPTED)  # nothing else ends it


def _written(count: int, output: Path) -> str:
    return f"{count} location{'' if count == 1 else 's'} written to {output}"
