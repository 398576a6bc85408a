"""Where a released object comes to rest: straight down to first contact, then standing or toppled.

Contacts never push or stop anything else, and nothing bounces, slips or rolls.
"""

import math
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import combinations, pairwise
from typing import NamedTuple

import numpy as np

from vrts.base.pose import (
    Z_AXIS,
    Pose,
    Vector,
    add,
    cross,
    dot,
    multiply,
    rotate,
    rotation_about,
    scale,
    subtract,
    translation,
    transpose,
)
from vrts.base.remembered import is_remembering, remembered
from vrts.engine.hand.resting import Rest, Standing
from vrts.geometry.clipping import Point, common, left
from vrts.geometry.hull import faces
from vrts.geometry.proving.scalar import nearest
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape
from vrts.geometry.support import Bounds, bounds, boxes_of, span
from vrts.scene.outline import contains, hull

TOUCHING = 1e-5  # [m] nearer than this is contact
LEAST_STEP = 1e-6  # [m] of the descent
SIDE_NORMAL = math.sin(math.radians(10.0))  # a flatter contact does not carry
ALIGNS_WITHIN = math.radians(10.0)  # between contact face and support plane
FLUSH = math.cos(math.radians(0.5))  # faces turned less to each other look the same way
LEVEL = 5e-5  # [m] from one plane: faces nearer than this lie in it
FRICTION = 0.5  # coefficient µ of an inclined support [assumed]
LEAST_AREA = 1e-8  # [m^2] that something stands on: nothing stands on a line
ROUNDING = 2e-9  # [m] of corners of a hull
CORNERS = 48  # of a round face
STEPS = 20_000  # of the descent


class Face(NamedTuple):
    """A flat face of a convex piece."""

    normal: Vector  # outward unit vector
    corners: tuple[Vector, ...]  # in order round the face


def settle(
    pieces: Sequence[Piece], X_WO: Pose, centre_of_mass: Vector, others: Sequence[Standing]
) -> Rest | None:
    """Return where a released body comes to rest; None when nothing is below it."""
    contact = _descend(pieces, X_WO, others)
    if contact is None:
        return None
    height, standing, mine, theirs = contact
    X_touch = translation(0.0, 0.0, -height) @ X_WO
    bottom = _face_along(mine, X_touch, scale(Z_AXIS, -1.0))
    top = _face_along(theirs, standing.X_WO, Z_AXIS)
    X_rest, normal = X_touch, Z_AXIS  # on edges or corners, if it stands at all: it is not turned
    if bottom is not None and top is not None and _carries(bottom, top):
        X_rest, normal = _aligned(X_touch, bottom, top), top.normal
    touched = _contacts(pieces, X_rest, others, normal)
    met = hull([point for of_one in touched.values() for point in of_one])
    mass = X_rest.apply(centre_of_mass)
    stands = _area(met) > LEAST_AREA and contains(met, (mass[0], mass[1]), slack=ROUNDING)
    also = tuple(name for name in touched if name != standing.name)
    return Rest(height, standing.name, X_rest if stands else X_touch, stands, also)


def _descend(
    pieces: Sequence[Piece], X_WO: Pose, others: Sequence[Standing]
) -> tuple[float, Standing, Piece, Piece] | None:
    """Return height, support and the two pieces of first contact straight down.

    Two pieces are as far apart as the widest gap over all directions, which `normal` points along.
    On the way down a gap closes at the rate at which its direction points down. So pieces do not
    meet before their widest gap is closed at its own rate, and where it is to the side it stays the
    widest, for steeper ones close faster: such pieces are passed by for good.
    """
    if not is_remembering():
        return _descended(pieces, X_WO, others)
    beneath = tuple((each.name, id(each.pieces), each.X_WO) for each in others)
    alive = (pieces, tuple(each.pieces for each in others))
    key = ("descend", id(pieces), X_WO, beneath)
    return remembered(key, lambda: _descended(pieces, X_WO, others), alive=alive)


def _descended(
    pieces: Sequence[Piece], X_WO: Pose, others: Sequence[Standing]
) -> tuple[float, Standing, Piece, Piece] | None:
    mine = bounds(pieces, X_WO)
    below = [(standing, piece) for standing in others for piece in _under(mine, standing)]
    if not below:
        return None
    pairs = [(piece, theirs, standing) for standing, theirs in below for piece in pieces]
    height = 0.0
    for _ in range(STEPS):
        X_low = translation(0.0, 0.0, -height) @ X_WO
        step = math.inf
        ahead: list[tuple[Piece, Piece, Standing]] = []
        for pair in pairs:
            piece, theirs, standing = pair
            found = nearest(piece, X_low, theirs, standing.X_WO)
            if found.lower < -TOUCHING:  # as deep to the side as upward it falls past
                X_lower = translation(0.0, 0.0, -TOUCHING) @ X_low
                found = nearest(piece, X_lower, theirs, standing.X_WO)
            upright = -found.normal[2]  # the second body lies below the first
            if upright <= SIDE_NORMAL:
                continue
            if found.lower <= TOUCHING:
                return height, standing, piece, theirs
            ahead.append(pair)
            step = min(step, found.lower / upright)
        if not ahead:
            return None
        pairs = ahead
        height += max(step, LEAST_STEP)
    return None


def _under(mine: Bounds, standing: Standing) -> list[Piece]:
    """Return the pieces that can be met by something in a box on its way straight down."""
    (ax, ay, _), (bx, by, bz) = mine
    return [  # most are elsewhere
        piece
        for piece, ((x0, y0, z0), (x1, y1, _)) in zip(
            standing.pieces, boxes_of(standing.pieces, standing.X_WO), strict=True
        )
        if ax < x1 and x0 < bx and ay < y1 and y0 < by and z0 < bz
    ]


def _carries(bottom: Face, top: Face) -> bool:
    incline = math.acos(max(-1.0, min(1.0, top.normal[2])))
    if math.tan(incline) > FRICTION:
        return False
    return -dot(bottom.normal, top.normal) >= math.cos(ALIGNS_WITHIN)


def _contacts(
    pieces: Sequence[Piece], X_WO: Pose, others: Sequence[Standing], normal: Vector
) -> dict[str, list[Point]]:
    """Return points of each body, seen from above, whose hull is what something stands on.

    It may stand on several pieces of a body, on several bodies, at several heights, and on edges
    and corners; all contacts look along one normal.
    """
    down = scale(normal, -1.0)
    mine = [(-height, part) for piece in pieces for height, part in _ends(piece, X_WO, down)]
    box = bounds(pieces, X_WO)
    found: dict[str, list[Point]] = {}
    for standing in others:
        for piece in _under(box, standing):
            for height, theirs in _ends(piece, standing.X_WO, normal):
                for own, part in mine:
                    if abs(own - height) <= LEVEL:
                        points = common(part, theirs)
                        if points:
                            found.setdefault(standing.name, []).extend(points)
    return found


def _ends(piece: Piece, X_WO: Pose, normal: Vector) -> list[tuple[float, list[Point]]]:
    """Return what of a piece is farthest along a normal, and how far, seen from above.

    That is a face, or several that are nearly one, or an edge or a corner.
    """
    X_WP = X_WO @ piece.X_OP
    far = span(piece.shape, rotate(transpose(X_WP.rotation), normal))[1]
    far += dot(X_WP.translation, normal)
    flat: list[tuple[Vector, ...]] = []
    for face in _faces(piece.shape):
        if dot(rotate(X_WP.rotation, face.normal), normal) < FLUSH:
            continue
        corners = tuple(X_WP.apply(corner) for corner in face.corners)
        if all(dot(corner, normal) >= far - LEVEL for corner in corners):
            flat.append(corners)
    return [(far, _flat(corners)) for corners in flat or [_edge(piece.shape, X_WP, normal, far)]]


def _edge(shape: Shape, X_WP: Pose, normal: Vector, far: float) -> tuple[Vector, ...]:
    """Return the edge or the corner of a shape that is farthest along a normal."""
    points: Iterable[Vector]
    match shape:
        case Box() | Hull():
            points = sorted({corner for face in _faces(shape) for corner in face.corners})
        case Cylinder(radius=radius, half_length=half_length):
            x, y, _ = rotate(transpose(X_WP.rotation), normal)
            out = math.hypot(x, y)
            rim = (radius * x / out, radius * y / out) if out > 0.0 else (0.0, 0.0)
            points = [(*rim, side * half_length) for side in (-1.0, 1.0)]
    placed = [X_WP.apply(point) for point in points]
    ends = [point for point in placed if dot(point, normal) >= far - LEVEL]
    if len(ends) < 3:
        return tuple(ends)
    return max(combinations(ends, 2), key=lambda pair: math.dist(*pair))


def _aligned(X_WO: Pose, bottom: Face, top: Face) -> Pose:
    """Return the pose turned least to make the faces parallel, and shifted to let them meet."""
    target = scale(top.normal, -1.0)
    axis = cross(bottom.normal, target)
    size = math.sqrt(dot(axis, axis))
    pivot = min(bottom.corners, key=lambda corner: corner[2])
    turned = X_WO
    if size > 1e-12:
        turn = rotation_about(scale(axis, 1.0 / size), math.atan2(size, dot(bottom.normal, target)))
        moved = add(rotate(turn, subtract(X_WO.translation, pivot)), pivot)
        turned = Pose(multiply(turn, X_WO.rotation), moved)
    gap = dot(subtract(pivot, top.corners[0]), top.normal) / top.normal[2]
    return translation(0.0, 0.0, -gap) @ turned


def _face_along(piece: Piece, X_WO: Pose, direction: Vector) -> Face | None:
    """Return the face of a piece that looks most along a direction, in W."""
    X_WP = X_WO @ piece.X_OP
    best = max(
        _faces(piece.shape), key=lambda face: dot(rotate(X_WP.rotation, face.normal), direction)
    )
    normal = rotate(X_WP.rotation, best.normal)
    if dot(normal, direction) <= 0.0:
        return None
    return Face(normal, tuple(X_WP.apply(corner) for corner in best.corners))


@lru_cache(maxsize=256)
def _faces(shape: Shape) -> tuple[Face, ...]:
    """Return the flat faces of a shape in its own frame."""
    match shape:
        case Box(half_extents=(a, b, c)):
            found: list[Face] = []
            for axis in range(3):
                for side in (-1.0, 1.0):
                    normal = [0.0, 0.0, 0.0]
                    normal[axis] = side
                    i, k = (axis + 1) % 3, (axis + 2) % 3
                    half = (a, b, c)
                    corners: list[Vector] = []
                    for u, v in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                        point = [0.0, 0.0, 0.0]
                        point[axis] = side * half[axis]
                        point[i], point[k] = u * half[i], v * half[k]
                        corners.append((point[0], point[1], point[2]))
                    found.append(Face((normal[0], normal[1], normal[2]), tuple(corners)))
            return tuple(found)
        case Cylinder(radius=radius, half_length=half_length):
            ring = [math.tau * k / CORNERS for k in range(CORNERS)]
            return tuple(
                Face(
                    (0.0, 0.0, side),
                    tuple(
                        (radius * math.cos(a), radius * math.sin(a), side * half_length)
                        for a in ring
                    ),
                )
                for side in (-1.0, 1.0)
            )
        case Hull(points=points):
            return _hull_faces(points)


def _hull_faces(points: Sequence[Vector]) -> tuple[Face, ...]:
    whole = faces(np.array(points))
    corners: list[Vector] = [(x, y, z) for x, y, z in whole.vertices.tolist()]
    found: list[Face] = []
    for polygon in whole.polygons:
        ring = tuple(corners[index] for index in polygon)
        normal = cross(subtract(ring[1], ring[0]), subtract(ring[2], ring[1]))
        found.append(Face(scale(normal, 1.0 / math.sqrt(dot(normal, normal))), ring))
    return tuple(found)


def _flat(corners: Sequence[Vector]) -> list[Point]:
    """Return a face seen from above, counter-clockwise."""
    points = [(x, y) for x, y, _ in corners]
    area = sum(
        a[0] * b[1] - b[0] * a[1] for a, b in zip(points, points[1:] + points[:1], strict=True)
    )
    return points if area >= 0.0 else points[::-1]


def _area(polygon: Sequence[Point]) -> float:
    """Return the area of a convex polygon [m^2]."""
    spokes = pairwise(polygon[1:])
    return sum(left(polygon[0], a, b) for a, b in spokes) / 2.0
