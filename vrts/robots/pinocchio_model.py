"""Arms as Pinocchio models: a second opinion on our kinematics.

The only module that imports pinocchio.
"""

import math
from pathlib import Path
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt
import pinocchio as pin

from vrts.base.pose import Pose
from vrts.robots.model import Configuration, SphericalWristArm

Array: TypeAlias = npt.NDArray[np.float64]


class PinocchioArm(NamedTuple):
    """A model, its workspace of results, and the number of the flange's frame."""

    model: pin.Model
    data: pin.Data
    flange: int


def pinocchio_arm(arm: SphericalWristArm) -> PinocchioArm:
    """Return the model of an arm: six joints about z, each before the rest of its row."""
    alpha = (-90.0, 0.0, 90.0, -90.0, 90.0, 0.0)
    along_x = (0.0, arm.a2, arm.a3, 0.0, 0.0, 0.0)
    along_z = (0.0, arm.d2, 0.0, arm.d4, 0.0, arm.d6)
    model = pin.Model()
    joint, before = 0, pin.SE3.Identity()
    for number, (twist, a, d) in enumerate(zip(alpha, along_x, along_z, strict=True), 1):
        joint = model.addJoint(joint, pin.JointModelRZ(), before, f"joint{number}")
        before = _row(math.radians(twist), a, d)
    frame = pin.Frame("flange", joint, 0, before, pin.FrameType.OP_FRAME)
    flange = model.addFrame(frame)
    return PinocchioArm(model, model.createData(), flange)


def pinocchio_from_urdf(path: Path, flange: str) -> PinocchioArm:
    """Return the model that Pinocchio itself reads from a URDF file; `flange` names a link."""
    model = pin.buildModelFromUrdf(str(path))
    return PinocchioArm(model, model.createData(), model.getFrameId(flange))


def flange_pose(arm: PinocchioArm, q: Configuration) -> tuple[Array, Array]:
    """Return the rotation, shape (3, 3), and the origin, shape (3,) [m], of F in B."""
    pin.framesForwardKinematics(arm.model, arm.data, np.array(q))
    X_BF: pin.SE3 = arm.data.oMf[arm.flange]
    return X_BF.rotation.copy(), X_BF.translation.copy()


def jacobian(arm: PinocchioArm, q: Configuration) -> Array:
    """Return the flange's Jacobian in B, shape (6, 6): linear velocity above angular."""
    return pin.computeFrameJacobian(
        arm.model, arm.data, np.array(q), arm.flange, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    )


def step_to(arm: PinocchioArm, X_BF: Pose, start: Configuration, most_steps: int = 30) -> bool:
    """Return whether damped Newton steps with Pinocchio's Jacobian lead to a pose.

    Numeric inverse kinematics as it is commonly written on top of Pinocchio, for comparison.
    """
    wanted = pin.SE3(np.array(X_BF.rotation).reshape(3, 3), np.array(X_BF.translation))
    q: Array = np.array(start)
    for _ in range(most_steps):
        pin.framesForwardKinematics(arm.model, arm.data, q)
        here: pin.SE3 = arm.data.oMf[arm.flange]
        error = pin.log6(here.actInv(wanted)).vector
        if float(np.linalg.norm(error)) < 1e-9:
            return True
        J = pin.computeFrameJacobian(arm.model, arm.data, q, arm.flange, pin.ReferenceFrame.LOCAL)
        q = q + J.T @ np.linalg.solve(J @ J.T + 1e-9 * np.eye(6), error)
    return False


def _row(twist: float, a: float, d: float) -> pin.SE3:
    """Return what a standard Denavit-Hartenberg row puts behind its joint's turn."""
    c, s = math.cos(twist), math.sin(twist)
    rotation = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    return pin.SE3(rotation, np.array([a, 0.0, d]))
