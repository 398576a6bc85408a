"""The past of a session over HTTP, and private rooms that go on from a moment of it."""

import gzip
import json
import math
from collections.abc import Iterator
from typing import Any

import pytest

from tests.support_live import Browser, LiveServer
from tests.unit.live.session.looking.played import coordinates, in_force
from vrts.live.logs.log_file import read_log
from vrts.live.places import places_of
from vrts.live.session.again.carrying_on import STOPPED_HERE
from vrts.live.session.again.replay import replay
from vrts.live.session.channel.messages import Start
from vrts.live.session.views.frame import PoseFrame, unpacked

PROGRAM = """\
.PROGRAM swing()
    turns = 7
    SIGNAL 3
    DRIVE 1,40,30
    BREAK
    turns = 8
    DRIVE 1,-40,30
.END
"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("past") / "live"
    with LiveServer(folder, "--private-rooms", "1") as started:
        yield started


def settled(server: LiveServer, cookie: str, **fields: Any) -> tuple[Browser, dict[str, Any]]:
    """Join; return the browser, and the state of the session when it runs."""
    browser = server.join(cookie, **fields)
    state = browser.wait("snapshot")["state"]
    while state is None:
        state = browser.wait("state")["state"]
    return browser, state


def frames(browser: Browser) -> list[PoseFrame]:
    return [unpacked(frame) for frame in browser.frames]


def typed(browser: Browser, lease: str, line: str) -> str:
    number = browser.command(lease, "line", line=line)
    return browser.wait("result", lambda m: m["of"] == number)["result"]["text"]


@pytest.mark.thorough
def test_anybody_looks_at_the_past_and_goes_on_from_there_alone(server: LiveServer) -> None:
    cookie, other = server.enter("Anna"), server.enter("Ben")
    anna, _ = settled(server, cookie)
    room = anna.came[0]["room"]
    session = next(m for m in anna.came if m["type"] == "snapshot")["session"]
    lease = anna.take_control()
    anna.command(lease, "upload", name="swing.v2", text=PROGRAM)
    typed(anna, lease, "EXECUTE swing")
    anna.wait("now", lambda m: m["status"]["joints_rad"][0] > 0.3)
    anna.wait("now", lambda m: m["status"]["mode"] == "idle")

    where = f"/past/{room}/{session}"
    assert server.request("GET", f"{where}/0").status == 401
    assert server.request("GET", f"{where}/0", cookie=other).status == 403, "he is not in the room"
    assert server.request("GET", f"/past/{room}/{session + 1}/0", cookie=cookie).status == 404
    to_come = server.request("GET", f"{where}/9", cookie=cookie)
    assert (to_come.status, to_come.json["text"]) == (409, "this has not happened yet")
    answer = server.request("GET", f"{where}/0", cookie=cookie, accept_encoding="gzip")
    assert answer.headers["content-encoding"] == "gzip"
    block = json.loads(gzip.decompress(answer.body))
    seen = [frame for frame in frames(anna) if frame.time_s <= block["until"]]
    assert len(seen) > 20
    for frame in seen:
        assert coordinates(block, frame.time_s)[:6] == pytest.approx(frame.joints, abs=1e-5)
        assert in_force(block["outputs"], frame.time_s)[1] == frame.outputs
    assert any(step["text"] == "DRIVE 1,40,30" for step in block["steps"])

    ben, _ = settled(server, other)
    middle = next(f.time_s for f in seen if f.outputs == 4 and f.joints[0] > 0.2)
    anna.send("go_on_from", of=50, at_s=1e6)
    assert anna.wait("refused")["text"] == "this has not happened yet"
    anna.send("go_on_from", of=51, at_s=middle)
    made = anna.wait("branched", lambda m: m["of"] == 51)["room"]
    assert any(entry["id"] == made for entry in anna.wait("rooms")["rooms"])
    ben.send("go_on_from", of=52, at_s=middle)
    assert ben.wait("refused")["text"] == "there are 1 private rooms already"
    assert all(made not in json.dumps(message) for message in ben.came)
    stranger = server.join(other, room=made)
    closed = stranger.closed()
    assert closed is not None
    assert closed["text"] == "there is no such room any more"

    own, state = settled(server, cookie, room=made)
    assert any(row["text"] == STOPPED_HERE for row in state["events"])
    lease = own.wait("control", lambda m: m["lease"] != "")["lease"]
    assert state["status"]["time_s"] >= middle
    own.take_frames(2)
    assert "7" in typed(own, lease, "LISTR turns"), "8 came later"
    known = [state["status"]["mode"]]
    known += [m["status"]["mode"] for m in own.came if m["type"] == "now"]
    if known[-1] != "stopped":  # which may have been told before what was typed was answered
        own.wait("now", lambda m: m["status"]["mode"] == "stopped")
    typed(own, lease, "DO DRIVE 2,10,100")
    own.wait("now", lambda m: abs(m["status"]["joints_rad"][1] + math.pi / 2) > 0.15)
    theirs = frames(ben)[-1].joints
    ben.take_frames(20)
    assert frames(ben)[-1].joints == theirs, "nothing moved in the room of all"

    supervisor = server.supervisor()
    boss, _ = settled(server, supervisor, room=made)
    log = server.request("GET", f"/log/{made}", cookie=supervisor).body
    (logged,) = read_log(log)
    place = places_of((logged.scene,))[0]
    end_s = frames(own)[-1].time_s
    run = replay(Start(logged.number, "", place.scene), logged.entries, until_s=end_s)
    for frame in (*(f for f in seen if f.time_s < middle), *frames(own)):
        assert run.at(frame.time_s).configuration == pytest.approx(frame.joints, abs=1e-6)

    own.send("go_on_from", of=53, at_s=middle - 0.2)
    again = own.wait("branched", lambda m: m["of"] == 53)["room"]
    assert again != made
    assert own.closed() == {"type": "closed", "code": "room closed", "text": "the room was closed"}
    boss, _ = settled(server, supervisor, room=again)
    boss.send("close_room", room=again)
    assert boss.closed() is not None
    ben.send("go_on_from", of=54, at_s=middle)
    assert ben.wait("branched", lambda m: m["of"] == 54)["room"] != made
