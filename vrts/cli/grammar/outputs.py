"""Outputs that cannot be written are told before anything is run."""

import os
import stat
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from vrts.cli.shared.console import STDOUT, fail, reason_of

FILES = frozenset(  # options that name a file to write, in whatever command
    (
        *("--html", "--record", "--mcap", "--certificate", "--csv", "--save", "--svg", "--sheet"),
        *("--counterexample", "--transcript", "--backup", "--png"),
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
ALSO = (("rehearse", "--log"),)  # elsewhere it names a file that is read


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
        in_pieces = option in NO_STREAM or (command.name, param.name) in FOLDERS
        if str(value) == STDOUT:
            if in_pieces:
                fail(f"`{option}` wants a name, not `-`")
            to_stdout.append(option)
        else:
            _require(Path(value), option, is_file=option != EITHER, in_pieces=in_pieces)
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
    also = {option for name, option in ALSO if name == command.name}
    names = {*FILES, EITHER, *also} & set(param.opts)
    option = next(iter(names), None)
    return None if (command.name, option) in OWN else option


def _require(path: Path, option: str, *, is_file: bool, in_pieces: bool) -> None:
    there = _status(path)
    if there is not None and stat.S_ISDIR(there.st_mode):
        if is_file:
            fail(f"`{path}` is a folder, and `{option}` writes a file")
        _require_writable(path)
    elif there is not None:
        is_replaced = not in_pieces and stat.S_ISREG(there.st_mode)
        if is_replaced:
            _require_writable(_home(path))
        if not (is_replaced and _may_be_replaced(there)) and not os.access(path, os.W_OK):
            fail(f"`{path}` may not be written to")
    else:
        home = _home(path)
        if is_file and not os.path.isdir(home):
            fail(f"there is no folder `{home}` for `{path.name}`", ("make it first",))
        while not os.path.exists(home):
            home = home.parent
        if not os.path.isdir(home):
            fail(f"`{home}` is no folder, so `{path}` cannot be written")
        _require_writable(home)


def _status(path: Path) -> os.stat_result | None:
    """Return what there is about a file; None where there is none."""
    try:
        return path.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    except OSError as problem:
        fail(f"`{path}` cannot be written: {reason_of(problem)}")


def _home(path: Path) -> Path:
    """Return the folder that a file is written in: where a link leads, not where it is."""
    return (Path(os.path.realpath(path)) if os.path.islink(path) else path).parent


def _may_be_replaced(there: os.stat_result) -> bool:
    """Return whether another file may take the place of one, with its owner, as `write_file` does.

    Where it may not, the file itself is written to.
    """
    if os.name == "nt":
        return False
    groups = (os.getegid(), *os.getgroups())
    return os.geteuid() in (0, there.st_uid) and (os.geteuid() == 0 or there.st_gid in groups)


def _require_writable(folder: Path) -> None:
    if not os.access(folder, os.W_OK | os.X_OK):
        fail(f"nothing can be written in the folder `{folder}`")
