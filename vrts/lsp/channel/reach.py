"""What is asked of the arm's reach, as a line of JSON and back. The answer is a text."""

import json

from vrts.base.pose import Pose


def reach_line(path: str, X_WT: Pose) -> bytes:
    """Return a line that asks whether the tool gets to a pose.

    Args:
        path: Of a program; the task beside it tells the scene.
        X_WT: Pose of the tool in the world; translation in m.
    """
    return json.dumps((path, X_WT.rotation, X_WT.translation)).encode() + b"\n"


def reach_of(line: bytes) -> tuple[str, Pose]:
    """Return the path and the pose of the tool in the world [m] that a line asks about."""
    path, rotation, translation = json.loads(line)
    return path, Pose(tuple(rotation), tuple(translation))
