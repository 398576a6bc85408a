"""What the joints do from rest to rest, as `trajectory_msgs/JointTrajectory`.

A joint trajectory controller of ROS joins points that have positions and velocities by cubics
(ros2_controllers, joint_trajectory_controller, "Trajectory representation"). Pieces of a run that
are cubics need a point at each end and are followed exactly; others are halved until the cubic is
as near as `TOLERANCE`.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from rosbags.typesys.stores.ros2_humble import (
    trajectory_msgs__msg__JointTrajectory as JointTrajectory,
)
from rosbags.typesys.stores.ros2_humble import (
    trajectory_msgs__msg__JointTrajectoryPoint as JointTrajectoryPoint,
)

from vrts.check.collision.of_run import motion_of
from vrts.check.curves.timeline_arrays import Curves
from vrts.engine.run import Run
from vrts.report.ros.messages import Array, duration, header, joint_names, nanoseconds

TOLERANCE = 1e-6  # [rad] of a cubic from the motion
LOOKED_AT = np.array([0.15, 0.3, 0.5, 0.7, 0.85])  # parts of a piece where the cubic is compared
SHORTEST = 1e-4  # [s] no piece is halved below
REST = 1e-9  # [s] less is no time
JOINTS = slice(0, 6)


class Way(NamedTuple):
    """From rest to rest."""

    start_s: float
    end_s: float
    times: Array  # of points, from 0 [s]
    positions: Array  # (n, 6) [rad]
    velocities: Array  # (n, 6) [rad/s]


def ways(run: Run) -> Iterator[Way]:
    """Return the ways of the arm from rest to rest, in time order."""
    motion = motion_of(run)
    for begin, end in _busy(motion):
        times = np.array(_points(motion, begin, end))
        values, rates = motion.values(times)[:, JOINTS], motion.velocities(times)[:, JOINTS]
        rates[[0, -1]] = 0.0
        yield Way(begin, end, times - begin, values, rates)


def trajectories(run: Run) -> Iterator[tuple[int, JointTrajectory]]:
    """Return a message for each way, with the time at which it begins [ns]."""
    names = joint_names(run.scene.robot.arm)
    for way in ways(run):
        time_ns = nanoseconds(way.start_s)
        yield time_ns, JointTrajectory(header("", time_ns), names, _messages(way))


def _messages(way: Way) -> list[JointTrajectoryPoint]:
    nothing = np.zeros(0)
    return [
        JointTrajectoryPoint(position, velocity, nothing, nothing, duration(time_s))
        for time_s, position, velocity in zip(
            way.times.tolist(), way.positions, way.velocities, strict=True
        )
    ]


def _busy(motion: Curves) -> list[tuple[float, float]]:
    """Return the intervals in which joints move [s]."""
    moving = np.abs(motion.powers[:, JOINTS, 1:]).max(axis=(1, 2)) > 0.0
    moving |= motion.high_at >= 0
    found: list[tuple[float, float]] = []
    for start, end, busy in zip(
        motion.starts.tolist(), motion.ends.tolist(), moving.tolist(), strict=True
    ):
        if not busy or end - start <= REST:
            continue
        if found and start - found[-1][1] <= REST:
            found[-1] = (found[-1][0], end)
        else:
            found.append((start, end))
    return found


def _points(motion: Curves, begin: float, end: float) -> list[float]:
    """Return the times of the points of a way [s]."""
    inside = (motion.starts > begin + REST) & (motion.starts < end - REST)
    open_ = [*zip([begin, *motion.starts[inside]], [*motion.starts[inside], end], strict=True)]
    found = [begin]
    open_.reverse()
    while open_:
        a, b = open_.pop()
        if b - a > SHORTEST and _apart(motion, a, b) > TOLERANCE:
            middle = 0.5 * (a + b)
            open_ += [(middle, b), (a, middle)]
        else:
            found.append(float(b))
    return found


def _apart(motion: Curves, a: float, b: float) -> float:
    """Return how far the cubic between two points is from the motion, in rad."""
    span, inner = b - a, 1e-9 * (b - a)  # a piece begins with its own velocity
    ends = np.array([a + inner, b - inner])
    q, v = motion.values(ends)[:, JOINTS], motion.velocities(ends)[:, JOINTS] * span
    u = LOOKED_AT[:, None]
    cubic = (
        (1 + 2 * u) * (1 - u) ** 2 * q[0]
        + u * (1 - u) ** 2 * v[0]
        + u**2 * (3 - 2 * u) * q[1]
        + u**2 * (u - 1) * v[1]
    )
    return float(np.abs(cubic - motion.values(a + LOOKED_AT * span)[:, JOINTS]).max())
