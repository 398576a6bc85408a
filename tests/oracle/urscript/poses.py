"""Poses of URScript: a position in metres and a rotation vector in radians."""

import math

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
