"""What may stand for a parameter, by its name: resolved once, here, before any command sees it."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from vrts.cli.grammar.completing import offering
from vrts.cli.shared.console import fail, reason_of

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

PROGRAM_ENDINGS = (".v2", ".val", ".val2", ".pg", ".as")
PROGRAMS = ("program", "programs")  # names of parameters


class ProgramFile(click.ParamType[Any]):
    """The file of a program; a folder stands for the only program in it."""

    name = "program"

    def __init__(self, kind: "click.ParamType[Any]") -> None:
        """Take the kind of value that the command wants."""
        self._kind = kind

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the program's file as the command wants it."""
        if isinstance(value, str) and os.path.isdir(value):
            value = str(_program_in(Path(value)))
        return self._kind.convert(value, param, ctx)

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> "list[CompletionItem]":
        """Let the shell complete a file."""
        from click.shell_completion import CompletionItem

        return [CompletionItem(incomplete, type="file")]


def completed(param: click.Parameter, command: str) -> click.Parameter:
    """Return a parameter of a command; its values are resolved, and a shell can complete it."""
    is_argument = isinstance(param, click.Argument)
    if is_argument and param.name in PROGRAMS and not isinstance(param.type, ProgramFile):
        param.type = ProgramFile(param.type)
    return offering(param, command)


def _program_in(folder: Path) -> Path:
    """Return the only program in a folder, or say which there are."""
    try:
        names = sorted(os.listdir(folder))
    except OSError as problem:
        fail(f"cannot look into the folder `{folder}`: {reason_of(problem)}")
    programs = (folder / name for name in names if name[0] != ".")
    found = [
        path for path in programs if path.suffix.lower() in PROGRAM_ENDINGS and os.path.isfile(path)
    ]
    if len(found) == 1:
        return found[0]
    if not found:
        fail(f"there is no program in `{folder}`", ("name the file of a program",))
    shown = ", ".join(f"`{path.name}`" for path in found[:9])
    return fail(
        f"there are several programs in `{folder}`: {shown}",
        ("name one of them", f"`vrts grade {folder}` marks what was handed in for a task"),
    )
