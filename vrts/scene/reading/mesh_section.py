"""Reads an object of a scene file that a mesh describes: its pieces, the way up, where it is held.

The pieces that were made of the mesh stand in a file beside it: runs go by these. The mesh need not
be there; where it is, it must be the one that they were made of.
"""

import hashlib
import math
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.oat import rotation_from_oat
from vrts.base.pose import IDENTITY, Pose, Vector
from vrts.base.toml.reading import Table
from vrts.base.units import MM
from vrts.geometry.shapes import Hull, Piece
from vrts.scene.meshes.mesh_file import MOST_BYTES as MOST_OF_MESH
from vrts.scene.meshes.mesh_file import UNITS
from vrts.scene.meshes.pieces_file import MOST_BYTES, Pieces, PiecesFault, read_pieces
from vrts.scene.reading.files import PIECES, FileFault, SceneFolder
from vrts.scene.things.forms import Form

NO_PIECES = Rule("V899", "no-pieces")
INVALID_PIECES = Rule("V909", "invalid-pieces")
CHANGED = Rule("V910", "mesh-changed")

FARTHEST = 10_000.0  # [mm] of a grip from the middle of the underside

# rows of the rotation from the mesh's frame to one in which the named axis points up
WAYS_UP: dict[str, tuple[Vector, Vector, Vector]] = {
    "z": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "-z": ((1, 0, 0), (0, -1, 0), (0, 0, -1)),
    "x": ((0, 1, 0), (0, 0, 1), (1, 0, 0)),
    "-x": ((0, 0, 1), (0, 1, 0), (-1, 0, 0)),
    "y": ((0, 0, 1), (1, 0, 0), (0, 1, 0)),
    "-y": ((1, 0, 0), (0, 0, 1), (0, -1, 0)),
}


class MeshKeys(NamedTuple):
    """What a section says of a mesh."""

    file: str
    unit: str
    pieces: str  # name of the pieces file
    up: str
    grip: Pose | None  # X_OP of the pads


def read_mesh_keys(section: Table) -> MeshKeys | None:
    """Return what a section says of its mesh; None after saying what is wrong."""
    before = len(section.problems.found)
    file = section.string("file", required=True)
    unit = section.string("unit", choices=UNITS, required=True)
    up = section.string("up", "z", choices=WAYS_UP)
    pieces = section.string("pieces", f"{file}{PIECES}")
    grip = section.table("grip")
    held = None if grip is None else _grip(grip)
    if file is None or unit is None or len(section.problems.found) > before:
        return None
    return MeshKeys(file, unit, pieces, up, held)


def read_mesh(section: Table, folder: SceneFolder) -> Form | None:
    """Return the form of a mesh's pieces; None after saying what is wrong."""
    keys = read_mesh_keys(section)
    if keys is None:
        return None
    pieces = _pieces(section, folder, keys)
    return None if pieces is None else mesh_form(pieces, keys)


def mesh_form(pieces: Pieces, keys: MeshKeys) -> Form:
    """Return the form of pieces, O in the middle of the box round them, on its underside."""
    rows = WAYS_UP[keys.up]
    turned = [[_turned(rows, point) for point in points] for points in pieces.corners]
    flat = [point for points in turned for point in points]
    low, high = ([edge(each[k] for each in flat) for k in range(3)] for edge in (min, max))
    foot = ((low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0, low[2])
    shapes = tuple(
        Piece(Hull(tuple(_moved(point, foot) for point in points)), IDENTITY) for points in turned
    )
    mass = _moved(_turned(rows, pieces.centre_of_mass), foot)
    grips = () if keys.grip is None else (keys.grip,)
    return Form(shapes, mass, None, (high[2] - low[2]) * MM, grips=grips)


def _pieces(section: Table, folder: SceneFolder, keys: MeshKeys) -> Pieces | None:
    key = "pieces" if "pieces" in section else "file"
    problems = section.problems
    try:
        data = folder.read(keys.pieces, MOST_BYTES)
    except FileFault as fault:
        problems.error(
            NO_PIECES,
            f"{section.title} has no convex pieces yet: `{keys.pieces}` is not there",
            section.value_span(key),
            str(fault),
            help=("make them of the mesh: `vrts scene check SCENE --write`",),
            data={"file": keys.pieces},
        )
        return None
    try:
        pieces = read_pieces(data)
        if pieces.unit != keys.unit:
            raise PiecesFault(f"the mesh was read in {pieces.unit}, the scene says {keys.unit}")
        if pieces.mesh != keys.file.rpartition("/")[2]:
            raise PiecesFault(f"it was made of `{pieces.mesh}`")
    except PiecesFault as fault:
        problems.error(
            INVALID_PIECES,
            f"the pieces of {section.title} in `{keys.pieces}` cannot be taken",
            section.value_span(key),
            str(fault),
            help=("make them again: `vrts scene check SCENE --write`",),
            data={"file": keys.pieces},
        )
        return None
    mesh = folder.beside(keys.file, MOST_OF_MESH)
    if mesh is not None and hashlib.sha256(mesh).hexdigest() != pieces.sha256:
        tell_changed(section, keys.file)
        return None
    return pieces


def tell_changed(section: Table, file: str) -> None:
    """Say that a mesh is another one than its pieces were made of."""
    section.problems.error(
        CHANGED,
        f"`{file}` is another mesh than the one its pieces were made of",
        section.value_span("file"),
        help=("make them again: `vrts scene check SCENE --write`",),
        data={"file": file},
    )


def _grip(section: Table) -> Pose | None:
    at = section.numbers("at_mm", count=3, minimum=-FARTHEST, maximum=FARTHEST, required=True)
    turn = section.number("turn_deg", 90.0, minimum=-360.0, maximum=360.0)
    section.finish()
    if at is None:
        return None
    x, y, z = at
    return Pose(rotation_from_oat(turn, 90.0, 0.0), (x * MM, y * MM, z * MM))


def _turned(rows: tuple[Vector, Vector, Vector], point: Vector) -> Vector:
    x, y, z = (math.fsum(a * b for a, b in zip(row, point, strict=True)) for row in rows)
    return (x, y, z)


def _moved(point: Vector, foot: Vector) -> Vector:
    """Return a point seen from the foot, in m, without the last digits that subtraction leaves."""
    x, y, z = (round((a - b) * MM, 9) + 0.0 for a, b in zip(point, foot, strict=True))
    return (x, y, z)
