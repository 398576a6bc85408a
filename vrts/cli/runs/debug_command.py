"""`vrts debug`."""

import sys
from pathlib import Path

import click

from vrts.cli.shared.console import (
    WRONG,
    color_option,
    fail,
    guarded,
    lab_option,
    say,
    show_diagnostics,
)

EPILOG = """\b
Examples:
  vrts debug prog.v2
  vrts debug prog.v2 --scene cans-on-bases
n and N go a step forward and back, c and C to the next stop and the last one, v and V show the
moment in the browser and in the Rerun viewer, : takes a command of the monitor; ? shows all keys.
"""


@click.command(name="debug", epilog=EPILOG)
@click.argument("program", type=click.Path(path_type=Path))
@click.option("--scene", help="Name or path of a scene; without it the task's, or the robot alone.")
@click.option("--task", type=click.Path(path_type=Path), help="Task file, or its folder.")
@click.option(
    "--scenario", type=click.Path(path_type=Path), help="What happens in the cell: a scenario file."
)
@lab_option
@click.option(
    "--program",
    "entry",
    help="Program of the file to execute; the task's, or the first, otherwise.",
)
@click.option(
    "--with",
    "others",
    type=click.Path(path_type=Path),
    multiple=True,
    metavar="FILE",
    help="Compile together with the programs and data of FILE.",
)
@click.option(
    "--dialect",
    type=click.Choice(["val2", "val2+", "val", "vplus", "as"]),
    help="Language of the family; left out, file name and content tell.",
)
@color_option
@guarded
def command(
    program: Path,
    scene: str | None,
    task: Path | None,
    scenario: Path | None,
    lab: Path | None,
    entry: str | None,
    others: tuple[Path, ...],
    dialect: str | None,
    color: str,
) -> None:
    """Debug PROGRAM at the terminal, with time running both ways."""
    from vrts.debug.opening import Asked, opened

    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        fail("debugging needs a terminal", ("editors use `vrts dap`",))
    asked = Asked(program, scene, task, scenario, lab, entry, others, dialect)
    found = opened(asked)
    if found.debugger is None or found.console is None:
        show_diagnostics(found.diagnostics, color)
        sys.exit(WRONG)
    from vrts.cli.runs.debug_outside import DebugOutside
    from vrts.debug.alarms import Filter
    from vrts.debug.terminal.screen import debug

    debugger = found.debugger
    debugger.wishes.filters = frozenset({Filter.CONTACT, Filter.ERROR})
    with DebugOutside(asked, found) as outside:
        debug(debugger, found.console, outside.keys())
    say(f"left at {debugger.at.time_s:.3f} s")
