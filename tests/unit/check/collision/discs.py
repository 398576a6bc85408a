"""A can that the hand turns about its own axis, as near to a block as anybody likes."""

import math

from tests.collision_runs import Line, Record, fixed, hermite, movable, scene_of
from vrts.base.pose import IDENTITY, translation
from vrts.engine.memory.records import Lie, Placement, Segment
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.robots.catalog import robot
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scene

READY = (0.0, -1.0, 1.5, 0.0, 1.0, 0.0)
RADIUS, HALF = 0.05, 0.02  # [m]
TURN_S = 1.0


def turning(gap: float, off: float = 0.0) -> tuple[Scene, Record]:
    """Return a run in which a can turns by 1.5 rad beside a block.

    Args:
        gap: Between them at first [m].
        off: Of the can's axis from that of the last joint [m].
    """
    machine = robot("puma761")
    X_FO = translation(off, 0.0, 0.5)
    beside = translation(RADIUS + gap + HALF, 0.0, 0.0)
    X_WB = forward(machine.arm, READY) @ X_FO @ beside
    block = fixed("block", Piece(Box((HALF, HALF, HALF)), X_WB))
    can = movable("can", Piece(Cylinder(RADIUS, 0.05), IDENTITY), at=(0.0, 0.0, 9.0), on=None)
    rows = [*((q,) for q in READY[:5]), hermite(READY[5], 1.5, 0.0, 0.0, TURN_S), (0.0,)]
    held = {"can": (Placement("can", 0.0, math.inf, Lie.HELD, X_FO, None),)}
    record = Record(Line((Segment(0.0, TURN_S, tuple(rows), None),)), (), (), held)
    return scene_of(block, can, machine=machine), record
