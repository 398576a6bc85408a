"""Goals of a joint trajectory controller as YAML, as `ros2 action send_goal` takes them."""

from collections.abc import Sequence

from vrts.report.ros.messages import Array, duration
from vrts.report.ros.trajectories import Way

DECIMALS = 9  # of angles in rad: less than a thousandth of what matters


def goal_text(names: Sequence[str], way: Way) -> str:
    """Return a goal of `control_msgs/FollowJointTrajectory`.

    Args:
        names: Of the joints.
        way: From rest to rest.
    """
    lines = ["trajectory:", f"  joint_names: [{', '.join(names)}]", "  points:"]
    for time_s, position, velocity in zip(
        way.times.tolist(), way.positions, way.velocities, strict=True
    ):
        after = duration(time_s)
        lines += [
            f"  - positions: [{_listed(position)}]",
            f"    velocities: [{_listed(velocity)}]",
            f"    time_from_start: {{sec: {after.sec}, nanosec: {after.nanosec}}}",
        ]
    return "\n".join(lines) + "\n"


def _listed(values: Array) -> str:
    return ", ".join(f"{value + 0.0:.{DECIMALS}f}" for value in values.tolist())
