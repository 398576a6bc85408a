"""A page of the course with modules of its own, in few files: the room's page is none of it.

A module stands in one bundle only. So what two pages share, such as `live/dom.js`, is served to
each from its own bundle, and never as a part of the other.
"""

from collections.abc import Sequence

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import BaseRoute, Route

from vrts.live.front.guard import refused
from vrts.live.front.static_files import StaticFiles


class OwnPage:
    """A page, and what it loads."""

    def __init__(self, folder: str) -> None:
        """Serve `index.html` of a folder below `vrts/web`, such as `course/board`."""
        self._folder = folder
        self._page = f"{folder}/index.html"
        self._files = StaticFiles(self._page)

    def routes(self, address: str) -> Sequence[BaseRoute]:
        """Return the routes of the page, by its address, and of what it loads."""
        return (Route(address, self.page), Route(f"/web/{self._folder}/{{path:path}}", self.file))

    async def page(self, request: Request) -> Response:
        """Return the page itself; what it shows it asks for."""
        return self._found(request, self._page)

    async def file(self, request: Request) -> Response:
        """Return a file that it loads."""
        return self._found(request, f"{self._folder}/{request.path_params['path']}")

    def _found(self, request: Request, path: str) -> Response:
        found = self._files.find(path)
        if found is None:
            return refused(404, "file", "there is no such page")
        return found.answer(request)
