"""Signs of the logs: what somebody without the key changes in the database shows."""

import os
import shutil
import sqlite3
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

import pytest

from vrts.live import administration
from vrts.live.settings import DATABASE
from vrts.live.store import log
from vrts.live.store.accepting import accept
from vrts.live.store.accounts import add_account
from vrts.live.store.database import Database, opened
from vrts.live.store.log import Entry
from vrts.live.store.rooms import KeptRoom, keep_room
from vrts.live.store.seals.key import make_key
from vrts.live.store.verifying import findings
from vrts.pipeline.files import CannotRead

Answer = TypeVar("Answer")
ROOMS = ("a", "b")
UNTOUCHED = ["a (Group A): unbroken, 4 records", "b (Group B): unbroken, 4 records"]


class Term:
    """A folder in which a server was, and the key of its logs."""

    def __init__(self, place: Path) -> None:
        self.folder = place / "live"
        self.key = place / "state" / "log-key"
        self.path = self.folder / DATABASE
        self.folder.mkdir()
        with_rooms = self.start()
        for number, room in enumerate(ROOMS):
            name = f"Group {room.upper()}"
            self.do(with_rooms, lambda c, r=room, n=name, k=number: keep_room(c, kept(r, n, k)))
        self.anna = self.do(with_rooms, lambda c: add_account(c, "Anna", 0.0).id)
        self.ben = self.do(with_rooms, lambda c: add_account(c, "Ben", 0.0).id)
        for room in ROOMS:
            self.append(with_rooms, room, None, "")
            self.append(with_rooms, room, self.anna, "Anna")
            self.append(with_rooms, room, self.ben, "Ben")
            self.append(with_rooms, room, self.anna, "Anna")
        with_rooms.close()

    def start(self) -> Database:
        return Database(self.path, self.key, signs=True)

    @staticmethod
    def do(database: Database, job: Callable[[sqlite3.Connection], Answer]) -> Answer:
        return database.submit(job).result(10.0)

    def append(self, database: Database, room: str, account: int | None, name: str) -> None:
        entry = Entry(room, 1, 1.5, 1000.25, "line", True, account, name, f'{{"of":"{name}"}}')
        self.do(database, lambda c: log.append_now(c, entry))

    def server_goes_on(self) -> None:
        """Start the server, do something in both rooms, and end it."""
        database = self.start()
        for room in ROOMS:
            self.append(database, room, self.ben, "Ben")
        database.close()

    def attack(self, *statements: str) -> None:
        """Change the database as somebody who has the file, and not the key."""
        connection = sqlite3.connect(self.path, isolation_level=None)
        connection.execute("DROP TRIGGER IF EXISTS log_is_append_only")
        connection.execute("DROP TRIGGER IF EXISTS log_is_kept")
        for statement in statements:
            connection.execute(statement)
        connection.close()

    def told(self) -> list[str]:
        """Return what is told, the wrong lines first of all."""
        found = list(findings(self.path, self.key))
        return [line(one.room, one.name, one.text) for one in found if one.wrong] or [
            line(one.room, one.name, one.text) for one in found
        ]


def line(room: str, name: str, text: str) -> str:
    return f"{room} ({name}): {text}" if name else f"{room}: {text}" if room else text


def kept(room: str, name: str, place: int) -> KeptRoom:
    return KeptRoom(room, name, "cans-on-bases", place, True, 0.0, 120.0)


@pytest.fixture
def term(tmp_path: Path) -> Term:
    return Term(tmp_path)


def test_logs_that_nobody_has_touched_are_unbroken(term: Term) -> None:
    assert term.told() == UNTOUCHED
    term.server_goes_on()
    assert term.told() == [text.replace("4", "5") for text in UNTOUCHED]
    assert term.key.stat().st_mode & 0o777 == 0o600
    assert not term.key.is_relative_to(term.folder)


TAIL = "DELETE FROM {} WHERE room='a' AND seq>2"
ATTACKS = {
    "the tail is cut": (
        [TAIL.format("log"), TAIL.format("log_text")],
        ["a (Group A): the end is missing: 4 records were signed, 2 are there"],
    ),
    "a room is deleted with all that is signed of it": (
        [
            "DELETE FROM log WHERE room='a'",
            "DELETE FROM log_text WHERE room='a'",
            "DELETE FROM log_head WHERE room='a'",
            "DELETE FROM log_name WHERE room='a'",
            "DELETE FROM room WHERE id='a'",
        ],
        ["rooms are missing: 2 were signed, 1 are there"],
    ),
    "a room's log is deleted": (
        ["DELETE FROM log WHERE room='a'", "DELETE FROM log_text WHERE room='a'"],
        ["a (Group A): the end is missing: 4 records were signed, 0 are there"],
    ),
    "a room is deleted, and its log stays": (
        ["DELETE FROM room WHERE id='a'"],
        ["a: the room was deleted"],
    ),
    "a text is removed": (
        ["DELETE FROM log_text WHERE room='a' AND seq=3"],
        ["a (Group A): the text of record 3 was removed, and nobody purged it"],
    ),
    "a purge is made up": (
        [
            "DELETE FROM log_text WHERE room='a' AND seq=3",
            "INSERT INTO log_purged VALUES ('a', 3, 5.0, 'somebody was purged', zeroblob(32))",
        ],
        ["a (Group A): what is said of the purge of record 3 was changed"],
    ),
    "two persons are exchanged in the texts": (
        ["UPDATE log_text SET account=3-account WHERE room='a' AND account NOT NULL"],
        ["a (Group A): the person of record 2 was exchanged"],
    ),
    "two persons are exchanged in the names": (
        ["UPDATE log_name SET name=CASE name WHEN 'Ben' THEN 'Anna' ELSE 'Ben' END"],
        [
            "a (Group A): account 1 has another name: `Ben` was not signed",
            "b (Group B): account 1 has another name: `Ben` was not signed",
        ],
    ),
    "two persons are exchanged everywhere": (
        [
            "UPDATE log_name SET name=CASE name WHEN 'Ben' THEN 'Anna' ELSE 'Ben' END",
            "UPDATE account SET name='x' WHERE id=1",
            "UPDATE account SET name='Anna' WHERE id=2",
            "UPDATE account SET name='Ben' WHERE id=1",
        ],
        [
            "a (Group A): account 1 has another name: `Ben` was not signed",
            "b (Group B): account 1 has another name: `Ben` was not signed",
        ],
    ),
    "two persons are exchanged among the accounts": (
        [
            "UPDATE account SET name='x' WHERE id=1",
            "UPDATE account SET name='Anna' WHERE id=2",
            "UPDATE account SET name='Ben' WHERE id=1",
        ],
        [
            f"{room}: account 1 is `Anna` in the log, and `Ben` among the accounts"
            for room in ("a (Group A)", "b (Group B)")
        ],
    ),
    "the server's own record is given to somebody": (
        ["UPDATE log_text SET account=1 WHERE room='a' AND seq=1"],
        ["a (Group A): the person of record 1 was exchanged"],
    ),
    "two rooms are exchanged": (
        ["UPDATE room SET name=CASE id WHEN 'a' THEN 'Group B' ELSE 'Group A' END"],
        [
            "a (Group B): the room was called `Group A`, and is called `Group B`",
            "b (Group A): the room was called `Group B`, and is called `Group A`",
        ],
    ),
    "the head is made to fit": (
        [
            TAIL.format("log"),
            TAIL.format("log_text"),
            "UPDATE log_head SET records=2, last=(SELECT hash FROM log WHERE seq=2) WHERE room='a'",
        ],
        ["a (Group A): the signed head of its log was changed"],
    ),
    "all signs are removed": (
        ["DELETE FROM log_head", "DELETE FROM log_seal"],
        ["the signed list of rooms is missing"],
    ),
    "the list of rooms is changed": (
        ["UPDATE log_seal SET rooms=1, seal=zeroblob(32)"],
        ["the signed list of rooms was changed"],
    ),
}


@pytest.mark.parametrize("attack", ATTACKS)
def test_what_somebody_without_the_key_does_shows(attack: str, term: Term) -> None:
    statements, words = ATTACKS[attack]
    term.attack(*statements)
    assert term.told()[: len(words)] == words
    term.server_goes_on()
    after = term.told()
    assert any(words[0].partition(":")[0] in text for text in after), "it is signed over"
    assert after not in (UNTOUCHED, [text.replace("4", "5") for text in UNTOUCHED])


def test_a_record_that_was_made_up_at_the_end_is_never_signed(term: Term) -> None:
    connection = opened(term.path)  # with the right chain: that needs no key
    log.append(connection, Entry("a", 1, 2.0, 1001.0, "line", True, term.anna, "Anna", "{}"))
    connection.close()
    words = "a (Group A): 1 records at the end were never signed"
    assert term.told() == [words]
    term.server_goes_on()
    assert term.told() == [words.replace("1 ", "2 ")]


def test_an_older_copy_in_place_of_the_database_shows(term: Term) -> None:
    shutil.copy(term.path, term.folder / "older")
    term.server_goes_on()
    shutil.copy(term.folder / "older", term.path)
    words = "this is an older state of the database: it was signed"
    assert term.told()[0].startswith(words)
    term.server_goes_on()
    term.server_goes_on()
    assert term.told()[0].startswith(words), "going on from it hides nothing"
    assert accept(term.path, term.key, 2000.0)[0].startswith(words)
    assert term.told() == [text.replace("4", "6") for text in UNTOUCHED]
    term.server_goes_on()
    assert term.told() == [text.replace("4", "7") for text in UNTOUCHED]
    assert accept(term.path, term.key, 2001.0) == []
    term.attack("DELETE FROM log_accepted")
    assert term.told() == ["1 faults were accepted, but 0 are noted"]


def test_another_database_in_place_of_one_shows(term: Term) -> None:
    term.path.unlink()
    database = term.start()
    term.do(database, lambda c: keep_room(c, kept("a", "Group A", 0)))
    database.close()
    (told,) = term.told()
    assert told.startswith("another database was here, which had been signed")
    assert accept(term.path, term.key, 2000.0) == [told]
    assert term.told() == ["a (Group A): unbroken, 0 records"]


def test_a_purge_leaves_notes_and_no_fault(term: Term) -> None:
    assert administration.purge_user(term.folder, "Anna", term.key).accounts == 1
    told = term.told()
    assert [text.partition(", last")[0] for text in told] == [
        f"{text}; the texts of 2 were purged" for text in UNTOUCHED
    ]
    assert told[0].endswith("UTC: somebody was purged")
    database = term.start()
    term.append(database, "a", term.anna, "Anna")  # it was on its way
    database.close()
    assert term.told()[0].endswith("recorded after its person was purged")
    term.attack("DELETE FROM log_purged WHERE room='b' AND seq=2")
    assert term.told() == ["b (Group B): the text of record 2 was removed, and nobody purged it"]


def test_a_missing_key_is_told_and_never_made_anew(term: Term) -> None:
    away = term.key.rename(term.key.with_name("away"))
    for ask in (
        term.start,
        term.told,
        lambda: administration.purge_user(term.folder, "x", term.key),
    ):
        with pytest.raises(CannotRead, match="the key of the logs is missing"):
            ask()
    assert not term.key.exists()
    make_key(term.key)
    for ask in (term.start, term.told):
        with pytest.raises(CannotRead, match="signed with another key"):
            ask()
    assert accept(term.path, term.key, 2000.0) == ["the key that had signed the logs was not there"]
    assert term.told() == UNTOUCHED
    term.server_goes_on()
    away.replace(term.key)
    with pytest.raises(CannotRead, match="signed with another key"):
        term.told()


def test_a_key_that_guards_nothing_is_refused(term: Term) -> None:
    inside = term.folder / "key"
    with pytest.raises(CannotRead, match="in the folder of the database"):
        Database(term.path, inside, signs=True)
    term.key.write_text("no key")
    with pytest.raises(CannotRead, match="there is no key in"):
        term.told()
    os.chmod(term.key, 0o644)
    with pytest.raises(CannotRead, match="others may read"):
        term.told()


ENDLESS = "SELECT 1 UNION ALL SELECT 1 FROM t"
HOSTILE = {
    "a view that never ends": [
        "DROP TABLE log",
        f"CREATE VIEW log AS WITH RECURSIVE t AS ({ENDLESS}) SELECT 1 FROM t",
    ],
    "numbers for names": ["UPDATE log_name SET name=zeroblob(9)", "UPDATE room SET name=7.5"],
    "a room that is no text": ["UPDATE log_head SET room=zeroblob(3) WHERE room='a'"],
    "a record of other kinds": ["UPDATE log SET kind=zeroblob(4), at_s='late' WHERE seq=2"],
    "digests that are texts": ["UPDATE log SET person='a', content='b', previous='c'"],
    "a text that is none": ["UPDATE log_text SET text=CAST(x'ff80' AS TEXT)"],
    "a huge text": ["UPDATE log_text SET text=CAST(zeroblob(40000000) AS TEXT) WHERE seq=2"],
    "signs of other kinds": ["UPDATE log_head SET seal='x'", "UPDATE log_name SET seal=7"],
    "a root of other kinds": ["UPDATE log_seal SET database='x', key=7, count='many'"],
    "texts of no record": ["INSERT INTO log_text VALUES ('a', 99, 1, zeroblob(16), 'x')"],
    "a name that steers a terminal": ["UPDATE room SET name=char(27) || '[2J' || char(10) || 'x'"],
    "a purge of other kinds": ["INSERT INTO log_purged VALUES ('a', 1, 'x', 7, 'y')"],
}


@pytest.mark.parametrize("hostile", HOSTILE)
def test_a_hostile_database_gives_sentences(hostile: str, term: Term) -> None:
    term.attack(*HOSTILE[hostile])
    found = list(findings(term.path, term.key))
    assert any(one.wrong for one in found)
    for one in found:
        assert f"{one.name}{one.text}".isprintable(), one
        assert len(one.text) < 300


def test_a_file_that_is_no_database_of_vrts_gives_a_sentence(tmp_path: Path) -> None:
    path = tmp_path / "live" / DATABASE
    path.parent.mkdir()
    for content in (b"", b"no database" * 100, b"SQLite format 3\0" + bytes(84)):
        path.write_bytes(content)
        (found,) = findings(path, tmp_path / "key")
        assert found.wrong
        assert found.text
