"""A course beside the live server: its parts put together, each with pages of its own."""

from collections.abc import Sequence

from starlette.routing import BaseRoute

from vrts.course.beside import Beside
from vrts.course.course import HANDING, Course
from vrts.course.front.assignment_pages import AssignmentPages
from vrts.course.front.board_pages import BoardPages
from vrts.course.front.course_pages import CoursePages
from vrts.course.front.login_pages import LoginPages
from vrts.course.front.people_pages import PeoplePages
from vrts.course.front.robot_pages import RobotPages
from vrts.course.front.slot_pages import SlotPages
from vrts.course.people.watching import WatchedPeople
from vrts.course.variants.own_variants import OwnVariants
from vrts.live.front.added import Added, Adding
from vrts.live.front.http import Pages
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.sessions import Sessions


class ServedCourse:
    """Everything that a course adds to a server."""

    def __init__(self, parts: Sequence[Added]) -> None:
        """Put parts together; they begin in this order, and end in the other."""
        self._parts = tuple(parts)

    def routes(self) -> list[BaseRoute]:
        """Return the pages of all parts."""
        return [route for part in self._parts for route in part.routes()]

    async def open(self) -> None:
        """Begin."""
        for part in self._parts:
            await part.open()

    async def beat(self) -> None:
        """Do what time brings about."""
        for part in self._parts:
            await part.beat()

    async def close(self) -> None:
        """End."""
        for part in reversed(self._parts):
            await part.close()


def adding(course: Course) -> Adding:
    """Return what makes a course a part of a server."""

    def add(hub: Hub, sessions: Sessions, pages: Pages) -> Added:
        return ServedCourse(_parts(course, hub, sessions, pages))

    return add


def _parts(course: Course, hub: Hub, sessions: Sessions, pages: Pages) -> tuple[Added, ...]:
    """Return the parts of a course in the order in which they begin."""
    people, folder = WatchedPeople(course, hub), hub.settings.folder
    beside = Beside(folder / HANDING / "telling")
    variants = OwnVariants(course, hub.database, folder, beside)
    return (
        PeoplePages(people, hub, pages),
        LoginPages(people, hub, pages),
        CoursePages(people, hub, pages),
        RobotPages(people, hub, pages, variants),
        SlotPages(people, hub, pages),
        AssignmentPages(people, hub, pages, variants, beside),
        BoardPages(people, hub, pages),
    )
