"""The desk marks again as `vrts grade` would; whatever dies meanwhile, the folder stays whole."""

import fcntl
from pathlib import Path

import pytest

from tests.support_desk import write_desk_class
from tests.support_desk_server import DeskServer
from tests.support_live import Json
from vrts.desk.book.book import found_out
from vrts.marking.about import from_bytes
from vrts.marking.layout import Layout
from vrts.marking.row import Class, class_from_bytes

CHANGED = "the task has changed since the class was marked"


def listed(layout: Layout) -> Class:
    return class_from_bytes(layout.results.read_bytes())


def ended(desk: DeskServer, students: object) -> Json:
    """Mark, and return the last that is told of it."""
    with desk.events() as events:
        assert desk.request("POST", "/api/mark", {"students": students}).status == 202
        refused = desk.request("POST", "/api/mark", {"students": "all"}).status
        assert refused == 409, "one at a time"
        return next(told for name, told in events if name == "marking" and not told["running"])


@pytest.mark.thorough
def test_one_is_not_marked_by_another_task_than_the_others(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 2, decisions=False)
    before = {row.id: row.result for row in listed(layout).rows}
    with DeskServer(layout.root) as desk:
        assert desk.request("POST", "/api/mark", {"students": ["nobody"]}).status == 404
        assert desk.request("POST", "/api/mark", {"students": []}).status == 422
        assert desk.request("DELETE", "/api/mark").status == 409
        told = ended(desk, ["s0001"])
        assert told["problem"] == f"{CHANGED}. Mark all again, so that one task holds for everybody"
        assert desk.whole["marking"]["problem"] == told["problem"]
    assert {row.id: row.result for row in listed(layout).rows} == before
    (tmp_path / "handed-in").rename(tmp_path / "moved")
    with DeskServer(layout.root) as desk:
        moved = desk.request("POST", "/api/mark", {"students": "all"})
        assert moved.status == 422
        assert "is not where it was" in moved.json["error"]
        assert desk.row("s0001")["source"] is None
        assert "handed-in" in desk.row("s0001")["source_problem"]


@pytest.mark.thorough
def test_marks_anew_keep_decisions_and_a_desk_that_dies_loses_nothing(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 3)
    desk = DeskServer(layout.root)
    words = {"does": "comment", "student": "s0001", "text": "see me"}
    assert desk.add(words).status == 200
    told = ended(desk, "all")
    assert (told["problem"], told["done"]) == (None, 3)
    marks = {row.id: found_out(row).mark for row in listed(layout).rows}
    assert marks == {"s0000": 7.0, "s0001": 7.0, "s0002": 7.0}, "as the example's program earns"
    assert ended(desk, ["s0002"])["problem"] is None
    with desk.events() as events:
        assert desk.request("POST", "/api/mark", {"students": "all"}).status == 202
        next(told for name, told in events if name == "marking" and told["done"])
        desk.kill()
    with (layout.staff / ".again.lock").open() as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # until the marking has ended by itself
    assert from_bytes((layout.staff / "marking.json").read_bytes()).finished is not None
    assert {row.id: found_out(row).mark for row in listed(layout).rows} == marks
    with DeskServer(layout.root) as again:
        assert again.whole["marking"]["problem"] is None
        assert "see me" in [one["text"] for one in again.row("s0001")["comments"]]
    report = (layout.student("s0001") / "report.html").read_text()
    assert "see me" in report


@pytest.mark.thorough
def test_what_a_dead_desk_has_not_written_the_next_one_writes(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 4, decisions=False)
    desk = DeskServer(layout.root)
    change = {"does": "change", "students": ["s0003"], "mark": "4", "reason": "from paper"}
    assert desk.add(change).status == 200
    desk.kill()
    with DeskServer(layout.root) as again:
        shown = {row["id"]: row["final"] for row in again.whole["rows"]}
        assert shown["s0003"] == 4.0, "the state is that of the files"
    assert {row.id: row.final for row in listed(layout).rows} == shown
    assert "4.0" in (layout.student("s0003") / "feedback.txt").read_text()
