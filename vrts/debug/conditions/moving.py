"""Arm and hand at many instants at once, to the last digit as they are at each alone."""

import math
from functools import cached_property
from typing import cast

import numpy as np

from vrts.base.pose import Pose
from vrts.debug.conditions.block import Block
from vrts.debug.conditions.columns import Reals, pose_of
from vrts.engine.run import Run
from vrts.robots.kinematics import spherical_wrist
from vrts.robots.kinematics.batch import JOINTS
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.model import Configuration, SphericalWristArm

HALF_OPEN = 0.5  # share of the opening from which on a hand counts as open


def sines(angles: Reals) -> Reals:
    """Return what `math.sin` gives of each; numpy's own may differ in the last digit."""
    return np.array([math.sin(angle) for angle in angles.tolist()])


def cosines(angles: Reals) -> Reals:
    """Return what `math.cos` gives of each."""
    return np.array([math.cos(angle) for angle in angles.tolist()])


class Moving:
    """What moves in a run, as arrays that are made when they are first asked for."""

    def __init__(self, run: Run) -> None:
        """Take a run."""
        self._run = run

    @cached_property
    def _pieces(self) -> tuple[Reals, Reals, Reals]:
        """Begins and ends of the pieces of the arm [s of the path], their coefficients."""
        pieces = self._run.history.arm.pieces
        powers = max((len(row) for piece in pieces for row in piece.rows), default=1)
        rows = np.zeros((powers, JOINTS, len(pieces)))
        for k, piece in enumerate(pieces):
            for joint, row in enumerate(piece.rows):
                rows[: len(row), joint, k] = row
        begins = np.array([piece.start_s for piece in pieces], np.float64)
        return begins, np.array([piece.end_s for piece in pieces], np.float64), rows

    def joints(self, times: Reals) -> Reals:
        """Return what `Timeline.configuration` does at each time, as six rows [rad]."""
        arm = self._run.history.arm
        begins, ends, rows = self._pieces
        first = np.repeat(np.array(arm.configuration)[:, None], len(times), axis=1)
        if not len(begins):
            return first
        path = times
        if not arm.scale.plain:
            path = np.array([arm.scale.path(time_s) for time_s in times.tolist()])
        found = np.searchsorted(begins, path, side="right")
        at = np.maximum(found - 1, 0)
        t = np.minimum(path, ends[at]) - begins[at]
        total = np.zeros_like(first)
        for coefficients in rows[::-1]:
            total = total * t + coefficients[:, at]
        return np.where(found > 0, total, first)

    def all_joints(self, block: Block) -> tuple[Reals, ...]:
        """Return #HERE as six columns [rad]."""
        return tuple([block.spread(row) for row in self.joints(block.distinct[0])])

    def flange(self, block: Block) -> Pose:
        """Return X_BF as the controller counts, its numbers as columns."""
        arm, q = self._run.scene.robot.arm, self.joints(block.distinct[0])
        if isinstance(arm, SphericalWristArm):
            rows = cast("Configuration", tuple(q))
            found = spherical_wrist.forward(arm, rows, sines, cosines)  # type: ignore[arg-type]
            numbers = (*found.rotation, *found.translation)
        else:
            each = [forward(arm, cast("Configuration", tuple(row))) for row in q.T.tolist()]
            numbers = np.array([(*X.rotation, *X.translation) for X in each]).T
        count = len(block.distinct[0])
        columns = [np.broadcast_to(cast("Reals", number), count) for number in numbers]
        return pose_of(tuple([block.spread(column) for column in columns]))

    def hand_is_open(self, block: Block) -> Reals:
        """Return HAND."""
        timeline, most = self._run.timeline, self._run.scene.robot.gripper.opening_max
        openings = np.array([timeline.opening(t) for t in block.distinct[0].tolist()])
        return block.spread(np.where(openings >= HALF_OPEN * most, 1.0, 0.0))
