"""A held box whose edge touches the side of a thin rod exactly: python-fcl ends its process there.

It throws through C++ (status 134). The two overlap by less than 0.1 µm.
"""

import math
from typing import NamedTuple

from tests.collision_runs import Record, Story, fixed, movable, scene_of
from vrts.base.pose import IDENTITY, Pose
from vrts.engine.memory.records import Lie, Placement
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scene

BOX = Box((0.0635, 0.0321, 0.0889))
ROD = Cylinder(0.001, 0.07225814648962738)
X_WB = Pose(
    (
        *(-0.8883728802915367, 0.29848623545642811, 0.3488546872346258),
        *(-0.45231059882569569, -0.69938593188904141, -0.55342067224276836),
        *(0.078795607443939181, -0.64943458909943097, 0.75632398264817291),
    ),
    (-0.31764131131034995, 0.67943270788304344, 1.2538681605088564),
)
X_WR = Pose(
    (
        *(0.70840657543871322, 0.68537119893810172, -0.16860143398365238),
        *(-0.61906721653414987, 0.71809248329470254, 0.31796063726239376),
        *(0.33899248559201839, -0.12086978572743737, 0.93299227735836521),
    ),
    (-0.36520721289586627, 0.64777262688706749, 1.4140144358849878),
)


class Touching(NamedTuple):
    """A run that rests in the touch, and where it happens."""

    scene: Scene
    record: Record


def touching() -> Touching:
    """Return a run that holds the box against the rod for a second."""
    box = movable("box", Piece(BOX, IDENTITY), at=(0.0, 0.0, 9.0), on=None)
    rod = fixed("rod", Piece(ROD, X_WR))
    scene = scene_of(rod, box)
    story = Story(scene, (0.4, -1.2, 2.2, 0.3, 0.9, 0.2))
    X_WF = forward(scene.robot.arm, story.q)
    held = Placement("box", 0.0, math.inf, Lie.HELD, X_WF.inverse() @ X_WB, None)
    story.placements["box"] = [held]
    story.wait(1.0)
    return Touching(scene, story.record())
