"""Places and connections are only so many: who is away for longest, or has most, makes way."""

from collections.abc import Iterator
from pathlib import Path
from typing import cast

import pytest

from vrts.live import limits
from vrts.live.door import Door
from vrts.live.places import places_of
from vrts.live.refusal import NotObeyed
from vrts.live.rooms.entering import make_way, make_way_for_one
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.member import Member
from vrts.live.rooms.room import Room
from vrts.live.settings import Settings
from vrts.live.store.accounts import Account
from vrts.live.store.database import Database
from vrts.live.store.rooms import KeptRoom

NEW = Account(99, "New", False, None)


class Ends:
    """A door that is told to end."""

    def __init__(self) -> None:
        self.ended = False

    def send(self, frame: bytes) -> None:
        """Take a frame."""

    def finish(self) -> None:
        self.ended = True


@pytest.fixture
def hub(tmp_path: Path) -> Iterator[Hub]:
    found = Hub(
        Settings(tmp_path, places_of(("cans-on-bases",))), Database(tmp_path / "live.sqlite")
    )
    found.rooms["r"] = Room(KeptRoom("r", "Class", "cans-on-bases", 1, True, 0.0, 0.0))
    yield found
    found.database.close()


def comes(hub: Hub, account: int, *, away_since: float = 0.0, address: str = "192.0.2.1") -> Member:
    """Put somebody into the room; one who is away has no door."""
    door = None if away_since else cast("Door", Ends())
    member = Member(Account(account, f"n{account}", False, None), "r", door=door)
    member.away_since, member.address = away_since, address
    hub.rooms["r"].members[member.id] = member
    return member


def test_a_full_room_gives_up_the_place_of_who_is_away_for_longest(
    hub: Hub, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "PLACES", 4)
    room = hub.rooms["r"]
    here, long_away, away = (
        comes(hub, 1),
        comes(hub, 2, away_since=5.0),
        comes(hub, 3, away_since=9),
    )
    make_way(hub, room, NEW)
    assert len(room.members) == 3, "there was room"
    comes(hub, 4)
    make_way(hub, room, NEW)
    assert long_away.id not in room.members
    comes(hub, 5)
    make_way(hub, room, NEW)
    assert away.id not in room.members
    assert here.id in room.members
    assert len(room.members) == 3


def test_a_room_full_of_people_who_take_no_more_than_a_share_takes_nobody_but_who_leads(
    hub: Hub, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "PLACES", 4)
    room = hub.rooms["r"]
    for number in range(4):
        comes(hub, number, address=f"192.0.2.{number}")
    with pytest.raises(NotObeyed, match="all 4 places"):
        make_way(hub, room, NEW, "198.51.100.1")
    make_way(hub, room, Account(98, "Boss", True, None), "198.51.100.1")
    assert len(room.members) == 4


@pytest.mark.parametrize("address", ["192.0.2.1", "198.51.100.1"])
def test_nobody_is_kept_out_of_a_room_by_who_floods_it(
    hub: Hub, monkeypatch: pytest.MonkeyPatch, address: str
) -> None:
    monkeypatch.setattr(limits, "PLACES", 40)
    room = hub.rooms["r"]
    honest = [comes(hub, 100 + n) for n in range(10)]  # a hall behind one address
    for number in range(30):
        comes(hub, number // 6)  # of five accounts in it
    operator = room.members[next(reversed(room.members))]
    room.control.request(operator.id, 0.0)
    for number in range(15):
        make_way(hub, room, Account(200 + number, "New", False, None), address)
        comes(hub, 200 + number, address=address)
        assert len(room.members) == 40
    assert all(one.id in room.members for one in (*honest, operator))


def test_who_dropped_and_operates_keeps_the_place_longer_than_others_who_are_away(
    hub: Hub, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "PLACES", 2)
    room = hub.rooms["r"]
    operator, other = comes(hub, 1, away_since=5.0), comes(hub, 2, away_since=9.0)
    room.control.request(operator.id, 0.0)
    make_way(hub, room, NEW)
    assert operator.id in room.members
    assert other.id not in room.members


def test_the_server_ends_a_connection_of_who_has_most(
    hub: Hub, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "ALL_CONNECTIONS", 5)
    one = comes(hub, 1)
    many = [comes(hub, 2) for _ in range(3)]
    assert make_way_for_one(hub)
    comes(hub, 3)
    assert make_way_for_one(hub)
    room = hub.rooms["r"]
    assert one.id in room.members
    assert sum(member.id in room.members for member in many) == 2
