"""A picture of a moment for the terminal: outlines in braille dots, nearer things in front.

Two by four dots a character make dots square. Parallel projection from the right, in front, above.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from vrts.base.pose import Pose, Vector, dot, translation
from vrts.geometry.shapes import Piece
from vrts.report.screen.palette import Palette, Style
from vrts.robots.kinematics.kinematics import hand_pose, link_poses
from vrts.robots.model import Configuration
from vrts.scene.model import Scene
from vrts.scene.outline import Polygon, outline

COLUMNS, ROWS = 76, 26  # at most [characters]
SIGN = "✕"

_AZIMUTH, _ELEVATION = math.radians(-40.0), math.radians(18.0)  # where the eye stands
_RIGHT: Vector = (-math.sin(_AZIMUTH), math.cos(_AZIMUTH), 0.0)
_UP: Vector = (
    -math.sin(_ELEVATION) * math.cos(_AZIMUTH),
    -math.sin(_ELEVATION) * math.sin(_AZIMUTH),
    math.cos(_ELEVATION),
)
_TOWARDS: Vector = (  # from the scene to the eye
    math.cos(_ELEVATION) * math.cos(_AZIMUTH),
    math.cos(_ELEVATION) * math.sin(_AZIMUTH),
    math.sin(_ELEVATION),
)
_DOTS = ((0x01, 0x08), (0x02, 0x10), (0x04, 0x20), (0x40, 0x80))  # bit of a dot: [row][column]


class _Face(NamedTuple):
    in_front: bool  # of every table: what stands on one is never hidden by it
    nearness: float  # along the direction to the eye [m]
    polygon: Polygon


class _Placed(NamedTuple):
    piece: Piece
    X_WO: Pose
    kind: str


def sketch(
    scene: Scene,
    configuration: Configuration,
    hand_opening: float,
    poses: Mapping[str, Pose],
    point: Vector | None,
    palette: Palette,
) -> list[str]:
    """Return the lines of a picture.

    Args:
        scene: What to draw; its floor is left out.
        configuration: Of the arm [rad].
        hand_opening: [m].
        poses: X_WO of bodies that are not where the scene starts.
        point: Where something touches, in W [m]; marked in front of everything.
        palette: Paints the mark.
    """
    faces = sorted(
        _Face(
            placed.kind != "table",
            dot(placed.X_WO.apply(placed.piece.X_OP.translation), _TOWARDS),
            outline([placed.piece], placed.X_WO, _RIGHT, _UP),
        )
        for placed in _pieces(scene, configuration, hand_opening, poses)
    )
    corners = [corner for face in faces for corner in face.polygon]
    left, low = min(x for x, _ in corners), min(y for _, y in corners)
    right, high = max(x for x, _ in corners), max(y for _, y in corners)
    scale = min((2 * COLUMNS - 1) / (right - left), (4 * ROWS - 1) / (high - low))
    width, height = (int(length * scale) + 1 for length in (right - left, high - low))
    dots = [bytearray(width) for _ in range(height)]
    for face in faces:
        _draw(dots, [((x - left) * scale, (high - y) * scale) for x, y in face.polygon])
    mark = None
    if point is not None:
        column = int((dot(point, _RIGHT) - left) * scale) // 2
        mark = (column, int((high - dot(point, _UP)) * scale) // 4)
    return _characters(dots, mark, palette)


def _pieces(
    scene: Scene, q: Configuration, hand_opening: float, poses: Mapping[str, Pose]
) -> list[_Placed]:
    arm, gripper = scene.robot.arm, scene.robot.gripper
    X_WL = link_poses(arm, q)
    X_WF = hand_pose(arm, q)
    found = [_Placed(p, X_WL[link.joint], "robot") for link in arm.links for p in link.pieces]
    found += [_Placed(piece, X_WF, "robot") for piece in gripper.body]
    for finger in gripper.fingers:
        X_WG = X_WF @ translation(0.0, finger.side * hand_opening / 2, 0.0)
        found += [_Placed(piece, X_WG, "robot") for piece in finger.pieces]
    for body in scene.bodies:
        if body.kind != "floor":
            X_WO = poses.get(body.name, body.X_WO)
            found += [_Placed(piece, X_WO, body.kind) for piece in body.pieces]
    return found


def _draw(dots: Sequence[bytearray], polygon: Sequence[tuple[float, float]]) -> None:
    """Clear the inside of a convex polygon, then set its edge. Coordinates in dots, y down."""
    edges = list(zip(polygon, (*polygon[1:], polygon[0]), strict=True))
    for y in range(len(dots)):
        crossings = [
            ax + (y - ay) / (by - ay) * (bx - ax)
            for (ax, ay), (bx, by) in edges
            if min(ay, by) <= y <= max(ay, by) and ay != by
        ]
        if crossings:
            first, last = math.ceil(min(crossings)), math.floor(max(crossings))
            dots[y][first : last + 1] = bytes(max(0, last + 1 - first))
    for (ax, ay), (bx, by) in edges:
        steps = max(1, math.ceil(max(abs(bx - ax), abs(by - ay))))
        for k in range(steps + 1):
            x, y = ax + (bx - ax) * k / steps, ay + (by - ay) * k / steps
            dots[min(int(y), len(dots) - 1)][min(int(x), len(dots[0]) - 1)] = 1


def _characters(
    dots: Sequence[bytearray], mark: tuple[int, int] | None, palette: Palette
) -> list[str]:
    rows: list[str] = []
    for top in range(0, len(dots), 4):
        cells: list[str] = []
        for left in range(0, len(dots[0]), 2):
            if mark == (left // 2, top // 4):
                cells.append(palette.paint(Style.ERROR, SIGN))
                continue
            bits = sum(
                bit
                for dy, pair in enumerate(_DOTS)
                for dx, bit in enumerate(pair)
                if top + dy < len(dots) and left + dx < len(dots[0]) and dots[top + dy][left + dx]
            )
            cells.append(chr(0x2800 + bits) if bits else " ")
        rows.append("".join(cells).rstrip())
    return rows
