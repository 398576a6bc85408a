"""A server that is killed in the middle of everything, and what stands where when it is back."""

import sqlite3
import time
from pathlib import Path
from typing import Any

import pytest

from tests.support_live import PATIENCE, Browser, Json, LiveServer
from vrts.live.administration import purge_user
from vrts.live.logs.log_file import read_log
from vrts.live.places import places_of
from vrts.live.session.again.carrying_on import STOPPED
from vrts.live.session.again.replay import replay
from vrts.live.session.channel.messages import Start
from vrts.live.session.growing.folder import FILE, OFF
from vrts.live.session.views.frame import MOVING, RUNNING, unpacked
from vrts.live.settings import DATABASE, SESSIONS

PROGRAM = """\
.PROGRAM swing()
    DRIVE 1,25,10
    TYPE "half of it"
    BREAK
    turns = 7
    SIGNAL 3
 10 DRIVE 1,60,10
    DRIVE 1,-60,10
    GOTO 10
.END
"""


def settled(server: LiveServer, cookie: str) -> tuple[Browser, Json]:
    """Join; return the browser, and the state of the session when it runs."""
    browser = server.join(cookie)
    state = browser.wait("snapshot")["state"]
    browser.wait("control")
    while state is None:
        state = browser.wait("state")["state"]
    return browser, state


def typed(browser: Browser, lease: str, line: str) -> str:
    """Type a line; return what the monitor answers."""
    number = browser.command(lease, "line", line=line)
    result: Json = browser.wait("result", lambda m: m["of"] == number)["result"]
    assert result["accepted"]
    return result["text"]


@pytest.mark.thorough
def test_a_killed_server_goes_on_with_everything_where_it_was(tmp_path: Path) -> None:
    server = LiveServer(tmp_path / "live")
    cookie = server.enter("Anna")
    anna, state = settled(server, cookie)
    room = anna.came[0]["room"]
    lease = anna.take_control()
    anna.command(lease, "upload", name="swing.v2", text=PROGRAM)
    typed(anna, lease, "DO a = 42")
    anna.command(lease, "record", name="here")
    typed(anna, lease, "EXECUTE swing")
    anna.wait("now", lambda m: 3 in m["status"]["signals"])
    anna.wait("now", lambda m: m["status"]["joints_rad"][0] > 0.7)
    (before,) = reached(tmp_path / "live", room, beyond=0.0)
    (later,) = reached(tmp_path / "live", room, beyond=before)
    server.kill()
    anna.quiet_until_closed()
    server.close_browsers()
    last = unpacked(anna.frames[-1])
    assert last.flags & RUNNING
    (until,) = reached(tmp_path / "live", room, beyond=later - 1e-9)

    server.start(str(server.port))
    with server:
        back, state = settled(server, cookie)
        stopped = next(row for row in state["events"] if row["text"] == STOPPED)
        assert stopped["time_s"] == pytest.approx(until), "within a second of the end"
        assert last.time_s - stopped["time_s"] < 4.0
        assert "half of it" in state["output"]
        assert [p["name"] for p in state["programs"]] == ["swing"]
        back.wait("now", lambda m: m["status"]["mode"] == "stopped")
        stands = unpacked(back.frames[-1])
        assert not stands.flags & (RUNNING | MOVING)
        assert stands.time_s > stopped["time_s"], "the time of the session goes on"
        again = back.take_control()
        assert "42" in typed(back, again, "LISTR a")
        assert "7" in typed(back, again, "LISTR turns")
        assert "here" in typed(back, again, "LISTL here")
        files = list((tmp_path / "live/sessions").glob("*/p*/swing.v2"))
        assert len(files) == 1, "made again, and gone from where it was"
        typed(back, again, "PROCEED")
        back.wait("now", lambda m: m["status"]["mode"] in ("running", "waiting"))
        back.send("panic")
        back.wait("now", lambda m: m["status"]["mode"] == "stopped")
        back.quiet(0.5)
        end = unpacked(back.frames[-1])
        log = server.request("GET", f"/log/{room}", cookie=server.supervisor()).body

    (session,) = read_log(log)
    place = places_of((session.scene,))[0]
    run = replay(Start(session.number, "", place.scene), session.entries, until_s=end.time_s)
    for frame in map(unpacked, anna.frames):
        if frame.time_s < stopped["time_s"]:
            assert run.at(frame.time_s).configuration == pytest.approx(frame.joints, abs=1e-6)
    assert run.at(end.time_s).configuration == pytest.approx(end.joints, abs=1e-6)
    middle = run.at(stands.time_s).configuration
    assert middle == pytest.approx(stands.joints, abs=1e-6), "it came to rest where it was"


def test_where_it_cannot_go_on_it_begins_anew_and_says_why(tmp_path: Path) -> None:
    folder, names = tmp_path / "live", tmp_path / "rooms.txt"
    names.write_text("One\nTwo\n")
    both = ("cans-on-bases", "one-can-ur5")
    server = LiveServer(folder, "--rooms", str(names), scenes=both)
    anna, _ = settled(server, server.enter("Anna"))
    number = anna.command(anna.take_control(), "line", line="DO a = 1")
    anna.wait("result", lambda m: m["of"] == number)
    supervisor = server.supervisor()
    boss = server.join(supervisor)
    other = boss.wait("rooms")["rooms"][1]["id"]
    away = server.join(supervisor, room=other)
    away.wait("control")
    away.send("set_scene", scene="one-can-ur5")
    away.wait("state", lambda m: "can2" not in str(m["state"]))
    server.kill()
    server.close_browsers()
    before = next((folder / SESSIONS).glob("*/p*")).parent
    (before / FILE).write_bytes(b"what was long ago")
    assert purge_user(folder, "Anna").accounts == 1
    assert not (before / FILE).exists()
    assert (before / OFF).exists(), "a server that runs does not keep it again"

    server.start(str(server.port))
    with server:
        ben, state = settled(server, server.enter("Ben"))
        assert state["status"]["time_s"] < 60.0
        assert not state["events"]
        chat = next(m for m in ben.came if m["type"] == "snapshot")["chat"]
        said = [line["text"] for line in chat if not line["person"]]
        said += [m["text"] for m in ben.came if m["type"] == "chat"]
        assert any("begins again" in text and "was purged" in text for text in said)
        number = ben.command(ben.take_control(), "line", line="LISTR a")
        told = ben.wait("result", lambda m: m["of"] == number)["result"]["text"]
        assert "Undefined" in told
        boss = server.join(supervisor, room=other)
        entry = boss.wait("snapshot")["room"]
        assert (entry["scene"], entry["id"]) == ("one-can-ur5", other)


def reached(folder: Path, room: str, *, beyond: float) -> tuple[float, ...]:
    """Wait until the database says that a session has come farther than a time [s]."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        connection = sqlite3.connect(folder / DATABASE, timeout=10.0)
        rows: list[Any] = connection.execute(
            "SELECT time_s FROM reached WHERE room=? AND time_s>?", (room, beyond)
        ).fetchall()
        connection.close()
        if rows:
            return tuple(row[0] for row in rows)
        time.sleep(0.02)
    raise AssertionError("nothing is kept")
