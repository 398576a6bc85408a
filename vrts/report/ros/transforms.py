"""Where every link, the fingers and the objects are, as `tf2_msgs/TFMessage`."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from rosbags.typesys.stores.ros2_humble import geometry_msgs__msg__Transform as Transform
from rosbags.typesys.stores.ros2_humble import (
    geometry_msgs__msg__TransformStamped as TransformStamped,
)
from rosbags.typesys.stores.ros2_humble import geometry_msgs__msg__Vector3 as Vector3
from rosbags.typesys.stores.ros2_humble import tf2_msgs__msg__TFMessage as TFMessage

from vrts.base.pose import IDENTITY, Pose
from vrts.engine.run import Run
from vrts.report.poses.followed import followed
from vrts.report.poses.quaternions import quaternions
from vrts.report.ros.messages import (
    BASE,
    FLANGE,
    WORLD,
    Array,
    Quaternion,
    header,
    link_frame,
    nanoseconds,
)
from vrts.robots.kinematics.batch import flange_of, link_frames

LINKS = range(1, 7)


class _Track(NamedTuple):
    """Where a frame is in its parent at n instants."""

    parent: str
    child: str
    turns: Array  # quaternions x y z w, (n, 4)
    origins: Array  # (n, 3) [m]


def moving_frames(run: Run, times: Array, states: Array) -> Iterator[tuple[int, TFMessage]]:
    """Return a message for each instant with all that ever moves, with its time [ns].

    Args:
        run: The run.
        times: Shape (n,) [s].
        states: Joints [rad] and hand opening [m], shape (n, 7).
    """
    arm = run.scene.robot.arm
    rotations, origins = link_frames(arm, states[:, :6])
    flange = flange_of(arm, rotations[6], origins[6])
    tracks = [*_arm(rotations, origins, flange), *_fingers(run, states[:, 6])]
    tracks += _bodies(run, times, flange)
    for k, time_s in enumerate(times.tolist()):
        time_ns = nanoseconds(time_s)
        frames = [
            _stamped(track.parent, track.child, track.turns[k], track.origins[k], time_ns)
            for track in tracks
        ]
        yield time_ns, TFMessage(frames)


def still_frames(run: Run) -> TFMessage:
    """Return the base of the robot and the bodies that never move, in the world."""
    found = [TransformStamped(header(WORLD), BASE, _placed(IDENTITY))]
    found += [
        TransformStamped(header(WORLD), body.name, _placed(body.X_WO))
        for body in run.scene.bodies
        if body.name not in run.placements
    ]
    return TFMessage(found)


def _arm(rotations: Array, origins: Array, flange: tuple[Array, Array]) -> Iterator[_Track]:
    for k in LINKS:
        back = np.swapaxes(rotations[k - 1], 1, 2)
        turns = quaternions(back @ rotations[k]).astype(float)
        at = np.einsum("nij,nj->ni", back, origins[k] - origins[k - 1])
        yield _Track(link_frame(k - 1), link_frame(k), turns, at)
    turned, tip = flange
    back = np.swapaxes(rotations[6], 1, 2)
    at = np.einsum("nij,nj->ni", back, tip - origins[6])
    yield _Track(link_frame(6), FLANGE, quaternions(back @ turned).astype(float), at)


def _fingers(run: Run, opening: Array) -> Iterator[_Track]:
    unturned = np.tile([0.0, 0.0, 0.0, 1.0], (len(opening), 1))
    for finger in run.scene.robot.gripper.fingers:
        at = np.zeros((len(opening), 3))
        at[:, 1] = 0.5 * finger.side * opening
        yield _Track(FLANGE, frame_of_finger(finger.name), unturned, at)


def frame_of_finger(name: str) -> str:
    """Return the frame of a finger, which moves along the y axis of the flange."""
    return name.replace(" ", "_")


def _bodies(run: Run, times: Array, flange: tuple[Array, Array]) -> Iterator[_Track]:
    for name, track in run.placements.items():
        turns, at = followed(track, times, *flange)
        yield _Track(WORLD, name, quaternions(turns).astype(float), at)


def _placed(X: Pose) -> Transform:
    turn = quaternions(np.array(X.rotation).reshape(1, 3, 3)).astype(float)[0]
    return _transform(turn, np.array(X.translation))


def _stamped(parent: str, child: str, turn: Array, at: Array, time_ns: int) -> TransformStamped:
    return TransformStamped(header(parent, time_ns), child, _transform(turn, at))


def _transform(turn: Array, at: Array) -> Transform:
    return Transform(Vector3(*at.tolist()), Quaternion(*turn.tolist()))
