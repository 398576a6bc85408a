"""Who has which variant of a task, and where it lies; a process beside the server gives it."""

import asyncio
from contextlib import suppress
from pathlib import Path
from typing import Final, NamedTuple

from vrts.course.beside import Beside, Died
from vrts.course.course import Assignment, Course
from vrts.course.variants.asked import Called, GiveIt, Given
from vrts.course.variants.task_stamp import task_stamp
from vrts.live.session.setting import has_variants
from vrts.live.settings import VARIANTS, variant_task
from vrts.live.store.course.people import Person, people, person_of
from vrts.live.store.database import Connection, Database
from vrts.marking.intake.row import Platform, plain_id
from vrts.pipeline.files import TASK_FILE

MOST_S: Final = 60.0  # until one is given [s]
NOT_GIVEN: Final = "your variant of the task cannot be made now: try again, or tell your teacher"
NO_LIST: Final = "the course has no list of the class, so nobody has a variant of this task"


class Own(NamedTuple):
    """The task of an assignment, as somebody has it."""

    task: Path  # its file
    tag: str = ""  # of the variant; empty: the task is the same for all, or as it is written
    problem: str = ""  # why they cannot have it: then the task is as it is written


class OwnVariants:
    """Asks for variants as they are needed, and remembers what was answered."""

    def __init__(self, course: Course, database: Database, server: Path, beside: Beside) -> None:
        """Take a course, the folder of the server, and the process that reads tasks."""
        self.course = course  # as its file is now
        self._database = database
        self._server = server
        self._beside = beside
        self._known: dict[tuple[str, int], tuple[object, Own]] = {}

    def task(self, assignment: Assignment, tag: str) -> Path:
        """Return the file of an assignment's task in a variant, if somebody was given it."""
        written = (assignment.task / TASK_FILE).resolve()
        return variant_task(self._server, assignment.id, tag, written) if tag else written

    async def of(self, assignment: Assignment, account: int) -> Own:
        """Return the task of an assignment as an account has it; it is given the first time.

        Students on the list have a variant, or that of their team; all others, such as those who
        teach, see the task as it is written.

        Raises:
            CannotRead: The task is not there any more.
        """
        written = Own((assignment.task / TASK_FILE).resolve())
        if not await asyncio.to_thread(has_variants, written.task):
            return written
        members = await self._database.do(lambda c: members_of(c, account, assignment))
        if not members:
            return written
        roster = self.course.roster
        if roster is None:
            return written._replace(problem=NO_LIST)
        stamp = (members, *await asyncio.to_thread(_stamps, assignment, roster))
        known = self._known.get((assignment.id, account))
        if known is not None and known[0] == stamp and known[1].task.is_file():
            return known[1]
        team = members[0].team if assignment.team else ""
        folder = self._server / VARIANTS / assignment.id
        await asyncio.to_thread(folder.mkdir, mode=0o700, parents=True, exist_ok=True)
        asked = GiveIt(
            str(written.task),
            str(roster.resolve()),
            tuple(_called(one) for one in members),
            team,
            str(folder.resolve()),
        )
        try:
            given = await self._beside.ask(asked, Given, MOST_S)
        except Died:
            return written._replace(problem=NOT_GIVEN)
        if given.problem:
            return written._replace(problem=given.problem)
        own = Own(Path(given.task), given.tag)
        self._known[assignment.id, account] = (stamp, own)
        return own


def members_of(connection: Connection, account: int, assignment: Assignment) -> tuple[Person, ...]:
    """Return for whom somebody works on an assignment, themselves first: of a team all.

    Nobody: they are no student on the list.
    """
    person = person_of(connection, account)
    if person is None or person.rank != "student" or not person.listed:
        return ()
    if not (assignment.team and person.team):
        return (person,)
    others = (
        one
        for one in people(connection)
        if one.team == person.team and one.rank == "student" and one.listed
    )
    return (person, *(one for one in others if one.account != account))


def _stamps(assignment: Assignment, roster: Path) -> tuple[object, ...]:
    of_task = task_stamp(assignment.task)
    with suppress(OSError):
        return of_task, roster.stat().st_mtime_ns
    return of_task, None


def _called(person: Person) -> Called:
    ids = dict(person.ids)
    if "id" in ids:  # a plain table: `vrts grade` calls it so
        ids[Platform.SIS.value] = plain_id(ids["id"])
    return Called(person.email, ids)
