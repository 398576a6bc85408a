"""Mesh files as triangles: STL, binary or text, and OBJ. Nothing that a file names is opened."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.units import MM
from vrts.robots.urdf.stl import stl_points
from vrts.scene.meshes.closed import closed
from vrts.scene.meshes.triangles import MeshFault, Triangles

Array: TypeAlias = npt.NDArray[np.float64]

UNITS = {"mm": 1.0, "cm": 10.0, "m": 1.0 / MM, "inch": 25.4}  # [mm]
MOST_BYTES = 16_000_000
MOST_TRIANGLES = 50_000
MOST_CORNERS = 16  # of one polygon of an OBJ file
LONGEST = 2000  # letters of one line of it
FEWER = "save it with fewer triangles: a simulation needs no fillets or threads"


def read_mesh(name: str, data: bytes, unit: str) -> Triangles:
    """Return the surface of a mesh file, in mm.

    Args:
        name: Of the file; what it ends with tells its format.
        data: Its bytes.
        unit: Of its coordinates, one of `UNITS`.

    Raises:
        MeshFault: It is no such file, or no closed surface of a size that is taken.
    """
    ending = name.rpartition(".")[2].lower()
    if len(data) > MOST_BYTES:
        raise MeshFault(f"the mesh has more than {MOST_BYTES:,} bytes", FEWER)
    if ending == "obj":
        corners = _obj(data)
    elif ending == "stl":
        corners = _stl(data)
    else:
        raise MeshFault(f"`.{ending}` is no mesh that vrts reads", "save it as STL or OBJ")
    if len(corners) > MOST_TRIANGLES:
        raise MeshFault(
            f"the mesh has {len(corners):,} triangles; {MOST_TRIANGLES:,} are taken", FEWER
        )
    return closed(corners * UNITS[unit])


def _stl(data: bytes) -> Array:
    if len(data) >= 84:
        count = int.from_bytes(data[80:84], "little")
        if len(data) == 84 + 50 * count and count > MOST_TRIANGLES:
            raise MeshFault(
                f"the mesh has {count:,} triangles; {MOST_TRIANGLES:,} are taken", FEWER
            )
    points = stl_points(data)
    if points is None or len(points) % 3:
        raise MeshFault(
            "this is no STL file, it is cut off, or a corner in it is not a number",
            "save the mesh again as STL",
        )
    return points.reshape(-1, 3, 3)


def _obj(data: bytes) -> Array:
    vertices: list[tuple[float, float, float]] = []
    faces: list[tuple[int, int, int]] = []
    for number, line in enumerate(data.decode("utf-8", "replace").split("\n"), 1):
        if len(line) > LONGEST:
            raise MeshFault(f"line {number} of the mesh is too long", "save the mesh again as OBJ")
        words = line.split()
        if not words:
            continue
        try:
            if words[0] == "v":
                x, y, z = (float(word) for word in words[1:4])
                vertices.append((x, y, z))
            elif words[0] == "f":
                faces += _polygon(words[1:], len(vertices))
        except ValueError as problem:
            raise MeshFault(
                f"line {number} of the mesh cannot be read", "save the mesh again as OBJ"
            ) from problem
        if len(faces) > MOST_TRIANGLES or len(vertices) > 3 * MOST_TRIANGLES:
            raise MeshFault(f"the mesh has more than {MOST_TRIANGLES:,} triangles", FEWER)
    if not faces:
        raise MeshFault("the mesh has no triangle", "save the mesh again as OBJ")
    return np.array(vertices, dtype=np.float64)[np.array(faces)]


def _polygon(words: list[str], known: int) -> list[tuple[int, int, int]]:
    """Return the triangles of a polygon, as a fan. Raises ValueError."""
    if not 3 <= len(words) <= MOST_CORNERS:
        raise ValueError(words)
    corners: list[int] = []
    for word in words:
        number = int(word.partition("/")[0])
        index = number - 1 if number > 0 else known + number
        if number == 0 or not 0 <= index < known:
            raise ValueError(word)
        corners.append(index)
    return [(corners[0], corners[k], corners[k + 1]) for k in range(1, len(corners) - 1)]
