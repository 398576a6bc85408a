"""Downloads of no platform: a folder for each student, or files side by side."""

import re
from collections.abc import Mapping, Sequence
from datetime import datetime, tzinfo
from pathlib import PurePosixPath

from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.row import Student
from vrts.marking.intake.tree.file_names import copy_of, is_note, same_name, stem_of

NOT_HANDED_IN = frozenset(  # what may lie beside hand-ins
    {"task.toml", "scene.toml", "scenario.toml", "intake.csv", "overrides.toml"}
)
LISTS = (".csv", ".toml")  # endings of what teachers keep beside hand-ins
FOLDERS, FLAT, LIST = "a folder for each student", "files side by side", "files as named"

_TIME = re.compile(r"\d{4}(?:-\d\d){5}$")  # folders of attempts, as VPL writes them
_ATTEMPT = re.compile(r"(?:attempt|versuch|submission|try)[-_ ]?(\d{1,4})$", re.IGNORECASE)


def folders(tops: Mapping[str, Sequence[str]], zone: tzinfo | None) -> Layout:
    """Return what is in each folder, and the files beside them.

    Args:
        tops: Files by the entry of the root that they are, or are in; none for an empty folder.
        zone: Of times in names of folders; None: they only tell the order.
    """
    hand_ins: list[HandIn] = []
    flat: list[str] = []
    for top, files in tops.items():
        if list(files) == [top]:
            flat.append(top)
        else:
            hand_ins += _of_folder(top, sorted(files), zone)
    lists = [file for file in flat if is_note(file) or file.casefold().endswith(LISTS)]
    beside = _of_files([file for file in flat if file not in lists])
    title = FOLDERS if len(hand_ins) > len(beside) else FLAT
    strays = tuple(f"`{file}` is taken for no hand-in" for file in lists)
    return Layout(title, (*hand_ins, *beside), (*strays, *_copies(beside)))


def listed(files: Sequence[str]) -> Layout:
    """Return a hand-in for each of the files named."""
    hand_ins = tuple(
        HandIn(file, (stem_of(file),), Student(stem_of(file).strip()), (file,)) for file in files
    )
    return Layout(LIST, hand_ins)


def is_attempt(folder: str) -> bool:
    """Return whether a folder is named as one of several attempts, or as what belongs to one."""
    return _order(folder.removesuffix(".ceg")) is not None


def _of_folder(top: str, files: list[str], zone: tzinfo | None) -> list[HandIn]:
    student = Student(top.strip(), email=top if re.fullmatch(r"[\w.+-]+@[\w.-]+", top) else "")
    attempts: dict[str, list[str]] = {}
    for file in files:
        inside = PurePosixPath(file).relative_to(top).parts
        if not (inside and inside[0].endswith(".ceg")):  # results that VPL keeps beside an attempt
            attempts.setdefault(inside[0] if len(inside) > 1 else "", []).append(file)
    orders = {name: _order(name) for name in attempts}
    if not attempts or any(order is None for order in orders.values()):
        return [HandIn(f"{top}/", (top,), student, tuple(files))]
    return [
        HandIn(f"{top}/", (top,), student, tuple(inside), orders[name] or (), _received(name, zone))
        for name, inside in attempts.items()
    ]


def _order(folder: str) -> tuple[int, ...] | None:
    """Return where an attempt comes among the others; None when the folder is no attempt."""
    if _TIME.match(folder):
        return tuple(int(part) for part in folder.split("-"))
    numbered = _ATTEMPT.match(folder)
    return (int(numbered[1]),) if numbered else None


def _received(folder: str, zone: tzinfo | None) -> datetime | None:
    if zone is None or not _TIME.match(folder):
        return None
    try:
        return datetime.strptime(folder, "%Y-%m-%d-%H-%M-%S").replace(tzinfo=zone)
    except ValueError:
        return None


def _of_files(flat: Sequence[str]) -> list[HandIn]:
    """Return files side by side: those that differ only in their ending are of one student."""
    found: dict[str, list[str]] = {}
    for file in flat:
        found.setdefault(stem_of(file), []).append(file)
    return [
        HandIn(stem, (stem,), Student(stem.strip()), tuple(sorted(files)))
        for stem, files in found.items()
    ]


def _copies(beside: Sequence[HandIn]) -> tuple[str, ...]:
    """Remark on files that may be copies: of one student, or of two that chose one name."""
    names = {same_name(hand_in.files[0]) for hand_in in beside}
    remarks: list[str] = []
    for hand_in in beside:
        original, number = copy_of(hand_in.files[0])
        if number and same_name(original) in names:
            remarks.append(
                f"`{hand_in.files[0]}` and `{original}` are two rows: delete one in intake.csv if"
                " they are of one student"
            )
    return tuple(remarks)
