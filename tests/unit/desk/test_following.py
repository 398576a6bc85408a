"""Files follow when a marking has ended; some are never marked by another task than the others."""

import threading
from datetime import UTC, datetime
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.support_desk import TASK, write_desk_class
from vrts.desk.again import marked
from vrts.desk.again.marked import is_as_now, mark_again, together
from vrts.desk.book.shelf import Shelf
from vrts.desk.following import NOT_YET, follow, is_behind
from vrts.desk.upkeep import Upkeep
from vrts.marking.appeals.written import read_written
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Comment
from vrts.marking.class_files import begin_class, write_class
from vrts.marking.result import Kind, Result
from vrts.marking.row import HandedIn, Student, row_of
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.submission.summary import unmarked
from vrts.pipeline.refused import Refused


def test_what_is_decided_while_a_marking_goes_on_is_written_when_it_has_ended(
    tmp_path: Path,
) -> None:
    layout = write_desk_class(tmp_path, 3, decisions=False)
    written = read_written(layout.root)
    begin_class(replace(written.about, finished=None), layout)
    said = [Comment(0, "", "s0001", "see me")]
    add_decisions(layout.decisions, "R. Huber", said, datetime.now(UTC))
    assert follow(layout.root) == NOT_YET
    assert is_behind(Shelf(layout.root, "huber").now())
    write_class(written.rows, written.about, layout)  # newer than the decision, and without it
    assert is_behind(Shelf(layout.root, "huber").now())
    assert follow(layout.root) == ""
    assert not is_behind(Shelf(layout.root, "huber").now())


def test_what_could_not_be_written_is_tried_again_and_no_fault_ends_that() -> None:
    wrote = threading.Event()
    answers = iter([NOT_YET, OSError("no disk"), ""])

    def write() -> str:
        answer = next(answers)
        if isinstance(answer, OSError):
            raise answer
        if not answer:
            wrote.set()
        return answer

    upkeep = Upkeep(write, quiet_s=0.0, again_s=0.0)
    upkeep.begin()
    upkeep.wanted()
    assert wrote.wait(20)
    upkeep.end()
    assert upkeep.problem == ""


def test_a_changed_scene_model_or_vrts_is_another_task(tmp_path: Path) -> None:
    marker = Marker(Place(str(TASK)), Wanted())
    layout = write_desk_class(tmp_path, 1, decisions=False)
    same = unmarked(Kind.MISSING, "anna", "nothing came", None, marker.whole, "0" * 64)

    def is_as(result: Result) -> bool:
        return is_as_now(row_of(result, Student(), HandedIn()), marker, layout)

    assert is_as(same)
    other = "0" * 64
    assert not is_as(replace(same, scene=replace(same.scene, sha256=other)))
    assert not is_as(replace(same, task=replace(same.task, sha256=other)))
    assert same.controller is not None
    model = replace(same.controller, sha256=other)
    assert not is_as(replace(same, controller=model))
    older = replace(same.versions, vrts="0.0.1")
    assert not is_as(replace(same, versions=older))


def test_who_is_new_is_listed_and_a_class_is_never_marked_by_two_tasks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    layout = write_desk_class(tmp_path, 3, decisions=False)
    written = read_written(layout.root)
    new = replace(written.rows.rows[0], id="new")
    rows = together(written.rows, {"new": new, "s0001": replace(written.rows.rows[1], final=1.0)})
    assert [row.id for row in rows.rows][-1] == "new"
    assert {row.id: row.final for row in rows.rows}["s0001"] == 1.0
    before = layout.results.read_bytes()

    def nobody(*_: object) -> None:
        """Is told."""

    def half(*_: object, begun: object, told: object, **__: object) -> None:
        assert callable(begun)
        assert callable(told)
        begun(["s0000"])
        raise marked.Stopped

    monkeypatch.setattr(marked, "mark_whole_class", half)
    with pytest.raises(Refused) as refused:  # the rows of this class are of a task that is no more
        mark_again(layout.root, None, nobody)
    assert refused.value.diagnostics[0].headline == marked.HALF
    assert layout.results.read_bytes() == before
    assert follow(layout.root) == NOT_YET, "the marking has not ended"
    with pytest.raises(Refused) as refused:
        mark_again(layout.root, ["s0000"], nobody)
    assert "begun and not ended" in refused.value.diagnostics[0].headline
