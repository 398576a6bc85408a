"""Publishes a marking to the students of a course, and withdraws it: acts of a teacher."""

import secrets
import shutil
from pathlib import Path
from typing import NamedTuple

import msgspec

from vrts.base.diagnostic import Diagnostic
from vrts.course.course import Course
from vrts.course.handing.names import folder_in
from vrts.course.handing.published import CURRENT, FINAL, PUBLISHED, REPORT, Returning, Said
from vrts.marking.appeals.written import read_class, read_written
from vrts.marking.exports.feedback import for_student, words_for
from vrts.marking.exports.given import Returned, returned
from vrts.marking.exports.unsafe_marks import closing, refusal
from vrts.marking.exports.write import read_given
from vrts.marking.layout import Layout, write_atomically
from vrts.marking.privacy.pseudonyms import with_names
from vrts.marking.renewing.renewed import brought_up_to_date
from vrts.pipeline.refused import Refused


class Publication(NamedTuple):
    """What was published."""

    students: int
    diagnostics: tuple[Diagnostic, ...]


def publish(course: Course, assignment: str, out: Path, despite: frozenset[str]) -> Publication:
    """Let each student see the final mark of a marking, with what graders say, and nobody else's.

    Args:
        course: The course.
        assignment: Id of one of its assignments.
        out: Folder that the marking wrote.
        despite: Reasons why marks are unsafe that do not keep them back.

    Raises:
        CannotRead: A file cannot be read.
        Refused: There is no such marking, it has not ended, or marks are unsafe.
        OSError: It cannot be written.
    """
    written = read_written(out)
    brought_up_to_date(written)
    layout = Layout(out)
    rows = read_class(layout.results, out)
    unsafe = refusal(rows, despite, out)
    if unsafe:
        raise Refused(unsafe)
    given = read_given(rows, layout)
    given = given._replace(whole=with_names(given.whole, layout))
    home = course.folder / PUBLISHED / assignment
    name = secrets.token_hex(8)
    count = 0
    (home / name).mkdir(mode=0o700, parents=True)
    for told in returned(given):
        report = layout.student(told.row.id) / REPORT
        page = report.read_bytes() if report.is_file() and not report.is_symlink() else None
        own = home / name / folder_in(told.row)
        own.mkdir(mode=0o700, exist_ok=True)
        if page is not None:
            (own / REPORT).write_bytes(page)
        final = _final(told, page=page is not None)
        (own / FINAL).write_bytes(msgspec.json.encode(final))
        count += 1
    write_atomically(home / CURRENT, name.encode())
    _forget_others(home, name)
    return Publication(count, closing(rows) if despite else ())


def withdraw(course: Course, assignment: str) -> bool:
    """Let nobody see what was published of an assignment; return whether there was anything."""
    home = course.folder / PUBLISHED / assignment
    there = (home / CURRENT).is_file()
    (home / CURRENT).unlink(missing_ok=True)
    _forget_others(home, "")
    return there


def _forget_others(home: Path, name: str) -> None:
    if home.is_dir():
        for folder in home.iterdir():
            if folder.is_dir() and folder.name != name:
                shutil.rmtree(folder, ignore_errors=True)


def _final(told: Returned, *, page: bool) -> Returning:
    words = words_for(told)
    decided = for_student(told.row)
    said: list[Said] = []
    if decided is not None:
        said += [Said(one.text, one.who, one.line, one.time_s) for one in decided.comments]
        for item in decided.items:
            places = item.places or ((None, None),)
            said += [Said(item.title, item.who, line, at, item.points) for line, at in places]
    made = tuple(f"{line.points}  {line.sentence}" for line in words.made_of)
    return Returning(words.mark, made, tuple(said), words.remarks, page)
