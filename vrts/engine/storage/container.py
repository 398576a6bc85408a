"""The outside of a saved run: a zip of `vrun.json` and one `.npy` member for every array.

Nothing is believed: names, kinds and sizes are checked before anything is decompressed, and an
array's header has to be the one that would be written here, so no header is ever interpreted.
"""

import re
from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.zips import BadZip, Flaw, Unpacker, packed
from vrts.engine.storage.damage import Damaged, TooLarge, require
from vrts.engine.storage.recognise import MANIFEST

Table: TypeAlias = npt.NDArray[Any]

MOST_BYTES = 256_000_000  # of all members, decompressed
MOST_MANIFEST = 32_000_000  # bytes of `vrun.json`
MODE = 0o600  # of members
MAGIC = b"\x93NUMPY\x01\x00"
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
    return packed(members, MODE)


class Container:
    """The members of a file, whose names and sizes are known to be sound."""

    def __init__(self, data: bytes) -> None:
        """Look at the table of contents.

        Raises:
            Damaged: It is not sound, or promises too much.
        """
        try:
            self._zip = Unpacker(data)
        except BadZip as problem:
            raise _damage(problem) from problem
        self._sizes = self._zip.sizes
        require(MANIFEST in self._sizes, f"its member `{MANIFEST}` is missing")
        _check_sizes(self._sizes)

    def manifest(self) -> bytes:
        """Return the bytes of `vrun.json`.

        Raises:
            Damaged: They cannot be had.
        """
        return self._read(MANIFEST)

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
        return {
            name: _table(self._read(f"{name}.npy"), name, kind, columns)
            for name, (kind, columns) in layout.items()
        }

    def _read(self, name: str) -> bytes:
        try:
            return self._zip.read(name)
        except BadZip as problem:
            raise _damage(problem) from problem


def _damage(problem: BadZip) -> Damaged:
    match problem.flaw:
        case Flaw.INCOMPLETE:
            return Damaged("it is incomplete, or was changed")
        case Flaw.FOREIGN:
            return Damaged("it is packed in a way that saved runs are not")
        case Flaw.TWICE:
            return Damaged("a member is there twice")
        case Flaw.LENGTH:
            return Damaged(f"its member `{problem.member}` has another length")


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
