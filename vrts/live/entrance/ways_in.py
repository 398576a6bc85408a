"""The ways into a server while it runs: its class code and links, what they let in, their end."""

import asyncio
import contextlib
from collections.abc import Callable
from pathlib import Path
from typing import Final, NamedTuple

from vrts.live.entrance.by_hand import working_code
from vrts.live.entrance.class_code import ClassCode, Guess, keep_code, kept_code
from vrts.live.entrance.entries import Entries, Lately
from vrts.live.entrance.guessing import left_after
from vrts.live.entrance.log_ins import LogIns
from vrts.live.lasting.clock import steady, wall
from vrts.live.store import links
from vrts.live.store.accounts import LINK_S, MANY, add_link
from vrts.live.store.database import Connection, Database, Failed
from vrts.live.store.guests import Crowd, crowd, unused
from vrts.live.store.links import KeptLink
from vrts.live.tokens import digest, grouped, new_token

AHEAD: Final = 1000  # wrong guesses that the database holds ahead of what was counted


class Shown(NamedTuple):
    """What a supervisor sees of the ways in."""

    code: str  # in groups; empty: there is none
    url: str  # with the code
    wrong: int  # guesses at class codes so far
    left: int  # before the code becomes longer
    links: list[KeptLink]  # the class code first
    lately: Lately
    crowd: Crowd


class WaysIn:
    """The ways into one server."""

    def __init__(self, folder: Path, database: Database, address: str, *, has_code: bool) -> None:
        """Take the ways that are there.

        Args:
            folder: Of the server; the code stands in it.
            database: Of the server.
            address: Where browsers find the server, without a slash at the end.
            has_code: Whether there may be a class code at all.
        """
        self.entries = Entries()
        self.log_ins = LogIns()
        self.code = ClassCode("", 0)
        self.changed: Callable[[], None] = _nothing  # is called when the code is another one
        self._folder = folder
        self._database = database
        self.address = address
        self._has_code = has_code
        self._ahead = 0
        self._kept = ""  # the code that the database knows
        self._renewing = asyncio.Lock()

    async def open(self) -> None:
        """Read what is kept; make a code where there is none that works."""
        folder, wanted, now = self._folder, self._has_code, wall()

        def read(connection: Connection) -> tuple[str, int, list[int]]:
            text = working_code(folder, connection, now, wanted=wanted)
            return text, links.wrong_guesses(connection), unused(connection)

        text, self._ahead, waiting = await self._database.do(read)
        self.code, self._kept = ClassCode(text, self._ahead), text
        self.entries.remember(waiting)

    def url(self, token: str = "") -> str:
        """Return the address that lets in by a token, without one by the code."""
        found = token or self.code.text
        return f"{self.address}/#enter={found}" if found else ""

    # --- guesses ---------------------------------------------------------------------------------

    async def guess(self, typed: str) -> Guess:
        """Answer what was typed as a class code; who is right never waits for who is wrong."""
        while self.code.wrong >= self._ahead:  # so that a count is kept before it is made
            await self._count_ahead(self.code.wrong + AHEAD)
        found = self.code.guess(typed)
        if self.code.used_up:
            await self.renew_code()
        return found

    async def _count_ahead(self, count: int) -> None:
        await self._database.do(lambda c: links.keep_wrong_guesses(c, count))
        self._ahead = max(self._ahead, count)

    # --- what supervisors do ---------------------------------------------------------------------

    async def renew_code(self, *, none: bool = False, away: bool = False) -> None:
        """Have another code; the one of before lets nobody in from now on.

        Args:
            none: Have no code instead.
            away: Send those away who came in by the code of before.

        Raises:
            Failed, OSError: It cannot be kept, so the code of before is the code again.
        """
        text = "" if none else self.code.fresh()
        self.code.replace(text)  # first of all: no guess at the old one is right any more
        self.changed()
        folder, now = self._folder, wall()

        def renew(connection: Connection) -> None:
            keep_code(folder, text)
            links.replace_code(connection, text, now, away=away)

        async with self._renewing:  # one after another
            try:
                await self._database.do(renew)
            except (Failed, OSError):
                with contextlib.suppress(OSError):
                    keep_code(folder, self._kept)
                if self.code.text == text:  # it was not renewed once more meanwhile
                    self.code.replace(self._kept)
                    self.changed()
                raise
            self._kept = text

    async def make_link(self, room: str) -> str:
        """Make a link that lets many into a room, under their names; return its address."""
        token, now = new_token(), wall()
        await self._database.do(
            lambda c: add_link(c, token, now + LINK_S, room=room, uses=MANY, made=now)
        )
        return self.url(token)

    async def end(self, id_: str, *, away: bool = False, renew: bool = False) -> str | None:
        """Let nobody in by a link or the code any more.

        Args:
            id_: What it is called.
            away: Send those away who came in by it.
            renew: Have another one in its place.

        Returns:
            The address of the new one, empty without one; None: there is no such link any more.
        """
        now = wall()
        found = await self._database.do(lambda c: links.link(c, id_, now))
        if found is None:
            return None
        if found.code:
            await self.renew_code(none=not renew, away=away)
            return self.url()
        await self._database.do(lambda c: links.end_link(c, id_, now, away=away))
        return await self.make_link(found.room) if renew and found.room else ""

    async def shown(self) -> Shown:
        """Return what a supervisor sees."""
        now = wall()

        def look(connection: Connection) -> tuple[list[KeptLink], Crowd]:
            return links.links(connection, now), crowd(connection, now)

        kept, guests = await self._database.do(look)
        code = self.code
        lately = self.entries.lately(steady())
        left = left_after(code.wrong)
        return Shown(grouped(code.text), self.url(), code.wrong, left, kept, lately, guests)

    async def look(self) -> None:
        """Take over a code that was renewed or ended from the command line."""
        changes = self.code.changes
        kept = await self._database.do(links.code_now)
        if self._renewing.locked() or changes != self.code.changes:
            return  # it is being renewed here
        if kept == (digest(self.code.text) if self.code.text else None):
            return
        text = kept_code(self._folder) if kept else ""
        if text and digest(text) != kept:
            return  # it is being written
        self.code.replace(text)
        self._kept = text
        self.changed()


def _nothing() -> None:
    """Tell nobody."""
