"""Databases of before: copied, brought to the present tables, and nothing of them is lost."""

import sqlite3
from pathlib import Path

import pytest

from vrts.live.store import accounts, log
from vrts.live.store.bars import bars_of
from vrts.live.store.database import bring_up_to_date, copy_of_before, opened, read_only
from vrts.live.store.migrations import STEPS, NotMigrated, version_of
from vrts.live.store.progress import last_session, reached
from vrts.live.store.rooms import lines, next_number, open_rooms

OLD = Path(__file__).parents[3] / "data" / "live-databases"
VERSIONS = (1, 2, 3)  # that servers ran with
NOW = 1_760_000_100.0


def database_of(version: int, folder: Path) -> Path:
    """Write a database as an old vrts left it."""
    path = folder / "live.sqlite"
    connection = sqlite3.connect(path, isolation_level=None)
    connection.executescript((OLD / f"version-{version}.sql").read_text(encoding="utf-8"))
    connection.close()
    return path


def contents(path: Path, tables: tuple[str, ...]) -> dict[str, list[dict[str, object]]]:
    """Return all rows of some tables."""
    connection = sqlite3.connect(path)
    connection.row_factory = sqlite3.Row
    found = {
        name: [dict(row) for row in connection.execute(f"SELECT * FROM {name}")] for name in tables
    }
    connection.close()
    return found


def tables_of(path: Path) -> tuple[str, ...]:
    connection = sqlite3.connect(path)
    rows = connection.execute("SELECT name FROM sqlite_master WHERE type='table'").fetchall()
    connection.close()
    return tuple(row[0] for row in rows)


@pytest.mark.parametrize("version", VERSIONS)
def test_a_database_of_before_is_copied_and_keeps_everything(version: int, tmp_path: Path) -> None:
    path = database_of(version, tmp_path)
    before = contents(path, tables_of(path))
    connection = opened(path)
    assert version_of(connection) == len(STEPS)
    for name, rows in before.items():
        now = contents(path, (name,))[name]
        kept = [{column: new[column] for column in old} for old, new in zip(rows, now, strict=True)]
        assert kept == rows, name
    for room in ("aa11bb22", "cc33dd44", "ee55ff66"):
        assert log.verify(connection, room) == ""
    assert [room.name for room in open_rooms(connection)] == ["Group A", "Group B"]
    assert [row.kind for row in last_session(connection, "cc33dd44")] == ["begin", "line", "line"]
    assert next(line.text for line in lines(connection, "aa11bb22")) == "good morning"
    assert accounts.password_of(connection, "Dr. Lee") is not None
    assert accounts.enter(connection, "abc def", "Cem", NOW) is None, "a code of 30 bits ends"
    assert reached(connection, "aa11bb22", 2, 1) == (4.75 if version >= 2 else 0.0)
    assert bars_of(connection, "cc33dd44") == ({2: "Anna"} if version >= 3 else {})
    assert next_number(connection, "session") == 5
    connection.close()
    copy = copy_of_before(path, version)
    if version == len(STEPS):
        assert not copy.exists(), "nothing was changed"
        return
    assert f"version-{version}" in copy.name
    assert copy.stat().st_mode & 0o777 == 0o600
    assert contents(copy, tables_of(copy)) == before
    opened(path).close()  # again: there is nothing to do
    assert len(list(tmp_path.glob("*.sqlite"))) == 2


def test_a_migration_that_fails_leaves_the_database_as_it_was_and_says_so(tmp_path: Path) -> None:
    path = database_of(2, tmp_path)
    before = contents(path, tables_of(path))
    half = (
        *STEPS[:2],
        "DELETE FROM account",
        "CREATE TABLE more (x); INSERT INTO nowhere SELECT 1",
    )
    connection = sqlite3.connect(path, isolation_level=None)
    with pytest.raises(NotMigrated) as told:
        bring_up_to_date(connection, path, half)
    assert version_of(connection) == 2
    connection.close()
    assert contents(path, tables_of(path)) == before
    assert str(told.value) == (
        "the database cannot be brought from version 2 to 4: no such table: nowhere;"
        f" it is as it was, and a copy of it is in `{copy_of_before(path, 2)}`"
    )
    opened(path).close()


def test_a_new_database_has_no_copy(tmp_path: Path) -> None:
    opened(tmp_path / "live.sqlite").close()
    assert [path.name for path in tmp_path.iterdir()] == ["live.sqlite"]
    with read_only(tmp_path / "live.sqlite") as connection:
        assert version_of(connection) == len(STEPS)
