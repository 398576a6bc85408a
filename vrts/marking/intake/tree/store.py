"""A download as files by name, wherever their bytes are."""

from collections.abc import Sequence
from types import TracebackType
from typing import BinaryIO, Protocol

MOST_FILES = 100_000  # of a download


class Unreadable(Exception):  # noqa: N818 -- names the situation
    """A file cannot be read; the words continue a sentence that begins with its name."""


class Store(Protocol):
    """Where the bytes are."""

    def size(self, name: str) -> int:
        """Return how many bytes a file has, as far as known before it is read.

        Raises:
            Unreadable: Not even that can be known.
        """
        ...

    def start(self, name: str, length: int) -> bytes:
        """Return the first bytes of a file, or raise `Unreadable`."""
        ...

    def read(self, name: str) -> bytes:
        """Return the bytes of a file, or raise `Unreadable`."""
        ...


class Tree:
    """Files by name, with `/` between folders; junk of operating systems is left out."""

    def __init__(
        self,
        title: str,
        store: Store,
        files: Sequence[str],
        folders: Sequence[str],
        refused: dict[str, str],
        opened: BinaryIO | None = None,
    ) -> None:
        """Keep what was found.

        Args:
            title: Of the whole, as shown.
            store: Knows every file by its name here.
            files: That can be read.
            folders: All, also those without files.
            refused: Files that are not read, and why, as the end of a sentence.
            opened: The zip file, to close in the end; None for files that are there already.
        """
        self.title = title
        self.store = store
        self.files = tuple(sorted(files))
        self.folders = tuple(sorted(folders))
        self.refused = refused
        self.is_zip = opened is not None
        self.is_list = False  # of files that were named one by one
        self._opened = opened

    def __enter__(self) -> "Tree":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        problem: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._opened is not None:
            self._opened.close()
