"""In which ways a hand can hold an object, as far as its kind tells.

A can is held round its middle from above, from the side or in between; a dish by its wall; a mesh
as its file says, or by its pieces.
"""

import math
from collections.abc import Iterator

from vrts.base.pose import IDENTITY, Y_AXIS, Pose, rotation_about
from vrts.base.units import DEG, mm
from vrts.geometry.support import bounds, extent_of
from vrts.robots.model import Gripper
from vrts.scene.handling.places import down_pose, grip_height
from vrts.scene.model import Body

TURNS = range(-180, 180, 15)  # [degrees] of the hand about the object's axis
LEANS = (0, 45, -45, 90, -90)  # [degrees] from straight down to level
LEANS_AT_WALL = (0, 20, -20, 40, -40)  # [degrees] more, and a finger is in the foot of the dish
WALL_SHARE = 0.94  # of a dish's radius: the middle of its leaning wall


def holds(gripper: Gripper, body: Body) -> Iterator[Pose]:
    """Yield poses X_OP of the middle between the pads, the plainest first: z of O is up.

    None for what is too wide, too low or too high for the hand.
    """
    if body.kind == "mesh":
        from vrts.scene.handling.mesh_grips import mesh_grips  # numpy

        yield from mesh_grips(gripper, body)
        return
    height = grip_height(gripper, body)
    if height is None:
        return
    wall = body.kind == "dish"
    away = WALL_SHARE * bounds(body.pieces, IDENTITY).upper[0] if wall else 0.0
    for lean in LEANS_AT_WALL if wall else LEANS:
        turned = Pose(rotation_about(Y_AXIS, lean * DEG), (0.0, 0.0, 0.0))
        for turn in TURNS:
            along = (math.cos(turn * DEG), math.sin(turn * DEG), 0.0)  # the fingers close
            if not wall and extent_of(body.pieces, IDENTITY, along).length > gripper.opening_max:
                continue
            x, y = mm(away * along[0]), mm(away * along[1])
            yield down_pose(x, y, mm(height), turn) @ turned
