"""Where links, hand and bodies are: poses only while they move, and the way of the tool."""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

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
    tracks: list[_Track] = []
    for k in range(len(rotations)):
        if k:
            moving = moving | np.concatenate([first, changes[:, k - 1]])
        names = [link.name for link in robot.arm.links if link.joint == k and link.pieces]
        tracks += [_Track(of_robot(name), rotations[k], origins[k], moving) for name in names]
    flange_r, flange_p = flange_of(robot.arm, rotations[6], origins[6])
    tracks.append(_Track(of_robot("hand"), flange_r, flange_p, moving))
    _tool_path(a, times, flange_r, flange_p, moving)
    for name, track in a.run.placements.items():
        turn, at = followed(track, times, flange_r, flange_p)
        places = np.concatenate([turn.reshape(-1, 9), at], axis=1)
        moved = np.concatenate([first, (places[1:] != places[:-1]).any(axis=1)])
        tracks.append(_Track(of_body(name), turn, at, moved))
    _send(tracks, times)
    _fingers(robot.gripper, times, states[:, 6], np.concatenate([first, changes[:, 6]]))


class _Track(NamedTuple):
    """Where something is in W at all times, and when it has just moved."""

    path: str
    rotations: Array  # (n, 3, 3)
    origins: Array  # (n, 3) [m]
    moving: Mask  # (n,)


def _send(tracks: Sequence[_Track], times: Array) -> None:
    """Send tracks; those that move together share what tells the times."""
    rows = [np.flatnonzero(track.moving) for track in tracks]
    turns = [track.rotations.take(at, axis=0) for track, at in zip(tracks, rows, strict=True)]
    ends = np.cumsum([len(at) for at in rows])
    columns: dict[bytes, list[rr.TimeColumn]] = {}
    each = np.split(quaternions(np.concatenate(turns)), ends[:-1])
    for track, at, turn in zip(tracks, rows, each, strict=True):
        key = at.tobytes()
        if key not in columns:
            columns[key] = at_times(times[at])
        rr.send_columns(
            track.path,
            columns[key],
            rr.Transform3D.columns(
                translation=track.origins.take(at, axis=0).astype(np.float32), quaternion=turn
            ),
        )


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
