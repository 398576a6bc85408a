"""Time slots: when they are, also when clocks change; who gets one; and who has control in it."""

import asyncio
from datetime import date
from itertools import pairwise
from pathlib import Path

import pytest

from tests.unit.course.test_course_file import GOOD, folder_with_task, headlines
from vrts.base.source import SourceFile
from vrts.course.course import Course
from vrts.course.course_file import read_course
from vrts.course.robots.slots import Slots
from vrts.course.slot_rules import SlotRules
from vrts.live.places import places_of
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.opening import make_room
from vrts.live.rooms.room import Room
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account, add_account
from vrts.live.store.database import Database

SLOTS = '\n[slots]\ntime_zone = "Europe/Berlin"\n'
RULES = SlotRules("Class", "Europe/Berlin", minutes=60, days=tuple(range(7)), begins=0, ends=360)
MONDAY = 1_796_022_000.0  # 30 November 2026, 08:00 in Berlin


def test_slots_are_read_with_the_course(tmp_path: Path) -> None:
    text = GOOD + SLOTS + 'days = ["mon"]\nhours = "09:00-10:00"\nminutes = 20\nroom = "Lab"\n'
    course, found = read_course(SourceFile("course.toml", text), folder_with_task(tmp_path))
    assert found == ()
    assert course is not None
    assert course.slots == SlotRules("Lab", "Europe/Berlin", 20, (0,), 540, 600)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('time_zone = "Mars/Base"', "there is no time zone `Mars/Base`"),
        ('time_zone = "../../etc/passwd"', "there is no time zone `../../etc/passwd`"),
        ('time_zone = "UTC"\ndays = ["moonday"]', "`moonday` is no day"),
        ('time_zone = "UTC"\nhours = "18-8"', "`18-8` is no span of hours"),
        ('time_zone = "UTC"\nhours = "08:00-24:30"', "`08:00-24:30` is no span of hours"),
        (
            'time_zone = "UTC"\nhours = "08:00-08:10"',
            "no slot of 30 minutes fits into `08:00-08:10`",
        ),
        ('time_zone = "UTC"\nroom = "Attic"', "there is no room `Attic`"),
    ],
)
def test_faults_of_slots_are_told(text: str, told: str, tmp_path: Path) -> None:
    assert headlines(f"{GOOD}\n[slots]\n{text}\n", folder_with_task(tmp_path)) == [told]


def test_a_day_on_which_clocks_change_has_an_hour_less_or_more() -> None:
    counts = [len(list(RULES.of_day(date(2026, 3, day)))) for day in (28, 29, 30)]
    assert counts == [6, 5, 6], "at 02:00 it is 03:00"
    autumn = list(RULES.of_day(date(2026, 10, 25)))
    assert len(autumn) == 7
    for slot, later in pairwise(autumn):
        assert slot.ends - slot.starts == 3600.0
        assert slot.ends == later.starts, "no slot lies over another"


def test_what_can_be_booked_is_what_has_not_ended() -> None:
    rules = SlotRules("Class", "Europe/Berlin", weeks=1)
    assert rules.coming(MONDAY + 60.0)[0].starts == MONDAY, "the one that goes on"
    assert rules.coming(MONDAY + 1800.0)[0].starts == MONDAY + 1800.0
    assert len(rules.coming(MONDAY)) == 5 * 20


class Booking:
    """Slots of a room, and people in it."""

    def __init__(self, folder: Path) -> None:
        self.hub = Hub(
            Settings(folder, places_of(("cans-on-bases",))), Database(folder / "db.sqlite")
        )
        rules = SlotRules("Class", "Europe/Berlin", ahead=2)
        self.slots = Slots(Course(folder, "Robotics", slots=rules), self.hub)
        self.room: Room

    async def come(self, account: Account) -> Member:
        member = Member(account, self.room.id)
        member.door = _Door()  # pyright: ignore[reportAttributeAccessIssue]
        self.room.members[member.id] = member
        return member


class _Door:
    """A connection that nobody reads."""

    def send(self, frame: bytes) -> None:
        """Take it."""

    def latest(self, what: str, frame: bytes) -> None:
        """Take it."""


async def begun(folder: Path, *names: str) -> tuple[Booking, list[Account]]:
    booking = Booking(folder)
    booking.room = await make_room(booking.hub, "Class", "cans-on-bases")
    people = [
        await booking.hub.database.do(lambda c, name=name: add_account(c, name, 0.0))
        for name in names
    ]
    return booking, people


def test_of_two_who_book_at_once_one_gets_it(tmp_path: Path) -> None:
    async def work() -> None:
        booking, (anna, bo) = await begun(tmp_path, "Anna", "Bo")
        slots = booking.slots
        both = [slots.book(who.id, MONDAY, MONDAY) for who in (anna, bo)]
        answers = await asyncio.gather(*both, return_exceptions=True)
        (refused,) = [one for one in answers if one is not None]
        assert isinstance(refused, NotObeyed)
        assert refused.code == "taken"
        (mine,) = [row for row in await slots.table(MONDAY) if row[1] is not None]
        assert mine[0].starts == MONDAY
        first = anna if answers[0] is None else bo
        other = bo if first is anna else anna
        await slots.book(other.id, MONDAY + 1800.0, MONDAY)
        with pytest.raises(NotObeyed, match="not yours"):
            await slots.cancel(other, MONDAY, MONDAY)
        with pytest.raises(NotObeyed, match="somebody else has this time"):
            await slots.move(first, MONDAY, MONDAY + 1800.0, MONDAY)
        whose = {row[0].starts: row[1] for row in await slots.table(MONDAY) if row[1]}
        assert sorted(whose) == [MONDAY, MONDAY + 1800.0], "the one of before stays"
        await slots.move(first, MONDAY, MONDAY + 3600.0, MONDAY)
        await slots.book(first.id, MONDAY, MONDAY)
        with pytest.raises(NotObeyed, match="as many times as you may"):
            await slots.book(first.id, MONDAY + 7200.0, MONDAY)
        with pytest.raises(NotObeyed, match="no time to book"):
            await slots.book(first.id, MONDAY + 7.0, MONDAY)
        await booking.hub.stop()

    asyncio.run(work())


def test_who_has_booked_goes_first_and_others_use_it_meanwhile(tmp_path: Path) -> None:
    async def work() -> None:
        booking, (anna, bo) = await begun(tmp_path, "Anna", "Bo")
        slots, control = booking.slots, booking.room.control
        await slots.book(anna.id, MONDAY, MONDAY - 60.0)
        b = await booking.come(bo)
        control.request(b.id, 0.0)
        await slots.beat(MONDAY + 1.0, 10.0)
        assert control.holder == b.id, "she is away"
        a = await booking.come(anna)
        await slots.beat(MONDAY + 2.0, 11.0)
        assert control.holder == a.id
        control.request(b.id, 12.0)
        control.hand_back(a.id, 13.0)
        await slots.beat(MONDAY + 3.0, 14.0)
        assert control.holder == b.id, "she gave it back"
        control.request(a.id, 15.0)
        await slots.beat(MONDAY + 4.0, 16.0)
        assert control.holder == a.id, "she asks, and goes first"
        control.request(b.id, 17.0)
        await slots.beat(MONDAY + 1800.0, 18.0)
        assert control.holder == b.id, "her time is over, and somebody waits"
        await booking.hub.stop()

    asyncio.run(work())
