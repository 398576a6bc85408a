"""Files of the marking, as it wrote them: reports, and what is alike.

What a grader must not see yet of other graders is taken out of a report before it is sent.

No path is made of an address: a student is looked up in the class, and a name in a fixed list.
"""

import asyncio
import re
from pathlib import Path
from typing import Final

from starlette.requests import Request
from starlette.responses import Response

from vrts.desk.desk import Desk
from vrts.desk.front.answers import refusal
from vrts.marking.layout import COMPARED
from vrts.marking.renewing.renewed import page_about
from vrts.marking.submission.report_files import REPORT

HTML: Final = "text/html; charset=utf-8"
LARGEST: Final = 200_000_000  # bytes of a file that is sent
_PAIR: Final = re.compile(r"pair-[0-9]{3,6}\.html")
_ALIKE: Final = re.compile(r"similarity[a-z0-9-]{0,80}\.html")


class FilePages:
    """The handlers."""

    def __init__(self, desk: Desk) -> None:
        """Serve the files of a desk."""
        self._desk = desk

    async def staff_report(self, request: Request) -> Response:
        """Return the report for those who mark."""
        return await asyncio.to_thread(self.report, *_asked(request), staff=True)

    async def sent_report(self, request: Request) -> Response:
        """Return the report that the student gets."""
        return await asyncio.to_thread(self.report, *_asked(request), staff=False)

    async def alike(self, request: Request) -> Response:
        """Return a page of what is alike."""
        name = request.path_params["name"]
        if not _ALIKE.fullmatch(name):
            return _nothing()
        book = (await asyncio.to_thread(self._desk.now)).book
        return await asyncio.to_thread(_file, book.opened.layout.staff / name)

    async def pair(self, request: Request) -> Response:
        """Return a page of two programs that are alike."""
        name = request.path_params["name"]
        if not _PAIR.fullmatch(name):
            return _nothing()
        book = (await asyncio.to_thread(self._desk.now)).book
        return await asyncio.to_thread(_file, book.opened.layout.staff / COMPARED / name)

    def report(self, student: str, name: str, *, staff: bool) -> Response:
        """Return a report as the grader at the desk may see it.

        Args:
            student: Id.
            name: Of the file.
            staff: Whether it is that for those who mark.
        """
        book = self._desk.now().book
        row = book.by_id.get(student)
        if row is None or name != REPORT:
            return _nothing()
        layout = book.opened.layout
        found = _file((layout.grader(row.id) if staff else layout.student(row.id)) / REPORT)
        if row.id in book.seen.alone and found.status_code == 200:
            return _page(page_about(bytes(found.body), row, staff=staff))
        return found


def _asked(request: Request) -> tuple[str, str]:
    return request.path_params["student"], request.path_params["name"]


def _file(place: Path) -> Response:
    try:
        if place.is_symlink() or not place.is_file() or place.stat().st_size > LARGEST:
            return _nothing()
        return _page(place.read_bytes())
    except OSError:  # it went meanwhile: a marking replaces it
        return _nothing()


def _page(data: bytes) -> Response:
    return Response(data, media_type=HTML, headers={"cache-control": "no-store"})


def _nothing() -> Response:
    return refusal(404, "there is no such file")
