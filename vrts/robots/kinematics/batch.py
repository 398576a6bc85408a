"""Forward kinematics of many configurations at once, in numpy, of the arm as it stands."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose
from vrts.robots.kinematics.chain import fixed_frames
from vrts.robots.model import Arm, SerialArm, SphericalWristArm, flange_in_hand

Array: TypeAlias = npt.NDArray[np.float64]

JOINTS = 6


def link_frames(arm: Arm, q: Array) -> tuple[Array, Array]:
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
    if arm.built is not None or isinstance(arm, SerialArm):
        _fill_serial(fixed_frames(arm), rotations, origins, cosines, sines)
    else:
        _fill_spherical_wrist(arm, rotations, origins, cosines, sines)
    return rotations, origins


def _fill_spherical_wrist(
    arm: SphericalWristArm, rotations: Array, origins: Array, cosines: Array, sines: Array
) -> None:
    """Fill the frames L_1 .. L_6: quarter turns only exchange axes, so nothing is multiplied."""
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


def _fill_serial(
    fixed: tuple[Pose, ...], rotations: Array, origins: Array, cosines: Array, sines: Array
) -> None:
    """Fill the frames L_1 .. L_6 from those before them."""
    for joint, before in enumerate(fixed):
        parent, child = rotations[joint], rotations[joint + 1]
        origins[joint + 1] = origins[joint] + parent @ np.array(before.translation)
        still = parent @ np.array(before.rotation).reshape(3, 3)
        c, s = cosines[:, joint, None], sines[:, joint, None]
        child[:, :, 0] = c * still[:, :, 0] + s * still[:, :, 1]
        child[:, :, 1] = c * still[:, :, 1] - s * still[:, :, 0]
        child[:, :, 2] = still[:, :, 2]


def flange_frames(arm: Arm, q: Array) -> tuple[Array, Array]:
    """Return the flange frame F in B: rotations, shape (n, 3, 3), and origins, shape (n, 3) [m]."""
    rotations, origins = link_frames(arm, q)
    return flange_of(arm, rotations[6], origins[6])


def flange_of(arm: Arm, rotations: Array, origins: Array) -> tuple[Array, Array]:
    """Return F in B, shapes (n, 3, 3) and (n, 3), where L_6 is known."""
    if arm.built is None and isinstance(arm, SphericalWristArm):
        return rotations, origins + arm.d6 * rotations[:, :, 2]
    X_LF = flange_in_hand(arm)
    turned = rotations @ np.array(X_LF.rotation).reshape(3, 3)
    return turned, origins + rotations @ np.array(X_LF.translation)


def joint_axes(arm: Arm, q: Array) -> tuple[Array, Array]:
    """Return the axes of joints 1 .. 6 in B: directions and points on them, both (6, n, 3)."""
    rotations, origins = link_frames(arm, q)
    return rotations[1:, :, :, 2], origins[1:]
