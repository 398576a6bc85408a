"""Joint angles, speeds and the opening of the hand, as `sensor_msgs/JointState`."""

from collections.abc import Iterator

import numpy as np
from rosbags.typesys.stores.ros2_humble import sensor_msgs__msg__JointState as JointState

from vrts.report.ros.messages import HAND, Array, header, joint_names, nanoseconds
from vrts.robots.model import Arm


def joint_states(
    arm: Arm, times: Array, states: Array, rates: Array
) -> Iterator[tuple[int, JointState]]:
    """Return a message for each instant, with its time [ns].

    Args:
        arm: Gives the names.
        times: Shape (n,) [s].
        states: Joints [rad] and hand opening [m], shape (n, 7).
        rates: Of these [rad/s, m/s].
    """
    names, nothing = [*joint_names(arm), HAND], np.zeros(0)
    for time_s, values, speeds in zip(times.tolist(), states, rates, strict=True):
        time_ns = nanoseconds(time_s)
        yield time_ns, JointState(header("", time_ns), names, values, speeds, nothing)
