"""The files of the vrts that runs here, by name in its wheel: those that are known to be its own.

Beside them may lie anything, marks of students too: a folder is never taken as it is. An installed
vrts has a list of its files, a checkout has Git's.
"""

import os
import shutil
import subprocess
from collections.abc import Iterable
from importlib.metadata import Distribution
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

import msgspec

_SHARED = ("scenes", "examples")  # beside the package in a checkout, within it in a wheel
_MADE = "__pycache__"  # by Python


class NoFiles(Exception):  # noqa: N818 -- names the situation
    """Nobody can tell which files are of vrts; the text says why."""


class _Origin(msgspec.Struct):
    url: str


def installed_files(installed: Distribution) -> dict[str, bytes]:
    """Return the files of an installed package, as its own list has them.

    Raises:
        NoFiles: It has none, or what it names is not there.
    """
    names = [str(path) for path in installed.files or () if path.parts[0] == "vrts"]
    root = Path(str(installed.locate_file("")))
    return {name: _read(root, name) for name in sorted(names) if _MADE not in name}


def checkout_files(root: Path) -> dict[str, bytes]:
    """Return the files that Git knows of a checkout: commit a new one first.

    Raises:
        NoFiles: It is no checkout, or Git is not there.
    """
    git = shutil.which("git")
    if git is None:
        raise NoFiles("it runs from a folder, and there is no Git to tell which files are its own")
    names = _known(git, root, ("vrts", *_SHARED))
    if "vrts/__init__.py" not in names:
        raise NoFiles(f"it runs from `{root}`, which is no checkout of Git")
    there = [name for name in names if os.path.lexists(root / name)]
    return {_in_wheel(name): _read(root, name) for name in there}


def is_checkout(installed: Distribution, root: Path) -> bool:
    """Return whether what was installed is a checkout that stays where it is."""
    text = installed.read_text("direct_url.json")
    if not text:
        return False
    try:
        url = msgspec.json.decode(text, type=_Origin).url
    except msgspec.MsgspecError:
        return False
    place = Path(url2pathname(urlsplit(url).path))
    return place.is_dir() and place.samefile(root)


def _known(git: str, root: Path, folders: Iterable[str]) -> list[str]:
    ours = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    command = [git, "-C", str(root), "ls-files", "-z", "--", *folders]
    done = subprocess.run(command, env=ours, capture_output=True, check=False)  # noqa: S603
    return sorted(filter(None, os.fsdecode(done.stdout).split("\0")))


def _in_wheel(name: str) -> str:
    return f"vrts/library/{name}" if name.split("/")[0] in _SHARED else name


def _read(root: Path, name: str) -> bytes:
    """Return the bytes of a file; a link might lead to anything."""
    path = root.resolve() / name
    if path.resolve() != path:
        raise NoFiles(f"`{name}` is a link")
    try:
        return path.read_bytes()
    except OSError as problem:
        raise NoFiles(f"`{name}` cannot be read") from problem
