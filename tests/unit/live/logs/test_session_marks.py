"""Sessions marked like submissions: by the same task, with the same result and pages."""

import hashlib
import json
import subprocess
from pathlib import Path
from typing import Any

import msgspec
import pytest

from tests.support_commands import vrts_text
from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.logs.session_marker import SessionMarker, entries_to_bytes
from vrts.live.session.channel.entries import Entry
from vrts.live.session.channel.messages import Act, Done
from vrts.live.store import log
from vrts.live.store.database import opened
from vrts.live.store.log import Entry as Logged
from vrts.live.store.rooms import KeptRoom, keep_room
from vrts.marking.submission.one import Order, Wanted, mark
from vrts.marking.submission.setting import Place, load

TASK = Path("examples/01-cans-on-bases/task.toml")
SOLUTION = Path("examples/01-cans-on-bases/solution.v2")
HALF = ".PROGRAM half()\n READY\n DRIVE 1,40,50\n.END\n"


def solved(folder: Path) -> list[Entry]:
    """Return the session of somebody who thinks, executes the solution, and looks around."""
    folder.mkdir()
    driven = Driven(folder, "cans-on-bases")
    driven.run(200.0, beat_s=1.0)  # longer than the task allows
    driven.act(do.Upload("solution.v2", SOLUTION.read_text()))
    driven.typed("EXECUTE main", seconds=0.1)
    driven.run(90.0, beat_s=0.5)
    driven.typed("WHERE", seconds=200.0)
    return _with_answers(driven)


def tried(folder: Path) -> list[Entry]:
    """Return the session of somebody who only waves; the last motion goes on when the log ends."""
    folder.mkdir()
    driven = Driven(folder, "cans-on-bases")
    driven.act(do.Upload("half.v2", HALF))
    driven.typed("EXECUTE half", seconds=0.5)
    return _with_answers(driven)


def _with_answers(driven: Driven) -> list[Entry]:
    answers = [done for done in driven.said(Done) if done.counts]
    return [entry._replace(done=d) for entry, d in zip(driven.log, answers, strict=True)]


def database(path: Path, rooms: dict[str, list[Entry]]) -> None:
    """Write what a server keeps of rooms, one account in each."""
    connection = opened(path)
    for place, (name, entries) in enumerate(rooms.items()):
        room = f"room{place}"
        keep_room(connection, KeptRoom(room, name, "01-cans-on-bases", place, True, 0.0, 120.0))
        begin = json.dumps({"scene": "01-cans-on-bases", "scene_sha256": "", "vrts": "0"})
        log.append(connection, Logged(room, 1, 0.0, 1.0, "begin", True, None, "", begin))
        for entry in entries:
            assert isinstance(entry.order, Act)
            what = {"action": entry.order.action, "result": entry.done}
            text = msgspec.json.encode(what).decode()
            kind = str(entry.order.action.__struct_config__.tag)
            account = place + 1
            row = Logged(room, 1, entry.at_s, 2.0, kind, True, account, "Anna", text)
            log.append(connection, row)
    connection.close()


def graded(*words: str, status: int = 0) -> tuple[str, str]:
    done = vrts_text("grade", *words)
    assert done.returncode == status, done.stderr
    return done.stdout, done.stderr


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a database with three rooms."""
    folder = tmp_path_factory.mktemp("class")
    path = folder / "class.sqlite"
    database(path, {"Solved": solved(folder / "a"), "Tried": tried(folder / "b"), "Empty": []})
    return path


@pytest.mark.thorough
def test_a_class_has_a_row_for_every_room(kept: Path, tmp_path: Path) -> None:
    before = hashlib.sha256(kept.read_bytes()).hexdigest()
    out, said = graded(str(TASK), "--session", str(kept), "-o", str(tmp_path / "out"))
    assert hashlib.sha256(kept.read_bytes()).hexdigest() == before, "nothing is changed"
    staff = json.loads((tmp_path / "out/staff/results.json").read_text())
    solved, tried, empty = (row["result"] for row in staff["rows"])
    order = Order("s", "s.v2", SOLUTION.read_bytes())
    program = mark(order, load(Place(str(TASK)), staff=True), Wanted(pages=False)).assessment
    assert program.grade is not None
    assert solved["mark"] == float(program.grade.mark), "the same as the program's"
    assert solved["metrics"]["duration_s"] == pytest.approx(program.grade.duration_s, abs=0.06)
    assert solved["metrics"]["motions"] == len(program.run.motions if program.run else ())
    assert (solved["id"], solved["kind"]) == ("Solved", "graded")
    assert tried["mark"] < 3.0
    assert tried["metrics"]["motions"] == 2
    assert tried["metrics"]["duration_s"] > 0.5, "what has begun is finished"
    assert (empty["kind"], empty["mark"]) == ("missing", None)
    assert "nothing was done" in empty["cause"]
    shown = {line.split()[1] for line in out.splitlines() if not line.startswith("      ")}
    assert shown == {"Solved", "Tried", "Empty"}
    page = (tmp_path / "out/students/Solved/report.html").read_text(encoding="utf-8")
    assert "MOVE" in page
    assert str(tmp_path) not in page
    assert "wrote" in said

    again, _ = graded(str(TASK), "--session", str(kept), "-o", str(tmp_path / "out"))
    assert "Solved" in again


@pytest.mark.thorough
def test_one_room_is_named_and_its_task_is_known(kept: Path, tmp_path: Path) -> None:
    home = tmp_path / "vrts-live"
    home.mkdir()
    (home / "live.sqlite").write_bytes(kept.read_bytes())
    for name in ("Tried", "room1"):
        out, _ = graded("--session", name, "--folder", str(home), "--format", "json")
        (row,) = json.loads(out)["rows"]
        assert row["student"]["name"] == "Tried"
        assert row["result"]["kind"] == "graded"
    _, said = graded("--session", "Nowhere", "--folder", str(home), status=2)
    assert "no room `Nowhere`" in said


@pytest.mark.thorough
def test_an_exported_log_is_marked_alike(kept: Path, tmp_path: Path) -> None:
    connection = opened(kept)
    data = log.export(connection, "room1", names=False)
    connection.close()
    file = tmp_path / "log-room1.jsonl"
    file.write_bytes(data)
    rows: list[dict[str, Any]] = []
    for given in (str(file), str(kept)):
        out, _ = graded(str(TASK), "--session", given, "--format", "json")
        rows += [r["result"] for r in json.loads(out)["rows"] if r["id"] in ("Tried", file.stem)]
    one, other = rows
    assert (one["mark"], one["losses"], one["metrics"]) == (
        other["mark"],
        other["losses"],
        other["metrics"],
    )


def test_what_cannot_be_repeated_has_no_mark(kept: Path, tmp_path: Path) -> None:
    entries = tried(tmp_path / "session")
    done = entries[0].done
    assert done is not None
    forged = [entries[0]._replace(done=msgspec.structs.replace(done, text="*Protected*\n"))]
    database(tmp_path / "other.sqlite", {"Other": [*forged, *entries[1:]]})
    changed = tmp_path / "changed.jsonl"
    connection = opened(kept)
    changed.write_bytes(log.export(connection, "room1", names=False).replace(b"READY", b"REEDY"))
    connection.close()
    out, _ = graded(
        *(str(TASK), "--session", str(tmp_path / "other.sqlite"), "--session", str(changed)),
        *("--format", "json"),
    )
    other, altered = (row["result"] for row in json.loads(out)["rows"])
    assert other["mark"] is None
    assert "cannot be repeated" in other["cause"]
    assert altered["mark"] is None
    assert "was changed" in altered["cause"]


@pytest.mark.thorough
def test_a_session_marked_in_a_process_of_its_own_has_the_same_mark(tmp_path: Path) -> None:
    marker = SessionMarker(Place(str(TASK)), Wanted())
    order = Order("s", "s", entries_to_bytes(tried(tmp_path / "session")))
    here, there = tmp_path / "here", tmp_path / "there"
    here.mkdir()
    there.mkdir()
    command, told = marker.command(order, there)
    done = subprocess.run(command, input=told, capture_output=True, check=True)
    mine, other = (msgspec.json.decode(data) for data in (marker.work(order, here), done.stdout))
    assert mine["staff"] == other["staff"]
    assert mine["staff"]["mark"] is not None


def test_sessions_with_a_task_that_has_variants_are_marked_as_it_is_written(tmp_path: Path) -> None:
    lab = Path("examples/08-own-numbers/lab1")
    marker = SessionMarker(Place(str(lab)), Wanted(pages=False))
    for setting in (marker.whole, marker.public):
        assert setting.task is not None
        assert setting.task.variants is None
        assert set(setting.scene.locations) == {"safe"}
    database(tmp_path / "class.sqlite", {"Empty": []})
    _, said = graded(str(lab), "--session", str(tmp_path / "class.sqlite"))
    assert "as it is written" in said
