"""What is drawn: the closed surfaces of bodies and of the robot, with normals and colours.

The pieces that are drawn are those that are tested for collision.
"""

from functools import lru_cache
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.geometry.mesh import tessellate
from vrts.geometry.shapes import Piece
from vrts.robots.model import Robot
from vrts.scene.model import Body, Scene

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int32]
Color: TypeAlias = tuple[float, float, float]

CREASE = np.cos(np.radians(35.0))  # faces that meet at a sharper angle keep their edge

ARM_LIGHT: Color = (0.74, 0.72, 0.66)  # linear RGB, as of painted castings
ARM_DARK: Color = (0.055, 0.065, 0.08)
STEEL: Color = (0.38, 0.40, 0.43)
FINGER: Color = (0.10, 0.11, 0.13)
LINK_COLORS: tuple[Color, ...] = (
    ARM_DARK,
    ARM_LIGHT,
    ARM_LIGHT,
    ARM_LIGHT,
    ARM_DARK,
    ARM_LIGHT,
    STEEL,
)


class Surface(NamedTuple):
    """A closed surface of triangles in its body's frame."""

    corners: Array  # (m, 3, 3): triangle, corner, xyz [m]
    normals: Array  # (m, 3, 3): unit normal at each corner, smooth over round faces


class Solid(NamedTuple):
    """A rigid thing to draw."""

    name: str  # of the body, link or finger
    group: str  # "robot", or the name of the body
    surface: Surface
    color: Color  # linear RGB 0..1


@lru_cache(maxsize=512)
def surface(pieces: tuple[Piece, ...]) -> Surface:
    """Return the surfaces of all pieces of a body, in the body's frame."""
    parts = [_smooth(*tessellate(piece)) for piece in pieces]
    if not parts:
        return Surface(np.zeros((0, 3, 3)), np.zeros((0, 3, 3)))
    return Surface(
        np.concatenate([part.corners for part in parts]),
        np.concatenate([part.normals for part in parts]),
    )


def body_solids(scene: Scene) -> tuple[Solid, ...]:
    """Return the bodies of a scene, in its order: one solid for every colour of a body."""
    return tuple(
        Solid(body.name, body.name, surface(pieces), color)
        for body in scene.bodies
        for color, pieces in by_color(body)
    )


def by_color(body: Body) -> list[tuple[Color, tuple[Piece, ...]]]:
    """Return every colour of a body with its pieces, in the order of the body."""
    colors = dict.fromkeys(color for _, color in body.painted)
    return [(c, tuple(piece for piece, own in body.painted if own == c)) for c in colors]


def link_solids(robot: Robot) -> tuple[Solid, ...]:
    """Return links 0 to 6, in their frames L_k, then the hand's body and two fingers, in F."""
    links = [
        Solid(link.name, "robot", surface(link.pieces), LINK_COLORS[link.joint % 7])
        for link in robot.arm.links
    ]
    hand = Solid("hand", "robot", surface(robot.gripper.body), STEEL)
    fingers = [
        Solid(finger.name, "robot", surface(finger.pieces), FINGER)
        for finger in robot.gripper.fingers
    ]
    return (*links, hand, *fingers)


def _smooth(vertices: Array, triangles: Indices) -> Surface:
    corners = vertices[triangles]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    facing /= np.maximum(np.linalg.norm(facing, axis=1, keepdims=True), 1e-300)
    weights = _angles(corners)
    # all pairs (corner, triangle) that share a vertex
    owner = triangles.ravel()
    order = np.argsort(owner, kind="stable")
    counts = np.bincount(owner, minlength=len(vertices))
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]])
    repeats = counts[owner]
    first = np.repeat(np.arange(len(owner)), repeats)
    offset = np.arange(len(first)) - np.repeat(np.cumsum(repeats) - repeats, repeats)
    second = order[np.repeat(starts[owner], repeats) + offset]
    one, other = facing[first // 3], facing[second // 3]
    share = np.where((one * other).sum(1) > CREASE, weights.ravel()[second], 0.0)
    normals = np.stack(
        [np.bincount(first, share * other[:, axis], len(owner)) for axis in range(3)], axis=1
    )
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Surface(corners, normals.reshape(-1, 3, 3))


def _angles(corners: Array) -> Array:
    """Return the inner angle at each corner, shape (m, 3), rad: the weight of its face."""
    ahead = np.roll(corners, -1, axis=1) - corners
    behind = np.roll(corners, 1, axis=1) - corners
    cosine = (ahead * behind).sum(2)
    lengths = np.linalg.norm(ahead, axis=2) * np.linalg.norm(behind, axis=2)
    return np.arccos(np.clip(cosine / np.maximum(lengths, 1e-300), -1.0, 1.0))
