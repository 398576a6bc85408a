"""What a new guest inherits of those of the same browser, or of a name that looks the same."""

import sqlite3
from pathlib import Path

from vrts.live.store.accounts import add_account
from vrts.live.store.bars import bar, inherit, mute, same_browser, unmute, use_browser
from vrts.live.store.database import opened
from vrts.live.store.log import purge

HERE, THERE = b"here", b"there"  # digests of two browsers


def guest(connection: sqlite3.Connection, name: str, browser: bytes) -> int:
    account = add_account(connection, name, 0.0).id
    use_browser(connection, (account,), browser)
    return account


def test_a_guest_inherits_what_was_done_about_the_browser(tmp_path: Path) -> None:
    connection = opened(tmp_path / "live.sqlite")
    anna = guest(connection, "Anna", HERE)
    ben = guest(connection, "Ben", THERE)
    user = add_account(connection, "Eva", 0.0, password="hash").id
    use_browser(connection, (user,), HERE)
    mute(connection, anna, "Anna")
    bar(connection, "r", anna, "Anna")
    berta = guest(connection, "Berta", HERE)
    assert inherit(connection, berta, "Berta") == ([("r", "Anna")], "Anna")
    assert inherit(connection, ben, "Ben") == ([], "")
    assert inherit(connection, ben, "Аnnа") == ([("r", "Anna")], ""), "it looks the same"
    assert same_browser(connection, anna) == {anna, berta}, "a user is known by the account"
    assert same_browser(connection, user) == {user, anna, berta}
    unmute(connection, "Anna")
    carla = guest(connection, "Carla", HERE)
    assert inherit(connection, carla, "Carla").muted == ""
    connection.close()


def test_nothing_of_a_browser_stays_of_who_was_purged(tmp_path: Path) -> None:
    connection = opened(tmp_path / "live.sqlite")
    anna = guest(connection, "Anna", HERE)
    mute(connection, anna, "Anna")
    purge(connection, anna)
    for table in ("browser", "muted"):
        (count,) = connection.execute(f"SELECT count(*) FROM {table}").fetchone()
        assert count == 0, table
    connection.close()
