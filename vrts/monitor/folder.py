"""The files a monitor may touch: those that lie directly in its working folder."""

import os
import re
from pathlib import Path
from typing import NamedTuple, Protocol

MAX_BYTES = 4_000_000  # of a file, as the compiler takes them
MAX_FILES = 1_000  # that are listed
SUFFIXES = (".v2", ".pg", ".lc", ".rv", ".st", ".as", ".val", ".txt")  # that may be written

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_. -]{0,98}")


class CannotUse(Exception):  # noqa: N818 -- names the situation
    """A file cannot be used; `words` are VAL's, `reason` is ours."""

    def __init__(self, words: str, reason: str) -> None:
        """Keep both."""
        super().__init__(reason)
        self.words = words
        self.reason = reason


class FileEntry(NamedTuple):
    """A file as a directory shows it."""

    name: str
    size: int  # bytes


class Folder(Protocol):
    """Named files. Every method raises `CannotUse` for what it will not or cannot do."""

    def entries(self) -> tuple[FileEntry, ...]:
        """Return the files, by name."""
        ...

    def exists(self, name: str) -> bool:
        """Return whether there is such a file."""
        ...

    def read(self, name: str) -> bytes:
        """Return what a file holds."""
        ...

    def write(self, name: str, data: bytes, *, replace: bool) -> None:
        """Make a file; one that is there is replaced only if that is wanted."""
        ...

    def delete(self, name: str) -> None:
        """Remove a file."""
        ...


class WorkingFolder:
    """A folder of the disk: no path leads out of it, no link is followed."""

    def __init__(self, root: Path) -> None:
        """Take a folder that exists."""
        self._root = root.resolve()

    def entries(self) -> tuple[FileEntry, ...]:
        """Return the regular files of the folder, hidden ones left out."""
        found = [
            FileEntry(entry.name, entry.stat(follow_symlinks=False).st_size)
            for entry in os.scandir(self._root)
            if _NAME.fullmatch(entry.name) and entry.is_file(follow_symlinks=False)
        ]
        return tuple(sorted(found)[:MAX_FILES])

    def exists(self, name: str) -> bool:
        """Return whether something of this name is there, whatever it is."""
        return os.path.lexists(self._path(name))

    def read(self, name: str) -> bytes:
        """Return the bytes of a regular file."""
        path = self._regular(name)
        try:
            with os.fdopen(os.open(path, os.O_RDONLY | _NO_LINKS), "rb") as file:
                data = file.read(MAX_BYTES + 1)
        except OSError as problem:
            raise _failed(name, problem) from problem
        if len(data) > MAX_BYTES:
            raise CannotUse("Not enough storage area", f"`{name}` is larger than 4 MB")
        return data

    def write(self, name: str, data: bytes, *, replace: bool) -> None:
        """Write a file whole or not at all."""
        path = self._writable(name)
        if len(data) > MAX_BYTES:
            raise CannotUse("Not enough storage area", f"`{name}` would be larger than 4 MB")
        if os.path.lexists(path):
            if not replace:
                raise CannotUse("File already exists", f"`{name}` is kept as it is")
            self._regular(name)
        draft = path.with_name(f".{path.name}.part")
        try:
            draft.unlink(missing_ok=True)
            flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | _NO_LINKS
            with os.fdopen(os.open(draft, flags, 0o644), "wb") as file:
                file.write(data)
            draft.replace(path)
        except OSError as problem:
            raise _failed(name, problem) from problem

    def delete(self, name: str) -> None:
        """Remove a regular file of a kind that the monitor writes."""
        self._writable(name)
        path = self._regular(name)
        try:
            path.unlink()
        except OSError as problem:
            raise _failed(name, problem) from problem

    def _path(self, name: str) -> Path:
        if not _NAME.fullmatch(name) or ".." in name:
            raise CannotUse(
                "Nonexistent file",
                f"`{name[:60]}` is no name of a file in the working folder",
            )
        return self._root / name

    def _regular(self, name: str) -> Path:
        path = self._path(name)
        if path.is_symlink() or (path.exists() and not path.is_file()):
            raise CannotUse("Nonexistent file", f"`{name}` is a link or no file")
        if not path.exists():
            raise CannotUse("Nonexistent file", f"there is no `{name}` in the working folder")
        return path

    def _writable(self, name: str) -> Path:
        path = self._path(name)
        if path.suffix.lower() not in SUFFIXES:
            known = ", ".join(SUFFIXES)
            raise CannotUse("Nonexistent file", f"the monitor writes only {known}: not `{name}`")
        return path


_NO_LINKS = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)


def _failed(name: str, problem: OSError) -> CannotUse:
    reason = (problem.strerror or "failed").lower()
    return CannotUse("Nonexistent file", f"`{name}`: {reason}")
