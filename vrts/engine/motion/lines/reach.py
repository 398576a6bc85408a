"""Whether the end of a straight line can be reached at all, before the line is begun."""

from vrts.base.pose import Pose
from vrts.engine.motion.lines.path import LinePath
from vrts.robots.kinematics.approach import approach
from vrts.robots.kinematics.kinematics import reach_error
from vrts.robots.kinematics.limits import unlimited
from vrts.robots.kinematics.serial_solutions import MOST_STEPS
from vrts.robots.kinematics.tracking import track
from vrts.robots.model import Arm, ArmBranch, Configuration, SerialArm

LOOKS = 64  # along a line whose end no start leads to


def end_out_of_reach(
    arm: Arm, path: LinePath, X_FT: Pose, start: tuple[Configuration, ArmBranch]
) -> tuple[str, float] | None:
    """Return why the end of a line is out of reach, and by how much; None when it is in reach.

    Joint limits are another question: they bind where the line comes to them. Arms without a closed
    form are asked from where they stand, from everywhere, and at last along the line.

    Args:
        arm: The arm.
        path: Of the tool.
        X_FT: The tool.
        start: Where the arm stands.

    Returns:
        ("too far" or "too close", by how much [m]).
    """
    X_TF = X_FT.inverse()
    X_BF = path.X_BT1 @ X_TF
    if not isinstance(arm, SerialArm):
        return reach_error(arm, X_BF)
    if approach(arm, X_BF, start[0], MOST_STEPS).reached:
        return None
    error = reach_error(arm, X_BF)
    if error is None:
        return None
    free, (q, branch) = unlimited(arm), start
    for number in range(1, LOOKS + 1):
        found = track(free, path.pose(number / LOOKS) @ X_TF, branch, q)
        if found is None:
            return error
        q, branch = found
    return None
