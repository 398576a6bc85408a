"""What is read: the class, one row, statistics."""

import asyncio

import msgspec
from starlette.requests import Request
from starlette.responses import Response

from vrts.desk.again.marking import Marking
from vrts.desk.desk import Desk, Shown
from vrts.desk.figures.statistics import statistics
from vrts.desk.following import NOT_YET
from vrts.desk.front.answers import refusal, told, told_bytes
from vrts.desk.programs import Programs
from vrts.desk.rows.row_view import one_row
from vrts.desk.told import ClassTold, GraderTold, MarkingTold
from vrts.desk.upkeep import Upkeep


class ClassPages:
    """The handlers."""

    def __init__(self, desk: Desk, programs: Programs, marking: Marking, upkeep: Upkeep) -> None:
        """Serve a desk."""
        self._desk = desk
        self._marking = marking
        self._upkeep = upkeep
        self._programs = programs

    async def whole(self, request: Request) -> Response:
        """Return the class."""

        def made() -> Response:
            shown = self._desk.now()
            return told_bytes(request, msgspec.json.encode(self._told(shown)))

        return await asyncio.to_thread(made)

    async def row(self, request: Request) -> Response:
        """Return everything about a row."""

        def made() -> Response:
            shown = self._desk.now()
            row = shown.listed.rows.get(request.path_params["student"])
            if row is None:
                return refusal(404, "there is no such student in this class")
            book = shown.book
            return told(request, one_row(book, row, *self._programs.of(book, row.id)))

        return await asyncio.to_thread(made)

    async def statistics(self, request: Request) -> Response:
        """Return the class in numbers."""

        def made() -> Response:
            shown = self._desk.now()
            return told(request, statistics(shown.book, shown.listed.causes))

        return await asyncio.to_thread(made)

    def _told(self, shown: Shown) -> ClassTold:
        marking = self._marking.told(shown.book.opened)
        problem = self._upkeep.problem
        problems = () if problem in {"", NOT_YET} else (problem,)  # `marking` tells the other
        return class_told(self._desk.me, shown, marking, problems)


def class_told(
    me: GraderTold, shown: Shown, marking: MarkingTold, problems: tuple[str, ...]
) -> ClassTold:
    """Return a class as the page is told it."""
    book, listed = shown.book, shown.listed
    others = {one.id: one for one in (*book.decided.graders, me)}
    about = book.opened.about
    return ClassTold(
        book.rows.title,
        float(book.rows.total),
        shown.revision,
        me,
        tuple(sorted(others.values(), key=_name)),
        tuple(listed.rows.values()),
        book.decided.items,
        listed.causes,
        book.decided.conflicts,
        marking,
        about.when.isoformat(),
        (*book.problems, *problems),
    )


def _name(grader: GraderTold) -> tuple[str, str]:
    return grader.name.casefold(), grader.id
