"""Where things stand on a thing whose highest point is not its place for them."""

from vrts.base.pose import Pose, translation
from vrts.geometry.shapes import Box
from vrts.scene.model import Body


def seat(body: Body) -> Pose | None:
    """Return X_WS in the middle of a stand's plate or an oven's stone, z away from it.

    None for other kinds. Plate and stone are the first pieces.
    """
    piece = body.pieces[0]
    if body.kind not in ("stand", "oven") or not isinstance(piece.shape, Box):
        return None
    return body.X_WO @ piece.X_OP @ translation(0.0, 0.0, piece.shape.half_extents[2])
