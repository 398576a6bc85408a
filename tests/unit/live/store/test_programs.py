"""Programs and their versions: every save is kept, none is lost unseen, nobody fills the rest."""

import sqlite3
from collections.abc import Iterator
from pathlib import Path

import pytest

from vrts.live.store import programs
from vrts.live.store.accounts import add_account
from vrts.live.store.database import opened
from vrts.live.store.programs import (
    COUNT_S,
    GuestsTogether,
    Outcome,
    Version,
    own_shelf,
    room_shelf,
    room_takes,
)
from vrts.live.store.rooms import KeptRoom, keep_room

ANNA, BEN = 7, 8
ROOM = room_shelf("r1")


@pytest.fixture
def database(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    connection = opened(tmp_path / "live.sqlite")
    yield connection
    connection.close()


def saved(
    database: sqlite3.Connection,
    text: str,
    seen: int,
    *,
    shelf: str = ROOM,
    account: int = ANNA,
    name: str = "pick",
    at: float = 0.0,
) -> Outcome:
    who = {ANNA: "Anna", BEN: "Ben"}[account]
    return programs.save(database, shelf, Version(name, 0, at, account, who, 0), text, seen)


def numbers(database: sqlite3.Connection, name: str = "pick") -> list[int]:
    return [version.number for version in programs.versions(database, ROOM, name)]


def test_every_save_is_a_version_that_can_be_had_again(database: sqlite3.Connection) -> None:
    for number, text in enumerate(("one", "two", "three")):
        assert saved(database, text, number, at=10.0 + number).saved
    assert numbers(database) == [3, 2, 1]
    assert programs.text_of(database, ROOM, "pick", 2) == "two"
    assert programs.text_of(database, ROOM, "pick", 4) is None
    assert programs.programs(database, ROOM) == [Version("pick", 3, 12.0, ANNA, "Anna", 5)]
    assert programs.programs(database, own_shelf(ANNA)) == []


def test_what_one_has_not_seen_is_not_saved_over(database: sqlite3.Connection) -> None:
    saved(database, "first", 0)
    assert saved(database, "Ben's", 1, account=BEN).saved
    refused = saved(database, "Anna's", 1)
    assert (refused.saved, refused.full) == (False, False)
    assert refused.version is not None
    assert (refused.version.number, refused.version.saver) == (2, "Ben")
    assert numbers(database) == [2, 1]
    assert saved(database, "Anna's", 2).saved  # who has been told of it may
    assert programs.text_of(database, ROOM, "pick", 2) == "Ben's"
    assert not saved(database, "new", 0).saved  # a name that is taken, unknown to the saver


def test_saving_the_same_again_is_no_version(database: sqlite3.Connection) -> None:
    saved(database, "same", 0)
    assert saved(database, "same", 1).saved
    assert numbers(database) == [1]


def test_who_saves_often_loses_the_oldest_of_ones_own_alone(
    database: sqlite3.Connection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(programs, "MOST_OF_A_PROGRAM", 3)
    saved(database, "Ben's", 0, account=BEN)
    for number in range(1, 7):
        assert saved(database, f"text {number}", number, at=float(number)).saved
    assert numbers(database) == [7, 6, 5, 1]
    assert programs.text_of(database, ROOM, "pick", 1) == "Ben's"


def test_a_person_may_keep_only_so_much(
    database: sqlite3.Connection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(programs, "MOST_CHARACTERS", 100)
    for name in "ab":
        assert saved(database, "x" * 40, 0, name=name).saved
    full = saved(database, "x" * 40, 0, name="c")  # the newest of a program is never dropped
    assert (full.saved, full.full, full.version) == (False, True, None)
    assert numbers(database, "c") == []
    assert saved(database, "x" * 40, 0, name="c", account=BEN).saved
    assert saved(database, "y" * 40, 1, name="a").saved  # the version before makes room
    assert numbers(database, "a") == [2]
    monkeypatch.setattr(programs, "MOST_VERSIONS", 2)
    assert saved(database, "z", 0, name="d").full


def of_anna(database: sqlite3.Connection) -> list[tuple[str, int, str]]:
    """Return shelf, number and text of all that Anna has saved."""
    query = "SELECT shelf, number, text FROM program_version WHERE account=? ORDER BY shelf, number"
    return database.execute(query, (ANNA,)).fetchall()


def test_what_a_person_has_saved_is_purged(database: sqlite3.Connection) -> None:
    saved(database, "in the room", 0)
    saved(database, "my own", 0, shelf=own_shelf(ANNA))
    saved(database, "Ben's", 1, account=BEN)
    assert of_anna(database) == [("own 7", 1, "my own"), ("room r1", 1, "in the room")]
    programs.purge_programs(database, ANNA)
    assert of_anna(database) == []
    assert programs.programs(database, own_shelf(ANNA)) == []
    assert programs.text_of(database, ROOM, "pick", 1) is None
    assert [(v.number, v.saver) for v in programs.versions(database, ROOM, "pick")] == [
        (2, "Ben"),
        (1, ""),
    ]
    assert "Anna" not in "".join(database.iterdump())
    assert saved(database, "next", 2, account=BEN).saved


def test_a_program_is_forgotten(database: sqlite3.Connection) -> None:
    saved(database, "one", 0)
    programs.remove(database, ROOM, "pick")
    assert programs.programs(database, ROOM) == []
    assert not programs.versions(database, ROOM, "pick")


def test_the_shelf_of_a_room_takes_only_so_much(
    database: sqlite3.Connection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(programs, "MOST_OF_A_SHELF", 2)
    monkeypatch.setattr(programs, "MOST_OF_A_ROOM", 100)
    assert room_takes(database, "r1", "a", 100)
    assert not room_takes(database, "r1", "a", 101)
    for name in "ab":
        assert saved(database, "x" * 40, 0, name=name).saved
    assert room_takes(database, "r1", "a", 20)
    assert not room_takes(database, "r1", "a", 21)
    assert not room_takes(database, "r1", "c", 1), "there are two programs"
    assert room_takes(database, "r2", "c", 100), "another room"


def test_all_guests_together_keep_only_so_much(
    database: sqlite3.Connection, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(programs, "MOST_OF_GUESTS", 100)
    local = add_account(database, "Local", 0.0, password="x").id
    one, two = (add_account(database, name, 0.0).id for name in ("One", "Two"))
    for account, length in ((local, 500), (one, 60)):
        version = Version("own", 0, 0.0, account, "x", 0)
        programs.save(database, own_shelf(account), version, "x" * length, 0)
    together = GuestsTogether()
    assert together.take(database, two, 40, 0.0)
    assert not together.take(database, two, 1, 1.0), "whether it was kept is not looked at yet"
    assert together.take(database, local, 1000, 1.0), "who has a password is no guest"
    assert together.take(database, two, 40, COUNT_S)
    database.execute("DELETE FROM account WHERE id=?", (one,))
    assert not together.take(database, two, 41, 2 * COUNT_S), "what is there counts, gone or not"


def test_the_shelf_of_a_closed_room_goes_to_who_saved_there(database: sqlite3.Connection) -> None:
    anna, ben = (add_account(database, name, 0.0).id for name in ("Anna", "Ben"))

    def save(shelf: str, account: int, name: str, text: str, seen: int) -> None:
        version = Version(name, 0, 1.0, account, "", 0)
        assert programs.save(database, shelf, version, text, seen).saved

    save(own_shelf(anna), anna, "pick", "own", 0)
    for number, (account, text) in enumerate(((anna, "1"), (anna, "2"), (ben, "3"), (99, "4"))):
        save(ROOM, account, "pick", text, number)
    save(ROOM, ben, "place", "5", 0)
    save(room_shelf("open"), ben, "stays", "6", 0)
    for room, closed in (("r1", 1), ("open", 0)):
        keep_room(database, KeptRoom(room, room, "x", 1, True, 0.0, 0.0))
        database.execute("UPDATE room SET closed=? WHERE id=?", (closed, room))
    programs.end_closed_shelves(database)
    assert programs.programs(database, ROOM) == []
    assert len(programs.programs(database, room_shelf("open"))) == 1
    assert [
        (one.name, one.number, programs.text_of(database, own_shelf(anna), one.name, 1))
        for one in programs.programs(database, own_shelf(anna))
    ] == [("pick", 1, "own"), ("pick r1", 1, "2")]
    kept = [(one.name, one.length) for one in programs.programs(database, own_shelf(ben))]
    assert kept == [("pick", 1), ("place", 1)]
