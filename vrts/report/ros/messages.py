"""Parts that many messages have: time stamps, headers, vectors; and names of frames and joints."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from rosbags.typesys.stores.ros2_humble import (
    builtin_interfaces__msg__Duration as Duration,
)
from rosbags.typesys.stores.ros2_humble import builtin_interfaces__msg__Time as Time
from rosbags.typesys.stores.ros2_humble import geometry_msgs__msg__Point as Point
from rosbags.typesys.stores.ros2_humble import geometry_msgs__msg__Pose as PoseMessage
from rosbags.typesys.stores.ros2_humble import geometry_msgs__msg__Quaternion as Quaternion
from rosbags.typesys.stores.ros2_humble import std_msgs__msg__ColorRGBA as ColorRGBA
from rosbags.typesys.stores.ros2_humble import std_msgs__msg__Header as Header

from vrts.robots.model import Arm
from vrts.robots.urdf.universal import names

__all__ = ["ColorRGBA", "Duration", "Header", "Point", "PoseMessage", "Quaternion", "Time"]

Array: TypeAlias = npt.NDArray[np.float64]

NS = 1_000_000_000  # nanoseconds a second
WORLD, BASE, FLANGE = "world", "base_link", "flange"  # as REP 199 of ROS has it
HAND = "hand"
UNIVERSAL = (  # as the ROS 2 driver of Universal Robots names them
    "shoulder_pan_joint",
    "shoulder_lift_joint",
    "elbow_joint",
    "wrist_1_joint",
    "wrist_2_joint",
    "wrist_3_joint",
)
STILL = PoseMessage(Point(0.0, 0.0, 0.0), Quaternion(0.0, 0.0, 0.0, 1.0))


def nanoseconds(time_s: float) -> int:
    """Return a time of the run in ns."""
    return round(time_s * NS)


def stamp(time_ns: int) -> Time:
    """Return a time stamp."""
    return Time(time_ns // NS, time_ns % NS)


def duration(time_s: float) -> Duration:
    """Return a span of time [s]."""
    time_ns = nanoseconds(time_s)
    return Duration(time_ns // NS, time_ns % NS)


def header(frame: str, time_ns: int = 0) -> Header:
    """Return the header of a message in a frame."""
    return Header(stamp(time_ns), frame)


def link_frame(joint: int) -> str:
    """Return the name of L_k; L_0 is the base."""
    return BASE if joint == 0 else f"link_{joint}"


def joint_names(arm: Arm) -> list[str]:
    """Return the names of the six joints: those of the maker's driver, where there is one."""
    if arm.name in names():
        return list(UNIVERSAL)
    return [f"joint_{k}" for k in range(1, 7)]
