"""A person is handed out whole, and forgotten everywhere: no file has a byte of them."""

import asyncio
import json
import sqlite3
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner

from vrts.cli.main import vrts
from vrts.live.notices.announcement import Announcement
from vrts.live.notices.kept import KeptNotice, keep_notice
from vrts.live.personal.names import GONE, Names
from vrts.live.personal.purging import Forgotten, purge
from vrts.live.places import places_of
from vrts.live.rooms.hub import Hub
from vrts.live.rooms.opening import forget_purged, open_kept
from vrts.live.settings import DATABASE, Settings
from vrts.live.store import accounts, bars, log, programs
from vrts.live.store.branches import Branch, keep_branch
from vrts.live.store.database import Connection, Database
from vrts.live.store.log import Entry
from vrts.live.store.rooms import KeptRoom, Line, keep_line, keep_room
from vrts.live.store.verifying import findings

ANNA, WORD = "Zénobie O'Quirk", "xylophonic"
NOW = 1_760_000_000.0


class Folder:
    """Of a server in which somebody's name occurs everywhere."""

    def __init__(self, place: Path) -> None:
        self.place = place / "live"
        self.key = place / "key"
        self.place.mkdir()
        (self.place / "live.version-2.sqlite").write_text(ANNA)
        database = Database(self.place / DATABASE, self.key, signs=True)
        self.anna, self.ben = database.submit(_filled).result(10.0)
        database.close()
        session = self.place / "sessions" / "a-1"
        for account, text in ((self.anna, WORD), (self.ben, "ben's")):
            folder = session / f"p{account}"
            folder.mkdir(parents=True)
            (folder / "pick.v2").write_text(f"; {text}")
        (session / f"p{self.ben}" / "for.v2").write_text(f"; for {ANNA}")
        (session / "history.bin").write_text(WORD)
        (session / "stderr.txt").write_text(f"a fault of {ANNA}")

    def holding(self, *words: str) -> list[str]:
        """Return the files in which one of some words stands."""
        found = [word.encode() for word in words]
        files = [path for path in self.place.rglob("*") if path.is_file()]
        return [file.name for file in files if any(word in file.read_bytes() for word in found)]

    def wrong(self) -> list[str]:
        return [one.text for one in findings(self.place / DATABASE, self.key) if one.wrong]


def announced(hub: Hub) -> str:
    return "" if hub.announcement is None else hub.announcement.text


def _filled(connection: Connection) -> tuple[int, int]:
    for number, (room, name) in enumerate((("a", "Group A"), ("b", f"{ANNA}, from 12 s"))):
        keep_room(connection, KeptRoom(room, name, "cans-on-bases", number, True, 0.0, 120.0))
    anna = accounts.add_account(connection, ANNA, NOW, password="hash").id
    ben = accounts.add_account(connection, "Ben", NOW).id
    accounts.log_in(connection, anna, NOW)
    accounts.add_link(connection, "for-one-of-them-alone", NOW, name=ANNA)
    bars.bar(connection, "a", anna, ANNA)
    bars.mute(connection, anna, ANNA)
    keep_branch(connection, Branch("b", anna, "a", 12.0))
    for number in range(300):  # so that pages are full, and some are emptied
        text = f'{{"action":{{"type":"line","line":"TYPE {WORD} {number}"}},"result":null}}'
        log.append(connection, Entry("a", 1, 1.0, NOW, "line", False, anna, ANNA, text))
    ours = [("allow", ben, "Ben", f'{{"name":{json.dumps(ANNA, ensure_ascii=False)}}}')]
    ours += [("line", ben, "Ben", f'{{"action":"for {ANNA}"}}')]
    for kind, account, name, text in ours:
        log.append(connection, Entry("a", 1, 1.0, NOW, kind, True, account, name, text))
    said = [
        (anna, ANNA, WORD, None),
        (ben, "Ben", f"{WORD} for you", anna),
        (ben, "Ben", f"hello {ANNA}!", None),
        (None, "", f"this room is for {ANNA} alone", None),
    ]
    for number, (account, name, text, reader) in enumerate(said, 1):
        line = Line("a", number, NOW, account, name, text, reader is not None, reader)
        keep_line(connection, line)
    for room, account, name, text in (
        ("a", anna, ANNA, "operator"),
        ("", ben, "Ben", f"for {ANNA}"),
    ):
        keep_notice(connection, KeptNotice(room, 1, NOW, account, name, text))
    for account, name, shelf in ((anna, ANNA, "own"), (anna, ANNA, "room"), (ben, "Ben", "room")):
        place = programs.own_shelf(account) if shelf == "own" else programs.room_shelf("a")
        text = f"; {WORD}" if account == anna else f"; with {ANNA}"
        version = programs.Version(f"{name[:3]}_pick", 0, NOW, account, name, 0)
        programs.save(connection, place, version, text, 0)
    return anna, ben


@pytest.fixture
def folder(tmp_path: Path) -> Folder:
    return Folder(tmp_path)


def test_after_a_purge_no_file_has_a_byte_of_a_person(folder: Folder) -> None:
    assert set(folder.holding(ANNA, WORD)) > {DATABASE, "live.version-2.sqlite", "history.bin"}
    found = purge(folder.place, ANNA, folder.key, mentions=True)
    assert found == Forgotten(1, ("live.version-2.sqlite",), 0, "")
    assert folder.holding(ANNA, WORD) == []
    assert folder.wrong() == [], "every text that is gone has a signed note"
    assert (folder.place / "sessions" / "a-1" / "history.off").exists()
    assert (folder.place / "sessions" / "a-1" / f"p{folder.ben}" / "pick.v2").exists()
    assert purge(folder.place, ANNA, folder.key) == Forgotten(0)


def test_texts_that_others_wrote_stay_until_somebody_wants_them_gone(folder: Folder) -> None:
    found = purge(folder.place, ANNA, folder.key)
    assert found.mentions == 3, "a command, a version of a program, a file"
    assert sorted(folder.holding(ANNA)) == ["for.v2", DATABASE]
    assert folder.holding(WORD) == []
    assert folder.wrong() == []


def test_a_purge_of_who_is_called_as_a_role_lets_the_server_begin_again(folder: Folder) -> None:
    def work(connection: Connection) -> None:
        account = accounts.add_account(connection, "operator", NOW, password="hash").id
        kept = KeptNotice("b", 1, NOW, folder.ben, "Ben", "operator")
        keep_notice(connection, kept)
        keep_notice(connection, kept._replace(room="", text="operator, see me"))
        keep_notice(connection, kept._replace(room="a", account=account, text="(purged)"))

    database = Database(folder.place / DATABASE, folder.key, signs=True)
    database.submit(work).result(10.0)
    database.close()
    purge(folder.place, "operator", folder.key)
    settings = Settings(folder.place, places_of(("cans-on-bases",)), log_key=folder.key)

    async def begun() -> list[str | None]:
        hub = Hub(settings, Database(folder.place / DATABASE, folder.key, signs=True))
        await open_kept(hub)
        hub.database.close()
        stops = [hub.rooms[room].stopped for room in ("a", "b")]
        return [announced(hub), *(stop.role if stop else "no stop" for stop in stops)]

    assert asyncio.run(begun()) == ["(purged), see me", None, "operator"]


class Interrupted:
    """A database that tells that somebody was purged, and then nothing."""

    asked = 0

    async def do(self, _: object) -> int:
        self.asked += 1
        if self.asked > 1:
            raise sqlite3.OperationalError("database is locked")
        return 1


def test_rooms_that_run_forget_what_was_said(folder: Folder) -> None:
    settings = Settings(folder.place, places_of(("cans-on-bases",)), log_key=folder.key)

    async def work() -> list[tuple[str, list[str]]]:
        hub = Hub(settings, Database(folder.place / DATABASE, folder.key, signs=True))
        await open_kept(hub)
        await forget_purged(hub)
        assert ANNA in hub.rooms["b"].kept.name
        assert announced(hub) == f"for {ANNA}"
        stopped = hub.rooms["a"].stopped
        assert stopped is not None
        assert (stopped.name, stopped.role) == (ANNA, "operator")
        told = Announcement(1, 0.0, ANNA, WORD, folder.anna)
        hub.announcement = Announcement(2, 0.0, "Ben", "stays", folder.ben)
        purge(folder.place, ANNA, folder.key)
        hub.database, whole = Interrupted(), hub.database  # type: ignore[assignment]
        with pytest.raises(sqlite3.OperationalError):
            await forget_purged(hub)
        hub.database = whole
        await forget_purged(hub)  # it is done again
        assert announced(hub) == "stays"
        hub.announcement, hub.purges = told, 0
        await forget_purged(hub)
        assert announced(hub) == ""
        stopped = hub.rooms["a"].stopped
        assert stopped is not None
        assert (stopped.name, stopped.role) == ("somebody", "operator"), (
            "it stands still all the same"
        )
        found = [
            (room.kept.name, [said.text for said, _ in room.chat]) for room in hub.rooms.values()
        ]
        hub.database.close()
        return found

    assert asyncio.run(work()) == [
        ("Group A", [f"hello {GONE}!", f"this room is for {GONE} alone"]),
        (f"{GONE}, from 12 s", []),
    ]
    assert folder.wrong() == []


def test_all_that_is_kept_of_a_person_is_handed_out(folder: Folder, tmp_path: Path) -> None:
    path = tmp_path / "anna.zip"
    words = ["serve", "--folder", str(folder.place), "--export-user", ANNA, "-o", str(path)]
    said = CliRunner().invoke(vrts, words)
    assert said.exit_code == 0, said.output
    assert f"300 records, 2 programs and 1 files in {path}" in said.stderr
    assert path.stat().st_mode & 0o777 == 0o600
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
        person = json.loads(archive.read("person.json"))
        records = [json.loads(row) for row in archive.read("log.jsonl").splitlines()]
        assert archive.read("files/a-1/pick.v2").decode() == f"; {WORD}"
        assert ANNA in archive.read("README.txt").decode()
    assert sum(name.startswith("programs/") for name in names) == 2
    assert records[0]["text"]["action"]["line"] == f"TYPE {WORD} 0"
    assert records[0]["room_name"] == "Group A"
    assert [row["name"] for row in person["account"]] == [ANNA]
    assert person["account"][0]["password"] == "kept, not shown"
    assert [row["text"] for row in person["chat"]] == [WORD, f"{WORD} for you"]
    counts = {table: len(rows) for table, rows in person.items()}
    once = ("account", "barred", "branch", "link", "log_name", "login", "muted", "notice")
    assert {table: counts[table] for table in once} == dict.fromkeys(once, 1)


def test_who_is_not_known_is_told_and_leaves_no_file(folder: Folder, tmp_path: Path) -> None:
    path = tmp_path / "nobody.zip"
    words = ["serve", "--folder", str(folder.place), "--log-key", str(folder.key)]
    for asked in (["--export-user", "Nobody", "-o", str(path)], ["--purge-user", "Nobody"]):
        said = CliRunner().invoke(vrts, [*words, *asked])
        assert said.exit_code == 1
        assert "nothing is kept of `Nobody`" in said.stderr
    assert not list(tmp_path.glob("nobody*"))


def test_names_are_found_as_words_and_short_ones_are_left() -> None:
    names = Names('A "B"')
    assert names.stands_in('{"name":"A \\"B\\""}')
    assert Names("Ann").without("Ann, Anna and Ann") == f"{GONE}, Anna and {GONE}"
    assert not Names("Ann").stands_in("Anna")
    assert Names("Al").short
    assert not Names("\u200b").stands_in("anything")
