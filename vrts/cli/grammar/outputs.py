"""Outputs that cannot be written are told before anything is run."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from vrts.cli.shared.console import STDOUT, fail

FILES = frozenset(  # options that name a file to write, in whatever command
    (
        *("--html", "--record", "--mcap", "--certificate", "--csv", "--save", "--svg", "--sheet"),
        *("--counterexample", "--transcript", "--backup"),
    )
)
EITHER = "--output"  # names a file, or a folder that is made, as the command says
NO_STREAM = ("--record", "--transcript", "--backup")  # written in pieces, or by somebody else
FOLDERS = (  # what `--output` names there, or a file that is written in pieces
    *(("mark", "folder"), ("session", "folder"), ("plan", "folder"), ("merge", "folder")),
    *(("run", "target"), ("export", "target"), ("pack", "target"), ("camera", "output")),
    *(("teach", "output"), ("fetch", "output"), ("learn", "output")),
)
OWN = (("point", "--save"),)  # take more than a file


def require_outputs(command: click.Command, values: Mapping[str, Any]) -> bool:
    """Refuse a call whose outputs cannot be written; return whether one is stdout (`-`).

    Args:
        command: What is called.
        values: Of its parameters, by their names.
    """
    to_stdout: list[str] = []
    for param in command.params:
        option = _output(command, param)
        value = values.get(param.name or "")
        if option is None or not isinstance(value, str | Path):
            continue
        if str(value) == STDOUT:
            if option in NO_STREAM or (command.name, param.name) in FOLDERS:
                fail(f"`{option}` wants a name, not `-`")
            to_stdout.append(option)
        else:
            _require(Path(value), option, is_file=option != EITHER)
    if to_stdout and values.get("form") == "json":
        to_stdout.append("--json")
    if len(to_stdout) > 1:
        both = " and ".join(f"`{option}`" for option in to_stdout)
        fail(f"{both} would both be written to stdout", ("give one of them a file",))
    return bool(to_stdout)


def _output(command: click.Command, param: click.Parameter) -> str | None:
    """Return the name of an option that says what is written; None for all others."""
    if not isinstance(param, click.Option):
        return None
    names = {*FILES, EITHER} & set(param.opts)
    option = next(iter(names), None)
    return None if (command.name, option) in OWN else option


def _require(path: Path, option: str, *, is_file: bool) -> None:
    if path.is_dir():
        if is_file:
            fail(f"`{path}` is a folder, and `{option}` writes a file")
        _require_writable(path)
        return
    if path.exists():
        if not os.access(path, os.W_OK):
            fail(f"`{path}` may not be written to")
        return
    home = path.parent
    if is_file and not home.is_dir():
        fail(f"there is no folder `{home}` for `{path.name}`", ("make it first",))
    while not home.exists():
        home = home.parent
    if not home.is_dir():
        fail(f"`{home}` is no folder, so `{path}` cannot be written")
    _require_writable(home)


def _require_writable(folder: Path) -> None:
    if not os.access(folder, os.W_OK | os.X_OK):
        fail(f"nothing can be written in the folder `{folder}`")
