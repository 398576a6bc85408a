"""Which robots of their own people of a course have and may open, and who may enter them."""

from collections.abc import Iterable
from typing import Final, NamedTuple

from vrts.course.course import Assignment, Course
from vrts.course.facts import facts_of
from vrts.course.variants.own_variants import OwnVariants
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import send_away
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.opening import close
from vrts.live.rooms.own.hands import leads
from vrts.live.rooms.own.making import Making, Wanted
from vrts.live.rooms.room import Room
from vrts.live.store.accounts import Account
from vrts.live.store.course.own_rooms import all_members
from vrts.live.store.course.people import Person
from vrts.pipeline.files import CannotRead

AGAIN_S: Final = 5.0  # how often it is looked who is in which team
MOST_FOUND: Final = 30  # rooms of one answer


class Choice(NamedTuple):
    """A robot that somebody may open."""

    scene: str  # of the set; for an assignment its id
    title: str
    assignment: bool
    team: str = ""  # who shares it; empty: it is for one alone
    room: str = ""  # id; empty: it was never opened
    asleep: bool = True


class Found(NamedTuple):
    """Somebody's robot, as those see it who lead."""

    room: str
    name: str
    whose: str
    title: str
    asleep: bool
    people: int
    hand: bool


class OwnRobots:
    """The robots of their own of a course."""

    def __init__(self, course: Course, hub: Hub, variants: OwnVariants) -> None:
        """Serve a course; `variants` knows who has which."""
        self._course = course
        self._variants = variants
        self._hub = hub
        self._making = Making(hub, course.limits)
        self._titles: dict[str, str] = {}
        self._looked = 0.0

    def follow(self, course: Course) -> None:
        """Follow a course whose file has changed."""
        self._course = course
        self._making.limits = course.limits
        self._titles = {one.id: _title(one) for one in course.assignments}

    def choices(self, account: Account, person: Person | None, now: float) -> list[Choice]:
        """Return the robots that somebody may open; `now` is Unix time [s]."""
        found: list[Choice] = []
        for wanted in self._all_wanted(account, person, now):
            room = self._making.there(wanted)
            there = ("", True) if room is None else (room.id, room.asleep)
            is_task = wanted.assignment != ""
            found.append(Choice(wanted.scene, wanted.title, is_task, wanted.team, *there))
        return found

    async def open(self, account: Account, person: Person | None, scene: str, now: float) -> Room:
        """Return somebody's robot in a scene or for an assignment, made where there is none.

        Raises:
            NotObeyed: They may have none there.
        """
        wanted = next(
            (one for one in self._all_wanted(account, person, now) if one.scene == scene), None
        )
        if wanted is None:
            if not self._course.own_robots:
                raise NotObeyed("own", "this course has no robots of one's own")
            if not _belongs(account, person):
                raise NotObeyed("role", "robots of one's own are for those on a list of the course")
            raise NotObeyed("scene", "there is no such scene or assignment, or it is not open yet")
        return await self._making.room(await self._varied(wanted))

    async def _varied(self, wanted: Wanted) -> Wanted:
        """Return a robot with the variant of its task that those have whose it is.

        Raises:
            NotObeyed: They cannot have it.
        """
        task = next((one for one in self._course.assignments if one.id == wanted.assignment), None)
        if task is None:
            return wanted
        try:
            own = await self._variants.of(task, wanted.account)
        except CannotRead as problem:
            raise NotObeyed("scene", problem.message) from problem
        if own.problem:
            raise NotObeyed("scene", own.problem)
        return wanted._replace(variant=own.tag)

    def found(self, account: Account, words: str, begin: int) -> tuple[list[Found], int]:
        """Return some robots in whose name words stand, and how many there are in all."""
        wanted = words.casefold().split()
        rooms = self._hub.rooms.values()
        own = [room for room in rooms if room.own is not None and leads(account, room)]
        fits = [room for room in own if all(w in room.kept.name.casefold() for w in wanted)]
        fits.sort(key=lambda room: (room.asleep, room.kept.name.casefold()))
        return [_found(room) for room in fits[begin : begin + MOST_FOUND]], len(fits)

    async def look(self, now: float) -> None:
        """See who belongs to which room; `now` only goes on [s]."""
        if now - self._looked < AGAIN_S:
            return
        self._looked = now
        known = await self._hub.database.do(all_members)
        for room in list(self._hub.rooms.values()):
            if room.own is None or room.id not in known:
                continue
            own, owners = known[room.id]
            if owners != room.owners:
                room.owners = owners
                for member in list(room.members.values()):
                    if not (leads(member.account, room) or member.account.id in owners):
                        send_away(self._hub, member, "room", "this robot is not yours any more")
                self._hub.rooms_changed(room)
            if room.own.hand_by in owners:  # else who raised it was purged, or left the team
                up = room.own
                own = own._replace(hand_at=up.hand_at, hand_by=up.hand_by, hand_text=up.hand_text)
            else:
                own = own._replace(hand_at=0.0, hand_by=None, hand_text="")
            room.own = own
            if not own.team and not owners:  # who had it was purged
                await close(self._hub, room)

    def _all_wanted(self, account: Account, person: Person | None, now: float) -> Iterable[Wanted]:
        if not self._course.own_robots or not _belongs(account, person):
            return
        teaches = account.leads_any
        team = "" if person is None else person.team
        tasks = {one.id: one for one in self._course.assignments}
        for one in self._course.assignments:
            if not teaches and one.opens is not None and one.opens.timestamp() > now:
                continue
            shared = team if one.team else ""
            name = shared or account.name
            yield Wanted(account.id, name, one.id, self._titles[one.id], one.id, shared)
        for place in self._hub.settings.places:
            if place.id not in tasks:
                yield Wanted(account.id, account.name, place.id, place.id)


def _belongs(account: Account, person: Person | None) -> bool:
    return account.supervisor or (person is not None and person.listed)


def _title(assignment: Assignment) -> str:
    try:
        return facts_of(assignment).title
    except CannotRead:  # who marks tells of it
        return assignment.id


def _found(room: Room) -> Found:
    hand = room.own is not None and room.own.hand_at > 0.0
    title = room.task or room.kept.scene
    return Found(room.id, room.kept.name, room.whose, title, room.asleep, room.crowd, hand)
