"""The answer of a distance query, and what can be asked of an engine."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol, TypeAlias

from vrts.base.pose import Pose, Vector
from vrts.geometry.shapes import Shape

if TYPE_CHECKING:  # numpy is loaded with an engine, at the first question
    import numpy as np
    import numpy.typing as npt

Array: TypeAlias = "npt.NDArray[np.float64]"

Transform: TypeAlias = Any  # a placement in the form of the engine that made it


class Nearest(NamedTuple):
    """The nearest points of two shapes, or the deepest ones where they overlap."""

    distance: float  # [m]; negative is the depth of penetration
    first: Vector  # on the first shape, in the frame of the transforms [m]
    second: Vector  # on the second shape [m]
    normal: Vector  # unit vector along which moving the second shape away parts them


class Pair(Protocol):
    """Two shapes whose distance is asked for again and again."""

    def distance(self, first: Transform, second: Transform) -> float:
        """Return the signed distance [m] of the shapes at two placements in one frame."""
        ...

    @property
    def normal(self) -> Array:
        """Unit normal of the last query, first to second, (3,); zero where there is none."""
        ...

    def nearest(self, first: Transform, second: Transform) -> Nearest:
        """Return the signed distance with the points between which it is measured."""
        ...


class Engine(NamedTuple):
    """A library that answers distance queries."""

    name: str
    error: float  # [m] largest error of a distance
    pair: Callable[[Shape, Shape], Pair]
    transform: Callable[[Array, Array], Transform]  # of a rotation (3, 3), an origin (3,) [m]
    placed: Callable[[Pose], Transform]
