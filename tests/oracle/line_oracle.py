"""A straight line followed by other means: Newton's steps on Pinocchio's Jacobian, in small parts.

It knows nothing of our inverse kinematics, arm branches, set points or halvings: from the start it
goes on in steps of the way, each at most so long that no joint turns far, and notes where it stood.
"""

import math
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.engine.motion.lines.path import LinePath
from vrts.robots.model import Configuration
from vrts.robots.pinocchio_model import PinocchioArm, flange_pose, jacobian

Array: TypeAlias = npt.NDArray[np.float64]

PARTS = 400  # of the way, at least
FAR = 0.02  # [rad] no joint turns farther in a part
SHORTEST = 1e-7  # part of the way: where it would have to be shorter the way is lost
CLOSE = 1e-9  # [m] and [rad]


class Followed(NamedTuple):
    """Where the joints were, and where the way was lost."""

    u: Array  # shares of the way, ascending
    q: Array  # shape (n, 6) [rad], without jumps
    lost: float | None  # share of the way at which no joints go on; None: the end was reached

    def at(self, u: float) -> Array:
        """Return the joints at a share of the way."""
        return np.array([np.interp(u, self.u, self.q[:, joint]) for joint in range(6)])

    def changes(self) -> Array:
        """Return how fast the joints turn with the way [rad], between the shares."""
        return np.diff(self.q, axis=0) / np.diff(self.u)[:, None]

    def first_outside(self, lower: Configuration, upper: Configuration) -> tuple[float, int] | None:
        """Return where a joint (from 1) first passes its limit."""
        out = (self.q < np.array(lower)) | (self.q > np.array(upper))
        rows = np.nonzero(out.any(axis=1))[0]
        if not len(rows):
            return None
        return float(self.u[rows[0]]), int(np.argmax(out[rows[0]])) + 1


def followed(arm: PinocchioArm, path: LinePath, X_TF: Array, start: Configuration) -> Followed:
    """Follow a line of the tool from a configuration; X_TF is a matrix, shape (4, 4)."""
    u, step = 0.0, 1.0 / PARTS
    q: Array = np.array(start)
    us, qs = [0.0], [q]
    while u < 1.0:
        end = min(u + step, 1.0)
        found = _stepped(arm, _flange(path, end, X_TF), q)
        if found is None or float(np.max(np.abs(found - q))) > FAR:
            step *= 0.5
            if step < SHORTEST:
                return Followed(np.array(us), np.array(qs), u)
            continue
        u, q, step = end, found, min(2.0 * step, 1.0 / PARTS)
        us.append(u)
        qs.append(q)
    return Followed(np.array(us), np.array(qs), None)


def least_singular_value(arm: PinocchioArm, q: Array, length: float) -> float:
    """Return the smallest singular value of the flange's Jacobian, by numpy."""
    J = jacobian(arm, tuple(q.tolist()))
    J[:3] /= length
    return float(np.linalg.svd(J, compute_uv=False)[-1])


def _flange(path: LinePath, u: float, X_TF: Array) -> Array:
    pose = path.pose(u)
    X: Array = np.eye(4)
    X[:3, :3] = np.array(pose.rotation).reshape(3, 3)
    X[:3, 3] = pose.translation
    return X @ X_TF


def _stepped(arm: PinocchioArm, wanted: Array, start: Array) -> Array | None:
    q = start
    for _ in range(8):
        rotation, origin = flange_pose(arm, tuple(q.tolist()))
        turn = wanted[:3, :3] @ rotation.T
        skew = 0.5 * np.array(
            [turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]
        )
        sine = float(np.linalg.norm(skew))
        angle = math.atan2(sine, 0.5 * (float(np.trace(turn)) - 1.0))
        vector = skew * (angle / sine) if sine > 1e-12 else skew
        error = np.concatenate([wanted[:3, 3] - origin, vector])
        if float(np.max(np.abs(error))) < CLOSE:
            return q
        J = jacobian(arm, tuple(q.tolist()))
        try:
            q = q + np.linalg.solve(J, error)
        except np.linalg.LinAlgError:
            return None
        if float(np.max(np.abs(q - start))) > 1.0:
            return None
    return None
