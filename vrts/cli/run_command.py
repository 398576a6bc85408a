"""`vrts run`."""

import sys
from pathlib import Path

import click

from vrts.cli.console import (
    HOLDS,
    WRONG,
    color_option,
    fail,
    guarded,
    language_options,
    out,
    program_bytes,
    reading_of,
    say,
    show_diagnostics,
)

EPILOG = """\b
Examples:
  vrts run prog.v2
  vrts run prog.v2 --scene cans-on-bases
  vrts run prog.v2 --scene cans-on-bases --at 4.5
  vrts run prog.v2 --scene cans-on-bases --scenario gripper-slips.toml
"""


@click.command(name="run", epilog=EPILOG)
@click.argument("program")
@click.option("--scene", help="Name or path of a scene; without it the robot stands alone.")
@click.option(
    "--scenario", type=click.Path(path_type=Path), help="What happens in the run: a scenario file."
)
@click.option("--program", "entry", help="Program of the file to execute; the first, if not given.")
@click.option("--at", "time_s", type=float, help="Print the state at a time in s, not the output.")
@language_options
@color_option
@guarded
def command(
    program: str,
    scene: str | None,
    scenario: Path | None,
    entry: str | None,
    time_s: float | None,
    others: tuple[str, ...],
    dialect: str | None,
    prec: str | None,
    replace: bool,
    color: str,
) -> None:
    """Run PROGRAM; what it TYPEs goes to stdout, everything else to stderr."""
    from vrts.pipeline import assess, load_scene, robot_alone, with_scenario
    from vrts.report.plain import plain_text

    data, name, path = program_bytes(program)
    setting = load_scene(scene, path.parent if path else None) if scene else robot_alone()
    if scenario is not None:
        setting = with_scenario(setting, scenario)
    warnings = setting.scenario.warnings if setting.scenario else ()
    reading = reading_of(others, dialect or "auto", prec, replace=replace)
    found = assess(data, setting=setting, title=name, entry=entry, judged=False, reading=reading)
    show_diagnostics((*warnings, *found.findings), color)
    run = found.run
    if run is None:
        sys.exit(WRONG)
    if time_s is not None:
        if not 0 <= time_s <= run.horizon_s:
            fail(f"the run ends at {run.horizon_s:.3f} s")
        from vrts.report.state_text import state_text

        out(state_text(run, time_s))
    else:
        out(plain_text(run.output.replace("\r\n", "\n")), end=False)
        ended = run.ended_s if run.ended_s is not None else run.horizon_s
        say(f"{run.ending.value} after {ended:.3f} s of simulated time")
    sys.exit(WRONG if any(d.is_error for d in run.findings) else HOLDS)
