"""Whether a file names somebody: in its text, as HTML or JSON write it, and inside zips."""

import json
import os
from collections.abc import Iterator, Sequence
from html import escape
from io import BytesIO
from pathlib import Path

from vrts.base.zips import BadZip, Unpacker

SHORTEST = 3  # letters of what is looked for: less stands anywhere by chance
DEEPEST = 3  # zips in zips
LARGEST = 256_000_000  # bytes of one file
ZIP = b"PK\x03\x04"
_INSIDE = frozenset(  # what goes on a word; platforms join names by `_`
    b"abcdefghijklmnopqrstuvwxyz0123456789-" + bytes(range(0x80, 0x100))
)


class Names:
    """All by which files may name a person."""

    def __init__(self, names: Sequence[str]) -> None:
        """Take them as people write them."""
        found: set[bytes] = set()
        for name in names:
            if len(name) >= SHORTEST:
                for text in (name, name.casefold()):
                    forms = (text, escape(text), json.dumps(text)[1:-1])
                    found |= {form.encode("utf-8", "replace").lower() for form in forms}
        self._forms = sorted(found)

    def are_in(self, data: bytes) -> bool:
        """Return whether any of them is in some bytes, or in the zip that they are."""
        return bool(self._forms) and self._in(data, DEEPEST)

    def _stand_in(self, data: bytes) -> bool:
        low = data.lower()
        return any(_is_word(low, at, len(form)) for form in self._forms for at in _all(low, form))

    def _in(self, data: bytes, deep: int) -> bool:
        if self._stand_in(data):
            return True
        if not data.startswith(ZIP) or not deep:
            return False
        try:
            archive = Unpacker(BytesIO(data))
            return any(
                self._stand_in(name.encode("utf-8", "replace"))
                or (size <= LARGEST and self._in(archive.read(name), deep - 1))
                for name, size in archive.sizes.items()
            )
        except BadZip:
            return False  # nobody can read what is in it


def files_naming(folder: Path, names: Names) -> Iterator[Path]:
    """Yield the files below a folder that name a person, by their own name too; no link is read."""
    for home, folders, files in os.walk(folder):
        folders.sort()
        for name in sorted(files):
            path = Path(home) / name
            inside = path.relative_to(folder).as_posix().encode("utf-8", "replace")
            if names.are_in(inside) or (
                not path.is_symlink()
                and path.is_file()
                and path.stat().st_size <= LARGEST
                and names.are_in(path.read_bytes())
            ):
                yield path


def _all(data: bytes, form: bytes) -> Iterator[int]:
    at = data.find(form)
    while at >= 0:
        yield at
        at = data.find(form, at + 1)


def _is_word(data: bytes, at: int, length: int) -> bool:
    end = at + length
    before = at > 0 and data[at - 1] in _INSIDE
    return not before and not (end < len(data) and data[end] in _INSIDE)
