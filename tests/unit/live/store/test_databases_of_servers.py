"""Databases that servers of before left behind: nothing is lost, and a class goes on in them."""

import json
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest

from tests.support_live import LiveServer
from tests.unit.live.rooms.test_session_deaths import done, settled
from tests.unit.live.store.test_migrations import OLD, contents, tables_of
from vrts.live.administration import accept_logs
from vrts.live.settings import DATABASE
from vrts.live.store import accounts, links, log, programs
from vrts.live.store.bars import bars_of
from vrts.live.store.branches import branch_of
from vrts.live.store.database import copy_of_before, opened
from vrts.live.store.migrations import STEPS, version_of
from vrts.live.store.rooms import lines, open_rooms
from vrts.live.store.verifying import findings

LEFT = ("4", "5", "6", "7", "8-unsigned", "8", "9", "10")
KEYS = json.loads((OLD / "log-keys.json").read_text("utf-8"))
NOTHING_SEEN = "the file beside the key is missing, which tells how far these logs had come"


def left(name: str, folder: Path) -> tuple[Path, int]:
    """Write a database as a server left it; return where, and its version."""
    path = folder / DATABASE
    path.parent.mkdir(parents=True, exist_ok=True)
    with closing(sqlite3.connect(path, isolation_level=None)) as connection:
        connection.executescript((OLD / f"version-{name}.sql").read_text("utf-8"))
        return path, version_of(connection)


def test_there_is_one_of_every_version() -> None:
    """Who adds a step adds what a server of it leaves: the next one is tried with it."""
    kept = {path.stem.split("-")[1] for path in OLD.glob("version-*.sql")}
    assert {int(version) for version in kept} >= set(range(1, len(STEPS)))


@pytest.mark.parametrize("name", LEFT)
def test_nothing_that_a_class_left_is_lost(name: str, tmp_path: Path) -> None:
    path, version = left(name, tmp_path)
    before = contents(path, tables_of(path))
    with closing(opened(path)) as connection:
        assert version_of(connection) == len(STEPS)
        for table, rows in before.items():
            now = contents(path, (table,))[table]
            kept = [{key: new[key] for key in old} for old, new in zip(rows, now, strict=True)]
            assert kept == rows, table
        rooms = {room.name: room.id for room in open_rooms(connection)}
        room = rooms["Group A"]
        assert [log.verify(connection, id_) for id_ in rooms.values()] == [""] * 3
        said = [line.text for line in lines(connection, room)]
        assert said[:2] == ["good morning", "for you alone"]
        known = accounts.password_of(connection, "Dr. Lee")
        assert known is not None
        assert known[0].supervisor
        anna = connection.execute("SELECT id FROM account WHERE name='Anna'").fetchone()[0]
        assert list(bars_of(connection, room).values()) == ["Ben Müller"]
        private = next(id_ for title, id_ in rooms.items() if title.endswith(", Anna"))
        branch = branch_of(connection, private)
        assert branch is not None
        assert (branch.owner, branch.origin) == (anna, room)
        if version >= 5:
            shelf = programs.room_shelf(room)
            versions = programs.versions(connection, shelf, "ours")
            assert [(one.number, one.saver) for one in versions] == [(2, "Anna"), (1, "Anna")]
            assert "BREAK" in str(programs.text_of(connection, shelf, "ours", 2))
            own = programs.programs(connection, programs.own_shelf(anna))
            assert [one.name for one in own] == ["mine"]
        (at,) = connection.execute("SELECT max(created) FROM account").fetchone()
        into = [link for link in links.links(connection, at) if link.room == rooms["Group B"]]
        assert len(into) == 1, "the link into a room still lets in"
    copy = copy_of_before(path, version)
    assert copy.exists() == (version < len(STEPS))
    if copy.exists():
        assert copy.stat().st_mode & 0o777 == 0o600
        assert contents(copy, tables_of(copy)) == before


@pytest.mark.parametrize("name", [name for name in LEFT if f"version-{name}" in KEYS])
def test_logs_that_were_signed_still_verify(name: str, tmp_path: Path) -> None:
    path, _ = left(name, tmp_path / "live")
    key = tmp_path / "log-key"
    key.write_text(KEYS[f"version-{name}"])
    key.chmod(0o600)
    opened(path).close()
    found = list(findings(path, key))
    assert [one.text for one in found if one.wrong] == [NOTHING_SEEN], "the file beside the key"
    assert len([one for one in found if one.text.startswith("unbroken")]) == 3
    with closing(sqlite3.connect(path)) as connection:
        connection.execute("UPDATE log_name SET name='Eve' WHERE name='Anna'")
        connection.commit()
    assert len([one for one in findings(path, key) if one.wrong]) > 1


@pytest.mark.thorough
@pytest.mark.parametrize("name", ["4", "8-unsigned", "9"])
def test_a_class_goes_on_in_it(name: str, tmp_path: Path) -> None:
    path, _ = left(name, tmp_path / "live")
    word = {"user": "Dr. Lee", "password": "correct horse"}
    assert not (path.parent / "sessions").exists(), "the rooms are made again from their logs"
    key = tmp_path / "keys" / "log-key"
    assert accept_logs(path.parent, key), "no server has signed them, or nobody knows how often"
    with LiveServer(path.parent, "--log-key", str(key)) as server:
        cookie = server.request("POST", "/login", word).cookie
        boss, _ = settled(server, cookie)
        assert boss.came[0]["room"] in {room.id for room in open_rooms(opened(path))}
        lease = boss.take_control()
        assert "1" in done(boss, lease, "line", line="LISTR a").partition("LISTR a")[2]
        assert "picked" in done(boss, lease, "line", line="LISTP pick")
        done(boss, lease, "line", line="DO MOVE p1")
        assert server.enter("Dora")
