"""What a room remembers for those who come back."""

from vrts.live.control import ControlRight
from vrts.live.member import Member
from vrts.live.protocol import Chat
from vrts.live.room import REMEMBERED, REMEMBERED_BYTES, Room
from vrts.live.store.accounts import Account
from vrts.live.store.rooms import KeptRoom


def told(count: int, length: int) -> tuple[Room, list[bytes]]:
    """Return a room in which so much was said, and what somebody is sent who missed it all."""
    room = Room(KeptRoom("r", "Room", "cans-on-bases", 1, True, 0.0, 120.0), control=ControlRight())
    for _ in range(count):
        number = room.next_number()
        room.tell(Chat(number, 0.0, "p", "Anna", "x" * length, False), number)
    member = Member(Account(1, "Ben", False, None), "r")
    return room, room.missed(member, 0)


def test_the_last_messages_are_remembered_and_not_all() -> None:
    room, missed = told(REMEMBERED + 500, 10)
    assert len(missed) == REMEMBERED
    assert room.remembers(500)
    assert not room.remembers(499)
    assert not room.remembers(REMEMBERED + 501)


def test_long_messages_are_fewer() -> None:
    _, missed = told(300, 20_000)
    assert REMEMBERED_BYTES - 21_000 < sum(map(len, missed)) <= REMEMBERED_BYTES
