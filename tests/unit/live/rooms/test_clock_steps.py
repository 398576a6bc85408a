"""The machine's clock is set back and forward while a class works, and nobody notices.

By libfaketime, whose file of offsets is changed while the server runs. Clocks that only go forward
are left as they are, as the machine leaves them when its clock is set.
"""

import time
from email.utils import parsedate_to_datetime
from pathlib import Path

import pytest

from tests.support_live import Json, LiveServer
from tests.unit.live.rooms.test_session_deaths import done, session_of, settled
from vrts.live.rooms.control import IDLE_S

HOUR = 3600
FOUND = sorted(Path("/usr/lib").glob("*/faketime/libfaketime.so.1"))


@pytest.mark.thorough
@pytest.mark.skipif(not FOUND, reason="needs libfaketime (faketime)")
def test_steps_of_the_clock_change_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    offset = tmp_path / "offset"
    offset.write_text("+0s\n")
    for name, value in {
        "LD_PRELOAD": str(FOUND[0]),
        "FAKETIME_TIMESTAMP_FILE": str(offset),
        "FAKETIME_NO_CACHE": "1",
        "FAKETIME_DONT_FAKE_MONOTONIC": "1",
        "DONT_FAKE_MONOTONIC": "1",
    }.items():
        monkeypatch.setenv(name, value)
    server = LiveServer(tmp_path / "live", "--turn", "600", measured=True)
    for name in ("LD_PRELOAD", "FAKETIME_TIMESTAMP_FILE"):
        monkeypatch.delenv(name)
    with server:
        cookie = server.enter("Anna")
        anna, _ = settled(server, cookie)
        ben, _ = settled(server, server.enter("Ben"))
        lease = anna.take_control()
        ben.send("request_control")
        ends = [anna.wait("control", lambda m: m["ends"] > 0.0)["ends"]]
        lines: list[Json] = []
        for number, step in enumerate((-HOUR, +HOUR, 90 * 24 * HOUR, -90 * 24 * HOUR)):
            offset.write_text(f"{step:+d}s\n")
            told = server.request("GET", "/me", cookie=cookie)
            assert told.status == 200, "whoever was in stays in"
            date = parsedate_to_datetime(str(told.headers["date"])).timestamp()
            assert abs(date - time.time()) < HOUR / 2, "the pages' clock stays right"
            assert done(anna, lease, "line", line=f"DO a = {number}")
            anna.send("say", text=f"after {step} s")
            lines.append(anna.wait("chat", lambda m: m["person"] != ""))
            assert server.enter(f"New {number}"), "the code lets in as before"
            anna.send("raise_hand", up=number % 2 == 0)
            anna.wait("people")  # the pulse goes on
            ben.send("say", text="still waiting")
            ben.wait("chat", lambda m: m["text"] == "still waiting")
        assert [line["at"] for line in lines] == sorted(line["at"] for line in lines)
        assert lines[-1]["at"] - lines[0]["at"] < IDLE_S, "the times that are shown do not jump"
        states = [m for m in anna.came + ben.came if m["type"] == "control"]
        holders = {m["holder"] for m in states if m["ends"] > 0.0}
        assert len(holders) == 1, "nobody has lost the right"
        ends += [m["ends"] for m in states if m["ends"] > 0.0]
        assert max(ends) - min(ends) < 1.0, "the turn ends when it was to end"
        session_of(server).kill()
        anna.wait("state", lambda m: m["state"] is not None)
        assert "3" in done(anna, lease, "line", line="LISTR a"), (
            "the log is carried on all the same"
        )
