"""How near the arm comes to its singularities on straight lines, certified on the polynomials.

Only straight lines count, with the corners that lead into them: a joint motion passes through a
singularity without harm, and READY, where every run begins, is one.

Of the PUMA family three distances are measured: the angle of joint 5 from zero, the angle of the
elbow from straight, and the distance of the wrist from the axis of joint 1. Of other arms it is the
smallest singular value of the Jacobian of the flange, with lengths as shares of the arm's extent:
how fast the hand moves, at least, when the joints turn by one radian a second together.
"""

import math
from collections.abc import Mapping
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.units import deg, mm
from vrts.check.curves.certified import Quantity, highest
from vrts.check.curves.timeline_arrays import Curves
from vrts.check.curves.tool_motion import turning
from vrts.check.rounding import exact_deg, exact_mm, exact_s
from vrts.check.task.demands import Keeps, distances_of
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.robots.kinematics.batch import flange_of, link_frames
from vrts.robots.kinematics.chain import extent
from vrts.robots.kinematics.levers import levers
from vrts.robots.model import Arm, SerialArm, SphericalWristArm

Array: TypeAlias = npt.NDArray[np.float64]

CLOSE = {
    Keeps.WRIST: math.radians(0.005),
    Keeps.ELBOW: math.radians(0.005),
    Keeps.SHOULDER: 5e-5,  # [m]
    Keeps.SINGULAR: 5e-4,
}  # to which distances are measured


def nearness(keeps: Keeps, arm: Arm, motion: Curves) -> Quantity:
    """Return minus the distance from a singularity: [rad], [m], or a singular value."""
    if isinstance(arm, SerialArm):
        return _singular_value(arm, motion)
    match keeps:
        case Keeps.WRIST:
            return _angle(4, 0.0, motion)
        case Keeps.ELBOW:
            return _angle(2, math.atan2(arm.d4, arm.a3), motion)
        case _:
            return _shoulder(arm, motion)


def on_lines(run: Run, motion: Curves) -> tuple[Array, Array]:
    """Return starts and ends [s] of the pieces of straight lines."""
    linear = [k for k, m in enumerate(run.motions) if m.interpolation is Interpolation.LINEAR]
    pieces = np.isin(motion.motions, linear)
    return motion.starts[pieces], motion.ends[pieces]


def measured(run: Run, motion: Curves) -> Mapping[str, float]:
    """Return the smallest distances on straight lines, and when; empty where there is no line."""
    start, end = on_lines(run, motion)
    found: dict[str, float] = {}
    if not len(start):
        return found
    arm = run.scene.robot.arm
    for keeps in distances_of(arm):
        nearest = highest(nearness(keeps, arm, motion), start, end, CLOSE[keeps])
        name, distance = _named(keeps, -nearest.value)
        found[name] = distance
        found[f"{name.rpartition('_')[0]}_at_s"] = float(exact_s(nearest.time_s))
    return found


def _named(keeps: Keeps, distance: float) -> tuple[str, float]:
    """Return a distance as it is written, with its name."""
    match keeps:
        case Keeps.WRIST:
            return "wrist_deg", float(exact_deg(distance))
        case Keeps.ELBOW:
            return "elbow_deg", float(exact_deg(distance))
        case Keeps.SHOULDER:
            return "shoulder_mm", float(exact_mm(distance))
        case _:
            return "singular_value", round(distance, 3)


def in_words(keeps: Keeps, distance: float) -> str:
    """Return a distance with its unit: "12.5 degrees"."""
    match keeps:
        case Keeps.WRIST | Keeps.ELBOW:
            return f"{deg(distance):.1f} degrees"
        case Keeps.SHOULDER:
            return f"{mm(distance):.1f} mm"
        case _:
            return f"{distance:.3f}"


def _angle(joint: int, zero: float, motion: Curves) -> Quantity:
    this = slice(joint, joint + 1)

    def near(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        away = motion.values(middle, this)[:, 0] - zero
        found = -np.abs(away - np.pi * np.round(away / np.pi))
        return found, np.minimum(found + motion.turn(start, middle, end, this)[:, 0], 0.0)

    return near


def _shoulder(arm: SphericalWristArm, motion: Curves) -> Quantity:
    forearm = math.hypot(arm.a3, arm.d4)
    reach = np.array((arm.a2 + forearm, forearm))  # of the wrist from the axes of joints 2 and 3
    these = slice(1, 3)

    def near(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values = motion.values(middle, these)
        q2, q23 = values[:, 0], values[:, 0] + values[:, 1]
        out = arm.a2 * np.cos(q2) + arm.a3 * np.cos(q23) + arm.d4 * np.sin(q23)
        found = -np.abs(out)
        turn = motion.turn(start, middle, end, these)
        return found, np.minimum(found + turn @ reach, 0.0)

    return near


def _singular_value(arm: SerialArm, motion: Curves) -> Quantity:
    length = extent(arm)
    reach = np.array(levers(arm, (0.0, 0.0, 0.0))) / length
    # a joint before turns a column of the Jacobian, one behind moves the flange that it reaches
    joints = np.arange(6)
    sways = np.where(
        joints[:, None] < joints[None, :], np.hypot(reach, 1.0)[None, :], reach[:, None]
    )  # [j, i]: how fast column i changes with joint j at most

    def near(start: Array, middle: Array, end: Array) -> tuple[Array, Array]:
        values = motion.values(middle)
        rotations, origins = link_frames(arm, values[:, :6])
        axes, points = rotations[1:, :, :, 2], origins[1:]
        _, flange = flange_of(arm, rotations[6], origins[6])
        across = np.cross(axes, flange[None] - points) / length
        jacobian = np.moveaxis(np.concatenate([across, axes], axis=2), 0, 2)
        found: Array = -np.linalg.svd(jacobian, compute_uv=False)[:, -1]
        # no singular value changes by more than the matrix does
        change: Array = np.linalg.norm(turning(motion, start, middle, end) @ sways, axis=1)
        return found, np.minimum(found + change, 0.0)

    return near
