"""The file of convex pieces that stands for a mesh in runs, hashes and evidence.

JSON, in millimetres and in the frame of the mesh, so that the unit and the way up stay what the
scene says. Runs read this file alone and never the mesh.
"""

import json
from typing import NamedTuple, TypeAlias, cast

import numpy as np
import numpy.typing as npt

from vrts.scene.meshes.polytopes import Polytope, polytope
from vrts.scene.meshes.triangles import LARGEST

Array: TypeAlias = npt.NDArray[np.float64]

FORMAT = "vrts pieces 1"
MOST_BYTES = 1_000_000
MOST_PIECES = 64
MOST_CORNERS = 400  # of one piece
MOST_OF_ALL = 6000
LONGEST = 200  # letters of a text in the file

_NUMBERS = ("mesh_volume_mm3", "pieces_volume_mm3", "found_mm", "at_most_mm", "closeness")


class PiecesFault(Exception):  # noqa: N818 -- names what it is
    """A text that is no pieces file, and where."""


class Pieces(NamedTuple):
    """What a pieces file says."""

    mesh: str  # name of the mesh file
    sha256: str  # of its bytes
    unit: str  # in which the mesh was read
    library: str  # that split it, with its version
    closeness: float  # asked of the library: its measure of concavity
    most: int  # pieces asked for at most
    triangles: int  # of the mesh
    mesh_volume: float  # [mm^3]
    pieces_volume: float  # of the union, measured [mm^3]
    centre_of_mass: tuple[float, float, float]  # of the mesh as one density [mm]
    found: float  # how far pieces were seen to stand out of the mesh [mm]
    at_most: float  # how far they stand out at most, proven [mm]
    corners: tuple[tuple[tuple[float, float, float], ...], ...]  # of each piece [mm]

    def polytopes(self) -> tuple[Polytope, ...]:
        """Return the pieces with their planes. Raises ValueError when one is flat, or nearly."""
        return tuple(polytope(np.array(points, dtype=np.float64)) for points in self.corners)


def pieces_text(pieces: Pieces) -> str:
    """Return the text of a pieces file: the same pieces, the same text."""
    head = {
        "format": FORMAT,
        "mesh": pieces.mesh,
        "sha256": pieces.sha256,
        "unit": pieces.unit,
        "library": pieces.library,
        "closeness": pieces.closeness,
        "most": pieces.most,
        "triangles": pieces.triangles,
        "mesh_volume_mm3": pieces.mesh_volume,
        "pieces_volume_mm3": pieces.pieces_volume,
        "centre_of_mass_mm": pieces.centre_of_mass,
        "found_mm": pieces.found,
        "at_most_mm": pieces.at_most,
    }
    lines = [f"  {json.dumps(key)}: {json.dumps(value)}," for key, value in head.items()]
    rows = [f"    {json.dumps(points)}" for points in pieces.corners]
    return "\n".join(["{", *lines, '  "pieces_mm": [', ",\n".join(rows), "  ]", "}"]) + "\n"


def read_pieces(data: bytes) -> Pieces:
    """Return what a pieces file says.

    Raises:
        PiecesFault: It is no such file, or a piece in it is not convex and solid.
    """
    fields = _fields(data)
    if fields.get("format") != FORMAT:
        raise PiecesFault(f"`format` is not `{FORMAT}`")
    texts = {key: _text(fields, key) for key in ("mesh", "sha256", "unit", "library")}
    numbers = {key: _number(fields.get(key), key) for key in _NUMBERS}
    most, triangles = (int(_number(fields.get(key), key)) for key in ("most", "triangles"))
    found = Pieces(
        **texts,
        closeness=numbers["closeness"],
        most=most,
        triangles=triangles,
        mesh_volume=numbers["mesh_volume_mm3"],
        pieces_volume=numbers["pieces_volume_mm3"],
        centre_of_mass=_point(fields.get("centre_of_mass_mm"), "centre_of_mass_mm"),
        found=numbers["found_mm"],
        at_most=numbers["at_most_mm"],
        corners=_corners(fields.get("pieces_mm")),
    )
    try:
        found.polytopes()
    except ValueError as flat:
        raise PiecesFault("one of the pieces is flat, or its faces are not sure") from flat
    return found


def _fields(data: bytes) -> dict[str, object]:
    try:
        fields: object = json.loads(data)
    except (ValueError, RecursionError) as refusal:
        raise PiecesFault("it is not JSON") from refusal
    if not isinstance(fields, dict):
        raise PiecesFault("it is not a table")
    return cast("dict[str, object]", fields)


def _text(fields: dict[str, object], key: str) -> str:
    value = fields.get(key)
    if not isinstance(value, str) or len(value) > LONGEST:
        raise PiecesFault(f"`{key}` is not a short text")
    return value


def _number(value: object, key: str) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise PiecesFault(f"`{key}` is not a number")
    if not abs(value) <= LARGEST**3:  # nor is what is no number, however many digits it has
        raise PiecesFault(f"`{key}` has a number out of range")
    return float(value)


def _point(value: object, key: str) -> tuple[float, float, float]:
    items = _list(value, key)
    if len(items) != 3:
        raise PiecesFault(f"`{key}` has a place without three numbers")
    x, y, z = (_number(item, key) for item in items)
    if max(abs(x), abs(y), abs(z)) > LARGEST:
        raise PiecesFault(f"`{key}` has a number out of range")
    return (x, y, z)


def _corners(value: object) -> tuple[tuple[tuple[float, float, float], ...], ...]:
    pieces = _list(value, "pieces_mm")
    if not 1 <= len(pieces) <= MOST_PIECES:
        raise PiecesFault(f"it has {len(pieces)} pieces; 1 to {MOST_PIECES} are taken")
    counts = [len(_list(piece, "pieces_mm")) for piece in pieces]
    if not 4 <= min(counts) <= max(counts) <= MOST_CORNERS or sum(counts) > MOST_OF_ALL:
        raise PiecesFault(f"a piece has 4 to {MOST_CORNERS} corners, all have {MOST_OF_ALL}")
    return tuple(
        tuple(_point(point, "pieces_mm") for point in _list(piece, "pieces_mm")) for piece in pieces
    )


def _list(value: object, key: str) -> list[object]:
    if not isinstance(value, list):
        raise PiecesFault(f"`{key}` is not a list")
    return cast("list[object]", value)
