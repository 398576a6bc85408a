"""`vrts monitor`."""

import sys
import time

import click

from vrts.cli.shared.console import guarded, out, say, warn
from vrts.cli.shared.options import (
    IN_CELL,
    controller_option,
    dialect_option,
    lab_option,
    placed,
    scenario_option,
    scene_option,
)
from vrts.pipeline.where import Where

EPILOG = """\b
Examples:
  vrts monitor
  vrts monitor pick.v2 --scene cans-on-bases
  printf 'LOAD pick\\nEXECUTE main\\nWHERE\\n' | vrts monitor
\b
From a pipe, each line is typed when the robot program has stopped. After a line `;@ 2.5` the next
one is typed at that simulated time, in s.
"""


@click.command(name="monitor", epilog=EPILOG)
@click.argument("files", metavar="[FILE]...", nargs=-1)
@scene_option()
@lab_option
@controller_option
@scenario_option(IN_CELL)
@dialect_option("Dialect of commands and programs.", auto=False, default="val2")
@click.option("--replace", is_flag=True, help="LOAD replaces programs that are in memory.")
@click.option("--overwrite", is_flag=True, help="STORE replaces files without asking.")
@guarded
@placed
def command(
    files: tuple[str, ...],
    where: Where,
    dialect: str,
    replace: bool,
    overwrite: bool,
) -> None:
    """Talk to the controller as its operator does; FILEs are loaded first.

    Files are read and written in the working folder only. Ctrl-C stops a program, Ctrl-D leaves.
    """
    from vrts.monitor.opening import opened
    from vrts.monitor.transcript import transcript
    from vrts.report.plain import plain_text

    at_terminal = sys.stdin.isatty() and sys.stdout.isatty()
    dialogue, said = opened(
        files,
        where,
        dialect,
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
            warn(f"the program still executes, after {dialogue.time_s:.0f} s of simulated time")
