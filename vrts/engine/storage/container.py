"""The outside of a saved run: a zip of `vrun.json` and one `.npy` member for every array.

Nothing is believed: names, kinds and sizes are checked before anything is decompressed, and an
array's header has to be the one that would be written here, so no header is ever interpreted.
"""

import io
import re
import struct
import zipfile
import zlib
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.engine.storage.damage import Damaged, TooLarge, require
from vrts.engine.storage.recognise import MANIFEST

Table: TypeAlias = npt.NDArray[Any]

MOST_BYTES = 256_000_000  # of all members, decompressed
MOST_MANIFEST = 32_000_000  # bytes of `vrun.json`
EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time a zip can tell: the same run, the same bytes
MAGIC = b"\x93NUMPY\x01\x00"
FOREIGN = "it is packed in a way that saved runs are not"
ALIGNMENT = 64  # of the numbers after a header


def pack(manifest: bytes, tables: Mapping[str, Table]) -> bytes:
    """Return the bytes of a file. The same content gives the same bytes.

    Raises:
        TooLarge: It would not be read again.
    """
    members = {MANIFEST: manifest}
    for name, table in tables.items():
        members[f"{name}.npy"] = _header(table.dtype, table.shape) + table.tobytes()
    _check_sizes({name: len(data) for name, data in members.items()})
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as archive:
        for name, data in members.items():
            info = zipfile.ZipInfo(name, EPOCH)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o600 << 16
            archive.writestr(info, data)
    return buffer.getvalue()


class Container:
    """The members of a file, whose names and sizes are known to be sound."""

    def __init__(self, data: bytes) -> None:
        """Look at the table of contents.

        Raises:
            Damaged: It is not sound, or promises too much.
        """
        self._data = data
        with _opened(data) as archive:
            infos = archive.infolist()
        self._sizes = {info.filename: info.file_size for info in infos}
        require(len(self._sizes) == len(infos), "a member is there twice")
        require(MANIFEST in self._sizes, f"its member `{MANIFEST}` is missing")
        for info in infos:
            plain = info.compress_type in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
            require(plain and not info.flag_bits & 1, FOREIGN)
        _check_sizes(self._sizes)

    def manifest(self) -> bytes:
        """Return the bytes of `vrun.json`.

        Raises:
            Damaged: They cannot be had.
        """
        with _opened(self._data) as archive:
            return self._read(archive, MANIFEST)

    def tables(self, layout: Mapping[str, tuple[str, int]]) -> dict[str, Table]:
        """Return the arrays.

        Args:
            layout: Kind of number and count of columns of every array, by name; 0 columns: flat.

        Raises:
            Damaged: There are others, or they are not sound.
        """
        wanted = {MANIFEST, *(f"{name}.npy" for name in layout)}
        strange = sorted(self._sizes.keys() - wanted)
        require(not strange, f"it has a member `{''.join(strange[:1])}` that does not belong there")
        missing = sorted(wanted - self._sizes.keys())
        require(not missing, f"its member `{''.join(missing[:1])}` is missing")
        with _opened(self._data) as archive:
            return {
                name: _table(self._read(archive, f"{name}.npy"), name, kind, columns)
                for name, (kind, columns) in layout.items()
            }

    def _read(self, archive: zipfile.ZipFile, name: str) -> bytes:
        with archive.open(name) as member:
            found = member.read(self._sizes[name])
            ended = not member.read(1)
        whole = ended and len(found) == self._sizes[name]
        require(whole, f"its member `{name}` has another length")
        return found


@contextmanager
def _opened(data: bytes) -> Generator[zipfile.ZipFile]:
    """Open a zip; whatever is wrong with it is damage."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            yield archive
    except (zipfile.BadZipFile, zlib.error, struct.error, EOFError) as problem:
        raise Damaged("it is incomplete, or was changed") from problem
    except (NotImplementedError, RuntimeError, ValueError, OSError) as problem:
        raise Damaged(FOREIGN) from problem


def _check_sizes(sizes: Mapping[str, int]) -> None:
    total = sum(sizes.values())
    if total > MOST_BYTES:
        raise TooLarge(f"{total:,} bytes unpacked, the limit is {MOST_BYTES:,}")
    if sizes[MANIFEST] > MOST_MANIFEST:
        raise TooLarge(f"{sizes[MANIFEST]:,} bytes of `{MANIFEST}`, the limit is {MOST_MANIFEST:,}")


def _header(dtype: np.dtype[Any], shape: tuple[int, ...]) -> bytes:
    """Return the header of an array as numpy writes it, version 1.0."""
    said = f"{{'descr': '{dtype.str}', 'fortran_order': False, 'shape': {shape!r}, }}"
    padding = -(len(MAGIC) + 2 + len(said) + 1) % ALIGNMENT
    text = said.encode() + b" " * padding + b"\n"
    return MAGIC + len(text).to_bytes(2, "little") + text


_SHAPE = re.compile(rb"'shape': \((\d{1,12}),(?: (\d{1,3}))?\)")


def _table(data: bytes, name: str, kind: str, columns: int) -> Table:
    dtype = np.dtype(kind)
    said = _SHAPE.search(data, 0, 200)
    require(said is not None, f"its member `{name}.npy` has a header that is not understood")
    assert said is not None
    rows = int(said[1])
    shape = (rows, columns) if columns else (rows,)
    header = _header(dtype, shape)
    require(
        data.startswith(header),
        f"its member `{name}.npy` has numbers of another kind or count",
    )
    size = rows * max(columns, 1) * dtype.itemsize
    require(len(data) - len(header) == size, f"its member `{name}.npy` has another length")
    found = np.frombuffer(data, dtype, offset=len(header)).reshape(shape)
    if dtype.kind == "f":
        finite = bool(np.isfinite(found).all())
        require(finite, f"its member `{name}.npy` holds a number that is infinite or none")
    return found
