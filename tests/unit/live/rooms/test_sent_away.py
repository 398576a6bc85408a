"""Who was sent away stays away, until they are allowed again; who was purged is gone at once."""

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.support_live import Answer, Browser, LiveServer
from vrts.live.new_account import add_user
from vrts.live.session.views.frame import unpacked
from vrts.live.settings import DATABASE
from vrts.live.store import log
from vrts.live.store.database import opened

USER = {"user": "Eva", "password": "correct horse"}


@pytest.fixture
def server(tmp_path: Path) -> Iterator[LiveServer]:
    names = tmp_path / "rooms.txt"
    names.write_text("One\nTwo\n")
    add_user(tmp_path / "live", USER["user"], USER["password"], supervisor=False)
    with LiveServer(tmp_path / "live", "--rooms", str(names)) as found:
        yield found


def present(browser: Browser) -> str:
    """Return the room that a browser has entered."""
    return browser.wait("welcome")["room"]


def refused(browser: Browser) -> bool:
    closed = browser.closed()
    return closed is not None and (closed["type"], closed["code"]) == ("closed", "kicked")


def browser_of(cookies: str) -> str:
    """Return the cookie that says which browser it is, and not who."""
    return next(one for one in cookies.split("; ") if "_browser=" in one)


def enter(server: LiveServer, name: str, cookie: str) -> Answer:
    """Use the class code in a browser that has a cookie."""
    return server.request("POST", "/enter", {"code": server.code, "name": name}, cookie=cookie)


@pytest.mark.thorough
def test_who_was_sent_away_stays_away_until_they_are_allowed(server: LiveServer) -> None:
    cookie = server.enter("Anna")
    anna, boss = server.join(cookie), server.join(server.supervisor())
    room = present(anna)
    anna.wait("snapshot")
    me = anna.came[0]["you"]
    boss.wait("people", lambda m: any(p["id"] == me for p in m["people"]))
    boss.send("kick", person=me)
    assert refused(anna)
    told = boss.wait("people", lambda m: bool(m["barred"]))
    assert told["barred"] == ["Anna"]

    assert refused(server.join(cookie, room=room)), "the same cookie"
    again = enter(server, "Berta", cookie)
    assert room not in {r["id"] for r in again.json["rooms"]}
    assert refused(server.join(again.cookie, room=room)), "the same browser, another name"
    server.request("POST", "/logout", cookie=again.cookie)
    kept = browser_of(again.cookie)
    assert server.request("GET", "/me", cookie=kept).status == 401, "it lets nobody in"
    later = enter(server, "Carla", kept)
    assert refused(server.join(later.cookie, room=room)), "logged out in between"
    assert refused(server.join(server.enter("anna"), room=room)), "the same name elsewhere"
    assert refused(server.join(server.enter("Аnnа"), room=room)), "one that looks the same"
    other = server.join(cookie)
    assert present(other) != room, "the other rooms stay open"
    present(server.join(server.enter("Doris"), room=room))

    boss.send("allow", name="Anna")
    boss.wait("people", lambda m: not m["barred"])
    assert present(server.join(cookie, room=room)) == room
    assert present(server.join(later.cookie, room=room)) == room


def test_everybody_of_a_browser_is_sent_away_and_muted_together(server: LiveServer) -> None:
    one = server.request("POST", "/enter", {"code": server.code, "name": "Anna"})
    two = enter(server, "Berta", browser_of(one.cookie))
    anna, berta = server.join(one.cookie), server.join(two.cookie)
    boss, ben = server.join(server.supervisor()), server.join(server.enter("Ben"))
    me = berta.wait("welcome")["you"]
    anna.wait("snapshot")
    boss.wait("people", lambda m: any(p["id"] == me for p in m["people"]))
    boss.send("mute", person=me, on=True)
    told = boss.wait("people", lambda m: m["muted"] == ["Berta"])
    assert {p["name"] for p in told["people"] if p["muted"]} == {"Anna", "Berta"}
    for muted in (anna, berta):
        muted.send("say", text="hello")
        assert muted.wait("refused")["code"] == "muted"
    server.request("POST", "/logout", cookie=two.cookie)
    for left in (anna, berta):
        closed = left.closed()
        assert closed is not None
        assert (closed["code"], closed["text"]) == ("left", "you have logged out")
    doris = server.join(enter(server, "Doris", browser_of(two.cookie)).cookie)
    doris.wait("snapshot")
    doris.send("say", text="hello")
    assert doris.wait("refused")["code"] == "muted", "another name helps nothing"
    assert not ben.wait("people")["muted"], "only supervisors are told"
    boss.send("unmute", name="Berta")
    boss.wait("people", lambda m: not m["muted"])
    doris.send("say", text="it is me")
    ben.wait("chat", lambda m: m["text"] == "it is me")
    assert "hello" not in [m.get("text") for m in ben.came]

    anna = server.join(one.cookie)
    you = anna.wait("welcome")["you"]
    anna.wait("snapshot")
    boss.wait("people", lambda m: any(p["id"] == you for p in m["people"]))
    boss.send("kick", person=you)
    assert refused(anna)
    assert refused(doris)
    assert boss.wait("people", lambda m: bool(m["barred"]))["barred"] == ["Anna"]


@pytest.mark.thorough
def test_a_log_out_ends_no_connection_of_another_browser(server: LiveServer) -> None:
    here, there = (server.request("POST", "/login", USER).cookie for _ in range(2))
    first, second = server.join(here), server.join(there)
    for one in (first, second):
        one.wait("snapshot")
    server.request("POST", "/logout", cookie=here)
    closed = first.closed()
    assert closed is not None
    assert closed["code"] == "left"
    assert server.request("GET", "/me", cookie=here).status == 401
    second.send("say", text="still here")
    second.wait("chat", lambda m: m["text"] == "still here")


@pytest.mark.thorough
def test_bars_and_mutes_outlast_the_server(tmp_path: Path) -> None:
    folder = tmp_path / "live"
    server = LiveServer(folder)
    cookie = server.enter("Anna")
    anna, boss = server.join(cookie), server.join(server.supervisor())
    room = present(anna)
    ben = server.join(server.enter("Ben"))
    boss.wait("people", lambda m: len(m["people"]) == 3)
    boss.send("kick", person=anna.came[0]["you"])
    assert refused(anna)
    boss.send("mute", person=ben.wait("welcome")["you"], on=True)
    boss.wait("people", lambda m: bool(m["muted"]))
    server.kill()
    server.close_browsers()
    server.start(str(server.port))
    with server:
        assert refused(server.join(cookie, room=room))
        boss = server.join(server.supervisor())
        assert boss.wait("people")["muted"] == ["Ben"]


@pytest.mark.thorough
def test_who_is_purged_while_connected_is_gone(server: LiveServer, tmp_path: Path) -> None:
    cookie = server.enter("Anna")
    anna, ben = server.join(cookie), server.join(server.enter("Ben"))
    room = present(anna)
    ben.wait("snapshot")
    if anna.wait("snapshot")["state"] is None:
        anna.wait("state")
    lease = anna.take_control()
    number = anna.command(lease, "upload", name="mine.v2", text=".PROGRAM mine()\n.END\n")
    anna.wait("result", lambda m: m["of"] == number)
    anna.send("say", text="my secret")
    ben.wait("chat", lambda m: m["text"] == "my secret")
    files = list((tmp_path / "live/sessions").glob("*/p*/mine.v2"))
    assert files
    words = [sys.executable, "-m", "vrts.cli.main", "serve", "--folder", str(tmp_path / "live")]
    subprocess.run([*words, "--purge-user", "Anna"], check=True, capture_output=True)
    closed = anna.closed()
    assert closed is not None
    assert "removed" in closed["text"]
    assert server.request("GET", "/me", cookie=cookie).status == 401
    late = server.join(server.enter("Late"))
    assert "my secret" not in [line["text"] for line in late.wait("snapshot")["chat"]]
    assert not any(file.exists() for file in files)
    connection = opened(tmp_path / "live" / DATABASE)
    assert log.verify(connection, room) == ""
    assert "Anna" not in {one.name for one in log.records(connection, room)}
    connection.close()


@pytest.mark.thorough
def test_sixty_frames_a_second_for_who_wants_them(server: LiveServer) -> None:
    fast, usual = server.join(server.enter("Fast"), rate=60), server.join(server.enter("Usual"))
    usual.wait("snapshot")
    while len(fast.frames) < 30 or span_s(fast.frames[-30:]) > 29 / 55:
        fast.take()
        assert len(fast.frames) < 3000, "never more than 50 frames a second"


def span_s(frames: list[bytes]) -> float:
    """Return the session time between the first frame and the last [s]."""
    return unpacked(frames[-1]).time_s - unpacked(frames[0]).time_s
