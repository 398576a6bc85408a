"""Forward kinematics of many configurations at once, in numpy."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.robots.model import SphericalWristArm

Array: TypeAlias = npt.NDArray[np.float64]

JOINTS = 6


def link_frames(arm: SphericalWristArm, q: Array) -> tuple[Array, Array]:
    """Return the frames L_0 .. L_6 in B, each right after the turn of its joint.

    Args:
        arm: The arm.
        q: Configurations, shape (n, 6) [rad].

    Returns:
        Rotations, shape (7, n, 3, 3), and origins, shape (7, n, 3) [m]. The z axis of L_k is the
        axis of joint k.
    """
    count = len(q)
    rotations = np.empty((JOINTS + 1, count, 3, 3))
    origins = np.empty((JOINTS + 1, count, 3))
    rotations[0] = np.eye(3)
    origins[0] = 0.0
    cosines, sines = np.cos(q), np.sin(q)
    # before each joint: along x, along z, and quarter turns about x
    along_x = (0.0, 0.0, arm.a2, arm.a3, 0.0, 0.0)
    along_z = (0.0, 0.0, arm.d2, 0.0, arm.d4, 0.0)
    for joint, twist in enumerate((0, -1, 0, 1, -1, 1)):
        parent, child = rotations[joint], rotations[joint + 1]
        x, y, z = parent[:, :, 0], parent[:, :, 1], parent[:, :, 2]
        origins[joint + 1] = origins[joint]
        if along_x[joint]:
            origins[joint + 1] += along_x[joint] * x
        if along_z[joint]:
            origins[joint + 1] += along_z[joint] * z
        if twist > 0:
            y, z = z, -y
        elif twist < 0:
            y, z = -z, y
        c, s = cosines[:, joint, None], sines[:, joint, None]
        child[:, :, 0] = c * x + s * y
        child[:, :, 1] = c * y - s * x
        child[:, :, 2] = z
    return rotations, origins


def flange_frames(arm: SphericalWristArm, q: Array) -> tuple[Array, Array]:
    """Return the flange frame F in B: rotations, shape (n, 3, 3), and origins, shape (n, 3) [m]."""
    rotations, origins = link_frames(arm, q)
    return rotations[6], origins[6] + arm.d6 * rotations[6][:, :, 2]


def joint_axes(arm: SphericalWristArm, q: Array) -> tuple[Array, Array]:
    """Return the axes of joints 1 .. 6 in B: directions and points on them, both (6, n, 3)."""
    rotations, origins = link_frames(arm, q)
    return rotations[1:, :, :, 2], origins[1:]
