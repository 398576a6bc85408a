"""What a room remembers for those who come back."""

from pathlib import Path
from typing import cast

from vrts.live.door import Door
from vrts.live.lasting.clock import steady
from vrts.live.places import places_of
from vrts.live.protocol.from_server import Chat
from vrts.live.rooms.control import ControlRight
from vrts.live.rooms.entering import settle
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import FULL_RATE, Member
from vrts.live.rooms.process import SessionProcess
from vrts.live.rooms.pulse import AWAY_S
from vrts.live.rooms.room import UNWATCHED, Room
from vrts.live.rooms.telling.sent import REMEMBERED, REMEMBERED_BYTES, REMEMBERED_S
from vrts.live.session.channel.messages import Start
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account
from vrts.live.store.database import Database
from vrts.live.store.rooms import KeptRoom


def told(count: int, length: int) -> tuple[Room, list[bytes]]:
    """Return a room in which so much was said, and what somebody is sent who missed it all."""
    room = Room(KeptRoom("r", "Room", "cans-on-bases", 1, True, 0.0, 120.0), control=ControlRight())
    for _ in range(count):
        number = room.next_number()
        room.tell(Chat(number, 0.0, "p", "Anna", "x" * length, False), number)
    member = Member(Account(1, "Ben", False, None), "r")
    return room, room.sent.missed(member, 0)


def test_the_last_messages_are_remembered_and_not_all() -> None:
    room, missed = told(REMEMBERED + 500, 10)
    assert len(missed) == REMEMBERED
    assert room.sent.covers(500, room.number)
    assert not room.sent.covers(499, room.number)
    assert not room.sent.covers(REMEMBERED + 501, room.number)


def test_who_has_waited_for_a_snapshot_is_told_who_is_here(tmp_path: Path) -> None:
    room, _ = told(0, 0)
    settings = Settings(tmp_path, places_of(("cans-on-bases",)))
    hub = Hub(settings, Database(tmp_path / "live.sqlite"))
    try:
        room.joining.append(Member(Account(1, "Ben", False, None), room.id))
        room.show_people({})  # reaches nobody who waits
        settle(hub, room, b"null")
        assert room.crowd_changed, "everybody is told again"
    finally:
        hub.database.close()


def test_fewer_frames_are_made_where_nobody_looks(tmp_path: Path) -> None:
    room, _ = told(0, 0)
    room.process = process = SessionProcess(Start(1, str(tmp_path)), _hear, _hear)
    process.ready = True
    member = room.members["m"] = Member(Account(1, "Ben", False, None), "r", rate=60)
    room.set_pace()
    assert (room.pace, process.seldom) == (UNWATCHED, True), "who is away sees nothing"
    member.door = cast("Door", "open")
    room.set_pace()
    assert (room.pace, process.seldom) == (60, False)
    member.rate = 1
    room.set_pace()
    assert room.pace == FULL_RATE, "news come with frames"


def _hear(*_: object) -> None:
    """Tell nobody."""


def test_long_messages_are_fewer() -> None:
    _, missed = told(300, 20_000)
    assert REMEMBERED_BYTES - 21_000 < sum(map(len, missed)) <= REMEMBERED_BYTES


def test_nothing_is_remembered_for_longer_than_places_are_kept() -> None:
    room, _ = told(20, 10)
    room.sent.forget_old(steady() + AWAY_S + 60.0)
    assert room.sent.covers(5, room.number), (
        "who was away as long as one may be has their place still"
    )
    room.sent.forget_old(steady() + REMEMBERED_S + 1.0)
    assert not room.sent.covers(19, room.number)
    assert room.sent.covers(20, room.number), "nothing was missed"
    number = room.next_number()
    room.tell(Chat(number, 0.0, "p", "Anna", "more", False), number)
    assert room.sent.covers(20, room.number)
    assert not room.sent.covers(19, room.number)
