"""Poses of URScript: a position in metres and a rotation vector in radians."""

import math
from collections.abc import Callable

import numpy as np
import numpy.typing as npt

Matrix = npt.NDArray[np.float64]
Pose = tuple[float, ...]


def matrix(pose: Pose) -> Matrix:
    """Return a pose as a 4 x 4 matrix."""
    made = np.eye(4)
    made[:3, 3] = pose[:3]
    angle = math.sqrt(sum(part * part for part in pose[3:]))
    if angle > 0.0:
        x, y, z = (part / angle for part in pose[3:])
        k = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
        made[:3, :3] = np.eye(3) + math.sin(angle) * k + (1.0 - math.cos(angle)) * (k @ k)
    return made


def pose(given: Matrix) -> Pose:
    """Return a matrix as a pose."""
    turn = given[:3, :3]
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    angle = math.atan2(float(np.linalg.norm(axis)) / 2.0, (float(np.trace(turn)) - 1.0) / 2.0)
    if angle < 1e-12:
        vector = np.zeros(3)
    elif math.pi - angle < 1e-6:
        square = (turn + np.eye(3)) / 2.0
        column = square[:, int(np.argmax(np.diag(square)))]
        vector = angle * column / np.linalg.norm(column)
        if float(vector @ axis) < 0.0:
            vector = -vector
    else:
        vector = angle * axis / (2.0 * math.sin(angle))
    return (*map(float, given[:3, 3]), *map(float, vector))


def nearest(forward: Callable[[Pose], Matrix], target: Matrix, joints: Matrix) -> Matrix:
    """Return the joints of a pose of the flange that Newton's steps reach from where an arm stands.

    Every joint then is within half a turn of where it was.
    """
    at = joints.copy()
    for _ in range(40):
        error = _between(forward(tuple(at)), target)
        if np.abs(error).max() < 1e-10:
            break
        columns = [
            _between(forward(tuple(at)), forward(tuple(at + 1e-7 * np.eye(6)[k]))) / 1e-7
            for k in range(6)
        ]
        step = np.linalg.lstsq(np.array(columns).T, error, rcond=1e-9)[0]
        at = at + step * min(1.0, 0.3 / max(float(np.abs(step).max()), 1e-12))
    return joints + np.remainder(at - joints + math.pi, 2.0 * math.pi) - math.pi


def _between(one: Matrix, other: Matrix) -> Matrix:
    turn = np.array(pose(other @ np.linalg.inv(one))[3:])
    return np.concatenate([other[:3, 3] - one[:3, 3], turn])
