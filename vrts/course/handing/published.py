"""What a teacher has published of a marking, as each student may read it: theirs alone.

All of one publication is written first; one small file then says which one counts, so students see
the one of before or the whole next one. To withdraw it is to remove that file.
"""

from pathlib import Path
from typing import Final

import msgspec

from vrts.course.course import Course

PUBLISHED: Final = "published"  # in the course's folder
CURRENT: Final = "current"  # in the folder of an assignment: which publication counts
FINAL: Final = "final.json"
REPORT: Final = "report.html"


class Said(msgspec.Struct, frozen=True, omit_defaults=True):
    """A comment of a grader, or a rubric item at one of its places."""

    text: str
    who: str = ""
    line: int | None = None
    time_s: float | None = None  # in the run of the report
    points: str = ""  # of an item: a fraction, added to the mark


class Returning(msgspec.Struct, frozen=True):
    """What a student is told about the final mark."""

    mark: str  # a sentence
    made_of: tuple[str, ...] = ()  # how it came to be
    comments: tuple[Said, ...] = ()
    remarks: tuple[str, ...] = ()
    page: bool = False  # whether there is a report


def final_of(course: Course, assignment: str, folder: str) -> Returning | None:
    """Return what somebody, by the name of their folder, may read; None: nothing is published."""
    own = _own(course, assignment, folder)
    try:
        return None if own is None else _read(own / FINAL)
    except OSError:  # it was withdrawn meanwhile
        return None


def report_of(course: Course, assignment: str, folder: str) -> Path | None:
    """Return where somebody's report is; None: there is none."""
    own = _own(course, assignment, folder)
    return own / REPORT if own is not None and (own / REPORT).is_file() else None


def _own(course: Course, assignment: str, folder: str) -> Path | None:
    home = course.folder / PUBLISHED / assignment
    try:
        name = (home / CURRENT).read_text("ascii")
    except OSError:
        return None
    return home / name / folder if name.isalnum() else None


def _read(path: Path) -> Returning | None:
    return msgspec.json.decode(path.read_bytes(), type=Returning)
