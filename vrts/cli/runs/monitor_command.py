"""`vrts monitor`."""

import sys
import time
from pathlib import Path

import click

from vrts.cli.shared.console import fail, guarded, lab_option, out, say

EPILOG = """\b
Examples:
  vrts monitor
  vrts monitor pick.v2 --scene cans-on-bases
  printf 'LOAD pick\\nEXECUTE main\\nWHERE\\n' | vrts monitor
\b
From a pipe the next line is issued when the robot program has stopped, or, after a line `;@ 2.5`,
at that simulated time in s.
"""


@click.command(name="monitor", epilog=EPILOG)
@click.argument("files", metavar="[FILE]...", nargs=-1)
@click.option("--scene", help="Name or path of a scene; without it the robot stands alone.")
@lab_option
@click.option(
    "--scenario", type=click.Path(path_type=Path), help="What happens in the cell: a scenario file."
)
@click.option(
    "--dialect",
    type=click.Choice(["val2", "val2+", "val", "vplus", "as"]),
    default="val2",
    show_default=True,
    help="Language of commands and programs.",
)
@click.option("--replace", is_flag=True, help="LOAD replaces programs that are in memory.")
@click.option("--overwrite", is_flag=True, help="STORE replaces files without asking.")
@guarded
def command(
    files: tuple[str, ...],
    scene: str | None,
    lab: Path | None,
    scenario: Path | None,
    dialect: str,
    replace: bool,
    overwrite: bool,
) -> None:
    """Talk to the controller as its operator does; FILEs are loaded first.

    Files are read and written in the working folder only. Ctrl-C stops a program, Ctrl-D leaves.
    """
    if lab is not None and scene is None:
        fail("a lab is laid over a scene", ("give `--scene NAME`, too",))
    from vrts.monitor.opening import opened
    from vrts.monitor.transcript import transcript
    from vrts.report.plain import plain_text

    at_terminal = sys.stdin.isatty() and sys.stdout.isatty()
    dialogue, said = opened(
        files,
        scene,
        dialect,
        lab=lab,
        scenario=scenario,
        asks=at_terminal,
        replace=replace,
        overwrite=overwrite,
    )
    out(plain_text(said), end=False)
    if at_terminal:
        from vrts.cli.runs.history import history_file
        from vrts.monitor.screens.terminal import converse

        say("Ctrl-D leaves; ID, DIRECTORY and WHERE are commands to begin with")
        converse(dialogue, time.monotonic, history_file())
    else:
        for piece in transcript(dialogue, sys.stdin):
            out(plain_text(piece), end=False)
        if dialogue.busy:
            say(f"the program still executes, after {dialogue.time_s:.0f} s of simulated time")
