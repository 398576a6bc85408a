"""Rehearsals over a real server: nothing moves in the room, and nothing hostile gets through."""

import json
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import msgspec
import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from tests.support_live import PATIENCE, Json, LiveServer
from tests.unit.live.editing.support import gone
from tests.unit.live.rehearsing.support import HITS, TASK, Page, link, processes
from vrts.live.protocol.fields import LONGEST_MESSAGE
from vrts.live.rehearsing.asked import Rehearse, asked
from vrts.live.rehearsing.offering import MOST, Rehearsals, Whose
from vrts.live.rehearsing.process import DIED, TOO_LONG
from vrts.live.rehearsing.talk import BUSY, MOST_ASKED, MOST_BAD, NONE, OVER, UNREAD

FEW = ".PROGRAM main()\n  TYPE 1\n.END\n"
HOSTILE: dict[str, Json] = {
    "a scene of its own": {"type": "rehearse", "id": 1, "text": FEW, "scene": "/etc/passwd"},
    "the server's own message": {
        "type": "begin",
        "where": {"type": "start", "session": 1, "folder": "/", "task": "/etc/passwd"},
        "order": {"type": "rehearse", "id": 1, "text": FEW},
        "state": "/etc/passwd",
    },
    "a path for a name": {"type": "rehearse", "id": 1, "text": FEW, "name": "../main.v2"},
    "a long text": {"type": "rehearse", "id": 1, "text": "x" * 200_001},
    "many breakpoints": {"type": "rehearse", "id": 1, "text": FEW, "breakpoints": [1] * 201},
    "a line before the first": {"type": "breakpoints", "id": 1, "lines": [0]},
    "a time that is none": {"type": "at", "id": 1, "time_s": 1e9},
    "a block before the first": {"type": "block", "id": 1, "number": -1},
    "another way": {"type": "go", "id": 1, "what": "away"},
    "no number": {"type": "go", "what": "run"},
    "nothing": {},
}


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("rehearsing") / "live"
    with LiveServer(folder, scenes=(str(TASK),)) as started:
        yield started


class Student:
    """Somebody in a room, whose session runs."""

    def __init__(self, server: LiveServer, name: str) -> None:
        self.cookie = server.enter(name)
        self.browser = server.join(self.cookie, version=1)
        self.room: str = self.browser.wait("welcome")["room"]
        self.state: Json | None = self.browser.wait("snapshot")["state"]
        while self.state is None:
            self.state = self.browser.wait("state")["state"]


def require_gone(pid: int) -> None:
    """See to it that a process ends, and that the server takes notice of it."""
    until = time.monotonic() + PATIENCE
    while (Path("/proc") / str(pid)).exists():
        assert time.monotonic() < until, f"{pid} is still there"
        time.sleep(0.02)


def signalled(server: LiveServer, sign: int) -> list[int]:
    """Signal all processes of rehearsals, the one that waits, too; return them."""
    found = processes(server)
    for pid in found:
        with suppress(ProcessLookupError):
            os.kill(pid, sign)
    return found


@pytest.mark.thorough
def test_a_text_is_rehearsed_and_nothing_moves_in_the_room(server: LiveServer) -> None:
    anna = Student(server, "Anna")
    with link(server, anna.cookie, anna.room) as socket:
        page = Page(socket)
        ready = page.rehearse(HITS, name="main.v2", breakpoints=[12])
        assert ready["type"] == "ready"
        assert ready["mark"]["mark"] == 7.0
        assert [mark["kind"] for mark in ready["marks"]] == ["contact", "program"]
        pid = processes(server)[0]
        there = page.ask("go", what="run")
        assert (there["why"], there["line"]) == ("breakpoint", 12)
        assert page.ask("go", what="back")["line"] == 11
        moved = page.ask("breakpoints", lines=[7])
        assert moved["breakpoints"] == [{"line": 7, "verified": True, "at": 7}]
        assert page.ask("go", what="back_run")["line"] == 7
        block = page.ask("block", number=0)["data"]
        assert (block["whole"], block["until"]) == (True, ready["duration_s"])
        assert page.ask("at", time_s=ready["duration_s"])["typed"] == ["finished"]

        wrong = page.rehearse(HITS.replace("MOVE ", "MOVEE "))
        assert (wrong["type"], wrong["problems"][0]["line"]) == ("refused", 5)
        assert page.ask("go", what="run")["message"] == NONE

        folder = Path("/proc") / str(pid)
        assert list((folder / "cwd").resolve().iterdir()) == []
        assert b"HOME=" not in (folder / "environ").read_bytes()
        if sys.platform == "linux":
            limits = (folder / "limits").read_text().splitlines()[1:]
            limited = {row[:26].strip(): row[26:47].strip() for row in limits}
            assert int(limited["Max cpu time"]) < 120
            assert int(limited["Max data size"]) < 900_000_000
        assert page.ask("stop")["message"] == OVER
        assert gone(pid)
        lease = anna.browser.take_control()
        number = anna.browser.command(lease, "line", line="DO n = 5")
        assert anna.browser.answer(number)["type"] == "result"
        anna.browser.command(lease, "line", line="DO TYPE n*7")  # when that is done, n is known
        anna.browser.wait("event", lambda m: " 35" in m["event"].get("text", ""))  # no echo has it
        now = page.rehearse(
            ".PROGRAM main()\n  TYPE n\n  DRIVE 1,20,100\n.END\n", **{"from": "now"}
        )
        assert now["begin_s"] > 0.0
        assert page.ask("go", what="end")["typed"] == [" 5"]
        pid = processes(server)[0]
    require_gone(pid)
    ben = Student(server, "Ben")
    assert anna.state is not None
    assert ben.state is not None
    for what in ("joints_rad", "program", "contacts", "mode"):
        assert ben.state["status"][what] == anna.state["status"][what]
    assert ben.state["programs"] == []


@pytest.mark.parametrize("name", HOSTILE)
def test_a_browser_may_ask_nothing_else(name: str) -> None:
    with pytest.raises(msgspec.DecodeError):
        asked(json.dumps(HOSTILE[name]))


def test_a_file_may_have_any_name_that_the_page_gives() -> None:
    for name in ("main.v2", "-x.v2", "_" * 60 + ".v2", "Übung 1"):
        order = {"type": "rehearse", "id": 1, "text": FEW, "name": name, "from": "now"}
        assert asked(json.dumps(order)) == Rehearse(1, FEW, name, "now")


@pytest.mark.thorough
def test_what_is_not_allowed_reaches_no_process(server: LiveServer) -> None:
    eve = Student(server, "Eve")
    with link(server, eve.cookie, eve.room) as socket:
        page = Page(socket)
        assert page.rehearse(FEW)["type"] == "ready"
        for name, message in HOSTILE.items():
            socket.send(json.dumps(message))
            told = page.next()
            assert (told["type"], told["message"]) == ("refused", UNREAD), name
        socket.send(b"\x00\xff")
        assert page.next()["message"] == UNREAD
        assert page.ask("go", what="end")["typed"] == [" 1"]  # and it goes on
        pid = processes(server)[0]
        for _ in range(MOST_BAD):
            socket.send("{}")
        assert page.closed() == "message"
    require_gone(pid)
    for cookie, room, origin, status in (
        ("", eve.room, "", 401),
        (f"vrts_{server.port}=wrong", eve.room, "", 401),
        (eve.cookie, eve.room, "https://evil.example", 403),
        (eve.cookie, "another", "", 403),
        (server.enter("Mallory"), eve.room, "", 403),  # in no room
    ):
        with pytest.raises(InvalidStatus) as refused, link(server, cookie, room, origin):
            pass
        assert refused.value.response.status_code == status


@pytest.mark.thorough
def test_a_process_that_is_killed_is_told_of_and_the_next_rehearsal_works(
    server: LiveServer,
) -> None:
    kim = Student(server, "Kim")
    with link(server, kim.cookie, kim.room) as socket:
        page = Page(socket)
        assert page.rehearse(FEW)["type"] == "ready"
        for sign, words in ((signal.SIGKILL, DIED), (signal.SIGXCPU, TOO_LONG)):
            killed = signalled(server, sign)
            told = page.next()
            assert (told["type"], told["message"]) == ("ended", words)
            for pid in killed:
                require_gone(pid)
            assert page.ask("go", what="run")["message"] == NONE
            assert page.rehearse(FEW)["type"] == "ready"


@pytest.mark.thorough
def test_a_question_too_many_is_refused_alone_and_the_rehearsal_goes_on(server: LiveServer) -> None:
    ida = Student(server, "Ida")
    with link(server, ida.cookie, ida.room) as socket:
        page = Page(socket)
        assert page.rehearse(FEW)["type"] == "ready"
        signalled(server, signal.SIGSTOP)
        for _ in range(MOST_ASKED + 1):
            page.send("block", number=0)
        told = page.next()
        signalled(server, signal.SIGCONT)
        assert (told["type"], told["message"]) == ("refused", BUSY)
        assert (told["of"], told["number"]) == ("block", 0)
        assert [page.next()["type"] for _ in range(MOST_ASKED)] == ["block"] * MOST_ASKED
        assert page.ask("go", what="end")["typed"] == [" 1"]
        assert "of" not in page.rehearse("MOVEE x")


@pytest.mark.thorough
def test_a_flood_and_a_message_that_is_too_long_end_the_connection(server: LiveServer) -> None:
    eve = Student(server, "Eve")
    with link(server, eve.cookie, eve.room) as socket:
        page = Page(socket)
        assert page.rehearse(FEW)["type"] == "ready"
        pid = processes(server)[0]
        for _ in range(200):
            page.order(HITS)
        assert page.closed() == "limit"
    require_gone(pid)
    with link(server, eve.cookie, eve.room) as socket:
        socket.send("x" * (LONGEST_MESSAGE + 1))
        with pytest.raises(ConnectionClosed) as closed:
            socket.recv(timeout=PATIENCE)
        assert closed.value.rcvd is not None
        assert closed.value.rcvd.code == 1009


@pytest.mark.thorough
def test_one_rehearsal_of_a_person_in_a_room_ends_with_the_cookie(server: LiveServer) -> None:
    lea = Student(server, "Lea")
    with link(server, lea.cookie, lea.room) as first, link(server, lea.cookie, lea.room) as second:
        assert Page(first).closed() == "elsewhere"
        page = Page(second)
        assert page.rehearse(FEW)["type"] == "ready"
        pid = processes(server)[0]
        assert server.request("POST", "/logout", cookie=lea.cookie).status == 204
        assert page.closed() == "login"
    require_gone(pid)


def test_seats_are_few_and_nobody_begins_too_often(tmp_path: Path) -> None:
    seats = Rehearsals(tmp_path / "rehearsing", most=2).seats
    first = seats.take(Whose(1, "a"))
    assert first is not None
    assert seats.take(Whose(1, "b")) is not None  # in another room
    assert seats.take(Whose(2, "a")) is None
    assert [seats.take(Whose(1, "a")) is not None for _ in range(12)].count(True) == 9
    assert first.taken.is_set()
    assert MOST <= 12, "each takes 100 MB"
