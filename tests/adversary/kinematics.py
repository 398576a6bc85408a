"""Where the parts of the PUMA 761 are, from its table alone: it shares no code with vrts.

Denavit and Hartenberg's table, one row a joint: along z and x of the frame before, about its x,
along the new z, and then about that by the joint.
"""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]

TABLE = (  # along z [m], along x [m], about x [deg], along the new z [m]
    (0.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, -90.0, 0.0),
    (0.0, 0.650, 0.0, 0.190),
    (0.0, 0.0, 90.0, 0.0),
    (0.850, 0.0, -90.0, 0.0),
    (0.0, 0.0, 90.0, 0.0),
)
FLANGE = 0.125  # [m] from the wrist along the last axis


def frames(q: Array) -> Array:
    """Return seven link frames and the flange in the base for joints (n, 6) [rad]: (8, n, 4, 4)."""
    found = [np.tile(np.eye(4), (len(q), 1, 1))]
    for joint, (before, a, alpha, d) in enumerate(TABLE):
        still = _along(0, 0, before) @ _along(a, 0, 0) @ _about_x(np.radians(alpha))
        found.append(found[-1] @ (still @ _along(0, 0, d)) @ _about_z(q[:, joint]))
    return np.array([*found, found[-1] @ _along(0, 0, FLANGE)])


def _along(x: float, y: float, z: float) -> Array:
    shift = np.eye(4)
    shift[:3, 3] = x, y, z
    return shift


def _about_x(angle: float) -> Array:
    turn = np.eye(4)
    c, s = np.cos(angle), np.sin(angle)
    turn[1:3, 1:3] = ((c, -s), (s, c))
    return turn


def _about_z(angles: Array) -> Array:
    turn = np.tile(np.eye(4), (len(angles), 1, 1))
    c, s = np.cos(angles), np.sin(angles)
    turn[:, 0, 0], turn[:, 0, 1], turn[:, 1, 0], turn[:, 1, 1] = c, -s, s, c
    return turn
