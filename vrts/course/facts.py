"""What the page has to know of an assignment before anybody marks: read from its task alone.

No scene is read, so the server needs no arm for it. Faults of a task are told by who marks.
"""

from contextlib import suppress
from datetime import datetime
from typing import NamedTuple

from vrts.base.toml.reading import read_toml
from vrts.check.task.late_file import read_exam, read_keep, read_late
from vrts.check.task.late_rules import Keep, LateRules
from vrts.course.course import Assignment, Course
from vrts.pipeline.files import TASK_FILE, CannotRead, read_toml_source


class Facts(NamedTuple):
    """What is known of an assignment."""

    assignment: Assignment
    title: str
    rules: LateRules | None  # deadline, and what lateness costs; None: there is none
    keep: Keep  # which attempt counts
    text: str  # what its task says of itself

    @property
    def opens(self) -> datetime | None:
        """When students see it; None: it is open."""
        exam = self.rules.opens if self.rules is not None else None
        times = [time for time in (self.assignment.opens, exam) if time is not None]
        return max(times, default=None)

    @property
    def due(self) -> datetime | None:
        """When it is due; None: there is no deadline."""
        return None if self.rules is None else self.rules.due


def facts_of(assignment: Assignment) -> Facts:
    """Return what the file of a task tells.

    Raises:
        CannotRead: It is not there any more.
    """
    source = read_toml_source(assignment.task / TASK_FILE)
    top, problems = read_toml(source)
    if top is None:
        return Facts(assignment, assignment.id, None, Keep.LATEST, "")
    section = top.table("task")
    title = section.string("title", assignment.id) if section is not None else assignment.id
    text = section.string("description", "").strip() if section is not None else ""
    rules, keep, exam = read_late(top, problems), read_keep(top), read_exam(top, problems)
    if exam is not None:
        rules, keep = exam.rules, exam.keep
    return Facts(assignment, title, rules, keep, text)


def facts_of_all(course: Course) -> list[Facts]:
    """Return what is known of all assignments; one whose task is gone is left out."""
    found: list[Facts] = []
    for one in course.assignments:
        with suppress(CannotRead):
            found.append(facts_of(one))
    return found


def unix(time: datetime | None) -> float:
    """Return a time as pages are told it: Unix time [s]; 0: there is none."""
    return 0.0 if time is None else time.timestamp()
