"""The files in a zip: read without trust, and never written anywhere."""

import unicodedata
from collections.abc import Iterable, Iterator
from contextlib import suppress
from typing import BinaryIO

from vrts.base.zips import BadZip, Flaw, Unpacker
from vrts.marking.intake.tree.file_names import flaw_of, is_junk
from vrts.marking.intake.tree.store import MOST_FILES, Tree, Unreadable

FLAWS = {
    Flaw.INCOMPLETE: "is damaged or not complete",
    Flaw.FOREIGN: "is encrypted, packed in an unusual way, or has too many files",
    Flaw.TWICE: "has two files of one name",
    Flaw.LENGTH: "has a file of another size than it says",
}


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


def _parents(names: Iterable[str]) -> Iterator[str]:
    for name in names:
        at = name.rfind("/")
        while at > 0:
            yield name[:at]
            at = name.rfind("/", 0, at)
