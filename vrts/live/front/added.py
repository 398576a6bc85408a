"""What another part of vrts may add to the server: pages, and what time brings about for them."""

from collections.abc import Callable, Sequence
from typing import Protocol

from starlette.routing import BaseRoute

from vrts.live.front.http import Pages
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.sessions import Sessions


class Added(Protocol):
    """Lives as long as the server does."""

    def routes(self) -> Sequence[BaseRoute]:
        """Return its pages; the server guards them as its own."""
        ...

    async def open(self) -> None:
        """Begin: the rooms are open, and nobody has come in yet."""
        ...

    async def beat(self) -> None:
        """Do what time brings about; called about once a second."""
        ...

    async def close(self) -> None:
        """End what goes on: the server ends."""
        ...


Adding = Callable[[Hub, Sessions, Pages], Added]
