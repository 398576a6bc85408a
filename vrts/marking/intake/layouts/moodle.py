"""Downloads of Moodle: "Anna Berger_123456_assignsubmission_file_", as folders or before names."""

import re
from collections.abc import Mapping, Sequence

from vrts.marking.intake.layouts.hand_in import HandIn, Layout
from vrts.marking.intake.row import Platform, Student

# Moodle takes `_` out of names, so the first number counts whatever a file is called
_ENTRY = re.compile(r"(?P<name>[^_]*)_(?P<id>\d+)_assignsubmission_(?P<plugin>[a-z]+)(?:_|$)")


def moodle(tops: Mapping[str, Sequence[str]]) -> Layout | None:
    """Return the hand-ins of a download of Moodle; None when it is none.

    Args:
        tops: Files by the entry of the download's root that they are, or are in.
    """
    found: dict[str, tuple[str, list[str]]] = {}
    strays: list[str] = []
    for top, files in tops.items():
        match = _ENTRY.match(top)
        if match is None:
            strays.append(top)
            continue
        found.setdefault(match["id"], (match["name"].strip(), []))[1].extend(files)
    if not found or len(found) < len(strays):
        return None
    hand_ins = tuple(
        HandIn(
            number,
            (name, number),
            Student(name, ids={Platform.MOODLE.value: number}),
            tuple(sorted(files)),
        )
        for number, (name, files) in found.items()
    )
    remarks = tuple(f"`{stray}` is not of a student" for stray in strays)
    return Layout("Moodle", hand_ins, remarks)
