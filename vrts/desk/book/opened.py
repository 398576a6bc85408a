"""Reads what a marking wrote, or says why a folder is of no use to the desk."""

from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Rule, error
from vrts.marking import about
from vrts.marking.about import About
from vrts.marking.appeals.written import LARGEST_ABOUT, no_marking, read_class
from vrts.marking.exports.write import is_name
from vrts.marking.layout import STAFF, Layout
from vrts.marking.privacy.statistics_of_class import NAME as STATISTICS
from vrts.marking.result import Damaged
from vrts.marking.row import Class
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

PURGED = Rule("V850", "marking-purged")
GOES_ON = Rule("V851", "marking-not-ended")
BAD_ID = Rule("V852", "id-no-name")


class Opened(NamedTuple):
    """The output of a marking; `about.finished` tells whether another one is under way."""

    layout: Layout
    rows: Class  # as computed and as decided when it was written
    about: About


def open_marking(folder: Path) -> Opened:
    """Return what a marking wrote into a folder.

    Raises:
        CannotRead: There is no such folder.
        Refused: No marking has been written there, or it is purged, or has not ended.
    """
    if not folder.is_dir():
        hint = "name the folder that was given to `vrts grade` with `-o`"
        what = "is a file, and no folder" if folder.exists() else "is not there"
        raise CannotRead(f"`{folder}` {what}", (hint,))
    layout = Layout(folder)
    how = _about(layout, folder)
    if how.finished is None and not layout.results.is_file():
        headline = f"the marking in `{folder}` goes on, or was interrupted"
        again = "call the same `vrts grade` command again"
        remedy = f"wait for it, or {again}: it goes on where it was"
        raise Refused((error(GOES_ON, headline, help=(remedy,)),))
    rows = read_class(layout.results, folder)
    for row in rows.rows:
        if not is_name(row.id):
            headline = f"`{layout.results.name}` has an id that is no name of a folder"
            remedy = "mark the class again, or put back the file as marking wrote it"
            notes = (f"the id is {row.id[:80]!r}",)
            raise Refused((error(BAD_ID, headline, notes=notes, help=(remedy,)),))
    return Opened(layout, rows, how)


def _about(layout: Layout, folder: Path) -> About:
    place = layout.staff / about.NAME
    if not place.is_file() and (folder / STAFF / STATISTICS).is_file():
        headline = f"`{folder}` is purged: only its statistics are left"
        remedy = "mark the class again into another folder, if that is still allowed"
        raise Refused((error(PURGED, headline, help=(remedy,)),))
    try:
        if place.stat().st_size > LARGEST_ABOUT:
            raise no_marking(folder, f"`{about.NAME}` has more than {LARGEST_ABOUT:,} bytes")
        return about.from_bytes(place.read_bytes())
    except OSError as problem:
        raise no_marking(folder, f"`{about.NAME}` cannot be read") from problem
    except Damaged as problem:
        why = f"`{about.NAME}` is not as this vrts writes it: {problem}"
        raise no_marking(folder, why) from problem
