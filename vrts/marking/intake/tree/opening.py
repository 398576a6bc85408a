"""Opens a download, whatever it is: the files below a folder or in a zip are only read."""

from collections.abc import Sequence
from pathlib import Path

from vrts.marking.intake.tree.content import HEAD, archive, is_zip
from vrts.marking.intake.tree.folder_tree import folder_tree, list_tree
from vrts.marking.intake.tree.store import Tree, Unreadable
from vrts.marking.intake.tree.zip_tree import zip_tree
from vrts.pipeline.files import CannotRead

__all__ = ["Tree", "Unreadable", "open_place"]


def open_place(place: Path | Sequence[Path]) -> Tree:
    """Open a folder, a zip file, or a list of files and folders; close it with `with`.

    Raises:
        CannotRead: There is nothing of the kind.
    """
    if not isinstance(place, Path):
        return list_tree(place)
    if place.is_dir():
        return folder_tree(place)
    if not place.is_file():
        raise CannotRead(f"there is no `{place}`")
    with place.open("rb") as file:
        head = file.read(HEAD)
    if is_zip(head):
        return _opened_zip(place)
    packed = archive(head)
    if packed is not None:
        hint = "unpack it, and name the folder"
        raise CannotRead(f"`{place.name}` is {packed.what}, which is not opened", (hint,))
    return list_tree([place])


def _opened_zip(path: Path) -> Tree:
    file = path.open("rb")
    try:
        return zip_tree(file, path.name, opened=file)
    except Unreadable as problem:
        file.close()
        help_ = "download it again; or unpack it, and name the folder"
        raise CannotRead(f"`{path.name}` {problem}", (help_,)) from problem
