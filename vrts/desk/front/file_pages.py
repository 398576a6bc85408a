"""Files of the marking, as it wrote them: reports, and what is alike.

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
from vrts.marking.submission.report_files import REPORT

HTML: Final = "text/html; charset=utf-8"
LARGEST: Final = 200_000_000  # bytes of a file that is sent
_ALIKE: Final = re.compile(r"similarity[a-z0-9-]{0,80}\.html")


class FilePages:
    """The handlers."""

    def __init__(self, desk: Desk) -> None:
        """Serve the files of a desk."""
        self._desk = desk

    async def staff_report(self, request: Request) -> Response:
        """Return the report for those who mark."""
        return await asyncio.to_thread(self._report, request, staff=True)

    async def sent_report(self, request: Request) -> Response:
        """Return the report that the student gets."""
        return await asyncio.to_thread(self._report, request, staff=False)

    async def alike(self, request: Request) -> Response:
        """Return a page of what is alike."""
        name = request.path_params["name"]
        if not _ALIKE.fullmatch(name):
            return _nothing()
        book = (await asyncio.to_thread(self._desk.now)).book
        return await asyncio.to_thread(_file, book.opened.layout.staff / name)

    def _report(self, request: Request, *, staff: bool) -> Response:
        book = self._desk.now().book
        row = book.by_id.get(request.path_params["student"])
        if row is None or request.path_params["name"] != REPORT:
            return _nothing()
        layout = book.opened.layout
        return _file((layout.grader(row.id) if staff else layout.student(row.id)) / REPORT)


def _file(place: Path) -> Response:
    try:
        if place.is_symlink() or not place.is_file() or place.stat().st_size > LARGEST:
            return _nothing()
        return Response(place.read_bytes(), media_type=HTML, headers={"cache-control": "no-store"})
    except OSError:  # it went meanwhile: a marking replaces it
        return _nothing()


def _nothing() -> Response:
    return refusal(404, "there is no such file")
