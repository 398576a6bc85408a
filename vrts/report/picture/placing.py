"""Where everything is that a picture shows: what never moves, and what does."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from vrts.base.pose import Pose
from vrts.geometry.shapes import Piece
from vrts.report.picture.camera import bounds
from vrts.report.picture.raster import Array, Indices
from vrts.report.picture.solids import Color, Solid, by_color, link_solids, surface
from vrts.robots.kinematics.batch import flange_frames, link_frames
from vrts.robots.model import Configuration
from vrts.scene.model import Mobility, Scene


class Fixed(NamedTuple):
    """Pieces of one colour of a body that stays where it is."""

    name: str
    pieces: tuple[Piece, ...]
    color: Color
    X_WO: Pose


class Placed(NamedTuple):
    """Triangles in W with the solids they belong to."""

    corners: Array  # (m, 3, 3) [m]
    normals: Array  # (m, 3, 3)
    solid: Indices  # (m,) index in `solids`
    solids: tuple[Solid, ...]


Parts: TypeAlias = list[tuple[Solid, Array, Array]]  # with rotation and origin in W [m]


def fixed_parts(scene: Scene) -> tuple[Fixed, ...]:
    """Return what stands in a scene whatever a program does; not the floor, which is ground."""
    return tuple(
        Fixed(body.name, pieces, color, body.X_WO)
        for body in scene.bodies
        if body.mobility is Mobility.FIXED and body.kind != "floor"
        for color, pieces in by_color(body)
    )


def place_fixed(parts: Sequence[Fixed]) -> Placed:
    """Return the triangles of what never moves."""
    return _placed(
        [(Solid(p.name, p.name, surface(p.pieces), p.color), *_matrix(p.X_WO)) for p in parts]
    )


def place_moving(
    scene: Scene,
    configuration: Configuration,
    *,
    hand_opening: float,
    poses: Mapping[str, Pose],
) -> Placed:
    """Return the triangles of the robot and of what can be carried."""
    parts: Parts = []
    for body in scene.bodies:
        if body.mobility is Mobility.MOVABLE:
            R, p = _matrix(poses.get(body.name, body.X_WO))
            parts += [
                (Solid(body.name, body.name, surface(pieces), color), R, p)
                for color, pieces in by_color(body)
            ]
    q = np.array([configuration])
    turns, places = link_frames(scene.robot.arm, q)
    hand_turns, hand_places = flange_frames(scene.robot.arm, q)
    turn, place = hand_turns[0], hand_places[0]
    where = [(turns[link.joint, 0], places[link.joint, 0]) for link in scene.robot.arm.links]
    for side in (0, *(finger.side for finger in scene.robot.gripper.fingers)):
        where.append((turn, place + turn @ np.array([0.0, side * hand_opening / 2, 0.0])))
    parts += [(s, R, p) for s, (R, p) in zip(link_solids(scene.robot), where, strict=True)]
    return _placed(parts)


def boxes(part: Placed) -> Array:
    """Return the corners of the boxes round all solids, shape (k, 3), m.

    The triangles of a solid follow one another.
    """
    begins = np.flatnonzero(np.diff(part.solid, prepend=-1))
    if not len(begins):
        return np.empty((0, 3))
    first, second, third = (part.corners[:, k] for k in range(3))
    low = np.minimum.reduceat(np.minimum(np.minimum(first, second), third), begins)
    high = np.maximum.reduceat(np.maximum(np.maximum(first, second), third), begins)
    return bounds(low, high)


def _placed(parts: Parts) -> Placed:
    if not parts:
        return Placed(np.zeros((0, 3, 3)), np.zeros((0, 3, 3)), np.zeros(0, np.int64), ())
    return Placed(
        np.concatenate([solid.surface.corners @ R.T + p for solid, R, p in parts]),
        np.concatenate([solid.surface.normals @ R.T for solid, R, _ in parts]),
        np.repeat(np.arange(len(parts)), [len(solid.surface.corners) for solid, _, _ in parts]),
        tuple(solid for solid, _, _ in parts),
    )


def _matrix(X: Pose) -> tuple[Array, Array]:
    return np.array(X.rotation).reshape(3, 3), np.array(X.translation)
