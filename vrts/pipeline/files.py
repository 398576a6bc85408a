"""Where scenes and examples are found, and how files are read.

A file that is not there is a wrong call and raises `CannotRead`.
"""

import re
import sys
from difflib import get_close_matches
from pathlib import Path

from vrts.base.source import SourceFile

PACKAGE = Path(__file__).parents[1]
LIBRARY = PACKAGE / "library"  # scenes and examples in an installed package
CHECKOUT = PACKAGE.parent  # the same in a checkout

SCENE_FILE = "scene.toml"
TASK_FILE = "task.toml"
STAFF = "staff"  # folder beside a task: what students do not get
MANIFEST_FILE = "manifest.json"  # of a packed task, also after unpacking
SCENARIO_FILE = "scenario.toml"  # beside a task: how its runs begin, and what happens in them
STDIN = "-"  # in place of the name of a file that is read
MAX_TOML = 1_000_000  # bytes


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


def find_scene(name: str, beside: Path | None = None) -> Path:
    """Return the file of a scene: a path, beside a given file, or a name of the library.

    Raises:
        CannotRead: There is no such scene.
    """
    if name == STDIN:
        return Path(STDIN)
    folders = [folder for folder in (beside, Path.cwd()) if folder is not None]
    for folder in folders:
        for candidate in (folder / name, folder / name / SCENE_FILE):
            if candidate.is_file():
                return candidate
    for folder in library_folders():
        candidate = folder / "scenes" / name / SCENE_FILE
        if re.fullmatch(r"[\w.-]+", name) and candidate.is_file():
            return candidate
    known = scene_names()
    close = [f"did you mean `{near}`?" for near in get_close_matches(name, known, 1, 0.6)]
    raise CannotRead(f"there is no scene `{name}`", (*close, f"scenes: {', '.join(known)}"))


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
    """Return the bytes of a file; `-` is stdin.

    Raises:
        CannotRead: It is not there, is a folder, or may not be read.
    """
    if str(path) == STDIN:
        return sys.stdin.buffer.read()
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
