"""Where links, hand and bodies are: poses only while they move, and the way of the tool."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt
import rerun as rr

from vrts.report.assessment import Assessment
from vrts.report.poses.followed import followed
from vrts.report.poses.quaternions import quaternions
from vrts.report.recording.names import Array, at_times, of_body, of_finger, of_robot
from vrts.report.recording.static import static_chunk
from vrts.robots.kinematics.batch import flange_of, link_frames
from vrts.robots.model import Gripper

Mask: TypeAlias = npt.NDArray[np.bool_]

PATH_COLOR = (24, 100, 171)
PATH_RADIUS_M = 0.0015
STILL = 1e-9  # [rad, m] less is no movement


def send_motion(a: Assessment, times: Array, states: Array) -> None:
    """Send poses.

    Args:
        a: With run and scene.
        times: Shape (n,) [s].
        states: Joints [rad] and hand opening [m] at the times, shape (n, 7).
    """
    assert a.run is not None
    assert a.scene is not None
    robot = a.scene.robot
    rotations, origins = link_frames(robot.arm, states[:, :6])
    changes = np.abs(np.diff(states, axis=0)) > STILL
    first = np.ones(1, bool)
    moving = np.arange(len(times)) == 0
    sent = _Poses(times)
    for k in range(len(rotations)):
        if k:
            moving = moving | np.concatenate([first, changes[:, k - 1]])
        for link in robot.arm.links:
            if link.joint == k and link.pieces:
                sent.send(of_robot(link.name), rotations[k], origins[k], moving)
    flange_r, flange_p = flange_of(robot.arm, rotations[6], origins[6])
    sent.send(of_robot("hand"), flange_r, flange_p, moving)
    _tool_path(a, times, flange_r, flange_p, moving)
    for name, track in a.run.placements.items():
        turn, at = followed(track, times, flange_r, flange_p)
        moved = (turn[1:] != turn[:-1]).any(axis=(1, 2)) | (at[1:] != at[:-1]).any(axis=1)
        sent.send(of_body(name), turn, at, np.concatenate([first, moved]))
    _fingers(robot.gripper, times, states[:, 6], np.concatenate([first, changes[:, 6]]))


class _Poses:
    """Sends where things are; those that move together share what tells the times."""

    def __init__(self, times: Array) -> None:
        self._times = times
        self._columns: dict[bytes, list[rr.TimeColumn]] = {}

    def send(self, path: str, rotations: Array, origins: Array, moving: Mask) -> None:
        """Send poses in W at the times when something has just moved.

        At once, one after another: so the next finds the memory of the last.

        Args:
            path: Of what moves.
            rotations: At all times, shape (n, 3, 3).
            origins: Shape (n, 3) [m].
            moving: Shape (n,).
        """
        at, key = np.flatnonzero(moving), moving.tobytes()
        if key not in self._columns:
            self._columns[key] = at_times(self._times[at])
        columns = rr.Transform3D.columns(
            translation=origins.take(at, axis=0).astype(np.float32),
            quaternion=quaternions(rotations.take(at, axis=0)),
        )
        rr.send_columns(path, self._columns[key], columns)


def _fingers(gripper: Gripper, times: Array, opening: Array, moving: Mask) -> None:
    """Send where the fingers are in the hand, which moves them along its y axis."""
    for finger in gripper.fingers:
        at = np.zeros((np.count_nonzero(moving), 3), np.float32)
        at[:, 1] = 0.5 * finger.side * opening[moving]
        rr.send_columns(
            of_finger(finger.name), at_times(times[moving]), rr.Transform3D.columns(translation=at)
        )


def _tool_path(
    a: Assessment,
    times: Array,
    flange_r: Array,
    flange_p: Array,
    carried: Mask,
) -> None:
    """Draw the way of the tool's tip, with the tool in force at every instant."""
    assert a.run is not None
    tools = [a.run.scene.X_FT, *(m.X_FT for m in a.run.motions)]
    starts = np.array([m.start_s for m in a.run.motions])
    tip = np.array([tool.translation for tool in tools])
    at = tip[np.searchsorted(starts, times, side="right")]
    points = flange_p + (flange_r @ at[:, :, None])[:, :, 0]
    keep = carried | np.concatenate([[True], (at[1:] != at[:-1]).any(axis=1)])
    strip = rr.LineStrips3D(
        [points[keep].astype(np.float32)], colors=[PATH_COLOR], radii=[PATH_RADIUS_M]
    )
    rr.send_chunks(static_chunk("world/tool_path", strip))
