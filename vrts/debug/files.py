"""Files of a debugging session: whether they are what they were, and whether it may change any."""

import hashlib
from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

from vrts.base.diagnostic import Diagnostic
from vrts.lang.reading.decoding import decode
from vrts.monitor.folder import CannotUse, WorkingFolder
from vrts.pipeline.files import CannotRead, member_bytes

LOCKED = "a script changes no file"


class Lockable(WorkingFolder):
    """The monitor's folder; while it is locked no command changes a file, whatever its name is."""

    locked = False
    refused = False  # a change was, since somebody last said that none was

    def write(self, name: str, data: bytes, *, replace: bool) -> None:
        """Write a file whole or not at all."""
        self._change()
        super().write(name, data, replace=replace)

    def delete(self, name: str) -> None:
        """Remove a regular file of a kind that the monitor writes."""
        self._change()
        super().delete(name)

    def _change(self) -> None:
        if self.locked:
            self.refused = True
            raise CannotUse("Nonexistent file", LOCKED)


class Files:
    """Some files as they are when this is made; told apart by what stands in them."""

    def __init__(self, paths: Iterable[Path], texts: Iterable[Path] = ()) -> None:
        """Take the files; one that is not there is watched as well.

        Args:
            paths: The files.
            texts: Those of them with programs, with which a run goes on when they are changed.
        """
        self._texts = frozenset(texts)
        self._known: dict[Path, tuple[_Stamp, bytes]] = {}
        self._first = {path: self._content(path) for path in paths}
        self._told = dict(self._first)
        self._debugged: dict[Path, bytes] = {}  # texts that an editor sent: saved later, or before

    @property
    def stale(self) -> bool:
        """Whether any is not what it was at first."""
        return any(self._content(path) != known for path, known in self._first.items())

    def taken(self, path: Path, text: str) -> None:
        """Know the text of a file that is debugged now, whether it stands there already or not."""
        if path in self._told:
            self._debugged[path] = _digest(text.encode("utf-8", "replace"))
            self._told[path] = self._content(path)

    def news(self) -> str:
        """Return one sentence about what has changed since this was last asked; else nothing."""
        now = {path: self._content(path) for path in self._told}
        others = [
            path
            for path, known in self._told.items()
            if now[path] != known and (now[path] or b"") != self._debugged.get(path)
        ]
        self._told = now
        if not others or not self.stale:
            return ""
        has = "has" if len(others) == 1 else "have"
        listed = ", ".join(f"`{path.name}`" for path in others)
        reloads = "type `reload` to go on with it, " if self._texts.intersection(others) else ""
        return f"{listed} {has} changed on disk: {reloads}`restart` begins again with it"

    def _content(self, path: Path) -> bytes | None:
        """Return what tells one content from another; None where there is no such file."""
        stamp = _stamp(path)
        if stamp is None:
            return None
        known = self._known.get(path)
        if known is None or known[0] != stamp:
            known = self._known[path] = stamp, self._read(path, stamp)
        return known[1]

    def _read(self, path: Path, stamp: "_Stamp") -> bytes:
        try:
            data = member_bytes(path)
        except CannotRead:
            return repr(stamp).encode()  # then its time tells
        if path in self._texts:
            source = decode(data, path.name)
            data = data if isinstance(source, Diagnostic) else source.text.encode()
        return _digest(data)


_Stamp: TypeAlias = tuple[int, int]
"""Time of the last change [ns], size."""


def _stamp(path: Path) -> _Stamp | None:
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


def _digest(data: bytes) -> bytes:
    return hashlib.sha256(data.replace(b"\r\n", b"\n")).digest()
