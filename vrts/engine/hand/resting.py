"""What something that is let go may come to rest on, and how it does."""

from typing import NamedTuple

from vrts.base.pose import Pose
from vrts.geometry.shapes import Piece


class Standing(NamedTuple):
    """A body that something can stand on, and where it is."""

    name: str
    pieces: tuple[Piece, ...]
    X_WO: Pose


class Rest(NamedTuple):
    """Where a body ends."""

    height_m: float  # it fell this far
    support: str
    X_WO: Pose
    stands: bool
    also: tuple[str, ...] = ()  # what it touches beside its support, where it rests on several
