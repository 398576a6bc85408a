"""Connections that sleep and return, servers that are killed and return."""

import sqlite3
from pathlib import Path

import psutil
import pytest

from tests.support_live import Browser, LiveServer
from vrts.live.session.views.frame import unpacked
from vrts.live.settings import DATABASE
from vrts.live.store import log
from vrts.live.store.database import opened


@pytest.mark.thorough
def test_sixty_from_one_address_and_twenty_of_them_asleep(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        cookies = [server.enter(f"Student {n}") for n in range(60)]
        browsers = [server.join(cookie) for cookie in cookies]
        for browser in browsers:
            browser.wait("snapshot")
        asleep, awake = browsers[:20], browsers[20:]
        welcomes = [b.came[0] for b in asleep]
        assert all(w["type"] == "welcome" for w in welcomes)
        seen = [max((m.get("number", 0) for m in b.came), default=0) for b in asleep]
        for browser in asleep:
            browser.socket.socket.close()  # a closed lid says no good-bye
        for n in range(5):
            awake[n].send("say", text=f"while they slept {n}")
        said = {f"while they slept {n}" for n in range(5)}
        for browser in awake[5:]:
            assert {browser.wait("chat")["text"] for _ in range(5)} == said
        back = [
            server.join(cookie, resume=welcome["resume"], seen=number)
            for cookie, welcome, number in zip(cookies, welcomes, seen, strict=False)
        ]
        for browser, welcome in zip(back, welcomes, strict=True):
            again = browser.wait("welcome")
            assert again["resumed"]
            assert again["you"] == welcome["you"]
            browser.wait("snapshot")
            assert {m["text"] for m in browser.came if m["type"] == "chat"} == said
        people = back[0].wait("people", lambda m: not any(p["away"] for p in m["people"]))
        assert len(people["people"]) == 60, "nobody is there twice"


@pytest.mark.thorough
def test_a_client_that_does_not_read_holds_up_nobody(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        awake = server.join(server.enter("Awake"))
        awake.wait("control")
        alone = share_taken(awake)
        sleeper = server.join(server.enter("Sleeper"))
        sleeper.wait("control")
        sleeper.socket.socket.setsockopt(1, 8, 4096)  # SO_RCVBUF
        memory = psutil.Process(server.process.pid)
        awake.take_frames(40)
        before = memory.memory_info().rss
        assert share_taken(awake) > 0.5 * alone, "no more are left out because of a sleeper"
        assert memory.memory_info().rss - before < 8_000_000


def share_taken(browser: Browser) -> float:
    """Return how many of the frames that were made reach a browser, over some 120 of them."""
    sequence = [unpacked(frame).sequence for frame in browser.take_frames(120)]
    assert sequence == sorted(set(sequence))
    return len(sequence) / (sequence[-1] - sequence[0] + 1)


def work(browser: Browser, lease: str, count: int, offset: int) -> list[int]:
    """Give commands; return the numbers of those that were acknowledged."""
    for n in range(count):
        browser.command(lease, "line", line=f"a = {offset + n}")
    return [browser.wait("result")["of"] for _ in range(count)]


@pytest.mark.thorough
def test_a_killed_server_has_kept_all_that_it_acknowledged(tmp_path: Path) -> None:
    folder = tmp_path / "live"
    server = LiveServer(folder)
    cookie = server.enter("Anna")
    anna = server.join(cookie)
    room = anna.wait("welcome")["room"]
    if anna.wait("snapshot")["state"] is None:
        anna.wait("state")
    lease = anna.take_control()
    anna.send("say", text="before the end")
    anna.wait("chat", lambda m: m["text"] == "before the end")
    acknowledged = work(anna, lease, 20, 0)
    for n in range(40):  # under way when the server dies
        anna.command(lease, "line", line=f"b = {n}")
    anna.wait("result", lambda m: m["of"] > 30)  # some are acknowledged, others are not
    children = psutil.Process(server.process.pid).children(recursive=True)
    server.kill()
    anna.quiet_until_closed()
    acknowledged += [m["of"] for m in anna.came if m["type"] == "result" and m["of"] > 20]
    gone, alive = psutil.wait_procs(children, timeout=10.0)
    assert gone
    assert not alive, "sessions do not outlive their server"

    connection = opened(folder / DATABASE)
    assert log.verify(connection, room) == ""
    kept = [record for record in log.records(connection, room) if record.record.kind == "line"]
    connection.close()
    assert len(kept) >= len(acknowledged)
    server.close_browsers()

    port = str(server.port)
    server.start(port)
    with server:
        assert server.request("GET", "/me", cookie=cookie).json["name"] == "Anna"
        back = server.join(cookie, room=room, resume="gone", seen=10_000)
        assert not back.wait("welcome")["resumed"]
        chat = [line["text"] for line in back.wait("snapshot")["chat"]]
        assert chat == ["before the end"]
        back.wait("now")
        work(back, back.take_control(), 3, 100)
    with sqlite3.connect(folder / DATABASE) as after:
        (count,) = after.execute("SELECT count(*) FROM log WHERE kind='line'").fetchone()
        assert log.verify(after, room) == ""
    after.close()
    assert count == len(kept) + 3


def settled(server: LiveServer, name: str, **fields: str) -> Browser:
    browser = server.join(server.enter(name), **fields)
    state = browser.wait("snapshot")["state"]
    browser.wait("control")
    if state is None:
        browser.wait("state")
    return browser


def test_an_endless_program_delays_nobody(tmp_path: Path) -> None:
    names = tmp_path / "rooms.txt"
    names.write_text("One\nTwo\n")
    with LiveServer(tmp_path / "live", "--rooms", str(names)) as server:
        anna = settled(server, "Anna")
        rooms = next(m["rooms"] for m in anna.came if m["type"] == "snapshot")
        ben = settled(server, "Ben", room=rooms[1]["id"])
        lease = anna.take_control()
        anna.command(lease, "upload", name="x.v2", text=".PROGRAM x()\n10 GOTO 10\n.END\n")
        anna.command(lease, "line", line="EXECUTE x")
        anna.wait("now", lambda m: m["status"]["mode"] == "running")
        for browser in (anna, ben):
            times = [unpacked(frame).time_s for frame in browser.take_frames(60)]
            assert times[-1] - times[0] > 1.0, "session time follows the clock"
        anna.send("panic")
        anna.wait("now", lambda m: m["status"]["mode"] != "running")
