"""An arm as a URDF file describes it, or what is wrong with the file."""

from typing import NamedTuple

from vrts.base.pose import Pose

JOINTS = 6


class UrdfFault(Exception):  # noqa: N818 -- names what it is
    """A description does not give an arm that can be simulated."""

    def __init__(self, message: str, line: int | None = None) -> None:
        """Say what is wrong, and where if it is at one place."""
        super().__init__(message)
        self.message = message
        self.line = line


class Shape(NamedTuple):
    """A collision element of a link."""

    kind: str  # "box", "cylinder", "sphere" or "mesh"
    size: tuple[float, ...]  # edges; radius and length; radius; scale along x, y and z
    file: str  # of a mesh, as the description names it
    X_LP: Pose  # in the frame L_k it moves with
    line: int


class Part(NamedTuple):
    """What moves with one joint."""

    name: str  # of the URDF link
    joint: int  # 0 is the base
    shapes: tuple[Shape, ...]


class Description(NamedTuple):
    """An arm as its file describes it."""

    name: str
    joints: tuple[Pose, ...]  # of L_k in L_(k-1) at zero
    X_LF: Pose
    lower: tuple[float, ...]  # [rad]
    upper: tuple[float, ...]  # [rad]
    speed: tuple[float, ...]  # [rad/s]; 0 where the file gives none
    joint_names: tuple[str, ...]
    parts: tuple[Part, ...]
