"""Program files as an editor holds them: buffers that are open, and the files beside them."""

import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.ir.module import Datum
from vrts.lang.dialect import Dialect
from vrts.lang.reading.decoding import decode
from vrts.lang.reading.detection import detect
from vrts.lang.typed.loading import contents
from vrts.lsp.documents.names import Names, names_of

SUFFIXES = frozenset({".v2", ".pg", ".val", ".val2", ".as", ".lc", ".rv", ".st"})  # of the family
MOST_FILES = 500  # of one folder that are looked at
MOST_BYTES = 1_000_000  # of a file beside an open one
_CONTROLS = {0: " ", 12: " ", 26: " "}  # which a file may hold: columns stay as the editor counts


class Document:
    """The text of one file, and what is known of it. Never changes: an edit makes another."""

    def __init__(self, path: str, text: str) -> None:
        """Take the text; a file that cannot be a program counts as empty.

        Args:
            path: Absolute, or any name for a buffer that is in no file.
            text: As the editor holds it, with line ends of any kind.
        """
        self.path = path
        self._names: Names | None = None
        text = text.replace("\r\n", "\n").replace("\r", "\n").translate(_CONTROLS)
        found = decode(text.encode("utf-8", "replace"), os.path.basename(path))
        blank = not text.strip()  # nothing is written yet: no reason for a complaint
        self.refusal = found if isinstance(found, Diagnostic) and not blank else None
        self.source = SourceFile(os.path.basename(path), text if self.refusal is None else "")

    @cached_property
    def dialect(self) -> Dialect:
        """Language of the family, as file name and content tell."""
        return detect(self.source)[0]

    @property
    def names(self) -> Names:
        """Every name of the text and its uses."""
        return self.read()

    def read(self) -> Names:
        """Find the names, once. Without a lock: nobody waits until another file is read."""
        found = self._names
        if found is None:
            found = self._names = names_of(self.source, self.dialect)
        return found

    @property
    def is_read(self) -> bool:
        """Whether its names are known."""
        return self._names is not None

    @cached_property
    def data(self) -> Mapping[tuple[str, tuple[int, ...]], Datum]:
        """Values of the data sections, by name and subscripts; the last one holds."""
        found = contents(self.source, self.dialect).data
        return {(datum.name, datum.subscripts): datum for datum in found}


class _OnDisk(NamedTuple):
    modified_ns: int
    size: int
    document: Document | None  # None: too large, or no program


class Documents:
    """Buffers by their paths, and the program files of the folders that they are in."""

    def __init__(self) -> None:
        self.open: dict[str, Document] = {}
        self._on_disk: dict[str, _OnDisk] = {}

    def put(self, path: str, text: str) -> Document:
        """Take the text of a buffer; return its document."""
        document = self.open[path] = Document(path, text)
        return document

    def close(self, path: str) -> None:
        """Forget a buffer: its file counts again."""
        self.open.pop(path, None)

    def at(self, path: str) -> Document | None:
        """Return a file: its buffer, or as saved; None where it cannot be had."""
        return self.open.get(path) or self._saved(path)

    def beside(self, path: str) -> list[Document]:
        """Return the program files of the folder of a file, itself not included, by name.

        Only those that have been read: whoever needs all reads the folder first.
        """
        return [d for d in self.in_folder(os.path.dirname(path)) if d.path != path]

    def in_folder(self, folder: str) -> list[Document]:
        """Return the program files of a folder that have been read, by name, and its buffers."""
        found: list[Document] = []
        for path in self._paths(folder):
            saved = self._as_it_is(path) if path not in self.open else None
            document = saved.document if saved is not None else self.open.get(path)
            if document is not None and (document.is_read or path in self.open):
                found.append(document)
        return found

    def unread(self, folder: str) -> list[str]:
        """Return the paths of the program files of a folder that are new or have changed."""
        found: list[str] = []
        for path in self._paths(folder):
            saved = self._as_it_is(path)
            document = saved.document if saved is not None else None
            is_known = saved is not None and (document is None or document.is_read)
            if path not in self.open and not is_known:
                found.append(path)
        return found

    def read(self, path: str) -> None:
        """Read a file, if it is a program, so that it is among those of its folder."""
        document = self._saved(path)
        if document is not None:
            document.names.summarise()

    def everywhere(self, folders: Iterable[str]) -> list[Document]:
        """Return the program files of some folders and of those with open buffers."""
        return [document for folder in self.folders(folders) for document in self.in_folder(folder)]

    def folders(self, more: Iterable[str] = ()) -> list[str]:
        """Return the folders with open buffers, and more."""
        return sorted({*more, *(os.path.dirname(path) for path in self.open)})

    def _paths(self, folder: str) -> list[str]:
        paths = set(_program_files(folder)) if folder else set[str]()
        buffers = list(self.open)  # at once: another thread may open one meanwhile
        paths.update(path for path in buffers if os.path.dirname(path) == folder)
        return sorted(paths)

    def _as_it_is(self, path: str) -> _OnDisk | None:
        """Return what is known of a file on disk; None when it has changed since, or is gone."""
        known = self._on_disk.get(path)
        try:
            status = os.stat(path)
        except OSError:
            return None  # files come and go while a folder is looked at
        same = known and (known.modified_ns, known.size) == (status.st_mtime_ns, status.st_size)
        return known if same else None

    def _saved(self, path: str) -> Document | None:
        """Return a file on disk; None when it is gone, unreadable, too large or no program."""
        known = self._as_it_is(path)
        if known is not None:
            return known.document
        try:
            status = os.stat(path)
            data = Path(path).read_bytes() if status.st_size <= MOST_BYTES else b""
        except OSError:
            return None
        found = decode(data, os.path.basename(path))
        document = None if isinstance(found, Diagnostic) else Document(path, found.text)
        self._on_disk[path] = _OnDisk(status.st_mtime_ns, status.st_size, document)
        return document


def is_program_file(path: str) -> bool:
    """Return whether a file is of the family, by its name."""
    return os.path.splitext(path)[1].lower() in SUFFIXES


def file_stamps(folder: str) -> tuple[tuple[str, int, int], ...]:
    """Return paths, times of change [ns] and sizes of the program files of a folder."""
    found: list[tuple[str, int, int]] = []
    for path in _program_files(folder):
        try:
            status = os.stat(path)
        except OSError:
            continue  # gone while it is looked at
        found.append((path, status.st_mtime_ns, status.st_size))
    return tuple(found)


def _program_files(folder: str) -> Iterator[str]:
    """Return the paths of the first program files of a folder, links to elsewhere left out."""
    try:
        with os.scandir(folder) as entries:
            names = sorted(
                entry.name
                for entry in entries
                if is_program_file(entry.name) and entry.is_file(follow_symlinks=False)
            )
    except OSError:
        return  # a folder that is not there holds nothing
    for name in names[:MOST_FILES]:
        yield os.path.join(folder, name)
