"""`vrts teach`."""

import sys
import time
from pathlib import Path

import click

from vrts.cli.console import fail, guarded, say, write_file

EPILOG = """\b
Example:
  vrts teach cans-on-bases -o points.v2 --terminal
"""


@click.command(name="teach", epilog=EPILOG)
@click.argument("scene")
@click.option(
    "-o", "--output", type=click.Path(path_type=Path), required=True, help="File for the locations."
)
@click.option("--terminal", is_flag=True, help="Use the keys of the terminal as the pendant.")
@click.option("--overwrite", is_flag=True, help="Replace the file if it is there.")
@guarded
def command(scene: str, output: Path, terminal: bool, overwrite: bool) -> None:
    """Move the arm in SCENE by keys, record locations, write them as `.LOCATIONS`."""
    from vrts.monitor.opening import opened
    from vrts.monitor.pendant import points_text

    if not terminal:
        fail("the pendant of the browser is not there yet", ("give `--terminal`",))
    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        fail("the pendant needs a terminal")
    if output.exists() and not overwrite:
        fail(f"`{output}` is there already", ("give another name, or `--overwrite`",))
    from vrts.monitor.pendant_screen import teach

    dialogue, _ = opened((), scene, "val2", asks=False)
    pendant = teach(dialogue, time.monotonic)
    if pendant.done == "write" and pendant.recorded:
        write_file(output, points_text(pendant).encode())
        count = len(pendant.recorded)
        say(f"{count} location{'' if count == 1 else 's'} written to {output}")
    else:
        say("nothing is written")
