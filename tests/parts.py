"""Parts as meshes, for tests: prisms over polygons, as STL, with convex pieces by hand."""

import struct

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.closed import closed
from vrts.scene.meshes.pieces_file import Pieces, pieces_text
from vrts.scene.meshes.triangles import Triangles

Point = tuple[float, float, float]

U_SHAPE = ((0, 0), (120, 0), (120, 60), (100, 60), (100, 20), (20, 20), (20, 60), (0, 60))  # [mm]
U_FACES = ((0, 1, 4), (1, 2, 3), (1, 3, 4), (0, 4, 5), (0, 5, 6), (0, 6, 7))
U_PIECES = ((0, 0, 120, 20), (0, 20, 20, 60), (100, 20, 120, 60))  # x, y to x, y
HEIGHT = 80.0  # [mm]


def u_shape() -> npt.NDArray[np.float64]:
    """Return the corners of the triangles of a U that is extruded along z, shape (28, 3, 3), mm."""
    count = len(U_SHAPE)
    points = np.array([(x, y, z) for z in (0.0, HEIGHT) for x, y in U_SHAPE])
    faces = [(c, b, a) for a, b, c in U_FACES]
    faces += [(a + count, b + count, c + count) for a, b, c in U_FACES]
    for here in range(count):
        there = (here + 1) % count
        faces += [(here, there, there + count), (here, there + count, here + count)]
    return points[np.array(faces)]


def u_mesh() -> Triangles:
    """Return the same as a closed surface."""
    return closed(u_shape())


def stl(corners: npt.NDArray[np.float64]) -> bytes:
    """Return triangles as a binary STL file."""
    rows = [struct.pack("<12fH", 0, 0, 0, *each.reshape(-1).tolist(), 0) for each in corners]
    return bytes(80) + struct.pack("<I", len(rows)) + b"".join(rows)


def text_stl(corners: npt.NDArray[np.float64]) -> bytes:
    """Return triangles as a text STL file."""
    lines = ["solid part"]
    for each in corners:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += [f"vertex {x} {y} {z}" for x, y, z in each.tolist()]
        lines += ["endloop", "endfacet"]
    return "\n".join([*lines, "endsolid part", ""]).encode()


def obj(corners: npt.NDArray[np.float64]) -> bytes:
    """Return triangles as an OBJ file that names materials in a file elsewhere."""
    lines = ["mtllib ../../etc/passwd", "usemtl steel"]
    for each in corners:
        lines += [f"v {x} {y} {z}" for x, y, z in each.tolist()]
        lines += ["f -3//1 -2//1 -1//1"]
    return "\n".join([*lines, ""]).encode()


def block(x: float, y: float, x2: float, y2: float, more: float = 0.001) -> tuple[Point, ...]:
    """Return the corners of a block as high as the U, a little larger than asked for [mm]."""
    return tuple(
        (a, b, c)
        for a in (x - more, x2 + more)
        for b in (y - more, y2 + more)
        for c in (-more, HEIGHT + more)
    )


def u_pieces(mesh: str = "cradle.stl", unit: str = "mm", sha256: str = "") -> bytes:
    """Return a file of the three blocks that a U is made of."""
    return pieces_text(
        Pieces(
            mesh=mesh,
            sha256=sha256,
            unit=unit,
            library="by hand",
            closeness=0.05,
            most=32,
            triangles=28,
            mesh_volume=320_000.0,
            pieces_volume=320_000.0,
            centre_of_mass=(60.0, 22.0, 40.0),
            found=0.01,
            at_most=0.01,
            corners=tuple(block(*each) for each in U_PIECES),
        )
    ).encode()
