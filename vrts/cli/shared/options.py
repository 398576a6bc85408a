"""Options that mean the same in several commands, each defined once.

What a command says of its own goes into the help text; the order of decorators is that of `--help`.
"""

from collections.abc import Callable
from functools import wraps
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias, TypeVar

import click

from vrts.pipeline.where import Where

Command = TypeVar("Command", bound=Callable[..., Any])
Option: TypeAlias = Callable[[Command], Command]

DIALECTS = ("val2", "val2+", "val", "vplus", "as")
OR_AUTO = ("auto", *DIALECTS)
CONTROLLERS = ("val2", "vplus", "vrts-1")

ALONE = "Name or path of a scene; without it the robot stands alone."
TASK_OR_ALONE = "Name or path of a scene; without it the task's, or the robot alone."
IN_RUN = "What happens in the run: a scenario file."
IN_CELL = "What happens in the cell: a scenario file."
WITH_FILE = "Compile the programs and data of FILE, too."


class Language(NamedTuple):
    """How programs are to be read, as the options say."""

    others: tuple[str, ...] = ()  # files that are compiled together with the program
    dialect: str | None = None  # None: not said
    prec: str | None = None
    replace: bool = False

    @property
    def said(self) -> bool:
        """Whether any of the options is given."""
        return self != Language()


def file_option(*names: str, **attributes: Any) -> Option[Any]:
    """Return an option that takes the path of a file or folder."""
    return click.option(*names, type=click.Path(path_type=Path), **attributes)


color_option = click.option(
    "--color",
    type=click.Choice(["auto", "always", "never"]),
    default="auto",
    show_default=True,
    help="When to use colour; NO_COLOR and FORCE_COLOR are obeyed.",
)

lab_option = file_option(
    "--lab",
    help="Lay a lab over the scene: your own arm, table and hand; see `vrts new lab`.",
)

controller_option = click.option(
    "--controller",
    type=click.Choice(CONTROLLERS),
    help="Controller model of the run; see `vrts explain --assumptions`.",
)

no_collisions_option = click.option(
    "--no-collisions", is_flag=True, help="Do not check collisions."
)


def scene_option(says: str = ALONE) -> Option[Any]:
    """Return `--scene`."""
    return click.option("--scene", help=says)


def task_option(*, packed: bool = False) -> Option[Any]:
    """Return `--task`; a packed task may be a zip."""
    says = "Task file, its folder, or a zip." if packed else "Task file, or its folder."
    return file_option("--task", help=says)


def scenario_option(says: str = IN_RUN) -> Option[Any]:
    """Return `--scenario`."""
    return file_option("--scenario", help=says)


def entry_option(says: str) -> Option[Any]:
    """Return `--entry`, which names the program that is executed."""
    return click.option("--entry", metavar="NAME", help=says)


def dialect_option(says: str, *, auto: bool = True, default: str | None = None) -> Option[Any]:
    """Return `--dialect`, with or without the choice to be told by the file."""
    choice = click.Choice(OR_AUTO if auto else DIALECTS)
    if default is None:
        return click.option("--dialect", type=choice, help=says)
    return click.option("--dialect", type=choice, default=default, show_default=True, help=says)


def with_option(says: str = WITH_FILE) -> Option[Any]:
    """Return `--with`, which names files that belong to the program."""
    return click.option("--with", "others", metavar="FILE", multiple=True, help=says)


def engine_option(
    says: str = "Library that looks for the nearest parts; no mark depends on it.",
) -> Option[Any]:
    """Return `--engine`."""
    return click.option("--engine", type=click.Choice(["coal", "fcl", "own"]), help=says)


def form_option(*forms: str) -> Option[Any]:
    """Return `--format`, without a word of help; the first form is the default."""
    return click.option("--format", "form", type=click.Choice(forms), default=forms[0])


def overwrite_option(says: str = "Replace files that exist already.") -> Option[Any]:
    """Return `--overwrite`."""
    return click.option("--overwrite", is_flag=True, help=says)


def no_open_option(says: str) -> Option[Any]:
    """Return `--no-open`."""
    return click.option("--no-open", is_flag=True, help=says)


def placed(function: Command) -> Command:
    """Give a command one `where` for what `--scene`, `--task`, `--lab` and their like say."""

    @wraps(function)
    def wrapped(*args: Any, **kwargs: Any) -> Any:
        where = Where(*(kwargs.pop(name, None) for name in Where._fields))
        return function(*args, where=where, **kwargs)

    return wrapped  # type: ignore[return-value]


def language_options(function: Command) -> Command:
    """Add the options that say how programs are read; the command takes one `language`."""

    @wraps(function)
    def wrapped(*args: Any, **kwargs: Any) -> Any:
        language = Language(*(kwargs.pop(name) for name in Language._fields))
        return function(*args, language=language, **kwargs)

    command: Any = wrapped
    for option in (
        click.option("--replace", is_flag=True, help="Of programs of one name the last counts."),
        click.option(
            "--prec",
            type=click.Choice(["A", "B"]),
            help="Order of operators: A as in VAL-II, B as in AS; without it that of the dialect.",
        ),
        dialect_option("Dialect of the program; auto looks at file name and content."),
        with_option(),
    ):
        command = option(command)
    return command


def jobs_option(says: str, default: int | None = None) -> Option[Any]:
    """Return `--jobs`."""
    jobs = click.IntRange(1, 256)
    if default is None:
        return click.option("--jobs", type=jobs, help=says)
    return click.option("--jobs", type=jobs, default=default, show_default=True, help=says)
