"""Position and orientation of one frame in another, in plain Python.

`X_WT` reads "pose of T in W"; adjacent letters must match: `X_WT = X_WB @ X_BT`. The scalar form
needs no numpy, so the compiler and the controller's set points stay light.
"""

import math
from typing import NamedTuple, TypeAlias

Vector: TypeAlias = tuple[float, float, float]
Rotation: TypeAlias = tuple[float, float, float, float, float, float, float, float, float]

IDENTITY_ROTATION: Rotation = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)


class Pose(NamedTuple):
    """Pose of one frame in another."""

    rotation: Rotation  # row major; columns are the n, o, a vectors of the hand
    translation: Vector  # [m]

    def __matmul__(self, other: "Pose") -> "Pose":
        """Return the composition `X_AB @ X_BC = X_AC`."""
        return Pose(
            multiply(self.rotation, other.rotation),
            add(rotate(self.rotation, other.translation), self.translation),
        )

    def inverse(self) -> "Pose":
        """Return `X_BA` for `X_AB`."""
        transposed = transpose(self.rotation)
        x, y, z = rotate(transposed, self.translation)
        return Pose(transposed, (-x, -y, -z))

    def apply(self, point: Vector) -> Vector:
        """Return a point given in B, in A, for `X_AB`. Lengths in m."""
        return add(rotate(self.rotation, point), self.translation)

    @property
    def normal(self) -> Vector:
        """The x axis of the frame (VAL's n vector)."""
        return (self.rotation[0], self.rotation[3], self.rotation[6])

    @property
    def orientation(self) -> Vector:
        """The y axis of the frame (VAL's o vector, from finger to finger)."""
        return (self.rotation[1], self.rotation[4], self.rotation[7])

    @property
    def approach(self) -> Vector:
        """The z axis of the frame (VAL's a vector, where the tool points)."""
        return (self.rotation[2], self.rotation[5], self.rotation[8])


def multiply(a: Rotation, b: Rotation) -> Rotation:
    """Return the matrix product of two rotations."""
    a0, a1, a2, a3, a4, a5, a6, a7, a8 = a
    b0, b1, b2, b3, b4, b5, b6, b7, b8 = b
    return (
        a0 * b0 + a1 * b3 + a2 * b6,
        a0 * b1 + a1 * b4 + a2 * b7,
        a0 * b2 + a1 * b5 + a2 * b8,
        a3 * b0 + a4 * b3 + a5 * b6,
        a3 * b1 + a4 * b4 + a5 * b7,
        a3 * b2 + a4 * b5 + a5 * b8,
        a6 * b0 + a7 * b3 + a8 * b6,
        a6 * b1 + a7 * b4 + a8 * b7,
        a6 * b2 + a7 * b5 + a8 * b8,
    )


def transpose(a: Rotation) -> Rotation:
    """Return the inverse of a rotation."""
    return (a[0], a[3], a[6], a[1], a[4], a[7], a[2], a[5], a[8])


def rotate(a: Rotation, v: Vector) -> Vector:
    """Return a vector turned by a rotation."""
    x, y, z = v
    return (
        a[0] * x + a[1] * y + a[2] * z,
        a[3] * x + a[4] * y + a[5] * z,
        a[6] * x + a[7] * y + a[8] * z,
    )


def add(u: Vector, v: Vector) -> Vector:
    """Return the sum of two vectors."""
    return (u[0] + v[0], u[1] + v[1], u[2] + v[2])


def subtract(u: Vector, v: Vector) -> Vector:
    """Return the difference of two vectors."""
    return (u[0] - v[0], u[1] - v[1], u[2] - v[2])


def scale(v: Vector, factor: float) -> Vector:
    """Return a vector times a number."""
    return (v[0] * factor, v[1] * factor, v[2] * factor)


def dot(u: Vector, v: Vector) -> float:
    """Return the scalar product of two vectors."""
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def cross(u: Vector, v: Vector) -> Vector:
    """Return the vector product of two vectors."""
    return (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])


def distance(u: Vector, v: Vector) -> float:
    """Return the distance between two points, in their unit."""
    return math.dist(u, v)


def rotation_angle(a: Rotation, b: Rotation) -> float:
    """Return the angle of the rotation that carries one orientation into another [rad].

    Uses the half-angle form, which keeps its digits for angles near 0 and near pi.
    """
    d = multiply(transpose(a), b)
    s = math.sqrt((d[7] - d[5]) ** 2 + (d[2] - d[6]) ** 2 + (d[3] - d[1]) ** 2)
    return math.atan2(s, d[0] + d[4] + d[8] - 1.0)


def rotation_about(axis: Vector, angle: float) -> Rotation:
    """Return the right-handed rotation about a unit axis by an angle in rad [Rodrigues]."""
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    k = 1.0 - c
    return (
        c + x * x * k,
        x * y * k - z * s,
        x * z * k + y * s,
        y * x * k + z * s,
        c + y * y * k,
        y * z * k - x * s,
        z * x * k - y * s,
        z * y * k + x * s,
        c + z * z * k,
    )


X_AXIS: Vector = (1.0, 0.0, 0.0)
Y_AXIS: Vector = (0.0, 1.0, 0.0)
Z_AXIS: Vector = (0.0, 0.0, 1.0)

IDENTITY = Pose(IDENTITY_ROTATION, (0.0, 0.0, 0.0))


def translation(x: float, y: float, z: float) -> Pose:
    """Return a pure displacement. Lengths in m."""
    return Pose(IDENTITY_ROTATION, (x, y, z))
