"""What nobody may fill: a log, what waits for a full disk, shelves and folders of closed rooms."""

import asyncio
import sqlite3
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.support_live import PATIENCE, Browser, LiveServer
from tests.unit.live.rooms.test_full_disk import Failing
from vrts.live import limits
from vrts.live.places import places_of
from vrts.live.protocol.from_server import Chat
from vrts.live.rooms.again.folders import LEFT, empty_earlier, remove_all_closed, remove_closed
from vrts.live.rooms.hub import DISK_HELP, DISK_LOST, NO_DISK, Hub
from vrts.live.rooms.keeping import OFTEN, log_soon, record, stamped
from vrts.live.rooms.room import Room
from vrts.live.session.growing.folder import FILE
from vrts.live.settings import DATABASE, SESSIONS, Settings
from vrts.live.store.accounts import Account
from vrts.live.store.database import Database, opened
from vrts.live.store.rooms import KeptRoom
from vrts.live.store.waiting import journal


def test_only_so_many_records_wait_for_room_and_what_is_lost_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(journal, "MOST_WAITING", 3)
    monkeypatch.setattr(journal, "MOST", 5)
    hub = Hub(Settings(tmp_path, places_of(("cans-on-bases",))), Failing(tmp_path / "live.sqlite"))
    room = hub.rooms["r"] = Room(KeptRoom("r", "Class", "cans-on-bases", 1, True, 0.0, 0.0))
    told: list[str] = []

    def tell(_: Room, said: Chat, number: int) -> None:
        told.append(said.text)

    monkeypatch.setattr(Room, "tell", tell)

    async def work() -> list[bool]:
        for number in range(6):
            record(hub, room, "join", Account(number, "Guest", False, None), {})
        stops = [
            log_soon(hub, stamped(room, "panic", None, "{}", at_s=1.0, accepted=True))
            for _ in range(4)
        ]
        await hub.journal.settled()
        return [isinstance(stop.exception(), sqlite3.OperationalError) for stop in stops]

    assert all(asyncio.run(work())), "who waited was told that it is not written"
    hub.database.close()
    assert told == [f"{NO_DISK}; {DISK_HELP}", DISK_LOST.format(5)]
    connection = opened(tmp_path / "live.sqlite")
    rows = connection.execute("SELECT kind FROM log ORDER BY seq").fetchall()
    connection.close()
    assert [row[0] for row in rows] == ["join"] * 3 + ["panic"] * 2


def test_who_causes_very_many_records_leaves_room_for_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "RECORDS", 3)
    hub = Hub(Settings(tmp_path, places_of(("cans-on-bases",))), Database(tmp_path / "live.sqlite"))
    room = hub.rooms["r"] = Room(KeptRoom("r", "Class", "cans-on-bases", 1, True, 0.0, 0.0))

    async def work() -> None:
        for number in range(5):
            record(hub, room, "control", None, {})
            record(hub, room, "join", Account(number, "Guest", False, None), {})
            record(hub, room, "lock", None, {"on": True})
        await hub.stop()

    asyncio.run(work())
    assert [chat.text for chat, _ in room.chat] == [OFTEN["control"], OFTEN["join"]]
    connection = opened(tmp_path / "live.sqlite")
    rows = connection.execute("SELECT kind, count(*) FROM log GROUP BY kind ORDER BY kind")
    assert rows.fetchall() == [("control", 3), ("join", 3), ("lock", 5)]
    connection.close()


def filled(sessions: Path, room: str, number: int, fault: str = "") -> Path:
    """Write the folder of a session that is over."""
    folder = sessions / f"{room}-{number}"
    (folder / "p7").mkdir(parents=True)
    for name in (f"p7/{room}.v2", FILE, "before.jsonl"):
        (folder / name).write_text("x")
    (folder / "stderr.txt").write_text(fault)
    return folder


def test_of_closed_rooms_only_what_tells_of_faults_stays(tmp_path: Path) -> None:
    fine, failed = filled(tmp_path, "a", 1), filled(tmp_path, "a", 2, "a fault")
    others = [filled(tmp_path, "b", number, "a fault") for number in range(LEFT + 2)]
    (tmp_path / "not-ours").mkdir()
    remove_all_closed(tmp_path, ["b"])
    assert not fine.exists()
    assert [path.name for path in failed.iterdir()] == ["stderr.txt"]
    assert all((folder / FILE).exists() for folder in others), "that room is open"
    remove_closed(tmp_path, "b")
    assert [folder.exists() for folder in others] == [False, False, *[True] * LEFT]
    assert not any((folder / FILE).exists() for folder in others)
    assert (tmp_path / "not-ours").exists()


def test_a_folder_that_cannot_be_emptied_holds_up_nothing(
    tmp_path: Path, caplog: pytest.LogCaptureFixture
) -> None:
    odd, fine = filled(tmp_path, "a", 1), filled(tmp_path, "a", 2)
    (odd / FILE).unlink()
    (odd / FILE).mkdir()
    remove_all_closed(tmp_path, [])
    assert odd.exists()
    assert not fine.exists()
    assert "could not be emptied" in caplog.text
    fine = filled(tmp_path, "a", 2)
    empty_earlier(filled(tmp_path, "a", 3), "a")
    remove_closed(tmp_path, "a")
    assert odd.exists()
    assert not fine.exists()


@pytest.mark.thorough
def test_what_is_over_leaves_no_folder_and_no_program_of_nobody(tmp_path: Path) -> None:
    (tmp_path / "names").write_text("A\nB\n")
    with LiveServer(tmp_path / "live", "--rooms", str(tmp_path / "names")) as server:
        boss_cookie, cookie = server.supervisor(), server.enter("Anna")
        boss, anna = server.join(boss_cookie), server.join(cookie)
        boss.wait("state", lambda m: m["state"] is not None)
        first, second = (room["id"] for room in boss.came[1]["rooms"])
        lease = anna.take_control()
        anna.answer(anna.command(lease, "upload", name="own.v2", text=".PROGRAM own\n.END\n"))
        sessions = server.folder / SESSIONS
        (before,) = sessions.glob(f"{first}-*/p*")
        kept = {"room": first, "shelf": "room", "name": "pick", "text": "; mine", "seen": 0}
        assert server.request("POST", "/programs/keep", kept, cookie=cookie).status == 200
        boss.send("set_scene", scene="cans-on-bases")
        anna.wait("state", lambda m: m["state"] is None)
        anna.wait("state", lambda m: m["state"] is not None)
        until(boss, lambda: not before.exists())
        boss.send("close_room", room=first)
        closed = anna.closed()
        assert closed is not None
        assert closed["code"] == "room closed"
        boss = server.join(boss_cookie, room=second)
        until(boss, lambda: not list(sessions.glob(f"{first}-*")))
        there = server.request("GET", f"/programs?room={second}", cookie=cookie).json
        assert [row["name"] for row in there["own"]] == ["pick"]
        connection = opened(server.folder / DATABASE)
        shelves = connection.execute("SELECT DISTINCT shelf FROM program_version").fetchall()
        connection.close()
        assert [shelf.split()[0] for (shelf,) in shelves] == ["own"]


def until(browser: Browser, done: Callable[[], bool]) -> None:
    """Take messages until something is done."""
    end_s = time.monotonic() + PATIENCE
    while not done():
        assert time.monotonic() < end_s
        browser.quiet(0.05)


@pytest.mark.thorough
def test_several_pages_of_one_account_may_do_no_more_than_one(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        cookie = server.enter("Anna")
        pages = [server.join(cookie) for _ in range(3)]
        for page in pages:
            page.wait("snapshot")
            for number in range(6):
                page.send("say", text=f"line {number}")
        assert pages[2].wait("refused")["text"] == "too many lines at once"
        first = pages[0]
        for _ in range(40):
            first.send("request_control")
            first.send("hand_back")
        refused = first.wait("refused", lambda m: "control" in m["text"])
        assert (refused["code"], refused["help"]) == ("rate", "wait a few seconds")
