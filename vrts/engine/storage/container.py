"""The outside of a saved run: a zip of `vrun.json` and one `.npy` member for every array.

Nothing is believed: names, kinds and sizes are checked before anything is decompressed, and an
array's header has to be the one that would be written here, so no header is ever interpreted.
"""

import io
import re
import zipfile
import zlib
from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.engine.storage.damage import Damaged, TooLarge, require

Table: TypeAlias = npt.NDArray[Any]

MANIFEST = "vrun.json"
MOST_BYTES = 256_000_000  # of all members, decompressed
MOST_MANIFEST = 32_000_000  # bytes of `vrun.json`
EPOCH = (1980, 1, 1, 0, 0, 0)  # the earliest time a zip can tell: the same run, the same bytes
MAGIC = b"\x93NUMPY\x01\x00"
ALIGNMENT = 64  # of the numbers after a header
_START = b"PK\x03\x04"
_NAME_AT = 30  # offset of the first member's name


def is_saved_run(data: bytes) -> bool:
    """Return whether bytes begin as a saved run does, sound or not."""
    return data.startswith(_START) and data[_NAME_AT:].startswith(MANIFEST.encode())


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


def unpack(data: bytes, layout: Mapping[str, tuple[str, int]]) -> tuple[bytes, dict[str, Table]]:
    """Return the manifest and the arrays of a file.

    Args:
        data: Its bytes.
        layout: Kind of number and count of columns of every array, by name; 0 columns: flat.

    Raises:
        Damaged: It is not sound, or has other members than these.
    """
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            members = _members(archive, {MANIFEST, *(f"{name}.npy" for name in layout)})
    except (zipfile.BadZipFile, zlib.error, EOFError) as problem:
        raise Damaged("it is incomplete, or was changed") from problem
    except (NotImplementedError, RuntimeError, ValueError, OSError) as problem:
        raise Damaged("it is packed in a way that saved runs are not") from problem
    tables = {
        name: _table(members[f"{name}.npy"], name, kind, columns)
        for name, (kind, columns) in layout.items()
    }
    return members[MANIFEST], tables


def _members(archive: zipfile.ZipFile, wanted: set[str]) -> dict[str, bytes]:
    infos = archive.infolist()
    names = [info.filename for info in infos]
    strange = next((name for name in names if name not in wanted), None)
    require(strange is None, f"it has a member `{strange}` that saved runs do not have")
    require(len(set(names)) == len(names), "a member is there twice")
    missing = sorted(wanted.difference(names))
    require(not missing, f"its member `{missing[0] if missing else ''}` is missing")
    for info in infos:
        plain = info.compress_type in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
        require(plain and not info.flag_bits & 1, "it is packed in a way that saved runs are not")
    _check_sizes({info.filename: info.file_size for info in infos})
    found: dict[str, bytes] = {}
    for info in infos:
        with archive.open(info) as member:
            found[info.filename] = member.read(info.file_size)
        whole = len(found[info.filename]) == info.file_size
        require(whole, f"its member `{info.filename}` is incomplete")
    return found


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
