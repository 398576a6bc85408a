"""Writes what follows from decisions: lists, overview, feedback."""

from pathlib import Path

from vrts.desk.again.going_on import goes_on, writing_alone
from vrts.desk.book.opened import open_marking
from vrts.desk.book.shelf import sentence
from vrts.marking.renewing.renewed import renewed
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused


def follow(folder: Path) -> str:
    """Bring the files of a class up to date; return what went wrong, "" where nothing did.

    While a marking goes on nothing is written: it writes the same files, with all decisions.
    """
    try:
        with writing_alone(folder):
            if goes_on(folder):
                return ""
            opened = open_marking(folder)
            if opened.about.finished is not None:
                renewed(opened.layout)
    except (CannotRead, Refused) as problem:
        return f"lists and feedback are not up to date: {sentence(problem)}"
    except OSError as problem:
        return f"lists and feedback are not up to date: {problem.strerror or problem}"
    return ""


def is_behind(folder: Path) -> bool:
    """Return whether decisions are newer than the lists: a desk may have died before it wrote."""
    staff = folder / "staff"
    try:
        written = (staff / "results.json").stat().st_mtime_ns
        decided = [path.stat().st_mtime_ns for path in (staff / "decisions").glob("*.jsonl")]
    except OSError:
        return False
    return any(time > written for time in decided)
