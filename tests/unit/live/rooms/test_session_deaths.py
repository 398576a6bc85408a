"""Sessions that are killed, once or again and again, and rooms whose scene is not offered."""

import time
from pathlib import Path

import psutil
import pytest

from tests.support_live import PATIENCE, Browser, Json, LiveServer, session_processes
from vrts.live.logs.log_file import read_log
from vrts.live.logs.logged_sessions import LogRow, sessions_of
from vrts.live.rooms.again.deaths import MOST, WELL_S, Deaths
from vrts.live.rooms.again.words import command_words, died_too_often
from vrts.live.session.again.carrying_on import STOPPED


def settled(server: LiveServer, cookie: str, **join: str) -> tuple[Browser, Json]:
    """Join; return the browser, and the state of the session when it runs."""
    browser = server.join(cookie, **join)
    state = browser.wait("snapshot")["state"]
    browser.wait("control")
    while state is None:
        state = browser.wait("state")["state"]
    return browser, state


def done(browser: Browser, lease: str, action: str, **fields: object) -> str:
    """Give a command; return what is answered when it is recorded."""
    number = browser.command(lease, action, **fields)
    result: Json = browser.answer(number)["result"]
    assert result["accepted"], result
    return result["text"]


def session_of(server: LiveServer, *, other_than: int = 0) -> psutil.Process:
    """Return the process of the only session."""
    until = time.monotonic() + PATIENCE
    while time.monotonic() < until:
        for child in session_processes(server.process.pid):
            if child.pid != other_than and child.status() != psutil.STATUS_ZOMBIE:
                return child
        time.sleep(0.005)
    raise AssertionError("no session began")


def kill_until_it_waits(server: LiveServer, boss: Browser) -> Json:
    """Kill the session whenever it begins, until the supervisor is to choose."""
    pid = 0
    for _ in range(MOST):
        session = session_of(server, other_than=pid)
        pid = session.pid
        session.kill()
        psutil.wait_procs([session], PATIENCE)
    return boss.wait("no_session", lambda m: m["why"] != "")


@pytest.mark.thorough
def test_a_session_that_is_killed_goes_on_from_its_log(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        cookie = server.enter("Anna")
        anna, _ = settled(server, cookie)
        lease = anna.take_control()
        done(anna, lease, "upload", name="swing.v2", text=".PROGRAM swing()\n READY\n.END\n")
        done(anna, lease, "line", line="HERE place")
        done(anna, lease, "line", line="")  # no change
        for turn in range(3):
            done(anna, lease, "line", line=f"DO a[{turn}] = {turn}")
            lost = anna.command(lease, "line", line=f"DO b[{turn}] = 1")
            session_of(server).kill()
            answer = anna.answer(lost)  # it was recorded, or was not done
            anna.wait("chat", lambda m: "goes on from its log" in m["text"])
            state = anna.wait("state", lambda m: m["state"] is not None)["state"]
            assert [p["name"] for p in state["programs"]] == ["swing"]
            assert STOPPED in [row["text"] for row in state["events"]]
            kept = "1" in done(anna, lease, "line", line=f"LISTR b[{turn}]")
            assert kept or answer["type"] == "refused", "nothing acknowledged is lost"
        for turn in range(3):
            assert str(turn) in done(anna, lease, "line", line=f"LISTR a[{turn}]")
        assert "place" in done(anna, lease, "line", line="LISTL place")


@pytest.mark.thorough
def test_who_dies_again_and_again_waits_for_the_supervisor(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        boss, _ = settled(server, server.supervisor())
        room = boss.came[0]["room"]
        lease = boss.take_control()
        done(boss, lease, "line", line="DO a = 1")
        done(boss, lease, "line", line="DO a = 2")
        boss.send("go_on", without_last=False)
        assert boss.wait("refused")["code"] == "session", "nothing waits"
        waits = kill_until_it_waits(server, boss)
        assert "SIGKILL" in waits["why"]
        assert "`DO a = 2`" in waits["why"]
        assert waits["choices"] == ["again", "without_last", "begin"]
        anna = server.join(server.enter("Anna"))
        told = anna.wait("no_session")
        assert told["why"] == waits["why"]
        assert (told["help"], told["choices"]) == ("", []), "only a supervisor can choose"

        boss.send("go_on", without_last=True)
        assert boss.wait("no_session")["why"] == ""
        boss.wait("state", lambda m: m["state"] is not None)
        assert "1" in done(boss, lease, "line", line="LISTR a"), "as if it had not been given"
        (session,) = read_log(server.request("GET", f"/log/{room}", cookie=boss_cookie(boss)).body)
        lines = [str(entry.order) for entry in session.entries]
        assert not any("DO a = 2" in line for line in lines)

        assert kill_until_it_waits(server, boss)["why"]
        boss.send("set_scene", scene="cans-on-bases")
        boss.wait("state", lambda m: m["state"] is not None)
        assert "Undefined" in done(boss, lease, "line", line="LISTR a")


def boss_cookie(boss: Browser) -> str:
    request = boss.socket.request
    assert request is not None
    return request.headers["cookie"]


@pytest.mark.thorough
def test_a_room_whose_scene_is_not_offered_says_so_and_keeps_all(tmp_path: Path) -> None:
    both = ("cans-on-bases", "one-can-ur5")
    server = LiveServer(tmp_path / "live", scenes=both)
    boss, _ = settled(server, server.supervisor())
    room, cookie = boss.came[0]["room"], boss_cookie(boss)
    done(boss, boss.take_control(), "line", line="DO a = 7")
    before = server.request("GET", f"/log/{room}", cookie=cookie).body
    server.kill()
    server.close_browsers()

    with LiveServer(tmp_path / "live", scenes=both[1:], port=str(server.port)) as without:
        boss = without.join(cookie)
        snapshot = boss.wait("snapshot")
        assert snapshot["state"] is None
        assert not snapshot["room"]["offered"]
        assert snapshot["room"]["scene"] == both[0]
        said = boss.wait("no_session")
        assert "`cans-on-bases`" in said["why"]
        assert "vrts serve cans-on-bases" in said["help"]
        after = without.request("GET", f"/log/{room}", cookie=cookie).body
        known = before.split(b"\n")[1:-1]
        assert after.split(b"\n")[1 : len(known) + 1] == known, "its log is whole"
        boss.send("go_on")
        assert boss.wait("refused")["code"] == "session"

    with LiveServer(tmp_path / "live", scenes=both, port=str(server.port)) as again:
        boss, state = settled(again, cookie)
        assert STOPPED in [row["text"] for row in state["events"]]
        assert "7" in done(boss, boss.take_control(), "line", line="LISTR a")


def test_a_row_of_deaths_ends_with_a_command_and_with_time() -> None:
    deaths = Deaths()
    assert [deaths.died(1, 0.0) for _ in range(MOST)] == [False] * (MOST - 1) + [True]
    deaths = Deaths()
    assert not any(deaths.died(command, 0.0) for command in range(3 * MOST))
    assert not any(deaths.died(1, WELL_S + 1.0) for _ in range(3 * MOST))


@pytest.mark.parametrize("recorded", [True, False])
def test_what_was_not_recorded_cannot_be_left_out(recorded: bool) -> None:
    told = died_too_often("killed", 4, command_words(b'{"type":"ready"}'), recorded=recorded)
    assert "`ready`" in told.why
    assert ("without_last" in told.choices) == recorded


def test_a_command_that_is_taken_back_does_not_count_in_any_replay() -> None:
    def command(seq: int, line: str, at_s: float) -> LogRow:
        text = (
            f'{{"action":{{"type":"line","line":"{line}"}},"result":{{"type":"done","ref":{seq},'
            f'"at_s":{at_s},"accepted":true}}}}'
        )
        return LogRow(seq, 1, "line", "p1", text.encode())

    rows = [
        LogRow(1, 1, "begin", "p", b'{"scene":"x"}'),
        command(2, "DO a = 1", 3.0),
        command(3, "DO a = 2", 8.0),
        LogRow(4, 2, "carry_on", "p", b'{"at_s":9.0}'),
        LogRow(5, 2, "without", "p1", b'{"seq":3}'),
    ]
    (session,) = sessions_of(rows)
    assert [entry.at_s for entry in session.entries] == [3.0]
    assert session.least_s == 8.0, "time goes on to where it was given"
    assert session.jumped == 5, "what was reached after it counts no more"
