"""The quantities that demands bound: value at an instant, and upper bound over an interval."""

import math
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.check.curves.certified import Quantity
from vrts.check.curves.timeline_arrays import Curves
from vrts.check.curves.tool_motion import tips, tool_speed, turning
from vrts.check.task.demands import Demand, Keeps
from vrts.check.verdicts.singularity import CLOSE as NEAR
from vrts.check.verdicts.singularity import nearness
from vrts.robots.kinematics.levers import levers
from vrts.robots.model import Arm
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]

LENGTH = 5e-6  # [m], [m/s] half of what a measurement is rounded to
ANGLE = math.radians(0.005)
SHARE = 1e-6  # of a joint's speed limit, and of singular values


def quantity(demand: Demand, scene: Scene, motion: Curves) -> Quantity:
    """Return what must stay below `bound_of` a demand on the motion of tool or joints."""
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return _depth(demand, scene, motion)
        case Keeps.JOINT_SPEED:
            return _joint_share(scene.robot.arm, motion)
        case Keeps.TOOL_SPEED:
            return _tool_speed(scene, motion)
        case Keeps.WRIST | Keeps.ELBOW | Keeps.SHOULDER | Keeps.SINGULAR:
            return nearness(demand.keeps, scene.robot.arm, motion)
        case _:
            raise ValueError(demand.keeps)


def bound_of(demand: Demand) -> float:
    """Return what a quantity may reach, with what measurements are rounded to."""
    match demand.keeps:
        case Keeps.TOOL_OUT:
            return LENGTH
        case Keeps.WRIST | Keeps.ELBOW:
            return ANGLE - demand.limit
        case Keeps.SHOULDER:
            return LENGTH - demand.limit
        case Keeps.SINGULAR:
            return SHARE - demand.limit
        case Keeps.JOINT_SPEED:
            return SHARE + demand.limit
        case Keeps.TOOL_SPEED:
            return LENGTH + demand.limit
        case _:
            return ANGLE + demand.limit


def close_of(keeps: Keeps) -> float:
    """Return how exactly the largest value of a quantity is measured."""
    match keeps:
        case Keeps.TOOL_OUT:
            return 1e-4  # [m]
        case Keeps.TOOL_SPEED:
            return 5e-4  # [m/s]
        case Keeps.JOINT_SPEED:
            return 1e-3  # of the limit
        case _:
            return NEAR[keeps]


def _depth(demand: Demand, scene: Scene, motion: Curves) -> Quantity:
    lower, upper = np.array(demand.lower), np.array(demand.upper)
    reach = np.array(levers(scene.robot.arm, scene.X_FT.translation))

    def depth(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        tip = tips(scene, motion, middle)
        beyond: Array = np.maximum(lower - tip, tip - upper)
        outside: Array = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
        deepest: Array = beyond.max(axis=1)
        found = np.where(outside > 0.0, -outside, -deepest)
        return found, found + turning(motion, start, middle, end) @ reach

    return depth


def _joint_share(arm: Arm, motion: Curves) -> Quantity:
    limits = np.array(arm.speed)

    def share(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        found = (np.abs(motion.velocities(middle)[:, :6]) / limits).max(axis=1)
        return found, (motion.spread(start, end).speed[:, :6] / limits).max(axis=1)

    return share


def _tool_speed(scene: Scene, motion: Curves) -> Quantity:
    bounded = tool_speed(scene, motion)

    def speed(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        found, change = bounded(start, middle, end)
        return found, found + change

    return speed
