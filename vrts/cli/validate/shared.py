"""What the subcommands of `vrts validate` share: the run that a real robot is compared with."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

from vrts.cli.shared.console import fail, show_diagnostics
from vrts.cli.shared.options import (
    Language,
    controller_option,
    entry_option,
    lab_option,
    placed,
    scenario_option,
    scene_option,
)
from vrts.cli.shared.programs import given_program
from vrts.pipeline.where import Where

if TYPE_CHECKING:
    from vrts.engine.run import Run

Command = TypeVar("Command", bound=Callable[..., Any])

NOT_INSTALLED = "this needs packages that are installed by: pip install 'vrts[validate]'"


def setting_options(function: Command) -> Command:
    """Add the options that say in what a program runs; the command takes one `where`."""
    command: Any = placed(function)
    for option in (
        controller_option,
        lab_option,
        entry_option("Program to execute; without it the main one."),
        scenario_option("A scenario file."),
        scene_option(),
    ):
        command = option(command)
    return command


def run_of(
    program: str, where: Where, entry: str | None, language: Language, color: str
) -> "tuple[Run, str]":
    """Return the run of a program or of a file of one, and its name; end where there is none."""
    from vrts.engine.storage.recognise import is_saved_run

    given = given_program(program)
    name = given.program.name
    if is_saved_run(given.program.data):
        from vrts.run_files.loading import load_run

        found = load_run(*given.program, given.folder)
    else:
        from vrts.cli.shared.requests import run_request
        from vrts.run_files.simulated import simulate

        found = simulate(run_request(given, where, language, entry))
    show_diagnostics([d for d in found.diagnostics if d.is_error], color)
    if found.run is None:
        fail(f"there is no run of `{name}` to compare with", status=1)
    return found.run, name
