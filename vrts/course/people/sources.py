"""The files that tell who is in a course: read whole, and looked at again when they change."""

from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic
from vrts.course.course import COURSE_FILE, Course
from vrts.course.course_file import read_course
from vrts.course.people.class_list import open_class_list
from vrts.course.people.listed import Listed, everybody
from vrts.pipeline.files import CannotRead, read_toml_source

Stamp = tuple[tuple[str, int, int], ...]  # of files: name, time of change [ns], size


class Read(NamedTuple):
    """What the files say: either a course with its people, or what is wrong."""

    course: Course | None
    people: tuple[Listed, ...] = ()
    found: tuple[Diagnostic, ...] = ()  # those that are no errors too
    missing: str = ""  # which file cannot be read

    @property
    def good(self) -> bool:
        """Whether people may follow it."""
        return self.course is not None and not self.missing and not self.faults

    @property
    def faults(self) -> tuple[Diagnostic, ...]:
        """What keeps people as they are."""
        return tuple(one for one in self.found if one.is_error)

    @property
    def words(self) -> str:
        """What is wrong, in a line."""
        first = self.missing or next((one.headline for one in self.faults), "")
        more = len(self.faults) - 1
        return f"{first}, and {more} more" if more > 0 else first


def read_people(folder: Path) -> Read:
    """Return what the files of a course say now."""
    try:
        source = read_toml_source(folder / COURSE_FILE)
    except CannotRead as problem:
        return Read(None, missing=problem.message)
    course, found = read_course(source, folder)
    return Read(None, (), found) if course is None else _with_class(course, found)


def people_of(course: Course) -> Read:
    """Return the people of a course whose file was read already."""
    return _with_class(course, ())


def stamp_of(course: Course) -> Stamp:
    """Return by what a change of the files shows, without reading them."""
    paths = [course.folder / COURSE_FILE]
    if course.roster is not None:
        paths.append(course.roster)
    return tuple(_stamp(path) for path in paths)


def _with_class(course: Course, found: tuple[Diagnostic, ...]) -> Read:
    students: tuple[Listed, ...] = ()
    if course.roster is not None:
        try:
            students, more = open_class_list(course.roster)
        except CannotRead as problem:
            return Read(course, (), found, problem.message)
        found += more
    people, more = everybody(course, students)
    return Read(course, people, found + more)


def _stamp(path: Path) -> tuple[str, int, int]:
    try:
        status = path.stat()
    except OSError:
        return path.name, 0, -1
    return path.name, status.st_mtime_ns, status.st_size
