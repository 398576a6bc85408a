"""What the server keeps: migrations, acknowledged writes, the chain of the log, purge, backup."""

import multiprocessing
import os
import signal
import sqlite3
import threading
from collections.abc import Iterator
from multiprocessing.connection import Connection as Pipe
from pathlib import Path

import msgspec
import pytest

from vrts.live.store import accounts, log
from vrts.live.store.accounts import add_account, add_link, enter, log_in, who
from vrts.live.store.database import Database, backup, opened
from vrts.live.store.log import Entry
from vrts.live.store.migrations import STEPS, NotMigrated, TooNew, migrate
from vrts.live.store.rooms import KeptRoom, Line, keep_line, keep_room, lines, open_rooms
from vrts.live.store.verifying import findings
from vrts.live.tokens import new_token


@pytest.fixture
def connection(tmp_path: Path) -> Iterator[sqlite3.Connection]:
    found = opened(tmp_path / "live.sqlite")
    yield found
    found.close()


def entry(account: int | None = 1, text: str = '{"a":1}', name: str = "Anna") -> Entry:
    return Entry("room", 7, 1.5, 1000.25, "line", True, account, name, text)


def test_a_new_database_is_private_and_at_the_last_step(tmp_path: Path) -> None:
    opened(tmp_path / "live.sqlite").close()
    assert (tmp_path / "live.sqlite").stat().st_mode & 0o777 == 0o600
    again = opened(tmp_path / "live.sqlite")
    assert again.execute("PRAGMA user_version").fetchone() == (len(STEPS),)
    again.close()


def test_a_step_is_taken_whole_or_not_at_all() -> None:
    connection = sqlite3.connect(":memory:", isolation_level=None)
    good = "CREATE TABLE a (x); INSERT INTO a VALUES (1)"
    assert migrate(connection, (good,)) == 1
    with pytest.raises(NotMigrated, match="from version 1 to 2: no such table: c; it is as it was"):
        migrate(connection, (good, "CREATE TABLE b (x); INSERT INTO c VALUES (1)"))
    tables = [row[0] for row in connection.execute("SELECT name FROM sqlite_master")]
    assert tables == ["a"]
    assert migrate(connection, (good, "ALTER TABLE a ADD y DEFAULT 5")) == 1
    assert connection.execute("SELECT * FROM a").fetchall() == [(1, 5)], "what was there stays"
    with pytest.raises(TooNew):
        migrate(connection, (good,))
    connection.close()


def test_codes_of_thirty_bits_end_and_everything_else_of_before_stays() -> None:
    connection = sqlite3.connect(":memory:", isolation_level=None)
    migrate(connection, STEPS[:3])
    connection.execute("INSERT INTO account VALUES (7, 'Anna', NULL, 0, 'r', 50.0)")
    rows = [(b"code", 0, None, None), (b"room", 0, "r", None), (b"once", 1, None, "supervisor")]
    for digest, *whose in rows:
        connection.execute("INSERT INTO link VALUES (?,?,?,?,9,99.0)", (digest, *whose))
    migrate(connection)
    links = connection.execute("SELECT digest, id, ended FROM link ORDER BY digest").fetchall()
    ended = {b"code": 0.0, b"once": None, b"room": None}
    assert links == [(digest, digest.hex(), ended[digest]) for digest in sorted(ended)]
    account = connection.execute("SELECT id, name, room, created, seen FROM account").fetchone()
    assert account == (7, "Anna", "r", 50.0, 50.0), "who was there counts as seen"
    connection.close()


def test_a_chain_that_is_changed_anywhere_does_not_verify(connection: sqlite3.Connection) -> None:
    for n in range(5):
        log.append(connection, entry(text=f'{{"n":{n}}}'))
    assert log.verify(connection, "room") == ""
    with pytest.raises(sqlite3.IntegrityError, match="append-only"):
        connection.execute("UPDATE log SET at_s=9 WHERE seq=3")
    with pytest.raises(sqlite3.IntegrityError, match="append-only"):
        connection.execute("DELETE FROM log WHERE seq=3")
    connection.execute("DROP TRIGGER log_is_append_only")
    connection.execute("DROP TRIGGER log_is_kept")
    connection.execute("SAVEPOINT whole")
    for statement, words in [
        ("UPDATE log SET at_s=9 WHERE seq=3", "record 3 was changed"),
        ("UPDATE log SET kind='go' WHERE seq=1", "record 1 was changed"),
        ("UPDATE log SET accepted=0 WHERE seq=5", "record 5 was changed"),
        ("DELETE FROM log WHERE seq=2", "record 2 is missing"),
        ("UPDATE log_text SET text='{}' WHERE seq=4", "the text of record 4 was changed"),
    ]:
        connection.execute(statement)
        assert log.verify(connection, "room") == words
        connection.execute("ROLLBACK TO whole")


def test_purging_a_user_leaves_the_chain_and_nothing_personal(tmp_path: Path) -> None:
    path = tmp_path / "live.sqlite"
    connection = opened(path)
    anna = add_account(connection, "Anna Purged", 0.0).id
    ben = add_account(connection, "Ben", 0.0).id
    token = log_in(connection, anna, 0.0)
    log.append(connection, entry(anna, '{"line":"secretword"}', "Anna Purged"))
    log.append(connection, entry(ben, '{"line":"other"}', "Ben"))
    line = Line("room", 1, 0.0, anna, "Anna Purged", "secretword too", False, None)
    keep_line(connection, line)
    before = [r.hash for r in log.records(connection, "room")]
    log.purge(connection, anna)
    connection.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    assert log.verify(connection, "room") == ""
    assert [r.hash for r in log.records(connection, "room")] == before
    assert [(r.name, r.text) for r in log.records(connection, "room")] == [
        (None, None),
        ("Ben", '{"line":"other"}'),
    ]
    assert who(connection, token, 1.0) is None
    assert lines(connection, "room") == []
    connection.close()
    data = path.read_bytes()
    assert b"secretword" not in data
    assert b"Purged" not in data


def test_an_export_has_a_head_and_one_record_a_line(connection: sqlite3.Connection) -> None:
    log.append(connection, entry(None, '{"scene":"x"}', ""))
    log.append(connection, entry(4))
    rows = [msgspec.json.decode(row) for row in log.export(connection, "room", names=True).split()]
    assert rows[0]["records"] == 2
    assert rows[0]["last"] == rows[2]["hash"]
    assert rows[1]["previous"] == "00" * 32
    assert (rows[1]["name"], rows[2]["name"]) == (None, "Anna")
    assert rows[2]["text"] == {"a": 1}
    bare = log.export(connection, "room", names=False)
    assert b"Anna" not in bare


def test_links_are_used_up_and_expire(connection: sqlite3.Connection) -> None:
    once = new_token()
    add_link(connection, once, 100.0, supervisor=True, name="teacher", room=None)
    assert enter(connection, once, "x", 101.0) is None
    found = enter(connection, once, "x", 99.0)
    assert found is not None
    assert (found.name, found.supervisor) == ("teacher", True)
    assert enter(connection, once, "x", 99.0) is None
    kept = connection.execute("SELECT digest FROM link").fetchall()
    assert once.encode() not in kept[0][0]


def test_a_name_that_cannot_be_shown_uses_no_link_up(tmp_path: Path) -> None:
    database = Database(tmp_path / "live.sqlite")
    token = new_token()
    database.submit(lambda c: add_link(c, token, 100.0)).result(10.0)
    with pytest.raises(ValueError, match="letter"):
        database.submit(lambda c: enter(c, token, "\u200b", 1.0)).result(10.0)
    assert database.submit(lambda c: enter(c, token, "Anna", 1.0)).result(10.0) is not None
    database.close()


def test_accounts_keep_their_names(connection: sqlite3.Connection) -> None:
    teacher = add_account(connection, "Teacher", 0.0, password="hash", supervisor=True)
    with pytest.raises(ValueError, match="already"):
        add_account(connection, "Teacher", 0.0, password="hash")
    assert add_account(connection, "Teacher", 0.0).name == "Teacher 2"
    assert add_account(connection, "Теасhеr", 0.0).name == "Теасhеr 3", "looks the same"
    assert accounts.password_of(connection, "Teacher") == (teacher, "hash")
    assert accounts.password_of(connection, "Teacher 2") is None
    assert accounts.password_of(connection, "' OR 1=1 --") is None


def test_a_job_that_fails_takes_nothing_of_others_along(tmp_path: Path) -> None:
    database = Database(tmp_path / "live.sqlite")

    def bad(connection: sqlite3.Connection) -> None:
        keep_room(connection, KeptRoom("bad", "x", "s", 1, True, 0.0, 0.0))
        connection.execute("INSERT INTO nothing VALUES (1)")

    def good(id_: str) -> KeptRoom:
        return KeptRoom(id_, "x", "s", 1, True, 0.0, 0.0)

    futures = [
        database.submit(lambda c: keep_room(c, good("one"))),
        database.submit(bad),
        database.submit(lambda c: keep_room(c, good("two"))),
    ]
    futures[0].result(10.0)
    futures[2].result(10.0)
    with pytest.raises(sqlite3.Error):
        futures[1].result(10.0)
    assert {room.id for room in database.submit(open_rooms).result(10.0)} == {"one", "two"}
    database.close()


def test_whatever_goes_wrong_reaches_who_waits_and_the_thread_goes_on(tmp_path: Path) -> None:
    database = Database(tmp_path / "live.sqlite")

    def faulty(connection: sqlite3.Connection) -> None:
        keep_room(connection, KeptRoom("bad", "x", "s", 1, True, 0.0, 0.0))
        raise AttributeError("a fault of ours")

    def breaks_the_transaction(connection: sqlite3.Connection) -> None:
        connection.execute("ROLLBACK")

    with pytest.raises(AttributeError, match="a fault of ours"):
        database.submit(faulty).result(5.0)
    with pytest.raises(sqlite3.Error):
        database.submit(breaks_the_transaction).result(5.0)
    assert database.submit(open_rooms).result(5.0) == []
    database.close()


def test_who_does_not_wait_any_more_ends_nothing(tmp_path: Path) -> None:
    database = Database(tmp_path / "live.sqlite")
    begun, go_on = threading.Event(), threading.Event()

    def slow(_: sqlite3.Connection) -> None:
        begun.set()
        go_on.wait(5.0)

    first = database.submit(slow)
    begun.wait(5.0)
    given_up = database.submit(open_rooms)
    assert given_up.cancel()
    go_on.set()
    first.result(5.0)
    assert database.submit(open_rooms).result(5.0) == []
    database.close()


def test_a_database_that_is_closed_says_so(tmp_path: Path) -> None:
    database = Database(tmp_path / "live.sqlite")
    database.close()
    with pytest.raises(sqlite3.Error, match="closed"):
        database.submit(open_rooms).result(5.0)


def _write_forever(path: Path, acknowledged: Pipe) -> None:
    database = Database(path, path.parents[1] / "key", signs=True)
    n = 0
    while True:
        n += 1
        text = f'{{"n":{n}}}'
        seq = database.submit(lambda c, text=text: log.append(c, entry(text=text))).result(10.0)
        acknowledged.send_bytes(seq.to_bytes(4, "big"))


def test_killing_the_writer_loses_nothing_acknowledged(tmp_path: Path) -> None:
    path = tmp_path / "live" / "live.sqlite"
    path.parent.mkdir()
    ours, theirs = multiprocessing.Pipe(duplex=False)
    writer = multiprocessing.get_context("spawn").Process(
        target=_write_forever, args=(path, theirs)
    )
    writer.start()
    theirs.close()
    last = 0
    while last < 300:
        last = int.from_bytes(ours.recv_bytes(), "big")
    assert writer.pid is not None
    os.kill(writer.pid, signal.SIGKILL)
    writer.join()
    try:
        while True:
            last = int.from_bytes(ours.recv_bytes(), "big")
    except EOFError:
        ours.close()
    connection = opened(path)
    assert log.verify(connection, "room") == ""
    (kept,) = connection.execute("SELECT max(seq) FROM log").fetchone()
    connection.close()
    assert kept in (last, last + 1), "one may be kept that was not acknowledged any more"
    told = [(one.text, one.wrong) for one in findings(path, tmp_path / "key")]
    assert told == [(f"unbroken, {kept} records", False)], "each with its sign, or neither"


def test_a_backup_while_writing_is_whole(tmp_path: Path) -> None:
    database = Database(tmp_path / "live.sqlite")
    futures = [database.submit(lambda c: log.append(c, entry())) for _ in range(500)]
    futures[100].result(10.0)
    backup(tmp_path / "live.sqlite", tmp_path / "copy.sqlite")
    futures[-1].result(10.0)
    database.close()
    copy = opened(tmp_path / "copy.sqlite")
    assert log.verify(copy, "room") == ""
    (count,) = copy.execute("SELECT count(*) FROM log").fetchone()
    copy.close()
    assert 100 < count <= 500


def test_a_backup_ends_though_another_program_never_stops_writing(tmp_path: Path) -> None:
    path, ends = tmp_path / "live.sqlite", threading.Event()
    connection = opened(path)
    for number in range(1000):  # more than are copied in no time
        connection.execute("INSERT INTO counter VALUES (?, 1)", (f"{number:03000}",))

    def write() -> None:
        while not ends.is_set():
            connection.execute("UPDATE counter SET value=value+1 WHERE name LIKE '%7'")

    writer = threading.Thread(target=write)
    copier = threading.Thread(target=backup, args=(path, tmp_path / "copy"), daemon=True)
    writer.start()
    copier.start()
    copier.join(10.0)
    ends.set()
    writer.join()
    connection.close()
    assert not copier.is_alive()
    copy = opened(tmp_path / "copy")
    assert copy.execute("SELECT count(*) FROM counter").fetchone() == (1000,)
    copy.close()
