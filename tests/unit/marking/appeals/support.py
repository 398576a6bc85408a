"""A class of two that was marked, and results to compare."""

from datetime import UTC, datetime
from pathlib import Path

import msgspec

from vrts import __version__
from vrts.marking.about import About
from vrts.marking.class_files import write_class
from vrts.marking.layout import Layout
from vrts.marking.result import Kind, Result
from vrts.marking.row import Class, HandedIn, Lateness, Row, Student, row_of
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.whole_class import HowTo, Marked, mark_whole_class
from vrts.pipeline.files import CHECKOUT

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
TASK = EXAMPLE / "task.toml"
GOOD = (EXAMPLE / "solution.v2").read_bytes()
BAD = (EXAMPLE / "submissions" / "hits-base.v2").read_bytes()
SECRET = "Benedikt Zwölfer"  # another student, who must not turn up in anna's evidence


def result(identifier: str = "anna", mark: float | None = 8.5, **more: object) -> Result:
    """Return a result with something in every part."""
    from tests.unit.marking.test_result import result as full

    kind = Kind.GRADED if mark is not None else Kind.RESOURCE
    found = msgspec.structs.replace(full(mark, kind), id=identifier)
    return msgspec.structs.replace(found, **more)


def row(
    identifier: str = "anna",
    mark: float | None = 8.5,
    late: Lateness | None = None,
    **more: object,
) -> Row:
    """Return the row of a result."""
    return row_of(result(identifier, mark, **more), Student(identifier), HandedIn(), late)


def class_of(*rows: Row) -> Class:
    """Return a class."""
    return Class("vrts.class/1", "Lab 1", rows)


def submissions(folder: Path) -> Path:
    """Write the submissions of two students."""
    for name, data in (("anna", GOOD), (SECRET, BAD)):
        place = folder / "download" / name / f"{name}.v2"
        place.parent.mkdir(parents=True)
        place.write_bytes(data)
    return folder / "download"


def marked_class(
    folder: Path,
    download: Path,
    task: Path = TASK,
    wanted: Wanted = Wanted(pages=False),  # noqa: B008 -- frozen
    finished: datetime | None = None,
) -> tuple[Layout, Marker, Marked]:
    """Mark a download as the command does."""
    layout = Layout(folder)
    marker = Marker(Place(str(task)), wanted)
    marked = mark_whole_class(marker, download, layout, HowTo(jobs=2))
    about = About(
        "vrts.marking/1",
        marked.rows.title,
        marker.place,
        (str(download),),
        wanted,
        __version__,
        ("vrts", "grade", str(task), str(download), "-o", str(folder)),
        finished or datetime.now(UTC),
    )
    write_class(marked.rows, about, layout)
    return layout, marker, marked
