"""Convex shapes as plain data. A body is a union of them."""

from typing import NamedTuple, TypeAlias

from vrts.base.pose import Pose, Vector


class Box(NamedTuple):
    """A box centred in its frame."""

    half_extents: Vector  # [m]


class Cylinder(NamedTuple):
    """A cylinder centred in its frame, along its z axis."""

    radius: float  # [m]
    half_length: float  # [m]


class Hull(NamedTuple):
    """The convex hull of points given in its frame."""

    points: tuple[Vector, ...]  # [m]


Shape: TypeAlias = Box | Cylinder | Hull


class Piece(NamedTuple):
    """A convex part P of a body O."""

    shape: Shape
    X_OP: Pose
