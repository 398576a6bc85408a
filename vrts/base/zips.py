"""Zip files in memory: written so that the same content gives the same bytes, read without trust.

A hostile file may lie about anything. Sizes are known before a member is decompressed, and no
more than its size is ever decompressed; what to allow is for the caller to say.
"""

import io
import struct
import zipfile
import zlib
from collections.abc import Callable, Mapping
from enum import Enum
from typing import TypeVar

EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time a zip can tell

T = TypeVar("T")


class Flaw(Enum):
    """Why a zip file cannot be read."""

    INCOMPLETE = "incomplete"  # or changed, or no zip file at all
    FOREIGN = "foreign"  # encrypted, or packed by a method that is not written here
    TWICE = "twice"  # a member of that name is there twice
    LENGTH = "length"  # a member has another length than it says


class BadZip(Exception):  # noqa: N818 -- names the situation
    """A zip file cannot be read."""

    def __init__(self, flaw: Flaw, member: str = "") -> None:
        """Say why, and which member, if it is one."""
        super().__init__(flaw.value, member)
        self.flaw = flaw
        self.member = member


def packed(members: Mapping[str, bytes], mode: int) -> bytes:
    """Return the bytes of a zip file with members in the order given, and their access mode."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, data in members.items():
            info = zipfile.ZipInfo(name, EPOCH)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = mode << 16
            archive.writestr(info, data)
    return buffer.getvalue()


class Unpacker:
    """A zip file whose table of contents was read."""

    def __init__(self, data: bytes) -> None:
        """Read the table of contents.

        Raises:
            BadZip: It cannot be read.
        """
        self._archive = _guarded(lambda: zipfile.ZipFile(io.BytesIO(data)))
        infos = self._archive.infolist()
        self.sizes: dict[str, int] = {}  # bytes of each member, as it says; folders end in `/`
        for info in infos:
            known = info.compress_type in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
            if not known or info.flag_bits & 1:
                raise BadZip(Flaw.FOREIGN)
            if info.filename in self.sizes:
                raise BadZip(Flaw.TWICE, info.filename)
            self.sizes[info.filename] = info.file_size

    def read(self, name: str) -> bytes:
        """Return the bytes of a member.

        Raises:
            BadZip: They cannot be had, or are more or fewer than it says.
        """
        size = self.sizes[name]

        def unpack() -> tuple[bytes, bytes]:
            with self._archive.open(name) as member:
                return member.read(size), member.read(1)

        found, more = _guarded(unpack)
        if more or len(found) != size:
            raise BadZip(Flaw.LENGTH, name)
        return found


def _guarded(call: Callable[[], T]) -> T:
    """Call the zip library, and nothing else; whatever it raises is a flaw of the file."""
    try:
        return call()
    except (zipfile.BadZipFile, zlib.error, struct.error, EOFError) as problem:
        raise BadZip(Flaw.INCOMPLETE) from problem
    except (NotImplementedError, RuntimeError, ValueError, OSError) as problem:
        raise BadZip(Flaw.FOREIGN) from problem
