"""Who comes in, whose place goes, and who waits after wrong passwords; in memory and database."""

import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

from vrts.live.entrance.entries import HOUR_S, UNUSED, Entries, group
from vrts.live.entrance.log_ins import FREE, LONGEST_S, LogIns
from vrts.live.store import accounts
from vrts.live.store.accounts import LOGIN_S, MANY, add_account, add_link, knows
from vrts.live.store.bars import use_browser
from vrts.live.store.database import opened
from vrts.live.store.guests import (
    Crowd,
    come_in,
    crowd,
    give_up_unused,
    make_place,
    saw,
    unused,
)
from vrts.live.store.log import purge
from vrts.live.store.programs import Version, own_shelf, programs, room_shelf, save
from vrts.live.tokens import digest

HALL, CAMPUS, HOME = "192.0.2.1", "192.0.2.9", "2001:db8:1:2:3:4:5:6"


@pytest.fixture
def connection(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    found = opened(tmp_path / "live.sqlite")
    yield found
    found.close()


def test_a_flood_takes_away_places_of_the_flood() -> None:
    entries = Entries()
    for account in range(10):
        assert entries.entered(account, HALL, 0.0) == []
    gone = [entries.entered(account, CAMPUS, 1.0) for account in range(100, 100 + 3 * UNUSED)]
    lost = [account for one in gone for account in one]
    assert len(lost) == 3 * UNUSED + 10 - UNUSED
    assert lost[:3] == [100, 101, 102], "the oldest first"
    assert min(lost) >= 100, "nobody of another address"


def test_who_joined_a_room_keeps_the_place_at_the_address_of_a_flood_too() -> None:
    entries = Entries()
    for account in range(10):
        entries.entered(account, HALL, 0.0)
        assert entries.joined(account)
        assert not entries.joined(account), "once"
    lost = [gone for n in range(2 * UNUSED) for gone in entries.entered(100 + n, HALL, 1.0)]
    assert len(lost) == UNUSED
    assert min(lost) >= 100


def test_a_supervisor_sees_how_many_came_from_where() -> None:
    entries = Entries()
    for n in range(7):
        entries.entered(n, HALL, 0.0)
    for n in range(3):
        entries.entered(10 + n, HOME, 5.0 * HOUR_S)
    lately = entries.lately(5.1 * HOUR_S)
    assert (lately.hour, lately.day) == (3, 10)
    assert [tuple(row) for row in lately.most] == [("2001:db8:1:2::/64", 3, 3), (HALL, 0, 7)]
    assert entries.lately(40.0 * HOUR_S).day == 0, "it is forgotten after a day"


def test_one_machine_counts_as_one_address() -> None:
    assert group("2001:db8:1:2::7") == group(HOME) == "2001:db8:1:2::/64"
    assert group("::ffff:192.0.2.1") == HALL
    assert group("nonsense" * 20) == ("nonsense" * 20)[:64]


def guest(connection: sqlite3.Connection, name: str, created: float) -> int:
    return add_account(connection, name, created).id


def test_the_place_goes_of_who_needs_it_least(connection: sqlite3.Connection) -> None:
    now = LOGIN_S + 1000.0
    teacher = add_account(connection, "Teacher", 0.0, supervisor=True).id
    local = add_account(connection, "Local", 0.0, password="x").id
    expired = guest(connection, "Expired", 10.0)
    saw(connection, expired, 20.0, 5000.0)
    here, long_ago, lately = (guest(connection, name, now - 900.0) for name in "abc")
    brief = guest(connection, "Brief", now - 300.0)
    never = guest(connection, "Never", now - 200.0)
    for account, seen, stayed in (
        (here, now - 900.0, 0.0),
        (long_ago, now - 800.0, 500.0),
        (lately, now - 10.0, 500.0),
        (brief, now - 5.0, 3.0),
    ):
        saw(connection, account, seen, stayed)
    assert make_place(connection, (here,), now, most=50) is None, "there is room"
    gone = [make_place(connection, (here,), now, most=0) for _ in range(6)]
    assert gone == [expired, never, brief, long_ago, lately, None]
    left = {row[0] for row in connection.execute("SELECT id FROM account")}
    assert left == {teacher, local, here}


def test_a_right_code_always_finds_a_place_and_a_wrong_one_takes_none(
    connection: sqlite3.Connection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(accounts, "GUESTS", 2)
    for name in ("Lee", "Kim"):  # who have a password take no places of guests
        add_account(connection, name, 0.0, password="x")
    add_link(connection, "right", 100.0, uses=MANY)
    first = come_in(connection, "right", "One", 1.0, here=(), most=2)
    second = come_in(connection, "right", "Two", 2.0, here=(), most=2)
    assert first is not None
    assert second is not None
    assert come_in(connection, "wrong", "Eve", 3.0, here=(), most=2) is None
    assert come_in(connection, "right", "Late", 101.0, here=(), most=2) is None
    assert unused(connection) == [first.id, second.id]
    third = come_in(connection, "right", "Three", 4.0, here=(first.id,), most=2)
    assert third is not None
    assert unused(connection) == [first.id, third.id]


def test_the_programs_that_only_a_guest_sees_go_with_the_place(
    connection: sqlite3.Connection,
) -> None:
    one, two, stays = (guest(connection, name, 1.0) for name in ("One", "Two", "Stays"))
    for account in (one, two, stays):
        save(connection, own_shelf(account), Version("own", 0, 1.0, account, "x", 0), "text", 0)
    room = room_shelf("r")
    save(connection, room, Version("shared", 0, 1.0, one, "One", 0), "text", 0)
    saw(connection, stays, 2.0, 500.0)
    give_up_unused(connection, [one, stays])
    assert make_place(connection, (), 2.0, most=0) == two
    kept = [len(programs(connection, own_shelf(account))) for account in (one, two, stays)]
    assert kept == [0, 0, 1]
    assert [version.saver for version in programs(connection, room)] == ["One"]


def test_only_who_never_joined_is_given_up_with_a_flood(connection: sqlite3.Connection) -> None:
    one, two = guest(connection, "One", 1.0), guest(connection, "Two", 2.0)
    saw(connection, two, 3.0)
    assert unused(connection) == [one]
    assert crowd(connection, 4.0) == Crowd(2, 1, 0)
    assert crowd(connection, 4.0 + 8 * 86_400.0) == Crowd(2, 1, 1)
    give_up_unused(connection, [one, two])
    assert unused(connection) == []
    assert crowd(connection, 4.0) == Crowd(1, 0, 0)


def test_a_number_never_becomes_somebody_else_s(connection: sqlite3.Connection) -> None:
    first = guest(connection, "One", 1.0)
    purge(connection, first)
    assert guest(connection, "Two", 2.0) > first


def test_wrong_passwords_hold_up_their_own_source_only() -> None:
    tries = LogIns()
    for _ in range(FREE):
        assert tries.wait_s(1, "lee", HALL, 0.0) == 0.0
        tries.wrong(1, "lee", HALL, 0.0)
    assert tries.wait_s(1, "lee", HALL, 0.0) == 1.0
    assert tries.wait_s(1, "lee", CAMPUS, 0.0) == 0.0, "elsewhere"
    assert tries.wait_s(1, "lee", "browser 7", 0.0) == 0.0, "a browser that is known"
    assert tries.wait_s(2, "kim", HALL, 0.0) == 0.0, "another account at the same address"
    for _ in range(50):
        tries.wrong(1, "lee", HALL, 0.0)
    assert tries.wait_s(1, "lee", HALL, 0.0) == LONGEST_S
    assert tries.wait_s(1, "lee", HALL, LONGEST_S) == 0.0
    tries.right(1, HALL)
    assert tries.wait_s(1, "lee", HALL, 0.0) == 0.0


def test_nobody_learns_which_accounts_there_are() -> None:
    tries = LogIns()
    for account, name in ((1, "lee"), (None, "nobody")):
        waits: list[float] = []
        for _ in range(FREE + 3):
            tries.wrong(account, name, HALL, 0.0)
            waits.append(tries.wait_s(account, name, HALL, 0.0))
        assert waits == [0.0] * (FREE - 1) + [1.0, 2.0, 4.0, 8.0]


def test_a_try_that_nobody_looked_at_is_not_counted() -> None:
    tries = LogIns()
    for _ in range(3 * FREE):
        tries.wrong(1, "lee", HALL, 0.0)
        tries.take_back(1, "lee", HALL)
    assert tries.wait_s(1, "lee", HALL, 0.0) == 0.0


def test_browsers_in_which_somebody_logged_in_are_known(connection: sqlite3.Connection) -> None:
    lee = add_account(connection, "Lee", 0.0, password="x").id
    kim = add_account(connection, "Kim", 0.0, password="x").id
    use_browser(connection, (lee,), digest("secret"))
    assert knows(connection, lee, digest("secret"))
    assert not knows(connection, kim, digest("secret"))
    assert not knows(connection, lee, digest("another"))
