"""Where scenes and examples are found, and how files are read.

A file that is not there is a wrong call and raises `CannotRead`.
"""

import os
import re
import sys
from difflib import get_close_matches
from pathlib import Path, PurePath
from typing import NoReturn

from vrts.base.source import SourceFile

PACKAGE = Path(__file__).parents[1]
LIBRARY = PACKAGE / "library"  # scenes and examples in an installed package
CHECKOUT = PACKAGE.parent  # the same in a checkout

SCENE_FILE = "scene.toml"
TASK_FILE = "task.toml"
STAFF = "staff"  # folder beside a task: what students do not get
MANIFEST_FILE = "manifest.json"  # of a packed task, also after unpacking
SCENARIO_FILE = "scenario.toml"  # beside a task: how its runs begin, and what happens in them
STDIN = "-"  # in place of the name of a file that is read, where whoever calls names it
MAX_TOML = 1_000_000  # bytes
MAX_STDIN = 256_000_000  # bytes
_PIECE = 1_000_000  # bytes that are read at once


class CannotRead(Exception):  # noqa: N818 -- names the situation
    """A file that a request names cannot be read."""

    def __init__(self, message: str, hints: tuple[str, ...] = ()) -> None:
        """Say which and why; `hints` tell what there is instead."""
        super().__init__(message)
        self.message = message
        self.hints = hints


def library_folders() -> tuple[Path, ...]:
    """Return the folders that hold `scenes` and `examples`, the checkout's first."""
    return tuple(folder for folder in (CHECKOUT, LIBRARY) if (folder / "scenes").is_dir())


def scene_names() -> tuple[str, ...]:
    """Return the names of the scenes that come with vrts."""
    return tuple(
        sorted(
            {
                path.parent.name
                for folder in library_folders()
                for path in (folder / "scenes").glob(f"*/{SCENE_FILE}")
            }
        )
    )


def unwritable(name: str) -> str:
    """Return why a file cannot be written, for a sentence; nothing where it can, or is none yet."""
    try:
        mode = os.stat(name).st_mode
    except (OSError, ValueError):
        return ""  # a buffer that was never saved
    if mode & 0o222 and os.access(name, os.W_OK):
        return ""
    return f"`{os.path.basename(name)}` is write-protected"


def asked_scene(name: str, beside: Path | None = None) -> Path:
    """Return the file of a scene that whoever calls has named; `-` is stdin.

    A name of the library means the library's, whatever stands here or beside a program: that may
    have been handed in. All else is a path from the working folder, or else from a given one.

    Args:
        name: As it was typed.
        beside: Folder to look in last.

    Raises:
        CannotRead: There is no such scene.
    """
    if name == STDIN:
        return Path(STDIN)
    found = _in_library(name) or _scene_in(Path.cwd(), name)
    if found is None and beside is not None:
        found = _scene_in(beside, name)
    return found or _no_scene(name)


def find_scene(name: str, folder: Path) -> Path:
    """Return the file of a scene that a file names: beside that file, or in the library.

    Args:
        name: As it stands in the file.
        folder: That the file is in.

    Raises:
        CannotRead: There is no such scene.
    """
    if not names_file(name):
        _no_scene(name)
    found = _scene_in(folder, name) or _in_library(name) or _scene_in(Path.cwd(), name)
    return found or _no_scene(name)


def _scene_in(folder: Path, name: str) -> Path | None:
    places = (folder / name, folder / name / SCENE_FILE)
    return next((place for place in places if os.path.isfile(place)), None)


def _in_library(name: str) -> Path | None:
    if re.fullmatch(r"[\w.-]+", name) is None:
        return None
    places = (folder / "scenes" / name / SCENE_FILE for folder in library_folders())
    return next((place for place in places if os.path.isfile(place)), None)


def _no_scene(name: str) -> NoReturn:
    known = scene_names()
    close = [f"did you mean `{near}`?" for near in get_close_matches(name, known, 1, 0.6)]
    raise CannotRead(f"there is no scene `{name}`", (*close, f"scenes: {', '.join(known)}"))


def names_file(name: str) -> bool:
    """Return whether a name that stands in a file may be that of another: `-` there is none."""
    return PurePath(name) != PurePath(STDIN) and "\0" not in name


def named_place(folder: Path, name: str) -> Path:
    """Return the place of a file that a file names.

    Args:
        folder: That the file which names it is in.
        name: As it stands there.

    Raises:
        CannotRead: It is no name of a file. Stdin is for whoever calls.
    """
    if not names_file(name):
        raise CannotRead(f"`{name}` is no name of a file", ("give the file a name of its own",))
    return folder / name


def example_names() -> tuple[str, ...]:
    """Return the names of the examples that come with vrts."""
    return tuple(
        sorted(
            {
                path.parent.name
                for folder in library_folders()
                for path in (folder / "examples").glob(f"*/{TASK_FILE}")
            }
        )
    )


def find_example(name: str) -> Path | None:
    """Return the folder of an example: a path, or a name of the library."""
    if Path(name).is_dir():
        return Path(name)
    for folder in library_folders():
        candidate = folder / "examples" / name
        if re.fullmatch(r"[\w.-]+", name) and candidate.is_dir():
            return candidate
    return None


def read_bytes(path: Path) -> bytes:
    """Return the bytes of a file that whoever calls has named; `-` is stdin.

    Raises:
        CannotRead: It is not there, is a folder, or may not be read; or stdin is too large.
    """
    return read_stdin() if str(path) == STDIN else member_bytes(path)


def read_stdin() -> bytes:
    """Return all that comes from stdin.

    Raises:
        CannotRead: It is too large.
    """
    pieces: list[bytes] = []
    size = 0
    while piece := sys.stdin.buffer.read(_PIECE):
        pieces.append(piece)
        size += len(piece)
        if size > MAX_STDIN:
            raise CannotRead(f"stdin is too large: more than {MAX_STDIN:,} bytes")
    return b"".join(pieces)


def member_bytes(path: Path) -> bytes:
    """Return the bytes of a file that was found in a folder: `-` is a name as any other.

    Raises:
        CannotRead: It is not there, is a folder, or may not be read.
    """
    try:
        return path.read_bytes()
    except OSError as problem:
        reason = (problem.strerror or "unreadable").lower()
        raise CannotRead(f"cannot read `{path}`: {reason}") from problem


def read_toml_source(path: Path, home: Path | None = None) -> SourceFile:
    """Return the text of a TOML file.

    Args:
        path: Of the file.
        home: Folder from which names are shown; None: the working folder.

    Raises:
        CannotRead: It is not there, is too large, or is not UTF-8.
    """
    data = read_bytes(path)
    if len(data) > MAX_TOML:
        raise CannotRead(f"`{path}` is too large: {len(data):,} bytes")
    try:
        return SourceFile(shown(path, home), data.decode("utf-8-sig").replace("\r\n", "\n"))
    except UnicodeDecodeError as problem:
        raise CannotRead(f"`{path}` is not UTF-8 text") from problem


def shown(path: Path, home: Path | None = None) -> str:
    """Return a path as diagnostics show it: relative to the working folder where it is inside."""
    if str(path) == STDIN:
        return "stdin"
    try:
        return str(path.resolve().relative_to(Path.cwd() if home is None else home.resolve()))
    except ValueError:
        return str(path)
