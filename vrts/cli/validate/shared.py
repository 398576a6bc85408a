"""What the subcommands of `vrts validate` share: the run that a real robot is compared with."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar

import click

from vrts.cli.shared.console import fail, lab_option, program_bytes, reading_of, show_diagnostics

if TYPE_CHECKING:
    from vrts.engine.run import Run

Command = TypeVar("Command", bound=Callable[..., Any])

NOT_INSTALLED = "this needs packages that are installed by: pip install 'vrts[validate]'"


def setting_options(function: Command) -> Command:
    """Add the options that say in what a program runs."""
    for option in (
        lab_option,
        click.option("--program", "entry", help="Program of the file to execute; the first."),
        click.option("--scenario", type=click.Path(path_type=Path), help="A scenario file."),
        click.option("--scene", help="Name or path of a scene; without it the robot stands alone."),
    ):
        function = option(function)
    return function


class Where(NamedTuple):
    """What a program runs in."""

    scene: str | None
    scenario: Path | None
    entry: str | None
    lab: Path | None


def run_of(
    program: str,
    where: Where,
    others: tuple[str, ...],
    dialect: str | None,
    prec: str | None,
    *,
    replace: bool,
    color: str,
) -> "tuple[Run, str]":
    """Return the run of a program or of a file of one, and its name; end where there is none."""
    from vrts.engine.storage.recognise import is_saved_run
    from vrts.pipeline.settings import load_scene, robot_alone, with_scenario
    from vrts.run_files import load_run, simulate

    data, name, path = program_bytes(program)
    beside = path.parent if path else None
    if is_saved_run(data):
        found = load_run(data, name, beside)
    else:
        if where.lab is not None and where.scene is None:
            fail("a lab is laid over a scene", ("give `--scene NAME`, too",))
        setting = (
            robot_alone() if where.scene is None else load_scene(where.scene, beside, lab=where.lab)
        )
        if where.scenario is not None:
            setting = with_scenario(setting, where.scenario)
        reading = reading_of(others, dialect or "auto", prec, replace=replace)
        found = simulate(data, name, setting, entry=where.entry, reading=reading)
    show_diagnostics([d for d in found.diagnostics if d.is_error], color)
    if found.run is None:
        fail(f"there is no run of `{name}` to compare with", status=1)
    return found.run, name
