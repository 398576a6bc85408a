"""Which turns of a thing nobody can tell from not turning it, found from its pieces.

A turn counts when every piece, with its colour, comes to lie where a piece of the same shape was;
pieces inside others are not looked at. A brick has two or four such turns about the vertical, a can
any, and both may stand upside down. None that counts changes anything; where pieces overlap in a
way that makes a whole more regular than they are, some may be missed.
"""

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import NamedTuple, TypeAlias

from vrts.base.pose import (
    IDENTITY,
    Pose,
    Rotation,
    Vector,
    add,
    cross,
    distance,
    dot,
    multiply,
    rotate,
    rotation_angle,
    scale,
    subtract,
    transpose,
)
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.geometry.support import bounds
from vrts.scene.colors import Color
from vrts.scene.model import Body

SAME = 1e-4  # [m] nearer than this, two places or lengths are one: a brick of 80 x 80.05 is square
SAME_TURN = 1e-2  # [rad] nearer than this, two turns are one
ROUND = 16  # a thing that so many turns about a line leave as it is counts as round


class Symmetries(NamedTuple):
    """Turns of a thing after which it covers the same space, in its frame O."""

    turns: tuple[
        Pose, ...
    ]  # X_OO of each, the first one none; with an axis, each up to turns on it
    axis: Vector | None  # direction of the line that any turn about leaves the thing as it is
    foot: Vector  # the point of that line that is nearest to O's origin [m]; else the origin

    def upright(self) -> "Symmetries":
        """Return those after which the thing is as upright as before."""
        kept = tuple(turn for turn in self.turns if turn.approach[2] > math.cos(SAME_TURN))
        upright = self.axis is not None and abs(self.axis[2]) > math.cos(SAME_TURN)
        return Symmetries(kept, self.axis if upright else None, self.foot)


NONE = Symmetries((IDENTITY,), None, IDENTITY.translation)


class _Part(NamedTuple):
    """A piece as points that any turn of the thing takes along."""

    kind: str
    points: tuple[Vector, ...]  # corners, or the two ends of a cylinder's axis, from the centre
    radius: float  # of a cylinder [m]
    color: Color


_Marked: TypeAlias = tuple[int, Vector]  # number of the part, and one of its points


def symmetries_of(body: Body) -> Symmetries:
    """Return the symmetries of a body; colours of its pieces count.

    A mesh counts as having none: where it was split says nothing of what it is.
    """
    if body.kind == "mesh":
        return NONE
    colors = tuple(color for _, color in body.painted)
    return symmetries(body.pieces, colors, body.symmetry_axis)


@lru_cache(maxsize=256)
def symmetries(
    pieces: tuple[Piece, ...], colors: tuple[Color, ...], axis: Vector | None = None
) -> Symmetries:
    """Return the symmetries of a union of convex pieces.

    Args:
        pieces: In O.
        colors: Of each.
        axis: Direction through O's origin that the thing is said to be round about; None: not said.
    """
    seen = _not_inside(tuple(zip(pieces, colors, strict=True)))
    centre = _middle([_middle(_points(piece)) for piece, _ in seen])
    parts = [_part(piece, color, centre) for piece, color in seen]
    line = axis or _common_line(parts)
    if line is not None:
        return _about_line(parts, centre, line)
    found = _finite(parts)
    line = _round_about(found)
    if line is not None:
        return _about_line(parts, centre, line, found)
    return Symmetries(tuple(_about(centre, turn) for turn in found), None, IDENTITY.translation)


def _about_line(
    parts: Sequence[_Part], centre: Vector, line: Vector, known: Sequence[Rotation] = ()
) -> Symmetries:
    """Return the symmetries of what is round about a line through its centre."""
    foot = subtract(centre, scale(line, dot(centre, line)))
    if math.hypot(*foot) < SAME:
        foot = IDENTITY.translation
    turns = [IDENTITY]
    if _common_line(parts) is not None:
        over = _half_turn(_across(line))
        upside_down = [over] if _maps(parts, over) else []
    else:
        upside_down = [t for t in known or _finite(parts) if dot(rotate(t, line), line) < 0.0]
    turns += [_about(centre, turn) for turn in upside_down[:1]]
    return Symmetries(tuple(turns), line, foot)


def _finite(parts: Sequence[_Part]) -> tuple[Rotation, ...]:
    """Return every turn about the centre that takes parts to parts, the first one none.

    A turn is known by where it takes two points that are not in line with the centre.
    """
    marked = [(n, point) for n, part in enumerate(parts) for point in part.points]
    first = min(
        (each for each in marked if math.hypot(*each[1]) > SAME),
        key=lambda each: len(_like(parts, marked, each)),
        default=None,
    )
    if first is None:
        return (IDENTITY.rotation,)
    aside = [m for m in marked if math.hypot(*cross(first[1], m[1])) > SAME * math.hypot(*m[1])]
    if not aside:
        return (IDENTITY.rotation,)
    second = min(aside, key=lambda each: len(_like(parts, marked, each)))
    apart = distance(first[1], second[1])
    found = [IDENTITY.rotation]
    start = transpose(_frame(first[1], second[1]))
    for _, a in _like(parts, marked, first):
        for _, b in _like(parts, marked, second):
            if abs(distance(a, b) - apart) > 2 * SAME or math.hypot(*cross(a, b)) < SAME**2:
                continue
            turn = multiply(_frame(a, b), start)
            if all(rotation_angle(turn, other) > SAME_TURN for other in found) and _maps(
                parts, turn
            ):
                found.append(turn)
    return tuple(found)


def _like(parts: Sequence[_Part], marked: Sequence[_Marked], one: _Marked) -> list[_Marked]:
    """Return the points that a turn could take a point to."""
    part, length = parts[one[0]], math.hypot(*one[1])
    return [
        (n, point)
        for n, point in marked
        if abs(math.hypot(*point) - length) <= SAME and _alike(parts[n], part)
    ]


def _alike(one: _Part, other: _Part) -> bool:
    return (one.kind, one.color, len(one.points)) == (
        other.kind,
        other.color,
        len(other.points),
    ) and abs(one.radius - other.radius) <= SAME


def _maps(parts: Sequence[_Part], turn: Rotation) -> bool:
    """Return whether a turn about the centre takes every part to a part, no two to one."""
    free = list(parts)
    for part in parts:
        moved = part._replace(points=tuple(rotate(turn, point) for point in part.points))
        there = next((n for n, other in enumerate(free) if _covers(moved, other)), None)
        if there is None:
            return False
        free.pop(there)
    return True


def _covers(moved: _Part, other: _Part) -> bool:
    return _alike(moved, other) and all(
        any(distance(a, b) <= SAME for b in other.points) for a in moved.points
    )


def _round_about(turns: Sequence[Rotation]) -> Vector | None:
    """Return the line about which there are so many turns that the thing counts as round."""
    lines: list[tuple[Vector, int]] = []
    for axis in filter(None, map(_line_of, turns)):
        for n, (line, count) in enumerate(lines):
            if abs(dot(line, axis)) > math.cos(SAME_TURN):
                lines[n] = (line, count + 1)
                break
        else:
            lines.append((axis, 1))
    line, count = max(lines, key=lambda each: each[1], default=(None, 0))
    return line if count + 1 >= ROUND else None


def _line_of(turn: Rotation) -> Vector | None:
    """Return the direction that a turn leaves as it is; None for no turn and for half turns."""
    along = (turn[7] - turn[5], turn[2] - turn[6], turn[3] - turn[1])
    length = math.hypot(*along)
    return None if length < SAME_TURN else scale(along, 1.0 / length)


def _common_line(parts: Sequence[_Part]) -> Vector | None:
    """Return the direction of the line that all parts are round about; None: there is none."""
    if any(part.kind != "cylinder" for part in parts):
        return None
    start, end = parts[0].points
    along = subtract(end, start)
    line = scale(along, 1.0 / math.hypot(*along))
    points = (point for part in parts for point in part.points)
    return line if all(math.hypot(*cross(point, line)) <= SAME for point in points) else None


def _not_inside(pieces: Sequence[tuple[Piece, Color]]) -> list[tuple[Piece, Color]]:
    """Return the pieces that are not inside another one; of two that are one, the first."""
    kept: list[tuple[Piece, Color]] = []
    for n, (piece, color) in enumerate(pieces):
        if not any(
            _is_inside(piece, other) and (m < n or not _is_inside(other, piece))
            for m, (other, _) in enumerate(pieces)
            if m != n
        ):
            kept.append((piece, color))
    return kept


def _is_inside(piece: Piece, other: Piece) -> bool:
    """Return whether a piece is inside a box or a cylinder; of hulls it is not asked."""
    X_QP = other.X_OP.inverse() @ piece.X_OP
    (ax, ay, az), (bx, by, bz) = bounds((piece._replace(X_OP=X_QP),), IDENTITY)
    match other.shape:
        case Box(half_extents=(a, b, c)):
            return max(bx - a, -ax - a, by - b, -ay - b, bz - c, -az - c) <= 0.0
        case Cylinder(radius=radius, half_length=half_length):
            if max(bz, -az) > half_length:
                return False
            points = _points(piece._replace(X_OP=X_QP))
            width = 0.0
            if isinstance(piece.shape, Cylinder):
                width = piece.shape.radius
                if abs(X_QP.approach[2]) < math.cos(SAME_TURN):
                    return False
            return all(math.hypot(x, y) + width <= radius for x, y, _ in points)
        case Hull():
            return False


def _part(piece: Piece, color: Color, centre: Vector) -> _Part:
    points = tuple(subtract(point, centre) for point in _points(piece))
    match piece.shape:
        case Cylinder(radius=radius):
            return _Part("cylinder", points, radius, color)
        case Box() | Hull():
            return _Part("corners", points, 0.0, color)


def _points(piece: Piece) -> tuple[Vector, ...]:
    """Return corners, or the ends of a cylinder's axis, in O."""
    match piece.shape:
        case Box(half_extents=(a, b, c)):
            corners = [(x, y, z) for x in (-a, a) for y in (-b, b) for z in (-c, c)]
        case Cylinder(half_length=half_length):
            corners = [(0.0, 0.0, -half_length), (0.0, 0.0, half_length)]
        case Hull(points=points):
            corners = list(_apart(points))
    return tuple(piece.X_OP.apply(corner) for corner in corners)


def _apart(points: Sequence[Vector]) -> Iterator[Vector]:
    """Yield points, those that are one only once."""
    taken: list[Vector] = []
    for point in points:
        if all(distance(point, other) > SAME for other in taken):
            taken.append(point)
            yield point


def _middle(points: Sequence[Vector]) -> Vector:
    x, y, z = (math.fsum(values) / len(points) for values in zip(*points, strict=True))
    return (x, y, z)


def _frame(first: Vector, second: Vector) -> Rotation:
    """Return the axes that two directions span: x along the first."""
    x = scale(first, 1.0 / math.hypot(*first))
    z = cross(x, second)
    z = scale(z, 1.0 / math.hypot(*z))
    y = cross(z, x)
    return (x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2])


def _across(line: Vector) -> Vector:
    """Return a direction of length 1 at right angles to another."""
    x, y, z = line
    side = (0.0, z, -y) if abs(x) < 0.5 else (-z, 0.0, x)
    return scale(side, 1.0 / math.hypot(*side))


def _half_turn(axis: Vector) -> Rotation:
    x, y, z = axis
    return (
        *(2 * x * x - 1, 2 * x * y, 2 * x * z),
        *(2 * y * x, 2 * y * y - 1, 2 * y * z),
        *(2 * z * x, 2 * z * y, 2 * z * z - 1),
    )


def _about(centre: Vector, turn: Rotation) -> Pose:
    """Return X_OO of a turn about a point."""
    if turn == IDENTITY.rotation:
        return IDENTITY
    return Pose(turn, add(centre, scale(rotate(turn, centre), -1.0)))
