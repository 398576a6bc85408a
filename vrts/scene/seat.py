"""Where things stand on a thing whose highest point is not its place for them."""

from vrts.base.pose import Pose, translation
from vrts.geometry.shapes import Box
from vrts.scene.model import Body


def seat(body: Body) -> Pose | None:
    """Return the pose X_WS in the middle of a stand's plate, z away from it; None for other kinds.

    The plate is the first piece of a stand.
    """
    piece = body.pieces[0]
    if body.kind != "stand" or not isinstance(piece.shape, Box):
        return None
    return body.X_WO @ piece.X_OP @ translation(0.0, 0.0, piece.shape.half_extents[2])
