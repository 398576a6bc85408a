"""Announcements and stops: who has seen one, when it is over, and who may say so."""

import time
from pathlib import Path

import pytest

from tests.support_live import PATIENCE, LiveServer
from vrts.live.notices.announcement import Announcement, next_announcement
from vrts.live.notices.stopping import MOVING, is_panic, moves
from vrts.live.settings import DATABASE
from vrts.live.store.database import opened


def test_people_who_have_seen_an_announcement_are_counted_once_and_while_they_are_here() -> None:
    told = Announcement(7, 1.0, "Dr. Lee", "Read page 4")
    for account, closed in ((1, False), (1, True), (1, True), (2, False), (3, True)):
        told.noticed(account, closed=closed)
    assert told.changed
    whole = told.message({1, 2, 4})
    assert (whole.seen, whole.closed, whole.people) == (2, 1, 3)
    others = told.message(None)
    assert (others.text, others.seen, others.closed, others.people) == ("Read page 4", 0, 0, 0)
    told.changed = False
    told.noticed(1, closed=True)
    assert not told.changed, "nothing new for supervisors"


def test_no_two_announcements_have_one_number_though_the_clock_goes_back() -> None:
    first = next_announcement(None, 100.0, "Dr. Lee", "one")
    assert next_announcement(first, 50.0, "Dr. Lee", "two").id > first.id


def test_a_stop_is_over_when_something_moves() -> None:
    assert moves(b'{"type":"status","mode":"moving","time_s":1.0}')
    assert not any(moves(b'{"mode":"%b"}' % mode) for mode in (b"idle", b"stopped", b"braking"))


def test_panic_is_pressed_or_typed() -> None:
    assert is_panic(b'{"type":"panic"}')
    assert is_panic(b'{"type":"line","line":" panic "}')
    assert not is_panic(b'{"type":"line","line":"TYPE PANIC"}')
    assert not is_panic(b'{"type":"let_go"}')


def until_kept(server: LiveServer, *, notices: int) -> None:
    """Wait until so many notices are in the database."""
    connection = opened(server.folder / DATABASE)
    until = time.monotonic() + PATIENCE
    while connection.execute("SELECT count(*) FROM notice").fetchone() != (notices,):
        assert time.monotonic() < until
        time.sleep(0.02)
    connection.close()


@pytest.mark.thorough
def test_what_everybody_has_to_see_is_seen_again_after_a_restart(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        boss, anna = server.join(server.supervisor()), server.join(cookie := server.enter("Anna"))
        anna.wait("state", lambda m: m["state"] is not None)
        boss.send("broadcast", text="Read page 4")
        told = anna.wait("announced", lambda m: m["id"] > 0)
        lease = anna.take_control()
        anna.command(lease, "line", line="DO DRIVE 1,60,5")
        anna.wait("now", lambda m: m["status"]["mode"] == "moving")
        anna.command(lease, "line", line="PANIC")
        stopped = anna.wait("stopped", lambda m: m["at"] > 0.0)
        assert (stopped["name"], stopped["role"]) == ("Anna", "operator")
        until_kept(server, notices=2)  # the arm may brake still: what goes on from the log brakes
        server.close_browsers()
        server.kill()
        server.start(str(server.port))
        anna = server.join(cookie)
        assert anna.wait("announced")["text"] == told["text"]
        again = anna.wait("stopped")
        assert (again["at"], again["name"], again["role"]) == (stopped["at"], "Anna", "operator")
        state = anna.wait("state", lambda m: m["state"] is not None)["state"]
        if state["status"]["mode"] in (*MOVING, "braking"):
            anna.wait("now", lambda m: m["status"]["mode"] not in (*MOVING, "braking"))
        lease = anna.take_control()
        anna.command(lease, "line", line="DO DRIVE 1,5,50")
        assert anna.wait("stopped", lambda m: m["at"] == 0.0), "it moves again"
        boss = server.join(server.supervisor())
        boss.send("end_announcement")
        anna.wait("announced", lambda m: m["id"] == 0)
