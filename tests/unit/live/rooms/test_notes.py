"""Notes at a moment of a session: who may put one, who is told, and what is left after a purge."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.support_live import Browser, LiveServer
from vrts.live.administration import purge_user
from vrts.live.protocol.fields import LONGEST_NOTE
from vrts.live.store import log
from vrts.live.store.accounts import add_account
from vrts.live.store.database import opened
from vrts.live.store.rooms import KeptRoom, keep_room, notes_of

HOSTILE = "look <img src=x onerror=alert(1)></script>"
TASK = "examples/01-cans-on-bases/task.toml"


def joined(server: LiveServer, cookie: str) -> tuple[Browser, dict[str, Any]]:
    """Return a browser in the room, and the room's snapshot with a session in it."""
    browser = server.join(cookie)
    snapshot = browser.wait("snapshot")
    if snapshot["state"] is None:
        browser.wait("state", lambda m: m["state"] is not None)
    browser.take_frames(2)
    return browser, snapshot


def voices(server: LiveServer, cookie: str, room: str) -> list[tuple[str, str, str]]:
    """Return who said or did what, as the page of the last session has it."""
    page = server.request("GET", f"/replay/{room}", cookie=cookie)
    assert page.status == 200, page.body
    text = page.body.decode()
    assert "<img src=x" not in text
    assert "Ready for the real robot: <b>no</b>" in text
    script = re.search(r'<script type="application/json" id="data">(.*?)</script>', text)
    assert script is not None
    found = json.loads(script[1]).get("voices", [])
    return [(row["kind"], row["name"], row["text"]) for row in found]


@pytest.mark.thorough
def test_a_note_is_told_kept_and_shown_again(tmp_path: Path) -> None:
    with LiveServer(tmp_path / "live", scenes=(TASK,)) as server:
        boss_cookie = server.supervisor()
        boss, snapshot = joined(server, boss_cookie)
        room = snapshot["room"]["id"]
        anna, _ = joined(server, server.enter("Anna"))
        ben, _ = joined(server, server.enter("Ben"))

        anna.send("note", text="may I?")
        assert anna.wait("refused")["code"] == "role"
        lease = anna.take_control()
        anna.send("note", text="x" * (LONGEST_NOTE + 1))
        assert anna.wait("refused")["code"] == "message"
        anna.send("note", text="  ")
        assert anna.wait("refused")["code"] == "note"
        anna.send("note", text=HOSTILE)
        boss.send("note", text="well done")
        first, second = ben.wait("noted"), ben.wait("noted")
        assert {first["text"], second["text"]} == {HOSTILE, "well done"}
        assert first["at_s"] > 0.0
        assert first["number"] < second["number"]
        anna.send("say", text="for all")
        anna.send("say", text="for the supervisor only", private=True)
        ben.wait("chat", lambda m: m["text"] == "for all")
        boss.wait("chat", lambda m: m["private"])
        for n in range(12):
            anna.send("note", text=f"again {n}")
        assert anna.wait("refused")["code"] == "rate"
        assert anna.answer(anna.command(lease, "line", line="DO READY"))["type"] == "result"
        said = voices(server, boss_cookie, room)
        assert ("note", "Anna", HOSTILE) in said
        assert ("chat", "Anna", "for all") in said
        assert ("people", "Ben", "comes in") in said
        assert ("control", "Anna", "has control") in said
        assert not any("supervisor only" in text for _, _, text in said), "not for everybody"

        boss.send("note", text="the last one")
        boss.wait("noted", lambda m: m["text"] == "the last one")
        server.close_browsers()
        server.kill()
        server.start(str(server.port))
        boss, snapshot = joined(server, boss_cookie)
        boss.send("note", text="after the night")
        boss.wait("noted")
        _, snapshot = joined(server, boss_cookie)
        texts = [note["text"] for note in snapshot["notes"]]
        assert {HOSTILE, "well done", "the last one", "after the night"} <= set(texts)
        assert all(note["at_s"] > 0.0 for note in snapshot["notes"])

        assert purge_user(tmp_path / "live", "Ben").accounts == 1
        said = voices(server, boss_cookie, room)
        assert not any(name == "Ben" for _, name, _ in said)
        lease = boss.take_control()
        boss.answer(boss.command(lease, "reset"))
        _, snapshot = joined(server, boss_cookie)
        assert snapshot["notes"] == [], "another time has begun"


def test_notes_that_were_taken_back_stay_so_after_a_restart(tmp_path: Path) -> None:
    connection = opened(tmp_path / "live.sqlite")
    keep_room(connection, KeptRoom("r", "Class", "cans-on-bases", 1, True, 0.0, 0.0))
    anna = add_account(connection, "Anna", 0.0).id

    def put(kind: str, at_s: float, text: str = "{}", *, accepted: bool = True) -> None:
        what = (at_s, 0.0, kind, accepted, anna, "Anna", text)
        log.append(connection, log.Entry("r", 1, *what))

    def told() -> list[float]:
        return [note.at_s for note in notes_of(connection, "r")]

    def back(to_s: float) -> str:
        return f'{{"action":{{"type":"rewind","time_s":{to_s}}},"result":null}}'

    put("begin", 0.0)
    for at_s in (1.0, 2.0, 3.0):
        put("note", at_s, '{"text":"look"}')
    put("rewind", 3.5, back(0.5), accepted=False)
    put("reset", 3.5, accepted=False)
    assert told() == [1.0, 2.0, 3.0]
    put("rewind", 4.0, back(2.0))
    put("note", 2.5, '{"text":"look"}')
    assert told() == [1.0, 2.0, 2.5]
    put("reset", 5.0)
    assert told() == []
    put("note", 0.7, '{"text":"look"}')
    assert told() == [0.7]
    log.purge(connection, anna)
    assert told() == []
    connection.close()
