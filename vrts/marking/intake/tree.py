"""The files below a folder or in a zip, by name: whatever they are, they are only read."""

import os
import stat
import unicodedata
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import BinaryIO, NamedTuple, Protocol

from vrts.base.zips import BadZip, Flaw, Unpacker
from vrts.marking.intake.content import HEAD, archive, is_zip
from vrts.marking.intake.file_names import flaw_of, is_junk, same_name
from vrts.pipeline.files import CannotRead

MOST_FILES = 100_000  # of a download

FLAWS = {
    Flaw.INCOMPLETE: "is damaged or not complete",
    Flaw.FOREIGN: "is encrypted, packed in an unusual way, or has too many files",
    Flaw.TWICE: "has two files of one name",
    Flaw.LENGTH: "has a file of another size than it says",
}


class Unreadable(Exception):  # noqa: N818 -- names the situation
    """A file cannot be read; the words continue a sentence that begins with its name."""


class Store(Protocol):
    """Where the bytes are."""

    def size(self, name: str) -> int:
        """Return how many bytes a file has, as far as known before it is read."""
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


def open_place(place: Path | Sequence[Path]) -> Tree:
    """Open a folder, a zip file, or a list of files and folders; close it with `with`.

    Raises:
        CannotRead: There is nothing of the kind.
    """
    if not isinstance(place, Path):
        return _list_tree(place)
    if place.is_dir():
        return _folder_tree(place)
    if not place.is_file():
        raise CannotRead(f"there is no `{place}`")
    with place.open("rb") as file:
        head = file.read(HEAD)
    if is_zip(head):
        return _opened_zip(place)
    packed = archive(head)
    if packed is not None:
        hint = "unpack it, and name the folder"
        raise CannotRead(f"`{place.name}` is {packed.what}, which is not opened", (hint,))
    return _list_tree([place])


def _opened_zip(path: Path) -> Tree:
    file = path.open("rb")
    try:
        return zip_tree(file, path.name, opened=file)
    except Unreadable as problem:
        file.close()
        help_ = "download it again; or unpack it, and name the folder"
        raise CannotRead(f"`{path.name}` {problem}", (help_,)) from problem


# zip files


class _ZipStore:
    def __init__(self, unpacker: Unpacker, members: dict[str, str]) -> None:
        self._unpacker = unpacker
        self._members = members  # by name in the tree

    def size(self, name: str) -> int:
        return self._unpacker.sizes[self._members[name]]

    def start(self, name: str, length: int) -> bytes:
        try:
            return self._unpacker.start(self._members[name], length)
        except BadZip as problem:
            raise Unreadable(FLAWS[problem.flaw]) from problem

    def read(self, name: str) -> bytes:
        try:
            return self._unpacker.read(self._members[name])
        except BadZip as problem:
            raise Unreadable(FLAWS[problem.flaw]) from problem


def zip_tree(source: bytes | BinaryIO, title: str, opened: BinaryIO | None = None) -> Tree:
    """Return the files in a zip.

    Raises:
        Unreadable: It is damaged, encrypted, or has too many files.
    """
    try:
        unpacker = Unpacker(source)
    except BadZip as problem:
        raise Unreadable(FLAWS[problem.flaw]) from problem
    if len(unpacker.members) > MOST_FILES:
        raise Unreadable(FLAWS[Flaw.FOREIGN])
    members: dict[str, str] = {}
    folders: set[str] = set()
    refused: dict[str, str] = {}
    for member, facts in unpacker.members.items():
        name = _name_in_zip(member)
        flaw = flaw_of(name)
        if flaw:
            refused[name] = flaw
        elif name.endswith("/"):
            folders.add(name.rstrip("/"))
        elif is_junk(name) or not name:
            folders.update(_parents([name]))
        elif not facts.plain:
            refused[name] = "is a link or a device"
        elif name in members:
            refused[name] = "is there twice"
        else:
            members[name] = member
    folders.update(_parents(members))
    kept = [folder for folder in folders if folder and not is_junk(f"{folder}/x")]
    return Tree(title, _ZipStore(unpacker, members), list(members), kept, refused, opened)


def _name_in_zip(member: str) -> str:
    """Return the name as it was meant: some write backslashes, and UTF-8 without saying so."""
    name = member.replace("\\", "/")
    if not name.isascii():
        with suppress(ValueError):  # no UTF-8 in disguise
            name = name.encode("cp437").decode("utf-8")
    parts = [part for part in name.split("/") if part not in ("", ".")]
    start, end = "/" * name.startswith("/"), "/" * name.endswith("/")
    return unicodedata.normalize("NFC", f"{start}{'/'.join(parts)}{end}")


# folders


class _FolderStore:
    def __init__(self, paths: dict[str, Path]) -> None:
        self._paths = paths

    def size(self, name: str) -> int:
        return self._paths[name].lstat().st_size

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
            reason = (problem.strerror or "failed").lower()
            raise Unreadable(f"cannot be read: {reason}") from problem

    def read(self, name: str) -> bytes:
        return self.start(name, self.size(name))


class _Walk(NamedTuple):
    paths: dict[str, Path]
    folders: set[str]
    refused: dict[str, str]


def _folder_tree(root: Path) -> Tree:
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


def _list_tree(places: Sequence[Path]) -> Tree:
    """Return files as named; of a folder, the files right in it."""
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


# names


def _parents(names: Iterable[str]) -> Iterator[str]:
    for name in names:
        at = name.rfind("/")
        while at > 0:
            yield name[:at]
            at = name.rfind("/", 0, at)


def clashes(names: Sequence[str]) -> tuple[str, str] | None:
    """Return two names that some system takes for one, or None."""
    seen: dict[str, str] = {}
    for name in names:
        key = same_name(name)
        if key in seen:
            return seen[key], name
        seen[key] = name
    return None
