"""`vrts debug`."""

import sys
from pathlib import Path

import click

from vrts.cli.shared.console import WRONG, fail, guarded, say, show_diagnostics
from vrts.cli.shared.options import (
    IN_CELL,
    TASK_OR_ALONE,
    color_option,
    controller_option,
    dialect_option,
    entry_option,
    lab_option,
    placed,
    scenario_option,
    scene_option,
    task_option,
    with_option,
)
from vrts.cli.shared.programs import tell_task
from vrts.pipeline.where import Where

EPILOG = """\b
Examples:
  vrts debug prog.v2
  vrts debug prog.v2 --scene cans-on-bases
n and N go a step forward and back, c and C to the next stop and the one before, v and V show the
moment in the browser and in the Rerun viewer, : takes a command of the monitor; ? shows all keys.
"""


@click.command(name="debug", epilog=EPILOG)
@click.argument("program", type=click.Path(path_type=Path))
@scene_option(TASK_OR_ALONE)
@task_option()
@scenario_option(IN_CELL)
@lab_option
@controller_option
@entry_option("Program to execute; without it the task's, or the main one.")
@with_option()
@dialect_option("Dialect; without it vrts looks at file name and content.", auto=False)
@color_option
@guarded
@placed
def command(
    program: Path,
    where: Where,
    entry: str | None,
    others: tuple[str, ...],
    dialect: str | None,
    color: str,
) -> None:
    """Debug PROGRAM at the terminal, with time running both ways."""
    from vrts.debug.opening import Asked, opened

    if not (sys.stdin.isatty() and sys.stdout.isatty()):
        fail("debugging needs a terminal", ("editors use `vrts dap`",))
    tell_task(program, where)
    asked = Asked(program, where, entry, tuple(map(Path, others)), dialect)
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
