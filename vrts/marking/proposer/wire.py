"""What a process and its child say to each other about shapes, as plain numbers.

A message of the parent: its head, the shapes that the child has not seen, which pairs are asked
about, and where they are. Shapes are numbered as they come. The child answers each question as
soon as it can, so that it is known which one it died of. Both are one version of vrts on one
machine: there are no numbers of versions, and bytes are in the machine's order.
"""

import struct
from collections.abc import Iterable
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt

from vrts.geometry.proposing.proposer import Proposals, Questions
from vrts.geometry.shapes import Box, Cylinder, Hull, Shape

READY: Final = b"ready\n"  # what the child says first
HEAD: Final = struct.Struct("=III")  # bytes of what follows, shapes, questions
ANSWER: Final = 72  # bytes: normal, first and second point
_SHAPE: Final = struct.Struct("=cI")  # kind, numbers
_PLACES: Final = 24  # numbers for the two places of a question


class Asked(NamedTuple):
    """A message of the parent."""

    shapes: tuple[Shape, ...]  # that were not there before
    pairs: npt.NDArray[np.int32]  # numbers of shapes, (m, 2)
    places: npt.NDArray[np.float64]  # rotation and origin of A, then of B, (m, 24)


def places_of(asked: Questions) -> npt.NDArray[np.float64]:
    """Return where the shapes of each question are, (m, 24)."""
    count = len(asked.first)
    return np.concatenate(
        [
            asked.rotation_a.reshape(count, 9),
            asked.origin_a,
            asked.rotation_b.reshape(count, 9),
            asked.origin_b,
        ],
        axis=1,
        dtype=np.float64,
    )


def to_bytes(message: Asked) -> bytes:
    """Return a message as bytes, head included."""
    body = b"".join(
        [
            *(_shape_to_bytes(shape) for shape in message.shapes),
            message.pairs.astype(np.int32).tobytes(),
            message.places.astype(np.float64).tobytes(),
        ]
    )
    return HEAD.pack(len(body), len(message.shapes), len(message.pairs)) + body


def from_bytes(head: bytes, body: bytes) -> Asked:
    """Return what `to_bytes` was given."""
    _, shapes, count = HEAD.unpack(head)
    at = 0
    found: list[Shape] = []
    for _ in range(shapes):
        kind, numbers = _SHAPE.unpack_from(body, at)
        at += _SHAPE.size
        found.append(_shape(kind, np.frombuffer(body, np.float64, numbers, at).tolist()))
        at += 8 * numbers
    pairs = np.frombuffer(body, np.int32, 2 * count, at).reshape(count, 2)
    places = np.frombuffer(body, np.float64, _PLACES * count, at + pairs.nbytes)
    return Asked(tuple(found), pairs, places.reshape(count, _PLACES))


def answer_to_bytes(*vectors: Iterable[float]) -> bytes:
    """Return one answer as bytes: its normal and two points."""
    return struct.pack("=9d", *(value for vector in vectors for value in vector))


def proposals(data: bytes) -> Proposals:
    """Return whole answers, in the order of the questions."""
    found = np.frombuffer(data, np.float64).reshape(-1, 3, 3).copy()
    return Proposals(found[:, 0], found[:, 1], found[:, 2])


def _shape_to_bytes(shape: Shape) -> bytes:
    match shape:
        case Box(half_extents=half):
            kind, numbers = b"b", half
        case Cylinder(radius=radius, half_length=half_length):
            kind, numbers = b"c", (radius, half_length)
        case Hull(points=points):
            kind, numbers = b"h", tuple(value for point in points for value in point)
    return _SHAPE.pack(kind, len(numbers)) + struct.pack(f"={len(numbers)}d", *numbers)


def _shape(kind: bytes, numbers: list[float]) -> Shape:
    if kind == b"b":
        x, y, z = numbers
        return Box((x, y, z))
    if kind == b"c":
        radius, half_length = numbers
        return Cylinder(radius, half_length)
    of_axes = zip(numbers[0::3], numbers[1::3], numbers[2::3], strict=True)
    return Hull(tuple((x, y, z) for x, y, z in of_axes))
