"""Variables of a MATLAB file (version 5: `save -v6` or `-v7`) as a table of text, without trust.

A column becomes a column of that name; a matrix `q` of several becomes `q_1`, `q_2`, ...
"""

import struct
import zlib
from io import BytesIO
from typing import Any

import numpy as np
import scipy.io

from vrts.validate.log.unreadable import Unreadable

NEWER = b"MATLAB 7.3 MAT-file"
HEADER, TAG = 128, 8  # bytes
PACKED = 15  # the type of an element that is compressed
MOST_BYTES = 50_000_000
MOST_UNPACKED = 200_000_000  # bytes of one variable
MOST_VALUES = 20_000_000
NUMERIC = frozenset(
    ("double", "single", *(f"{sign}int{bits}" for sign in ("", "u") for bits in (8, 16, 32, 64)))
)
DAMAGED = (ValueError, TypeError, KeyError, IndexError, OSError, EOFError, MemoryError, zlib.error)


def matlab_text(data: bytes) -> str:
    """Return the numeric variables of a file as a table with tabs between its columns.

    Variables with fewer rows than the longest are left out: they are no samples.

    Raises:
        Unreadable: The file is damaged, too large, or of a version that is not read.
    """
    if data.startswith(NEWER):
        raise Unreadable("it is of version 7.3 (HDF5); `save -v7` writes one that is read")
    if len(data) > MOST_BYTES:
        raise Unreadable(f"it has {len(data):,} bytes, more than {MOST_BYTES:,}")
    _unpacks(data)
    try:
        shapes = scipy.io.whosmat(BytesIO(data))
        wanted = [name for name, shape, kind in shapes if kind in NUMERIC and len(shape) == 2]
        values = sum(shape[0] * shape[1] for name, shape, _ in shapes if name in wanted)
        if values > MOST_VALUES:
            raise Unreadable(f"it has {values:,} values, more than {MOST_VALUES:,}")
        found: dict[str, Any] = scipy.io.loadmat(BytesIO(data), variable_names=wanted)
        arrays = {name: np.asarray(found[name], dtype=float) for name in wanted if name in found}
    except DAMAGED as problem:
        raise Unreadable("it is damaged") from problem
    return _table(arrays)


def _table(arrays: dict[str, np.ndarray[Any, Any]]) -> str:
    upright = {name: values.T if len(values) == 1 else values for name, values in arrays.items()}
    rows = max((len(values) for values in upright.values()), default=0)
    if not rows:
        raise Unreadable("it has no numeric variables")
    columns: list[tuple[str, np.ndarray[Any, Any]]] = []
    for name, values in upright.items():
        if len(values) == rows:
            several = values.shape[1] > 1
            columns += [
                (f"{name}_{k + 1}" if several else name, values[:, k])
                for k in range(values.shape[1])
            ]
    table = np.column_stack([values for _, values in columns])
    lines = ["\t".join(name for name, _ in columns)]
    lines += ["\t".join(map(repr, row)) for row in table.tolist()]
    return "\n".join(lines)


def _unpacks(data: bytes) -> None:
    """Refuse a file in which something small unpacks to something huge."""
    order = ">" if data[126:128] == b"MI" else "<"
    at = HEADER
    while at + TAG <= len(data):
        kind, size = struct.unpack_from(f"{order}II", data, at)
        at += TAG
        if kind == PACKED:
            try:
                found = zlib.decompressobj().decompress(data[at : at + size], MOST_UNPACKED + 1)
            except zlib.error:
                raise Unreadable("it is damaged") from None
            if len(found) > MOST_UNPACKED:
                raise Unreadable(f"a variable unpacks to more than {MOST_UNPACKED:,} bytes")
        at += size
