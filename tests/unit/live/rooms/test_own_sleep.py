"""Robots of their own: which are awake, which give way, who may enter, what hands tell."""

import asyncio
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

import pytest

from vrts.live.actions import Typed
from vrts.live.places import places_of
from vrts.live.protocol.from_anybody import Command
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import room_for
from vrts.live.rooms.hub import Hub, may_enter, may_see
from vrts.live.rooms.member import Member
from vrts.live.rooms.obeying import obey
from vrts.live.rooms.opening import make_room
from vrts.live.rooms.own import sleeping
from vrts.live.rooms.own.limits import OwnLimits
from vrts.live.rooms.own.making import Making, Wanted
from vrts.live.rooms.own.sleeping import Sleeper, at_rest
from vrts.live.rooms.process import Head, SessionProcess
from vrts.live.rooms.room import Room
from vrts.live.rooms.sessions import Sessions
from vrts.live.session.channel.messages import Start
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account, add_account
from vrts.live.store.database import Database
from vrts.live.store.rooms import KeptRoom

LIMITS = OwnLimits(each=2, all=4, awake=2, each_awake=1)


class AtRest(SessionProcess):
    """A session that may sleep whenever it is asked; there is no process."""

    async def sleep(self) -> Head:
        """Say so."""
        return Head("slept")


def ready(room: Room, mode: str) -> None:
    """Have the session of a room be one that does something; nothing is started."""
    process = AtRest(Start(1, "", "", "", ""), lambda _: None, lambda _, __: None)
    process.ready = True
    room.process, room.rest = process, "awake"
    room.status = f'{{"mode":"{mode}"}}'.encode()


class Course:
    """A hub with robots of their own."""

    def __init__(self, folder: Path) -> None:
        self.hub = Hub(
            Settings(folder, places_of(("cans-on-bases", "around-obstacles"))),
            Database(folder / "db.sqlite"),
        )
        self.sessions = Sessions(self.hub)
        self.sleeper = Sleeper(self.hub, self.sessions, LIMITS)
        self.making = Making(self.hub, LIMITS)

    async def somebody(self, name: str) -> Account:
        return await self.hub.database.do(lambda c: add_account(c, name, 0.0))

    async def fallen(self, room: Room) -> None:
        """Wait until a robot sleeps."""
        while not room.asleep:
            await self.hub.database.do(lambda _: None)
        await self.hub.database.do(lambda _: None)

    async def robot(self, account: Account, scene: str = "cans-on-bases") -> Room:
        return await self.making.room(Wanted(account.id, account.name, scene, scene))


def within(folder: Path, work: Callable[[Course], Coroutine[Any, Any, None]]) -> None:
    async def run() -> None:
        course = Course(folder)
        try:
            await make_room(course.hub, "Class", "cans-on-bases")
            await work(course)
        finally:
            course.hub.rooms.clear()
            await course.hub.stop()

    asyncio.run(run())


def test_a_robot_is_its_owners_and_is_made_once(tmp_path: Path) -> None:
    async def work(course: Course) -> None:
        anna, bo = await course.somebody("Anna"), await course.somebody("Bo")
        boss = Account(99, "Boss", True, None)
        rooms = await asyncio.gather(*[course.robot(anna) for _ in range(3)])
        (room,) = set(rooms)
        assert (room.asleep, room.whose, room.kept.name) == (True, "Anna", "cans-on-bases, Anna")
        assert [may_enter(one, room) for one in (anna, bo, boss)] == [True, False, True]
        assert [may_see(one, room) for one in (anna, bo, boss)] == [True, False, False]
        with pytest.raises(NotObeyed, match="no such room"):
            room_for(course.hub, bo, room.id)
        assert room_for(course.hub, bo, "").kept.name == "Class"
        listed = [[row.own for row in course.hub.entries(one)] for one in (anna, bo, boss)]
        assert listed == [["", "Anna"], [""], [""]], "lists stay short"

    within(tmp_path, work)


def test_who_makes_robots_in_a_loop_comes_to_an_end(tmp_path: Path) -> None:
    async def work(course: Course) -> None:
        anna = await course.somebody("Anna")
        for scene in ("cans-on-bases", "around-obstacles"):
            await course.robot(anna, scene)
        with pytest.raises(NotObeyed, match="you have 2 robots already"):
            await course.making.room(Wanted(anna.id, "Anna", "around-obstacles", "Tower", "other"))
        for name in ("Bo", "Cy"):
            await course.robot(await course.somebody(name))
        with pytest.raises(NotObeyed, match="the course has 4 robots already"):
            await course.robot(await course.somebody("Di"))

    within(tmp_path, work)


def test_the_robot_that_was_used_longest_ago_makes_room_unless_it_works(tmp_path: Path) -> None:
    async def work(course: Course) -> None:
        people = [await course.somebody(name) for name in ("Anna", "Bo", "Cy")]
        anna, bo, cy = [await course.robot(one) for one in people]
        ready(anna, "running")
        ready(bo, "idle")
        anna.used, bo.used = 1.0, 2.0
        course.sleeper.wake(cy, people[2])
        await course.fallen(bo)
        assert [room.asleep for room in (anna, bo, cy)] == [False, True, False]
        ready(cy, "waiting")
        course.sleeper.wake(bo, people[1])
        assert bo.asleep
        assert bo.waits is not None
        assert bo.waits.why == sleeping.ALL_BUSY.format(2)

    within(tmp_path, work)


def test_a_command_wakes_a_robot_and_waits_for_it_or_is_told_why_not(tmp_path: Path) -> None:
    async def work(course: Course) -> None:
        people = [await course.somebody(name) for name in ("Anna", "Bo", "Cy")]
        anna, bo, cy = [await course.robot(one) for one in people]
        ready(anna, "running")
        ready(bo, "running")
        course.hub.sleeping = course.sleeper
        member = Member(people[2], cy.id)
        cy.members[member.id] = member
        cy.control.request(member.id, 0.0)

        async def command(number: int) -> None:
            given = Command(cy.control.lease, number, Typed("WHERE"))
            await obey(course.hub, course.sessions, member, given)

        with pytest.raises(NotObeyed, match="all 2 robots"):
            await command(1)
        assert (cy.asleep, cy.held) == (True, [])
        ready(bo, "stopped")
        course.sleeper.wake(cy, people[2])  # as soon as it can: `bo` gives way
        await course.sleeper.beat()
        cy.rest = "waking"
        await command(2)
        assert [held.of for held in cy.held] == [2], "nobody waits in the server for it"

    within(tmp_path, work)


def test_nobody_keeps_others_out_by_robots_of_their_own(tmp_path: Path) -> None:
    async def work(course: Course) -> None:
        anna = await course.somebody("Anna")
        first, second = await course.robot(anna), await course.robot(anna, "around-obstacles")
        ready(first, "running")
        course.sleeper.wake(second, anna)
        assert second.waits is not None
        assert second.waits.why == sleeping.OWN_BUSY.format(1)
        ready(first, "stopped")
        await course.sleeper.beat()  # nobody is in it any more
        assert second.asleep
        refused: list[str] = []
        for turn in range(12):
            room = (first, second)[turn % 2]
            try:
                course.sleeper.wake(room, anna)
                ready(room, "idle")
                await course.sessions.sleep(room)
            except NotObeyed as problem:
                refused.append(problem.code)
        assert set(refused) == {"rate"}

    within(tmp_path, work)


def test_a_robot_sleeps_when_nobody_needs_it_and_what_runs_on_is_stopped(tmp_path: Path) -> None:
    async def work(course: Course) -> None:
        anna = await course.somebody("Anna")
        room = await course.robot(anna)
        ready(room, "running")
        await course.sleeper.beat()
        since = room.empty_since
        assert since is not None
        room.used = room.empty_since = since - LIMITS.empty_s - 1.0
        await course.sleeper.beat()
        assert not room.asleep, "a program runs"
        assert not room.asked
        room.used = room.empty_since = since - LIMITS.empty_s - LIMITS.program_s - 1.0
        await course.sleeper.beat()
        assert [one.kind for one in room.asked.values()] == ["panic"]
        room.asked.clear()
        room.halting = False
        ready(room, "idle")
        await course.sleeper.beat()
        await course.fallen(room)
        assert [line.text for line, _ in room.chat] == [sleeping.STOPPED.format(35)]

    within(tmp_path, work)


def test_a_robot_rests_only_where_nothing_goes_on() -> None:
    room = Room(KeptRoom("r", "R", "around-obstacles", 1, True, 0.0, 0.0))
    assert not at_rest(room), "nothing is known"
    found: dict[str, bool] = {}
    for mode in ("idle", "stopped", "moving", "running", "waiting", "jogging", "braking"):
        ready(room, mode)
        found[mode] = at_rest(room)
    assert [mode for mode, rests in found.items() if rests] == ["idle", "stopped"]
