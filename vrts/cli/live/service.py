"""`vrts serve --service`: a unit for systemd that runs this very command."""

import sys
from pathlib import Path
from typing import Final

import click

from vrts.cli.shared.console import fail, out

# what ends after its work is no server; this option least of all
_ENDING: Final = (
    frozenset(
        ("service", "add_user", "supervisor", "purge_user", "verify_logs", "accept_logs", "backup")
    )
    | frozenset(("ways_in", "renew_code", "end_way", "send_away", "supervisor_link"))
    | frozenset(("purge_mentions", "export_user", "output"))
)


def print_service(context: click.Context, writes: tuple[Path, ...], port: int) -> None:
    """Print the unit; `writes` are the folders in which the server writes, the own one first."""
    from vrts.live.watching.service import Service, unit

    if port == 0:
        fail("a service needs a port that stays", ("such as `--port 8000`",))
    words, reads = _words(context)
    program = Path(sys.executable).with_name("vrts")
    begin = (str(program),) if program.is_file() else (sys.executable, "-m", "vrts.cli.main")
    reads = (*reads, Path(sys.executable).resolve())  # it may lie elsewhere than the command
    paths = tuple(folder.absolute() for folder in writes)
    if any(not str(path).isprintable() for path in (*paths, *reads)):
        fail("a path has characters that a service's file cannot have")
    service = Service((*begin, "serve", *words), paths, reads, port, own_key=len(writes) == 1)
    out(unit(service), end=False)


def folder_of_key(key: Path, folder: Path) -> Path:
    """Return the folder of a key, which is given to the service's user with all that is in it.

    So it may hold nothing else.
    """
    own = key.absolute().parent
    try:
        others = [file for file in own.iterdir() if not file.name.startswith(key.name)]
        alone = not others and not folder.resolve().is_relative_to(own.resolve())
    except FileNotFoundError:
        alone = not folder.resolve().is_relative_to(own.resolve())
    except OSError:  # nobody may look into it, or it is no folder
        alone = False
    if not alone:
        hint = f"such as `--log-key {own / 'vrts-log-key' / key.name}`"
        fail(f"a service needs a folder for its key alone, and `{own}` holds more", (hint,))
    return own


def _words(context: click.Context) -> tuple[list[str], tuple[Path, ...]]:
    """Return the arguments of this call with absolute paths, and the paths that are read."""
    words: list[str] = []
    reads: list[Path] = []

    def whole(value: object) -> str:
        path = Path(str(value))
        if isinstance(value, Path) or path.exists():
            reads.append(path.absolute())
            return str(path.absolute())
        return str(value)

    scenes: list[str] = []
    for parameter in context.command.params:
        name, value = str(parameter.name), context.params.get(str(parameter.name))
        if name == "scenes":
            scenes += map(whole, context.params["scenes"])
            continue
        if name in _ENDING or not isinstance(parameter, click.Option):
            continue
        if name != "folder" and value in (None, (), parameter.default):
            continue
        option = parameter.opts[-1]
        if parameter.is_flag:
            words += [option] if value else []
        elif parameter.multiple:
            words += [word for one in value or () for word in (option, str(one))]
        else:
            words += [option, whole(value) if isinstance(value, Path) else str(value)]
    return [*scenes, *words], tuple(reads)
