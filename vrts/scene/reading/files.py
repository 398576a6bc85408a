"""Files that a scene names: only those in its own folder, and only up to a size."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

PIECES = ".pieces.json"  # behind the name of a mesh: its convex pieces, unless a scene says other

_PLAIN = re.compile(r"[\w.-][\w. -]*(/[\w.-][\w. -]*)*")


class FileFault(Exception):  # noqa: N818 -- names what it is
    """A file that a scene names cannot be had."""


@dataclass(slots=True)
class SceneFolder:
    """The folder of a scene, that of a lab laid over it, and what was read from them."""

    path: Path | None  # None: the scene came without one
    lab: Path | None = None  # where to look next
    given: Mapping[str, bytes] | None = None  # files that came with the scene: no folder is opened
    contents: dict[str, bytes] = field(default_factory=dict[str, bytes])  # by name, as read

    def read(self, name: str, most: int) -> bytes:
        """Return the bytes of a file.

        Args:
            name: Path within the folder, parts joined by `/`.
            most: Bytes; a larger file is refused.

        Raises:
            FileFault: The name leads out of the folder, or the file is missing or too large.
        """
        if self.given is None and self.path is None:
            raise FileFault("the scene came without its folder")
        if not _PLAIN.fullmatch(name) or ".." in name.split("/"):
            raise FileFault("only names of files in the scene's own folder are taken")
        data = self._opened(name, most) if self.given is None else self.given.get(name)
        if data is None:
            raise FileFault("it did not come with the scene")
        if len(data) > most:
            raise FileFault(f"it has more than {most:,} bytes")
        self.contents[name] = data
        return data

    def beside(self, name: str, most: int) -> bytes | None:
        """Return the bytes of a file that runs do not need, at most one more; None: not there.

        It is none of the files that the scene is made of.
        """
        known = dict(self.contents)
        try:
            return self.read(name, most)
        except FileFault:
            return None
        finally:
            self.contents = known

    def to_write(self, name: str, begins: bytes) -> Path:
        """Return where a file of ours goes in the folder.

        Args:
            name: Path within the folder, parts joined by `/`.
            begins: What stands near the beginning of such a file; another one is not overwritten.

        Raises:
            FileFault: The name leads out of the folder, or is that of another file.
        """
        assert self.path is not None
        folder = self.path.resolve()
        if not _PLAIN.fullmatch(name) or ".." in name.split("/"):
            raise FileFault("only names of files in the scene's own folder are taken")
        place = (folder / name).resolve()
        if not place.is_relative_to(folder) or not place.parent.is_dir():
            raise FileFault(f"`{name}` would lie outside the scene's folder, or in none")
        if place.exists():
            if not place.is_file():
                raise FileFault(f"`{name}` is no file")
            with place.open("rb") as file:
                if begins not in file.read(200):
                    raise FileFault(f"`{name}` is another file, which is not overwritten")
        return place

    def _opened(self, name: str, most: int) -> bytes:
        """Return the first bytes of a file in a folder, one more than may be."""
        assert self.path is not None
        folder = self.path.resolve()
        if self.lab is not None and not (folder / name).is_file():
            folder = self.lab.resolve()
        place = (folder / name).resolve()
        if not place.is_relative_to(folder):  # by a link
            raise FileFault("it lies outside the scene's folder")
        if not place.is_file():
            raise FileFault("there is no such file in the scene's folder")
        try:
            with place.open("rb") as file:
                return file.read(most + 1)
        except OSError as refusal:
            raise FileFault(f"it cannot be read: {refusal.strerror}") from refusal
