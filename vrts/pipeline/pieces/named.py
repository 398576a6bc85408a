"""Which files of pieces a scene needs, as far as its text can be read."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from vrts.base.source import SourceFile
from vrts.base.toml.reading import Table, read_toml
from vrts.scene.reading.files import PIECES, FileFault, SceneFolder

MOST_BYTES = 1_000_000  # of a file of pieces


def pieces_files(source: SourceFile, folder: Path) -> Mapping[str, bytes]:
    """Return the files of pieces that a scene names and that are there, by name.

    Args:
        source: A scene file; a lab has none.
        folder: That it is in.
    """
    top, _ = read_toml(source)
    found: dict[str, bytes] = {}
    for _, section in () if top is None else mesh_sections(top):
        name = section.string("pieces", section.string("file", "") + PIECES)
        try:
            found[name] = SceneFolder(folder).read(name, MOST_BYTES)
        except FileFault:  # whoever reads the scene is told
            continue
    return found


def mesh_sections(top: Table) -> Iterator[tuple[str, Table]]:
    """Yield the names and sections of the objects of a scene file that are meshes."""
    for name, section in top.named_tables("objects"):
        if "kind" in section and section.string("kind", "") == "mesh":
            yield name, section
