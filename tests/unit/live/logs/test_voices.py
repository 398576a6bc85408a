"""Voices of a session at the session's own times, and the page that shows them beside the mark."""

import json
import re
from pathlib import Path
from typing import Any

from tests.support_commands import vrts_text
from tests.unit.live.logs.test_session_marks import TASK, database, tried
from vrts.live.logs.replay_page import Order
from vrts.live.logs.replay_process import page_of
from vrts.live.logs.voices import Said, voices_of
from vrts.live.settings import Place
from vrts.live.store import log
from vrts.live.store.database import opened

HOSTILE = "Eve </script><img src=x onerror=alert(1)>"


def row(kind: str, wall: float, at_s: float = 0.0, name: str | None = None, **text: Any) -> str:
    """Return a record as a log is exported, as far as it matters here."""
    fields = {"kind": kind, "wall": wall, "at_s": at_s, "name": name, "accepted": True}
    return json.dumps({**fields, "text": text, "seq": 1})


def purged(kind: str, wall: float, at_s: float = 0.0) -> str:
    """Return a record of somebody who was purged."""
    fields = {"kind": kind, "wall": wall, "at_s": at_s, "name": None, "accepted": True}
    return json.dumps({**fields, "text": None})


def told(*rows: str, session: int = 0, chat: tuple[Said, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the voices as plain rows."""
    log = "\n".join(('{"schema":"vrts/live-log"}', *rows)).encode()
    found = voices_of(log, session, chat, 100.0)
    return [(round(v.at_s, 3), v.kind, v.name, v.text, v.end_s) for v in found]


def test_what_is_said_comes_at_the_time_of_the_session() -> None:
    chat = (
        Said(999.0, "Ann", "before it began"),
        Said(1005.0, "Ann", "in between"),
        Said(1021.5, "", "the log is full"),
        Said(1500.0, "Bob", "in the next session"),
    )
    rows = [
        row("begin", 1000.0),
        row("join", 1002.0, 2.0, "Ann"),
        row("control", 1003.0, 0.0, "Ann"),
        row("line", 1010.0, 10.0, "Ann", action={"type": "line"}),
        row("carry_on", 1020.0).replace('"text": {}', '"text": {"at_s": 12.5}'),
        row("note", 1022.0, 14.5, HOSTILE, text="look <b>here</b>"),
        row("panic", 1024.0, 16.5, "Bob"),
        row("control", 1026.0, 18.5),
        row("begin", 1400.0),
    ]
    assert told(*rows, chat=chat) == [
        (2.0, "people", "Ann", "comes in", None),
        (3.0, "control", "Ann", "has control", 18.5),
        (5.0, "chat", "Ann", "in between", None),
        (14.0, "chat", "Server", "the log is full", None),
        (14.5, "note", HOSTILE, "look <b>here</b>", None),
        (16.5, "stop", "Bob", "presses PANIC", None),
    ]
    assert told(*rows, session=1, chat=chat) == [
        (100.0, "chat", "Bob", "in the next session", None)
    ]


def test_what_came_before_the_session_went_back_is_told_there() -> None:
    rows = [
        row("control", 990.0, 0.0, "Ann"),
        row("begin", 1000.0),
        row("note", 1003.0, 3.0, "Ann", text="early"),
        row("note", 1008.0, 8.0, "Ann", text="late"),
        row("rewind", 1010.0, 10.0, "Ann", action={"type": "rewind", "time_s": 5.0}),
        row("note", 1012.0, 7.0, "Ann", text="again"),
    ]
    assert told(*rows, chat=(Said(1013.0, "Ann", "here"),)) == [
        (0.0, "control", "Ann", "has control", 100.0),
        (3.0, "note", "Ann", "early", None),
        (5.0, "note", "Ann", "late (before the session went back)", None),
        (7.0, "note", "Ann", "again", None),
        (8.0, "chat", "Ann", "here", None),
    ]


def test_of_who_was_purged_nothing_is_there() -> None:
    rows = [
        row("begin", 1000.0),
        row("control", 1001.0, 1.0, "Ann"),
        purged("control", 1002.0, 2.0),
        purged("note", 1003.0, 3.0),
        purged("panic", 1004.0, 4.0),
        purged("join", 1005.0, 5.0),
        row("freeze", 1006.0, 6.0, "Lea", on=False),
    ]
    assert told(*rows) == [
        (1.0, "control", "Ann", "has control", 2.0),
        (6.0, "stop", "Lea", "lets the room go on", None),
    ]


def test_a_clock_that_is_set_back_makes_no_other_order() -> None:
    rows = [
        row("begin", 5000.0),
        row("line", 5010.0, 10.0, "Ann", action={}),
        row("line", 1420.0, 20.0, "Ann", action={}),
        row("freeze", 1421.0, 0.0, "Lea", on=True),
    ]
    (stop,) = told(*rows)
    assert 20.0 <= stop[0] <= 21.0


def test_the_page_of_a_room_with_a_task_shows_mark_and_voices(tmp_path: Path) -> None:
    database(tmp_path / "one.sqlite", {f"Room {HOSTILE}": tried(tmp_path / "a")})
    connection = opened(tmp_path / "one.sqlite")
    what = json.dumps({"text": f"look here {HOSTILE}"})
    log.append(connection, log.Entry("room0", 1, 0.4, 2.4, "note", True, 1, "Anna", what))
    data = log.export(connection, "room0", names=True)
    connection.close()
    places = (Place("01-cans-on-bases", "", str(TASK)),)
    chat = (Said(2.2, HOSTILE, HOSTILE),)
    page = page_of(Order(f"Room {HOSTILE}", data, places, chat)).decode()
    assert "Cans on bases" in page
    assert re.search(r'<p class="mark low"><b>0\.0</b><span>/ 10</span>', page)
    assert "Ready for the real robot: <b>no</b>" in page
    assert "<b>yes</b>" not in page
    assert "never picked up" in page
    assert "<img src=x" not in page
    assert page.count("</script>") == page.count("<script")
    script = re.search(r'<script type="application/json" id="data">(.*?)</script>', page)
    assert script is not None
    shown = json.loads(script[1])
    assert shown["scene"]["goals"], "the replay has ghosts"
    said = [(v["kind"], v["name"], v["text"]) for v in shown["voices"]]
    assert ("chat", HOSTILE, HOSTILE) in said
    assert ("note", "Anna", f"look here {HOSTILE}") in said

    file = tmp_path / "log-room0.jsonl"
    file.write_bytes(data)
    done = vrts_text("replay", str(file), "--scene", str(TASK))
    assert done.returncode == 0, done.stderr
    assert "0.0 / 10  Cans on bases; ready for the real robot: no" in done.stdout
    assert "0.400  Anna: look here" in done.stdout
