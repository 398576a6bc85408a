"""Files of a debugging session: whether they are what they were, and whether it may change any."""

from collections.abc import Iterable
from pathlib import Path

from vrts.monitor.folder import CannotUse, WorkingFolder

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
    """Some files as they are when this is made."""

    def __init__(self, paths: Iterable[Path], texts: Iterable[Path] = ()) -> None:
        """Take the files; one that is not there is watched as well.

        Args:
            paths: The files.
            texts: Those of them with programs, with which a run goes on when they are changed.
        """
        self._texts = frozenset(texts)
        self._first = {path: _stamp(path) for path in paths}
        self._told = dict(self._first)

    @property
    def stale(self) -> bool:
        """Whether any is not what it was at first."""
        return any(_stamp(path) != known for path, known in self._first.items())

    def taken(self, path: Path) -> None:
        """Know that a file, as it is now, is what is debugged."""
        if path in self._told:
            self._told[path] = _stamp(path)

    def news(self) -> str:
        """Return one sentence about what has changed since this was last asked; else nothing."""
        now = {path: _stamp(path) for path in self._told}
        others = [path for path, known in self._told.items() if now[path] != known]
        self._told = now
        if not others or not self.stale:
            return ""
        has = "has" if len(others) == 1 else "have"
        listed = ", ".join(f"`{path.name}`" for path in others)
        reloads = "type `reload` to go on with it, " if self._texts.intersection(others) else ""
        return f"{listed} {has} changed on disk: {reloads}`restart` begins again with it"


def _stamp(path: Path) -> tuple[int, int] | None:
    """Return what tells one content of a file from another; None where there is no such file."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size
