"""Pieces of a mesh: made once, and compared with the mesh whenever a scene is checked."""

import hashlib
import math
from collections.abc import Sequence
from typing import NamedTuple

from vrts.pipeline.pieces.fitting import fitted
from vrts.pipeline.pieces.splitting import check_installed, split
from vrts.scene.meshes.covering import ROUNDING, left_over, stands_out
from vrts.scene.meshes.deviation import deviation, united_volume
from vrts.scene.meshes.mesh_file import read_mesh
from vrts.scene.meshes.pieces_file import (
    MOST_CORNERS,
    MOST_OF_ALL,
    MOST_PIECES,
    Pieces,
)
from vrts.scene.meshes.polytopes import Polytope, polytope
from vrts.scene.meshes.triangles import MeshFault, Triangles

CLOSENESS = 0.05  # concavity of a part, as CoACD measures it; smaller: more pieces, nearer ones
MOST = 32  # pieces
PLACES = 2  # decimals of what is told in mm


class Compared(NamedTuple):
    """Pieces beside their mesh."""

    pieces: Pieces
    same: bool  # whether they were made of these very bytes
    stands_out: float  # the mesh out of the pieces, at most [mm]; 0: proven that it does not
    turned: int  # parts of the mesh that were inside out, and count as if they were not
    shared: bool  # whether solids in the mesh overlap


def made(name: str, data: bytes, unit: str, closeness: float, most: int) -> Pieces:
    """Return convex pieces that hold the whole surface of a mesh.

    Args:
        name: Of the mesh file.
        data: Its bytes.
        unit: Of its coordinates.
        closeness: The concavity that a piece may have, as CoACD measures it.
        most: Pieces at most.

    Raises:
        MeshFault: The mesh cannot be taken, or has no such pieces.
        NoLibrary: What splitting needs is not installed.
    """
    mesh = read_mesh(name, data, unit)
    check_installed()
    parts = split(mesh, closeness, min(most, MOST_PIECES))
    corners = fitted(mesh, parts.parts)
    counts = [len(points) for points in corners]
    if max(counts) > MOST_CORNERS or sum(counts) > MOST_OF_ALL:
        raise MeshFault(
            f"the pieces of the mesh have {sum(counts):,} corners, {max(counts)} in one",
            "save the mesh with fewer triangles, or ask for fewer pieces with `--most`",
        )
    shapes = [polytope(points) for points in corners]
    return Pieces(
        mesh=name.rpartition("/")[2],
        sha256=hashlib.sha256(data).hexdigest(),
        unit=unit,
        library=parts.library,
        closeness=closeness,
        most=most,
        **_measured(mesh, shapes)._asdict(),
        corners=tuple(tuple((x, y, z) for x, y, z in points.tolist()) for points in corners),
    )


def compared(pieces: Pieces, name: str, data: bytes) -> Compared:
    """Return pieces beside the mesh they are said to be made of; nothing in their file is believed.

    Args:
        pieces: As their file says.
        name: Of the mesh file.
        data: Its bytes.

    Raises:
        MeshFault: The mesh cannot be taken.
    """
    mesh = read_mesh(name, data, pieces.unit)
    shapes = pieces.polytopes()
    shreds = left_over(mesh, shapes)
    measured = pieces._replace(**_measured(mesh, shapes)._asdict())
    same = hashlib.sha256(data).hexdigest() == pieces.sha256
    out = max(stands_out(shreds, shapes), ROUNDING) if shreds else 0.0
    return Compared(measured, same, out, mesh.turned, mesh.shared)


class _Measured(NamedTuple):
    """The fields of a pieces file that are measured; see `Pieces`."""

    triangles: int
    mesh_volume: float
    pieces_volume: float
    centre_of_mass: tuple[float, float, float]
    found: float
    at_most: float


def _measured(mesh: Triangles, shapes: Sequence[Polytope]) -> _Measured:
    off = deviation(mesh, shapes)
    x, y, z = (round(value, 4) + 0.0 for value in mesh.centre_of_mass.tolist())
    return _Measured(
        triangles=len(mesh.faces),
        mesh_volume=round(mesh.volume, 1),
        pieces_volume=round(united_volume(shapes), 1),
        centre_of_mass=(x, y, z),
        found=_upward(off.found),
        at_most=_upward(off.at_most),
    )


def _upward(length: float) -> float:
    return math.ceil(length * 10**PLACES) / 10**PLACES
