"""What commands have in common that run one program in its scene: `run`, `verify`, others."""

from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, TypeVar

import click

from vrts.cli.shared.console import guarded
from vrts.cli.shared.options import (
    color_option,
    controller_option,
    lab_option,
    language_options,
    placed,
    scene_option,
    task_option,
)
from vrts.cli.shared.programs import STDIN, tell_task

SAVED = ".vrun"  # a run: where it happened is in it

Command = TypeVar("Command", bound=Callable[..., Any])


def of_one_program(scene: str, *, packed: bool = False) -> Callable[[Command], Command]:
    """Return a decorator that adds the program, and where it runs: first in `--help`.

    Args:
        scene: What a command says of `--scene`.
        packed: Whether a task may be a zip.
    """

    def decorated(function: Command) -> Command:
        with_task: Command = task_option(packed=packed)(function)
        with_scene: Command = scene_option(scene)(with_task)
        return click.argument("program")(with_scene)

    return decorated


def _telling_task(function: Command) -> Command:
    @wraps(function)
    def wrapped(*args: Any, **kwargs: Any) -> Any:
        program = kwargs.get("program")
        if program is not None and program != STDIN and not program.endswith(SAVED):
            tell_task(Path(program), kwargs["where"])
        return function(*args, **kwargs)

    return wrapped  # type: ignore[return-value]


def executed_so(function: Command) -> Command:
    """Add how a program is executed and read: last in `--help`. The command takes a `where`."""
    found: Any = guarded(placed(_telling_task(function)))
    for option in (color_option, language_options, controller_option, lab_option):
        found = option(found)
    return found
