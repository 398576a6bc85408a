"""Which files of pieces a scene needs, as far as its text can be read."""

from collections.abc import Mapping
from pathlib import Path

from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
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
    for _, section in () if top is None else top.named_tables("objects"):
        if section.string("kind", "") != "mesh":
            continue
        name = section.string("pieces", section.string("file", "") + PIECES)
        try:
            found[name] = SceneFolder(folder).read(name, MOST_BYTES)
        except FileFault:  # whoever reads the scene is told
            continue
    return found
