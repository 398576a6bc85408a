"""PANIC overtakes: neither a slow message of its sender nor what came before it holds it up."""

from pathlib import Path

import pytest

from tests.support_live import LiveServer
from vrts.live.front.sockets.socket import LONGEST_WAITING, STOPPED, TOO_MANY
from vrts.live.settings import DATABASE
from vrts.live.store.database import opened

LONG = ";" * 190_000


@pytest.mark.thorough
def test_panic_overtakes_what_takes_long_and_what_waits_behind_it(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live") as server:
        anna = server.join(server.enter("Anna"))
        anna.wait("state", lambda m: m["state"] is not None)
        lease = anna.take_control()
        of = anna.command(lease, "line", line="DO DRIVE 1,60,5")
        anna.wait("result", lambda m: m["of"] == of)
        other = opened(server.folder / DATABASE)
        other.execute("BEGIN IMMEDIATE")  # what has to be written waits now
        anna.send("say", text="this takes long")
        late = anna.command(lease, "line", line="DO DRIVE 1,-60,5")
        for _ in range(LONGEST_WAITING // len(LONG) + 2):
            anna.command(lease, "upload", name="long.v2", text=LONG)
        assert anna.wait("refused", lambda m: m["text"] == TOO_MANY), "no more than has room"
        anna.send("panic")
        assert anna.wait("stopped")["name"] == "Anna"
        assert not any(m["type"] == "chat" for m in anna.came), "it is still under way"
        other.execute("ROLLBACK")
        other.close()
        refused = anna.wait("refused", lambda m: m["of"] == late)
        assert (refused["code"], refused["text"]) == ("stopped", STOPPED)
        of = anna.command(lease, "line", line="DO DRIVE 1,5,50")
        assert anna.wait("result", lambda m: m["of"] == of)["result"]["accepted"]
        again = server.join(server.enter("Ben"))
        again.wait("snapshot")
        again.send("panic")
        assert again.wait("refused")["code"] == "role"
        anna.send("hand_back")
        again.wait("control", lambda m: not m["holder"])
        other = opened(server.folder / DATABASE)
        other.execute("BEGIN IMMEDIATE")
        again.send("say", text="this takes long")
        again.send("request_control")
        again.send("panic")  # what gives the right to it waits before it
        other.execute("ROLLBACK")
        other.close()
        assert again.wait("stopped", lambda m: m["at"] > 0.0)["name"] == "Ben"
