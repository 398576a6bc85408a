"""The quantities that demands bound: value at an instant, and upper bound over an interval."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose
from vrts.check.certified import Quantity
from vrts.check.curves import Curves
from vrts.check.demands import Demand, Keeps
from vrts.robots.batch import flange_of, link_frames
from vrts.robots.levers import levers
from vrts.robots.model import Arm, SphericalWristArm
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]


def quantity(demand: Demand, scene: Scene, motion: Curves) -> Quantity:
    """Return what must stay below `bound_of` a demand on the motion of tool or joints."""
    arm, X_FT = scene.robot.arm, scene.X_FT
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return _depth(demand, arm, X_FT, motion)
        case Keeps.JOINT_SPEED:
            return _joint_share(arm, motion)
        case Keeps.TOOL_SPEED:
            return _tool_speed(arm, X_FT, motion)
        case Keeps.WRIST | Keeps.ELBOW:
            assert isinstance(arm, SphericalWristArm)
            return _nearness(demand.keeps, arm, motion)
        case _:
            raise ValueError(demand.keeps)


def bound_of(demand: Demand) -> float:
    """Return what a quantity may reach, without tolerance."""
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return 0.0
        case Keeps.WRIST | Keeps.ELBOW:
            return -demand.limit
        case _:
            return demand.limit


def tilt(arm: Arm, X_FO: Pose, motion: Curves) -> Quantity:
    """Return the angle [rad] between the z axes of W and of an object fixed to the flange."""
    z_F = np.array([X_FO.rotation[2], X_FO.rotation[5], X_FO.rotation[8]])

    def angle(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values = motion.values(middle)
        rotations, origins = link_frames(arm, values[:, :6])
        rotations, _ = flange_of(arm, rotations[6], origins[6])
        z_W = rotations @ z_F
        found = np.arctan2(np.hypot(z_W[:, 0], z_W[:, 1]), z_W[:, 2])
        return found, found + _turn(motion, values, start, end).sum(axis=1)

    return angle


def _turn(motion: Curves, values: Array, start: Array, end: Array) -> Array:
    """Return how far each joint is from its middle value at most, (m, 6) [rad]."""
    spread = motion.spread(start, end)
    return np.maximum(spread.upper - values, values - spread.lower)[:, :6]


def _depth(demand: Demand, arm: Arm, X_FT: Pose, motion: Curves) -> Quantity:
    lower, upper = np.array(demand.lower), np.array(demand.upper)
    reach = np.array(levers(arm, X_FT.translation))

    def depth(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values = motion.values(middle)
        rotations, origins = link_frames(arm, values[:, :6])
        rotations, origins = flange_of(arm, rotations[6], origins[6])
        tip = origins + rotations @ np.array(X_FT.translation)
        beyond: Array = np.maximum(lower - tip, tip - upper)
        outside: Array = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
        deepest: Array = beyond.max(axis=1)
        found = np.where(outside > 0.0, -outside, -deepest)
        return found, found + _turn(motion, values, start, end) @ reach

    return depth


def _joint_share(arm: Arm, motion: Curves) -> Quantity:
    limits = np.array(arm.speed)

    def share(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        found = (np.abs(motion.velocities(middle)[:, :6]) / limits).max(axis=1)
        return found, (motion.spread(start, end).speed[:, :6] / limits).max(axis=1)

    return share


def _tool_speed(arm: Arm, X_FT: Pose, motion: Curves) -> Quantity:
    reach = np.array(levers(arm, X_FT.translation))

    def speed(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values, rates = motion.values(middle), motion.velocities(middle)[:, :6]
        rotations, origins = link_frames(arm, values[:, :6])
        turned, flange = flange_of(arm, rotations[6], origins[6])
        tip = flange + turned @ np.array(X_FT.translation)
        velocity = np.zeros_like(tip)
        for joint in range(6):
            axis = rotations[joint + 1, :, :, 2]
            velocity += rates[:, joint, None] * np.cross(axis, tip - origins[joint + 1])
        found = np.linalg.norm(velocity, axis=1)
        spread = motion.spread(start, end)
        top = spread.speed[:, :6]
        # |d2x/dq_i dq_j| is at most the distance from the outer of the two axes
        inner = np.cumsum(top, axis=1) - top
        curve = (spread.acceleration[:, :6] + top * (2.0 * inner + top)) @ reach
        return found, found + curve * 0.5 * (end - start)

    return speed


def _nearness(keeps: Keeps, arm: SphericalWristArm, motion: Curves) -> Quantity:
    """Return minus the angle [rad] of wrist or elbow from its singular position."""
    joint = 4 if keeps is Keeps.WRIST else 2
    zero = 0.0 if keeps is Keeps.WRIST else float(np.arctan2(arm.d4, arm.a3))

    def nearness(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values = motion.values(middle)
        away = values[:, joint] - zero
        found = -np.abs(away - np.pi * np.round(away / np.pi))
        return found, found + _turn(motion, values, start, end)[:, joint]

    return nearness
