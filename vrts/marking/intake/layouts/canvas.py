"""Downloads of Canvas: "bergeranna_LATE_12345_67890_pick-1.v2", all in one folder."""

import re
from collections.abc import Mapping, Sequence

from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.row import Platform, Student

_FILE = r"_(?:(?P<file>\d+)_.+|text\.html|link\.html)"
_ENTRIES = (
    re.compile(rf"(?P<name>)(?P<late>LATE_)?(?P<user>anon_\w+?){_FILE}", re.DOTALL),
    # Canvas takes numbers between `_` out of names, so the first ones count
    re.compile(rf"(?P<name>.*?)_(?P<late>LATE_)?(?P<user>\d+){_FILE}", re.DOTALL),
)


def canvas(tops: Mapping[str, Sequence[str]]) -> Layout | None:
    """Return the hand-ins of a download of Canvas; None when it is none.

    Args:
        tops: Files by the entry of the download's root that they are, or are in.
    """
    found: dict[str, list[tuple[re.Match[str], str]]] = {}
    strays: list[str] = []
    for top, files in tops.items():
        matches = (entry.fullmatch(top) for entry in _ENTRIES)
        match = next(filter(None, matches), None)
        if match is None or list(files) != [top]:
            strays.append(top)
        else:
            found.setdefault(match["user"], []).append((match, top))
    if len(found) <= len(strays):
        return None
    hand_ins = tuple(_hand_in(user, entries) for user, entries in found.items())
    remarks = tuple(f"`{stray}` is not of a student" for stray in strays)
    return Layout("Canvas", hand_ins, remarks, canvas=True)


def called_by_canvas(file: str) -> bool:
    """Return whether a file of a download, or the zip that it is in, has a name of Canvas."""
    name = file.split("!")[0].rsplit("/", 1)[-1]
    return any(entry.fullmatch(name) for entry in _ENTRIES)


def _hand_in(user: str, entries: Sequence[tuple[re.Match[str], str]]) -> HandIn:
    name = entries[0][0]["name"] or ""
    late = any(match["late"] for match, _ in entries)
    return HandIn(
        user,
        (name, user),
        Student(name.strip(), ids={Platform.CANVAS.value: user}),
        tuple(sorted(file for _, file in entries)),
        flagged=late,
    )
