"""Which table is about which download: that of a folder is in it, that of a zip is beside it.

Beside a zip there may be others, so every row names its download; tables of before do not.
"""

from pathlib import Path
from typing import NamedTuple
from unicodedata import normalize

from vrts.marking.intake.candidate import inspect
from vrts.marking.intake.tables.edited_table import LARGEST
from vrts.marking.intake.tables.intake_table import COLUMNS, NAME
from vrts.marking.intake.tables.table_text import read_text, table
from vrts.marking.intake.tree.opening import Tree
from vrts.pipeline.files import read_bytes


class OwnTable(NamedTuple):
    """The table of a download."""

    path: Path | None  # None: there is none
    remarks: tuple[str, ...] = ()  # why one was taken, or not


class _Told(NamedTuple):
    """What a table tells of its download."""

    name: str  # "": nothing
    files: tuple[str, ...]


def own_table(place: Path, tree: Tree) -> OwnTable:
    """Return the table that marking obeys without being told.

    Args:
        place: The download.
        tree: The same, opened.

    Raises:
        CannotRead: There is a table that cannot be read.
    """
    if place.is_dir():
        path = place / NAME
        return OwnTable(path if path.is_file() else None)
    if _second(place).is_file():
        return OwnTable(_second(place))
    path = place.parent / NAME
    if not path.is_file():
        return OwnTable(None)
    told = _read(path)
    if _same(told.name, place.name):
        return OwnTable(path)
    if told.name:
        why = f"`{NAME}` is of `{told.name}`, and was not obeyed; with `--intake {path}` it is"
        return OwnTable(None, (why,))
    if any(inspect(tree, file) is not None for file in told.files):
        why = f"`{NAME}` does not say of which download it is: it was obeyed for `{place.name}`"
        return OwnTable(path, (why,))
    return OwnTable(None, (f"`{NAME}` names no file of `{place.name}`, and was not obeyed",))


def remark_on(path: Path, place: Path) -> tuple[str, ...]:
    """Return that a table which was asked for is of another download, if it says so."""
    name = _read(path).name
    if place.is_dir() or not name or _same(name, place.name):
        return ()
    return (f"`{path.name}` was written for `{name}`, and was obeyed for `{place.name}`",)


def place_of_table(place: Path) -> Path:
    """Return where the table of a download is to be written.

    Raises:
        CannotRead: There is a table that cannot be read.
    """
    if place.is_dir():
        return place / NAME
    path = place.parent / NAME
    another = path.is_file() and _read(path).name
    taken = another and not _same(another, place.name)
    return _second(place) if taken or _second(place).is_file() else path


def _second(place: Path) -> Path:
    """Return the table of a download beside which there is that of another one."""
    return place.parent / f"{place.stem}-{NAME}"


def _read(path: Path) -> _Told:
    lines = table(read_text(read_bytes(path)[:LARGEST], path.name), COLUMNS)
    columns = [cell.text.strip().casefold() for cell in lines[0]] if lines else []
    rows = [
        dict(zip(columns, (cell.text.strip() for cell in line), strict=False)) for line in lines[1:]
    ]
    name = next((row["download"] for row in rows if row.get("download")), "")
    return _Told(name, tuple(filter(None, (row.get("file", "") for row in rows))))


def _same(name: str, other: str) -> bool:
    return normalize("NFC", name).casefold() == normalize("NFC", other).casefold()
