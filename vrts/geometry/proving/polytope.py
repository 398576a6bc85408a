"""How deep two shapes overlap: a polytope inside their difference, grown to its nearest side.

The difference of A and B is what y - x can be. A hull of some of its points lies inside it, so a
ball round the origin that fits into the hull shows overlap at least that deep; the reach of the
difference along the normal of the hull's nearest face shows overlap at most that deep. The point
farthest in that direction is added until both agree [VanDenBergen2001]_. Where
the origin lies outside, the same steps find a direction in which the shapes are apart.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

from vrts.base.pose import Vector
from vrts.geometry.proving.placed import Support
from vrts.geometry.proving.simplex import Corner, nearest

AXES = tuple(
    (x, y, z)
    for x in (-1.0, 0.0, 1.0)
    for y in (-1.0, 0.0, 1.0)
    for z in (-1.0, 0.0, 1.0)
    if abs(x) + abs(y) + abs(z) in (1.0, 3.0)
)  # ways to the sides and corners of a cube
MOST = 120  # corners
FLAT = 1e-12  # of the size: what is thinner has no inside
THIN = 1e-9  # sine of the angle between two edges of a face
LEVEL = 1e-10  # [m] a corner this little above a face lies in its plane

SIDE = 1e-9  # [m] triangles whose planes differ by less make one side


class Depth(NamedTuple):
    """What is proven of an overlap: lengths are signed distances, below zero is overlap."""

    lower: float  # gap along the normal [m]
    normal: Vector
    upper: float  # at least so deep: below zero or inf [m]
    first: Vector  # deepest point of A in B
    second: Vector  # deepest point of B in A


class _Face(NamedTuple):
    a: int
    b: int
    c: int
    normal: Vector  # outward
    offset: float  # of its plane from the origin [m]

    @property
    def edges(self) -> tuple[tuple[int, int], tuple[int, int], tuple[int, int]]:
        """Its edges, counter-clockwise seen from outside."""
        return (self.a, self.b), (self.b, self.c), (self.c, self.a)

    def under(self, corner: Corner) -> float:
        """How far a corner stands out of its plane [m]."""
        x, y, z = self.normal
        return x * corner.x + y * corner.y + z * corner.z - self.offset


@dataclass(slots=True)
class _Polytope:
    """A convex hull that grows corner by corner."""

    corners: list[Corner]
    faces: dict[tuple[int, int], _Face] = field(default_factory=dict[tuple[int, int], _Face])

    def highest(self, corner: Corner) -> _Face:
        """Return the face out of whose plane a corner stands farthest."""
        return max(self.faces.values(), key=lambda face: face.under(corner))

    def add(self, corner: Corner, top: _Face) -> bool:
        """Take in one more corner; return whether that can be done.

        Args:
            corner: Where the polytope is to reach.
            top: A face that the corner stands out of.
        """
        if top.under(corner) <= LEVEL:
            return False
        # the faces that are seen from there are neighbours of each other, whatever rounding says
        seen, edge = [top], 0
        while edge < len(seen):
            for a, b in seen[edge].edges:
                other = self.faces[b, a]
                if other not in seen and other.under(corner) > LEVEL:
                    seen.append(other)
            edge += 1
        inner = {own for face in seen for own in face.edges}
        number = len(self.corners)
        corners = [*self.corners, corner]
        new = [_face(corners, a, b, number) for a, b in inner if (b, a) not in inner]
        whole = [face for face in new if face is not None]
        if len(whole) < len(new) or len({face.a for face in whole}) < len(whole):
            return False  # thinner than rounding allows
        for own in inner:
            del self.faces[own]
        self.corners = corners
        for face in whole:
            self.put(face)
        return True

    def put(self, face: _Face) -> None:
        """Add a face."""
        for own in face.edges:
            self.faces[own] = face


def _face(corners: Sequence[Corner], a: int, b: int, c: int) -> _Face | None:
    """Return a face, its corners counter-clockwise seen from outside; None where it is thin."""
    p, q, r = corners[a], corners[b], corners[c]
    ux, uy, uz = q.x - p.x, q.y - p.y, q.z - p.z
    vx, vy, vz = r.x - p.x, r.y - p.y, r.z - p.z
    x, y, z = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    length = math.sqrt(x * x + y * y + z * z)
    if length <= THIN * math.sqrt((ux * ux + uy * uy + uz * uz) * (vx * vx + vy * vy + vz * vz)):
        return None
    normal = (x / length, y / length, z / length)
    return _Face(a, b, c, normal, normal[0] * p.x + normal[1] * p.y + normal[2] * p.z)


def depth(
    first: Support, second: Support, known: Iterable[Corner], tight: float, enough: float
) -> Depth | None:
    """Return bounds on the signed distance of two shapes that overlap, touch, or nearly touch.

    Args:
        first: A.
        second: B.
        known: Points of the difference to begin with.
        tight: Bounds this near to each other are near enough [m].
        enough: Overlap shown to be deeper than this signed distance is enough [m].

    Returns:
        The bounds; None where the difference is flat, as that of two flat shapes in one plane.
    """
    start = [*known]
    polytope = _tetrahedron(start) if len(start) == 4 else None
    if polytope is None:
        start += [corner(first, second, way) for way in AXES]
        polytope = _tetrahedron(start)
        if polytope is None:
            return None
        for one in start:
            polytope.add(one, polytope.highest(one))
    best, normal = -math.inf, (0.0, 0.0, 1.0)
    while True:
        face = min(polytope.faces.values(), key=lambda own: own.offset)
        x, y, z = face.normal
        far = corner(first, second, face.normal)
        reach = far.x * x + far.y * y + far.z * z
        if -reach > best:
            best, normal = -reach, (-x, -y, -z)  # the way in which A leaves B
        done = reach - face.offset <= tight or -face.offset < enough
        if done or best > 0.0 or len(polytope.corners) >= MOST:
            break
        if not polytope.add(far, face):
            break
    upper = -face.offset if face.offset >= 0.0 else math.inf
    points = _foot(face, polytope)
    return Depth(best, normal, upper, *points)


def corner(first: Support, second: Support, way: Vector) -> Corner:
    """Return the point of the difference that lies farthest in a direction."""
    x, y, z = way
    a, b = first(-x, -y, -z), second(x, y, z)
    return Corner(b[0] - a[0], b[1] - a[1], b[2] - a[2], a, b)


def _tetrahedron(known: Sequence[Corner]) -> _Polytope | None:
    """Return a first polytope: four corners that lie far from each other."""
    a = known[0]
    b = max(known, key=lambda p: math.dist(p[:3], a[:3]))
    size = math.dist(a[:3], b[:3])
    ux, uy, uz = b.x - a.x, b.y - a.y, b.z - a.z

    def off_line(p: Corner) -> Vector:
        vx, vy, vz = p.x - a.x, p.y - a.y, p.z - a.z
        return (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)

    c = max(known, key=lambda p: math.hypot(*off_line(p)))
    nx, ny, nz = off_line(c)

    def height(p: Corner) -> float:
        return nx * (p.x - a.x) + ny * (p.y - a.y) + nz * (p.z - a.z)

    d = max(known, key=lambda p: abs(height(p)))
    if abs(height(d)) <= FLAT * size**3:
        return None
    if height(d) > 0.0:
        b, c = c, b
    found = _Polytope([a, b, c, d])
    for three in ((0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)):
        face = _face(found.corners, *three)
        if face is None:
            return None
        found.put(face)
    return found


def _foot(lowest: _Face, polytope: _Polytope) -> tuple[Vector, Vector]:
    """Return the points of A and B whose difference is the foot of the origin on a side.

    A flat side is cut into triangles, and the foot lies in one of those that share its plane.
    """
    x, y, z = (lowest.offset * part for part in lowest.normal)
    best, points = math.inf, (lowest.normal, lowest.normal)
    for face in set(polytope.faces.values()):
        if face.offset > lowest.offset + SIDE:
            continue
        three = [polytope.corners[k] for k in (face.a, face.b, face.c)]
        found = nearest([Corner(p.x - x, p.y - y, p.z - z, p.first, p.second) for p in three])
        off = math.hypot(*found.point)
        if off < best:
            best, points = off, found.points
    return points
