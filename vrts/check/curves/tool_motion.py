"""Where the scene's tool is, how it is turned and how fast it is, with bounds over intervals.

Whatever TOOL the program sets: a task speaks of the tool of its scene.
"""

from collections.abc import Callable
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Vector
from vrts.check.curves.timeline_arrays import Curves
from vrts.robots.kinematics.batch import flange_of, link_frames
from vrts.robots.kinematics.levers import levers
from vrts.scene.model import Scene

Array: TypeAlias = npt.NDArray[np.float64]

Bounded: TypeAlias = Callable[[Array, Array, Array], tuple[Array, Array]]
"""Starts, middles and ends, each (m,) [s], to values at middles and how far they can differ."""


def turning(motion: Curves, start: Array, middle: Array, end: Array) -> Array:
    """Return how far each joint is from where it is at middles at most, (m, 6) [rad]."""
    return motion.turn(start, middle, end, slice(0, 6))


def tips(scene: Scene, motion: Curves, t: Array) -> Array:
    """Return the origin of T in W, (m, 3) [m], at times of shape (m,)."""
    arm = scene.robot.arm
    rotations, origins = link_frames(arm, motion.values(t)[:, :6])
    rotations, origins = flange_of(arm, rotations[6], origins[6])
    return origins + rotations @ np.array(scene.X_FT.translation)


def tool_distance(scene: Scene, motion: Curves, point: Vector) -> Bounded:
    """Return the distance [m] of the tool from a point in W."""
    reach = np.array(levers(scene.robot.arm, scene.X_FT.translation))

    def gap(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        away: Array = np.linalg.norm(tips(scene, motion, middle) - np.array(point), axis=1)
        return away, turning(motion, start, middle, end) @ reach

    return gap


def tool_angle(scene: Scene, motion: Curves, direction: Vector) -> Bounded:
    """Return the angle [rad] between the tool's approach and a direction in W of length 1."""
    arm = scene.robot.arm
    z_F = np.array(scene.X_FT.approach)

    def angle(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        rotations, origins = link_frames(arm, motion.values(middle)[:, :6])
        rotations, _ = flange_of(arm, rotations[6], origins[6])
        z_W = rotations @ z_F
        across: Array = np.linalg.norm(np.cross(z_W, np.array(direction)), axis=1)
        found = np.arctan2(across, z_W @ np.array(direction))
        return found, turning(motion, start, middle, end).sum(axis=1)

    return angle


def tool_speed(scene: Scene, motion: Curves) -> Bounded:
    """Return the speed [m/s] of the tool; intervals must not reach beyond a piece of the motion."""
    arm, X_FT = scene.robot.arm, scene.X_FT
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
        found: Array = np.linalg.norm(velocity, axis=1)
        spread = motion.spread(start, end)
        top = spread.speed[:, :6]
        # |d2x/dq_i dq_j| is at most the distance from the outer of the two axes
        inner = np.cumsum(top, axis=1) - top
        curve: Array = (spread.acceleration[:, :6] + top * (2.0 * inner + top)) @ reach
        return found, curve * 0.5 * (end - start)

    return speed
