"""How far databases had come, kept beside the key: an older copy in place of one shows.

A file for each database. It is written a little later than the database, never sooner, so what a
machine forgets when its power fails looks like nothing worse.
"""

import os
from pathlib import Path

import msgspec

from vrts.pipeline.files import CannotRead


class Seen(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is known of a database."""

    database: str  # its id, hexadecimal
    folder: str  # where it was
    count: int  # how often it was signed


class Witness:
    """The files beside a key."""

    def __init__(self, key: Path) -> None:
        """Say which key."""
        self._key = key

    def of(self, database: bytes) -> Seen | None:
        """Return what is known of a database.

        Raises:
            CannotRead: The file holds something else.
        """
        path = self._path(database.hex())
        return _read(path) if path.is_file() else None

    def in_folder(self, folder: Path) -> tuple[Seen, ...]:
        """Return what is known of databases that were in a folder.

        Raises:
            CannotRead: A file holds something else.
        """
        files = sorted(self._key.parent.glob(f"{self._key.name}.*.seen"))
        here = str(folder.resolve())
        return tuple(seen for seen in map(_read, files) if seen.folder == here)

    def write(self, seen: Seen) -> None:
        """Keep how far a database has come.

        Raises:
            OSError: It cannot be written.
        """
        path = self._path(seen.database)
        part = path.with_suffix(".part")
        descriptor = os.open(part, os.O_CREAT | os.O_TRUNC | os.O_WRONLY, 0o600)
        with open(descriptor, "wb") as file:
            file.write(msgspec.json.encode(seen))
            file.flush()
            os.fsync(file.fileno())
        part.replace(path)

    def forget(self, seen: Seen) -> None:
        """Forget a database that is not there any more."""
        self._path(seen.database).unlink(missing_ok=True)

    def _path(self, database: str) -> Path:
        return self._key.with_name(f"{self._key.name}.{database[:16]}.seen")


def _read(path: Path) -> Seen:
    try:
        return msgspec.json.decode(path.read_bytes(), type=Seen)
    except (OSError, msgspec.DecodeError) as problem:
        raise CannotRead(
            f"cannot read how far a database had come: `{path}`: {problem}"
        ) from problem
