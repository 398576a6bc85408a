"""What LinuxCNC's sampler wrote: joints and the number of the motion, each millisecond."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from vrts.base.units import DEG
from vrts.dispatch.linuxcnc.machine import JOINT_3

Array = npt.NDArray[np.float64]

STEP_S = 1e-3  # of the servo thread
COLUMNS = 8  # number of the sample, six joints, number of the motion
STILL = 1e-9 * DEG  # a smaller change of every joint is none


@dataclass(frozen=True, slots=True)
class Samples:
    """Commanded joints as VAL counts them."""

    joints: Array  # shape (n, 6) [rad]
    motions: npt.NDArray[np.int64]  # shape (n,): the motion that began last, from 1; 0 before
    lost: int  # samples that were not written

    @property
    def moving(self) -> npt.NDArray[np.bool_]:
        """Whether a joint moved since the sample before, shape (n,)."""
        steps = np.abs(np.diff(self.joints, axis=0)).max(axis=1) > STILL
        return np.concatenate(([False], steps))


def read_samples(text: str) -> Samples:
    """Return what the text holds; rows that are cut short are left out."""
    rows = [row.split() for row in text.splitlines() if "overrun" not in row]
    table = np.array([[float(cell) for cell in row] for row in rows if len(row) == COLUMNS])
    if not len(table):
        return Samples(np.zeros((0, 6)), np.zeros(0, np.int64), 0)
    joints = table[:, 1:7] + np.array([0.0, 0.0, JOINT_3, 0.0, 0.0, 0.0])
    lost = round(float(table[-1, 0] - table[0, 0])) + 1 - len(table)
    return Samples(joints * DEG, np.rint(table[:, 7]).astype(np.int64), lost)
