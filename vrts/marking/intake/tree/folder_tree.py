"""The files below a folder, or named one by one: links are not followed, pipes not waited for."""

import os
import stat
import unicodedata
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from vrts.marking.intake.tree.file_names import is_junk
from vrts.marking.intake.tree.store import MOST_FILES, Tree, Unreadable
from vrts.pipeline.files import CannotRead


class _FolderStore:
    def __init__(self, paths: dict[str, Path]) -> None:
        self._paths = paths

    def size(self, name: str) -> int:
        try:
            return self._paths[name].lstat().st_size
        except OSError as problem:
            raise _unreadable(problem) from problem

    def start(self, name: str, length: int) -> bytes:
        path = self._paths[name]
        # neither following a link nor waiting for the other end of a pipe
        flags = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
        flags |= getattr(os, "O_BINARY", 0) | os.O_RDONLY
        try:
            with open(os.open(path, flags), "rb") as file:
                if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                    raise Unreadable("is no file")
                return file.read(length)
        except OSError as problem:
            raise _unreadable(problem) from problem

    def read(self, name: str) -> bytes:
        return self.start(name, self.size(name))


def _unreadable(problem: OSError) -> Unreadable:
    return Unreadable(f"cannot be read: {(problem.strerror or 'failed').lower()}")


class _Walk(NamedTuple):
    paths: dict[str, Path]
    folders: set[str]
    refused: dict[str, str]


def folder_tree(root: Path) -> Tree:
    """Return the files below a folder; links are not followed.

    Raises:
        CannotRead: It cannot be read, or has too many files.
    """
    walk = _Walk({}, set(), {})
    _walk(root, "", walk)
    return Tree(
        root.name, _FolderStore(walk.paths), list(walk.paths), list(walk.folders), walk.refused
    )


def _walk(root: Path, prefix: str, walk: _Walk) -> None:
    waiting = [(root, prefix)]
    while waiting:
        folder, above = waiting.pop()
        try:
            entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
        except OSError as problem:
            reason = (problem.strerror or "failed").lower()
            if folder == root:
                raise CannotRead(f"cannot read `{folder}`: {reason}") from problem
            walk.refused[above.rstrip("/")] = f"cannot be read: {reason}"
            continue
        for entry in entries:
            name = above + _shown(entry.name)
            if entry.is_symlink():
                if not is_junk(name):
                    walk.refused[name] = "is a link"
            elif entry.is_dir():
                if not is_junk(f"{name}/x"):
                    walk.folders.add(name)
                    waiting.append((Path(entry.path), f"{name}/"))
            elif not is_junk(name):
                _keep(Path(entry.path), name, walk)
        if len(walk.paths) > MOST_FILES:
            raise CannotRead(f"`{root}` has more than {MOST_FILES:,} files")


def _keep(path: Path, name: str, walk: _Walk) -> None:
    if not stat.S_ISREG(path.lstat().st_mode):
        walk.refused[name] = "is a device or a pipe"
    elif name in walk.paths:
        walk.refused[name] = "is there twice"
    else:
        walk.paths[name] = path


def _shown(name: str) -> str:
    """Return the name of a file as text; names that are no UTF-8 are read as Windows has them."""
    try:
        text = os.fsencode(name).decode("utf-8")
    except UnicodeDecodeError:
        text = os.fsencode(name).decode("cp1252", errors="replace")
    shown = "".join("�" if unicodedata.category(c) == "Cc" else c for c in text)
    return unicodedata.normalize("NFC", shown)


def list_tree(places: Sequence[Path]) -> Tree:
    """Return files as named; of a folder, the files right in it.

    Raises:
        CannotRead: One of them is not there.
    """
    walk = _Walk({}, set(), {})
    for place in places:
        if not place.exists():
            raise CannotRead(f"there is no `{place}`")
        if place.is_dir():
            for path in sorted(place.iterdir()):
                if path.is_file() and not is_junk(path.name):
                    walk.paths[_shown(path.as_posix())] = path
        else:
            walk.paths[_shown(place.as_posix())] = place.resolve()  # named by the teacher
    tree = Tree("files", _FolderStore(walk.paths), list(walk.paths), [], walk.refused)
    tree.is_list = True
    return tree
