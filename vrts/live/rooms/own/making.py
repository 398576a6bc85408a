"""Makes rooms of their own: one for each person or team, and each scene or assignment."""

import asyncio
from typing import NamedTuple

from vrts.live.lasting.clock import steady
from vrts.live.limits import Buckets
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import DISK_HELP, NO_DISK, Hub
from vrts.live.rooms.opening import open_room
from vrts.live.rooms.own.limits import OPENED, OwnLimits
from vrts.live.rooms.room import Room
from vrts.live.store.course.own_rooms import OwnRoom, keep_own_room
from vrts.live.store.database import Connection
from vrts.live.store.rooms import KeptRoom, keep_room
from vrts.live.tokens import new_id

LONGEST_NAME = 64  # characters


class Wanted(NamedTuple):
    """A robot of somebody's own."""

    account: int  # of who opens it
    name: str  # of that account, or of the team
    scene: str  # of the set
    title: str  # of scene or assignment
    assignment: str = ""
    team: str = ""  # empty: for the account alone
    variant: str = ""  # tag of the variant of its task that they have; empty: as it is written


class Making:
    """Makes them one after another, so that nobody has two where one is meant."""

    def __init__(self, hub: Hub, limits: OwnLimits) -> None:
        """Make rooms of a hub."""
        self._hub = hub
        self.limits = limits
        self._one = asyncio.Lock()
        self._opened = Buckets(*OPENED)

    def there(self, wanted: Wanted) -> Room | None:
        """Return the room that is wanted, if it was made before."""
        for room in self._hub.rooms.values():
            own = room.own
            if own is None or own.assignment != wanted.assignment:
                continue
            if own.whose == (wanted.team or wanted.account) and room.kept.scene == wanted.scene:
                return room
        return None

    async def room(self, wanted: Wanted) -> Room:
        """Return a room of somebody's own, made the first time that it is wanted.

        Raises:
            NotObeyed: There are too many, or it cannot be kept.
        """
        async with self._one:
            found = self.there(wanted)
            if found is None:
                return await self._make(wanted)
            if found.own is not None and found.own.variant != wanted.variant:
                found.own = own = found.own._replace(variant=wanted.variant)
                await self._hub.database.do(lambda c: keep_own_room(c, own))
            return found

    async def _make(self, wanted: Wanted) -> Room:
        hub, limits = self._hub, self.limits
        if hub.settings.place(wanted.scene) is None:
            raise NotObeyed("scene", "there is no such scene in the set")
        if hub.journal.problem:
            raise NotObeyed("disk", NO_DISK, DISK_HELP)
        own = [room.own for room in hub.rooms.values() if room.own is not None]
        if sum(one.whose == (wanted.team or wanted.account) for one in own) >= limits.each:
            text = f"you have {limits.each} robots already"
            raise NotObeyed("limit", text, "ask a teacher to close one")
        if len(own) >= limits.all:
            text = f"the course has {limits.all} robots already"
            raise NotObeyed("limit", text, "ask a teacher to close some")
        if not self._opened.take(wanted.account, steady()):
            raise NotObeyed("rate", "you open many robots at once", "wait a few seconds")
        id_, settings = new_id(), hub.settings
        end = f", {wanted.name}"  # whole: a purge has to find the name
        name = (wanted.title[: max(LONGEST_NAME - len(end), 0)] + end).strip(", ")
        place = max((room.kept.place for room in hub.rooms.values()), default=0) + 1
        turns = (settings.turn_s, settings.idle_s) if wanted.team else (0.0, 0.0)
        kept = KeptRoom(id_, name, wanted.scene, place, True, *turns)
        owner = None if wanted.team else wanted.account
        whose = OwnRoom(id_, owner, wanted.team, wanted.assignment, variant=wanted.variant)

        def work(connection: Connection) -> None:
            keep_room(connection, kept)
            keep_own_room(connection, whose)

        await hub.database.do(work)
        room = await open_room(hub, kept)
        hub.rooms_changed(room)
        return room
