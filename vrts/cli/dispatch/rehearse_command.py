"""`vrts dispatch rehearse`."""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from vrts.cli.shared.console import (
    HOLDS,
    UNDETERMINED,
    WRONG,
    fail,
    guarded,
    out,
    say,
    show_diagnostics,
    write_file,
)
from vrts.cli.shared.options import color_option, file_option, form_option, scenario_option

if TYPE_CHECKING:
    from vrts.engine.run import Run

EPILOG = """\b
Examples:
  vrts dispatch export solution.v2 --to linuxcnc -o folder
  vrts dispatch rehearse folder
  vrts dispatch rehearse folder --scenario empty.toml --speed 5
"""
SPEED = 10.0


@click.command(name="rehearse", epilog=EPILOG)
@click.argument("folder", type=click.Path(path_type=Path, exists=True, file_okay=False))
@click.option(
    "--speed",
    type=click.FloatRange(0.1, 50.0),
    default=SPEED,
    show_default=True,
    help="How many times faster than the clock.",
)
@scenario_option("A scenario whose inputs are played instead of those of the export.")
@file_option("--html", help="Where the page goes; without it rehearsal.html in the folder.")
@file_option("--log", help="Where the log goes; without it linuxcnc.csv in the folder.")
@form_option("full", "json")
@color_option
@guarded
def command(
    folder: Path,
    speed: float,
    scenario: Path | None,
    html: Path | None,
    log: Path | None,
    form: str,
    color: str,
) -> None:
    """Run FOLDER on an installed LinuxCNC, and compare its motion with the run.

    FOLDER is what `vrts dispatch export --to linuxcnc` wrote. LinuxCNC runs without a screen and
    without a robot, never as root and in namespaces of its own. The inputs of the scenario are
    played. What `machine.hal` loads runs too: rehearse only folders that you exported or have read.
    Exit status 1 when LinuxCNC does not move as the sheet claims, or refuses the program; 3 when
    LinuxCNC is not installed.
    """
    from vrts.dispatch.rehearsing.installed import REMEDY, installed
    from vrts.dispatch.rehearsing.log_text import log_text
    from vrts.dispatch.rehearsing.page import rehearsal_page, summary
    from vrts.dispatch.rehearsing.rehearse import expected, rehearse

    run = expected(folder)
    if scenario is not None:
        run = _with_inputs(run, scenario)
    what = installed()
    if isinstance(what, str):
        fail(f"nothing was rehearsed: {what}", (REMEDY,), UNDETERMINED)
    found = rehearse(folder, run, what, speed)
    show_diagnostics(found.diagnostics, color)
    if form == "json":
        from vrts.report.formats.json_text import json_text

        stretches = [s._asdict() for s in found.stretches if not s.missing]
        out(json_text({"holds": found.holds, "stretches": stretches, "words": found.words}))
    else:
        for line in summary(found):
            out(line)
    page = html or folder / "rehearsal.html"
    write_file(page, rehearsal_page(found, folder.name).encode())
    say(f"wrote {page}")
    if len(found.samples.joints):
        table = log or folder / "linuxcnc.csv"
        write_file(table, "".join(log_text(found.samples)).encode())
        say(f"wrote {table}")
    sys.exit(HOLDS if found.holds else WRONG)


def _with_inputs(run: "Run", path: Path) -> "Run":
    from vrts.dispatch.rehearsing.rehearse import with_scenario
    from vrts.pipeline.scenes import with_scenario as in_scenario
    from vrts.pipeline.setting import Setting, scenario_of

    setting = in_scenario(Setting(run.scene, None, ()), path)
    return with_scenario(run, scenario_of(setting))
