"""The help of an editor in the page: what it answers, to whom, and what it lets nobody do."""

import json
import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus

from tests.support_live import PATIENCE, LiveServer
from tests.unit.live.editing.support import Editor, gone, helpers, link
from vrts.live.editing.seats import QUIET_S, Seats
from vrts.live.front.sockets.help_socket import MOST_BAD

pytest.importorskip("pygls", reason='needs pip install "vrts[ide]"')

WRONG = ".PROGRAM pick\n  MOVEE part\n  APPRO part,50\n.END\n"
RIGHT = WRONG.replace("MOVEE", "MOVE")
AT = {"line": 1, "character": 3}
FILE = "file:///etc/passwd"
HOSTILE: dict[str, Any] = {
    "initialize": {"method": "initialize", "id": 1, "params": {"rootUri": "file:///etc"}},
    "a command": {"method": "workspace/executeCommand", "id": 1, "params": {"command": "x"}},
    "a file opened": {
        "method": "textDocument/didOpen",
        "params": {"textDocument": {"uri": FILE, "version": 1, "languageId": "val2", "text": ""}},
    },
    "an address beside a text": {
        "method": "textDocument/didChange",
        "version": 2,
        "text": "",
        "uri": FILE,
    },
    "folders": {"method": "workspace/didChangeWorkspaceFolders", "params": {"event": {}}},
    "settings": {"method": "workspace/didChangeConfiguration", "params": {"settings": {}}},
    "an end": {"method": "exit"},
    "a rename": {"method": "textDocument/rename", "id": 1, "position": AT, "newName": "x"},
    "before the text": {
        "method": "textDocument/hover",
        "id": 1,
        "position": {"line": -1, "character": 0},
    },
    "far away": {
        "method": "textDocument/hover",
        "id": 1,
        "position": {"line": 10**9, "character": 0},
    },
    "no number": {"method": "textDocument/hover", "id": "x", "position": AT},
    "the first request again": {"method": "textDocument/hover", "id": 0, "position": AT},
    "a text twice": {"method": "textDocument/didOpen", "version": 2, "text": ""},
    "a long text": {"method": "textDocument/didChange", "version": 2, "text": "x" * 200_001},
    "many at once": [{"method": "textDocument/hover", "id": 1, "position": AT}] * 2,
    "nothing": {},
}


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("help") / "live") as started:
        yield started


def ends(server: LiveServer) -> bool:
    """Wait until no language server is left."""
    until = time.monotonic() + PATIENCE
    while helpers(server) and time.monotonic() < until:
        time.sleep(0.02)
    return not helpers(server)


@pytest.mark.thorough
def test_a_program_is_checked_completed_explained_and_mended(server: LiveServer) -> None:
    with link(server, server.enter("Anna")) as socket:
        editor = Editor(socket, WRONG)
        (found,) = [one for one in editor.findings() if one["code"] == "V120"]
        assert found["range"]["start"] == {"line": 1, "character": 2}
        assert "did you mean `MOVE`?" in found["message"]
        (fix,) = editor.ask("codeAction", range={"start": AT, "end": AT})
        assert [edit["newText"] for edit in fix["edits"]] == ["MOVE"]
        assert fix["range"] == found["range"]
        editor.change(RIGHT)
        assert not [one for one in editor.findings() if one["severity"] == 1]
        assert "APPRO" in editor.at("hover", 2, 4)["contents"]["value"]
        words = [item["label"] for item in editor.at("completion", 1, 5)["items"]]
        assert "MOVES" in words
        assert editor.at("signatureHelp", 2, 8)["signatures"][0]["label"].startswith("APPRO")
        assert editor.ask("formatting") is not None
        assert editor.at("hover", 3, 0) is None

        (pid,) = helpers(server)
        assert "file:" not in "".join(editor.raw)  # nothing of this machine is told
        assert list((Path("/proc") / str(pid) / "cwd").resolve().iterdir()) == []
        assert b"HOME=" not in (Path("/proc") / str(pid) / "environ").read_bytes()
        if sys.platform == "linux":
            limits = (Path("/proc") / str(pid) / "limits").read_text().splitlines()
            limited = {row[:26].strip(): row[26:47].strip() for row in limits[1:]}
            assert limited["Max cpu time"] == "900"
            assert int(limited["Max data size"]) < 700_000_000
        children = (Path("/proc") / str(pid) / "task" / str(pid) / "children").read_text()
        assert children == "", "no program is run for a text"
    assert ends(server)


def test_what_is_not_allowed_reaches_no_language_server(server: LiveServer) -> None:
    with link(server, server.enter("Eve")) as socket:
        editor = Editor(socket)
        editor.send("textDocument/hover", id=1, position=AT)
        editor.until("refused")  # there is no text yet
        editor.version = 1
        editor.send("textDocument/didOpen", version=1, text=RIGHT)
        (pid,) = helpers(server)
        for name, message in HOSTILE.items():
            socket.send(json.dumps(message))
            assert editor.until("refused"), name
        socket.send(b"\x00\xff")
        editor.until("refused")
        assert helpers(server) == [pid]
        assert "APPRO" in editor.at("hover", 2, 4)["contents"]["value"]  # and it goes on
        assert "root:" not in "".join(editor.raw)
        for _ in range(MOST_BAD):
            socket.send("{}")
        assert editor.closed() == "message"
    assert ends(server)


def test_only_who_is_in_the_class_gets_help_and_only_on_our_own_page(server: LiveServer) -> None:
    for cookie, origin, status in (
        ("", "", 401),
        (f"vrts_{server.port}=wrong", "", 401),
        (server.enter("Anna"), "https://evil.example", 403),
    ):
        with pytest.raises(InvalidStatus) as refused, link(server, cookie, origin):
            pass
        assert refused.value.response.status_code == status
    assert helpers(server) == []


@pytest.mark.thorough
def test_a_person_has_one_language_server_at_a_time(server: LiveServer) -> None:
    anna, ben = server.enter("Anna"), server.enter("Ben")
    with link(server, anna) as first, link(server, ben) as other, link(server, anna) as second:
        editors = [Editor(second, WRONG), Editor(other, WRONG)]
        with pytest.raises(ConnectionClosed):
            Editor(first).closed()
        for editor in editors:
            assert any(one["code"] == "V120" for one in editor.findings())
        assert len(helpers(server)) == 2
    assert ends(server)


def test_seats_are_few_and_begun_seldom(tmp_path: Path) -> None:
    seats: Seats[int] = Seats(tmp_path / "editing", most=2)
    first, second = seats.take(1), seats.take(2)
    assert first is not None
    assert second is not None
    assert seats.take(3) is None
    again = seats.take(1)
    assert again is not None
    assert first.taken.is_set()
    seats.give_back(first)  # it was taken already: the new one stays
    assert seats.take(3) is None
    seats.give_back(again)
    assert seats.take(3) is not None
    assert [seats.take(2) is not None for _ in range(8)].count(True) == 5  # six at once
    last = seats.take(3)
    assert last is not None
    seats.stop()
    assert last.taken.is_set()
    assert list(seats.folder.iterdir()) == []


def test_who_finds_no_seat_gets_the_one_that_is_quiet_for_longest(tmp_path: Path) -> None:
    seats: Seats[int] = Seats(tmp_path / "editing", most=2)
    first, second = seats.take(1), seats.take(2)
    assert first is not None
    assert second is not None
    first.heard_s -= QUIET_S
    second.heard_s -= 2 * QUIET_S
    assert seats.take(3) is not None
    assert (first.taken.is_set(), second.taken.is_set()) == (False, True)
    assert second.wanted
    seats.give_back(second)
    assert seats.take(4) is not None
    assert first.taken.is_set()
    assert seats.take(5) is None, "nobody is quiet"


@pytest.mark.thorough
def test_the_help_ends_with_the_cookie(server: LiveServer) -> None:
    cookie = server.enter("Leaves")
    with link(server, cookie) as socket:
        editor = Editor(socket)
        assert server.request("POST", "/logout", cookie=cookie).status == 204
        assert editor.closed() == "login"
    assert ends(server)


@pytest.mark.thorough
def test_a_flood_ends_the_connection_and_its_process(server: LiveServer) -> None:
    with link(server, server.enter("Eve")) as socket:
        editor = Editor(socket, RIGHT)
        with suppress(ConnectionClosed):  # it may end before all of it is sent
            for number in range(400):
                editor.send("textDocument/hover", id=number + 1, position=AT)
        assert editor.closed() == "limit"
    assert ends(server)


@pytest.mark.thorough
def test_a_language_server_that_dies_is_told_of_and_one_without_a_server_ends(
    tmp_path: Path,
) -> None:
    server = LiveServer(tmp_path / "live")
    cookie = server.enter("Anna")
    with link(server, cookie) as socket:
        editor = Editor(socket, RIGHT)
        (pid,) = helpers(server)
        os.kill(pid, signal.SIGKILL)
        assert editor.closed() == "gone"
    with link(server, cookie) as socket:
        editor = Editor(socket, RIGHT)
        editor.findings()
        (pid,) = helpers(server)
        server.kill()
        until = time.monotonic() + PATIENCE
        while not gone(pid) and time.monotonic() < until:
            time.sleep(0.02)
        assert gone(pid)
