"""Zip files in memory: written so that the same content gives the same bytes, read without trust.

A hostile file may lie about anything. The table of contents is bounded, sizes are known before a
member is decompressed, and no more than its size is ever decompressed; what to allow is for the
caller to say.
"""

import io
import stat
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterable, Mapping
from enum import Enum
from typing import BinaryIO, NamedTuple, TypeVar

EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time a zip can tell
LARGEST_CONTENTS = 16_000_000  # bytes of the table of contents, about 100,000 members

T = TypeVar("T")


class Flaw(Enum):
    """Why a zip file cannot be read."""

    INCOMPLETE = "incomplete"  # or changed, or no zip file at all
    FOREIGN = "foreign"  # encrypted, of too many members, or packed by an unusual method
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
    return packed_in_turn(members.items(), mode)


def packed_in_turn(members: Iterable[tuple[str, bytes]], mode: int) -> bytes:
    """Return the same; members are taken one after the other."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, data in members:
            info = zipfile.ZipInfo(name, EPOCH)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = mode << 16
            archive.writestr(info, data)
    return buffer.getvalue()


class Member(NamedTuple):
    """What the table of contents says of a member."""

    size: int  # bytes when unpacked
    packed: int  # bytes in the archive
    plain: bool  # a file or a folder: no link, device, or the like


class Unpacker:
    """A zip file whose table of contents was read."""

    def __init__(self, source: bytes | BinaryIO, *, contents: int = LARGEST_CONTENTS) -> None:
        """Read the table of contents.

        Args:
            source: The zip file; who opens a file closes it.
            contents: Bytes that the table of contents may have.

        Raises:
            BadZip: It cannot be read.
        """
        opened = io.BytesIO(source) if isinstance(source, bytes) else source
        bounded = _Bounded(opened, contents)
        self._archive = _guarded(lambda: zipfile.ZipFile(bounded))
        bounded.most = None
        infos = self._archive.infolist()
        self.members: dict[str, Member] = {}  # in order; names of folders end in `/`
        for info in infos:
            known = info.compress_type in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
            if not known or info.flag_bits & 1:
                raise BadZip(Flaw.FOREIGN)
            if info.filename in self.members:
                raise BadZip(Flaw.TWICE, info.filename)
            self.members[info.filename] = Member(info.file_size, info.compress_size, _plain(info))
        self.sizes = {name: member.size for name, member in self.members.items()}

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

    def start(self, name: str, length: int) -> bytes:
        """Return the first bytes of a member, `length` of them at most.

        Raises:
            BadZip: They cannot be had.
        """

        def unpack() -> bytes:
            with self._archive.open(name) as member:
                return member.read(length)

        return _guarded(unpack)


class _Bounded(io.RawIOBase):
    """A file of which no more than so many bytes are read at once."""

    def __init__(self, file: BinaryIO, most: int) -> None:
        """Wrap a file; `most` [bytes] is None for no limit."""
        super().__init__()
        self._file = file
        self.most: int | None = most

    def read(self, size: int = -1, /) -> bytes:
        """Read; more than the limit is a flaw."""
        if self.most is not None and size > self.most:
            raise BadZip(Flaw.FOREIGN)
        return self._file.read(size)

    def seek(self, offset: int, whence: int = 0, /) -> int:
        """Go to a place in the file."""
        return self._file.seek(offset, whence)

    def tell(self) -> int:
        """Return the place in the file."""
        return self._file.tell()

    def seekable(self) -> bool:
        """Return that it is."""
        return True


def _plain(info: zipfile.ZipInfo) -> bool:
    """Return whether a member is a file or a folder, as far as it tells."""
    kind = stat.S_IFMT(info.external_attr >> 16)
    return kind in (0, stat.S_IFREG, stat.S_IFDIR)


def _guarded(call: Callable[[], T]) -> T:
    """Call the zip library, and nothing else; whatever it raises is a flaw of the file."""
    try:
        return call()
    except (zipfile.BadZipFile, zlib.error, struct.error, EOFError) as problem:
        raise BadZip(Flaw.INCOMPLETE) from problem
    except (NotImplementedError, RuntimeError, ValueError, OSError) as problem:
        raise BadZip(Flaw.FOREIGN) from problem
