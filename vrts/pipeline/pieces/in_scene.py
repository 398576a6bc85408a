"""The meshes that a scene file names: pieces made of them, and pieces compared with them."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.pipeline.pieces.making import CLOSENESS, MOST, Compared, compared, made
from vrts.pipeline.pieces.named import mesh_sections
from vrts.pipeline.pieces.splitting import NoLibrary
from vrts.scene.meshes.mesh_file import MOST_BYTES
from vrts.scene.meshes.pieces_file import FORMAT, Pieces, PiecesFault, pieces_text, read_pieces
from vrts.scene.meshes.pieces_file import MOST_BYTES as MOST_TEXT
from vrts.scene.meshes.triangles import MeshFault
from vrts.scene.reading.files import FileFault, SceneFolder
from vrts.scene.reading.mesh_section import MeshKeys, read_mesh_keys, tell_changed

MESH = Rule("V897", "mesh-refused")
NO_LIBRARY = Rule("V911", "no-mesh-library")
NOT_HELD = Rule("V912", "mesh-not-held")
NOT_THERE = Rule("V913", "mesh-not-there")
INSIDE_OUT = Rule("V690", "part-inside-out")
OVERLAP = Rule("V922", "solids-overlap")


class Asked(NamedTuple):
    """How nearly pieces are to follow a mesh; None: as the file before, else as usual."""

    closeness: float | None = None
    most: int | None = None


class Named(NamedTuple):
    """A mesh object of a scene."""

    name: str
    keys: MeshKeys
    section: Table


class Shown(NamedTuple):
    """A mesh object, and its pieces beside its mesh; None where the mesh is not there."""

    name: str
    keys: MeshKeys
    pieces: Pieces
    beside: Compared | None


def make_pieces(
    source: SourceFile, folder: Path, asked: Asked
) -> tuple[Mapping[str, bytes], tuple[Diagnostic, ...]]:
    """Return the pieces files that a scene lacks or has of other meshes, by name, and what failed.

    Args:
        source: The scene file.
        folder: That it is in.
        asked: How nearly pieces are to follow the meshes.
    """
    made_files: dict[str, bytes] = {}
    top, problems = read_toml(source)
    for _, keys, section in () if top is None else _meshes(top):
        if keys.pieces in made_files:
            continue
        before = _before(keys, folder)
        closeness = asked.closeness or (before.closeness if before else CLOSENESS)
        most = asked.most or (before.most if before else MOST)
        try:
            SceneFolder(folder).to_write(keys.pieces, FORMAT.encode())
            data = SceneFolder(folder).read(keys.file, MOST_BYTES)
            pieces = made(keys.file, data, keys.unit, closeness, most)
        except (FileFault, MeshFault) as fault:
            _refused(problems, keys, section, fault)
        except NoLibrary as missing:
            problems.error(
                NO_LIBRARY,
                f"pieces are made with {missing}, which is not installed",
                None,
                notes=("to run or check a scene whose pieces are written, it is not needed",),
                help=("install it: pip install 'vrts[mesh]'",),
            )
            break
        else:
            made_files[keys.pieces] = pieces_text(pieces).encode()
    return made_files, problems.in_order()


def look_at_pieces(
    source: SourceFile, folder: Path
) -> tuple[tuple[Shown, ...], tuple[Diagnostic, ...]]:
    """Return the mesh objects of a scene, proven again beside their meshes, and what is wrong.

    Args:
        source: The scene file, which was read without an error.
        folder: That it is in.
    """
    top, problems = read_toml(source)
    found: list[Shown] = []
    known: dict[tuple[str, str], Compared | None] = {}
    for name, keys, section in () if top is None else _meshes(top):
        pieces = _before(keys, folder)
        if pieces is None:  # the reader of scenes has said so
            continue
        key = (keys.pieces, keys.file)
        if key not in known:
            known[key] = _beside(problems, pieces, keys, section, folder)
        found.append(Shown(name, keys, pieces, known[key]))
    return tuple(found), problems.in_order()


def _beside(
    problems: Problems, pieces: Pieces, keys: MeshKeys, section: Table, folder: Path
) -> Compared | None:
    if not (folder / keys.file).exists():
        problems.warning(
            NOT_THERE,
            f"`{keys.file}` is not there: whether its pieces hold it was not proven",
            section.value_span("file"),
            help=("put it back into that folder, and check again; runs do not need it",),
            data={"file": keys.file},
        )
        return None
    try:
        data = SceneFolder(folder).read(keys.file, MOST_BYTES)
        beside = compared(pieces, keys.file, data)
    except (FileFault, MeshFault) as fault:
        _refused(problems, keys, section, fault)
        return None
    if beside.turned:
        problems.warning(
            INSIDE_OUT,
            f"parts of the mesh `{keys.file}` are inside out",
            section.value_span("file"),
            f"of {beside.turned} the normals point inward; they count as solid",
            help=("turn their normals in your CAD or mesh program, and save the mesh again",),
            data={"file": keys.file, "parts": beside.turned},
        )
    if beside.shared:
        problems.warning(
            OVERLAP,
            f"solids in the mesh `{keys.file}` overlap, or pass through themselves",
            section.value_span("file"),
            "what they share counts more than once for volume and centre of mass",
            help=("unite the solids in your CAD or mesh program, and save the mesh again",),
            data={"file": keys.file},
        )
    if not beside.same:
        tell_changed(section, keys.file)
    elif beside.stands_out > 0.0 or _differ(pieces, beside.pieces):
        what = (
            f"it stands out of them by up to {beside.stands_out:.3f} mm"
            if beside.stands_out > 0.0
            else "their file says other lengths, volumes or another centre of mass than measured"
        )
        problems.error(
            NOT_HELD,
            f"the pieces in `{keys.pieces}` are not those of `{keys.file}`",
            section.value_span("file"),
            what,
            help=("make them again: `vrts scene check SCENE --write`",),
            data={"file": keys.pieces, "stands_out_mm": beside.stands_out},
        )
    return beside


def _differ(told: Pieces, measured: Pieces) -> bool:
    """Return whether a file says other numbers than are measured, rounding apart.

    Another release may prove another bound; it must not be below what is found.
    """
    pairs = (
        (told.mesh_volume, measured.mesh_volume, 0.2),
        *((a, b, 0.001) for a, b in zip(told.centre_of_mass, measured.centre_of_mass, strict=True)),
    )
    return told.at_most + 0.02 < measured.found or any(
        abs(a - b) > least + 1e-6 * abs(b) for a, b, least in pairs
    )


def _meshes(top: Table) -> Iterator[Named]:
    """Yield the mesh objects of a scene file whose sections can be read."""
    for name, section in mesh_sections(top):
        keys = read_mesh_keys(section)
        if keys is not None:
            yield Named(name, keys, section)


def _before(keys: MeshKeys, folder: Path) -> Pieces | None:
    """Return the pieces that are there, if they are."""
    try:
        return read_pieces(SceneFolder(folder).read(keys.pieces, MOST_TEXT))
    except (FileFault, PiecesFault):
        return None


def _refused(problems: Problems, keys: MeshKeys, section: Table, fault: Exception) -> None:
    remedy = fault.remedy if isinstance(fault, MeshFault) else "put the mesh into that folder"
    problems.error(
        MESH,
        f"the mesh `{keys.file}` cannot be taken",
        section.value_span("file"),
        str(fault),
        help=(remedy,) if remedy else (),
        data={"file": keys.file},
    )
