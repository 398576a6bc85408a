"""The answer of a distance query."""

from typing import NamedTuple

from vrts.base.pose import Vector


class Nearest(NamedTuple):
    """The nearest points of two shapes, or the deepest ones where they overlap."""

    distance: float  # [m]; negative is the depth of penetration
    first: Vector  # on the first shape, in the frame of the transforms [m]
    second: Vector  # on the second shape [m]
    normal: Vector  # unit vector along which moving the second shape away parts them
