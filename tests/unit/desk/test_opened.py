"""A folder that is of no use to the desk says why."""

import json
from datetime import UTC, datetime
from pathlib import Path

import pytest
from msgspec.structs import replace

from tests.support_desk import about_of, write_desk_class
from vrts.desk.adding.asked import Body
from vrts.desk.again.asked import again
from vrts.desk.book import shelf as shelf_module
from vrts.desk.book.opened import open_marking
from vrts.desk.book.shelf import Shelf
from vrts.desk.desk import Desk, Moved
from vrts.desk.told import GraderTold
from vrts.marking.about import to_bytes
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Comment
from vrts.marking.layout import Layout
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused


@pytest.fixture
def layout(tmp_path: Path) -> Layout:
    return write_desk_class(tmp_path, 2)


def refusal(folder: Path) -> tuple[str, str]:
    with pytest.raises(Refused) as caught:
        open_marking(folder)
    return caught.value.diagnostics[0].rule.code, caught.value.diagnostics[0].headline


def test_what_is_no_folder_or_no_marking(tmp_path: Path) -> None:
    for place in (tmp_path / "nothing", Path(__file__)):
        with pytest.raises(CannotRead):
            open_marking(place)
    assert refusal(tmp_path)[0] == "V760"


def test_a_purged_folder(layout: Layout) -> None:
    (layout.staff / "marking.json").unlink()
    (layout.staff / "statistics.json").write_text("{}")
    assert refusal(layout.root) == (
        "V850",
        f"`{layout.root}` is purged: only its statistics are left",
    )


def test_a_marking_that_has_not_come_to_a_list(layout: Layout) -> None:
    about = replace(open_marking(layout.root).about, finished=None)
    (layout.staff / "marking.json").write_bytes(to_bytes(about))
    assert open_marking(layout.root).about.finished is None, "the list of before is shown"
    layout.results.unlink()
    assert refusal(layout.root)[0] == "V851"


def test_files_of_another_version_and_ids_that_lead_out_of_the_folder(layout: Layout) -> None:
    rows = json.loads(layout.results.read_text())
    rows["rows"][0]["id"] = "../../etc"
    layout.results.write_text(json.dumps(rows))
    assert refusal(layout.root)[0] == "V852"
    rows["schema"] = "vrts.class/9"
    layout.results.write_text(json.dumps(rows))
    assert refusal(layout.root)[0] == "V760"


def test_what_becomes_unreadable_is_told_beside_what_was_there(layout: Layout) -> None:
    shelf = Shelf(layout.root, "huber")
    before = shelf.now()
    assert shelf.now() is before, "nothing has changed"
    layout.results.write_text("{")
    after = shelf.now()
    assert [row.id for row in after.rows.rows] == [row.id for row in before.rows.rows]
    assert "holds no complete marking" in after.problems[0]
    assert shelf.now() is after
    said = [Comment(0, "", "s0001", "see me")]
    add_decisions(layout.decisions, "R. Huber", said, datetime.now(UTC))
    assert "holds no complete marking" in shelf.now().problems[0], "the rows are still old"


def test_nothing_is_decided_about_what_cannot_be_seen(layout: Layout) -> None:
    desk = Desk(layout.root, GraderTold("huber", "R. Huber"))
    body = Body([{"does": "comment", "student": "s0001", "text": "see me"}], desk.now().revision)
    copy = layout.decisions / "mayr (1).jsonl"
    copy.write_bytes((layout.decisions / "mayr.jsonl").read_bytes())
    before = (layout.decisions / "huber.jsonl").read_bytes()
    with pytest.raises(Refused) as caught:
        desk.add(body)
    (said,) = caught.value.diagnostics
    assert said.rule.code == "V849"
    assert "`mayr (1).jsonl`" in said.headline
    assert "do not rename" in said.headline, "the page has the remedy, too"
    assert (layout.decisions / "huber.jsonl").read_bytes() == before
    copy.unlink()
    assert desk.add(body).added == ("huber:9",)


def test_a_mark_that_ends_at_its_bound_has_changed_all_the_same(layout: Layout) -> None:
    desk = Desk(layout.root, GraderTold("huber", "R. Huber"))

    def more(points: str, shown: str) -> float | None:
        change = {"does": "change", "students": ["s0000"], "delta": points, "reason": "paper"}
        desk.add(Body([change], shown))
        return desk.now().book.by_id["s0000"].final

    desk.add(Body([{"does": "undo", "records": ["mayr:3"]}], desk.now().revision))  # an excuse
    assert more("10", desk.now().revision) == 10.0
    shown = desk.now().revision
    assert more("1", shown) == 10.0
    with pytest.raises(Moved):  # another page, which shows only the first of them
        more("1", shown)


def test_what_is_sent_again_is_written_once(layout: Layout) -> None:
    """The answer to the first time was lost: the page cannot know whether it was written."""
    desk = Desk(layout.root, GraderTold("huber", "R. Huber"))
    words, shown = [{"does": "comment", "student": "s0001", "text": "once"}], desk.now().revision
    assert desk.add(Body(words, shown, again=True)).added == ("huber:9",), "it never came"
    with pytest.raises(Moved):
        desk.add(Body(words, shown, again=True))
    after = Desk(layout.root, GraderTold("huber", "R. Huber"))  # it was killed meanwhile
    with pytest.raises(Moved):
        after.add(Body(words, shown, again=True))
    assert [one.text for one in after.now().book.decided.of("s0001").comments] == ["once"]


def test_what_could_not_be_read_for_a_moment_is_tried_again(
    layout: Layout, monkeypatch: pytest.MonkeyPatch
) -> None:
    shelf = Shelf(layout.root, "huber")
    said = [Comment(0, "", "s0001", "see me")]
    add_decisions(layout.decisions, "R. Huber", said, datetime.now(UTC))

    def busy(*_: object) -> None:
        raise OSError(24, "Too many open files")

    with monkeypatch.context() as patch:
        patch.setattr(shelf_module, "decide", busy)
        assert "Too many open files" in shelf.now().problems[0]
    assert not shelf.now().problems
    assert "see me" in [one.text for one in shelf.now().decided.of("s0001").comments]


def test_a_task_or_submissions_that_have_moved_are_told(layout: Layout, tmp_path: Path) -> None:
    about = open_marking(layout.root).about
    told = again(replace(about, command=("vrts", "grade", "--zone", "+01:00")), layout, 1)
    assert told.submissions == tmp_path / "handed-in"
    assert told.how.zone is not None
    roster = ("vrts", "grade", "t", "--roster=nowhere.csv")
    gone = [
        replace(about, place=replace(about.place, task="nowhere/task.toml")),
        about_of(tmp_path / "nowhere"),
        replace(about, command=roster),
    ]
    for one in gone:
        with pytest.raises(Refused) as caught:
            again(one, layout, 1)
        assert caught.value.diagnostics[0].rule.code == "V854"
        assert "nowhere" in caught.value.diagnostics[0].headline


def test_two_whose_names_look_alike_have_a_file_each(layout: Layout) -> None:
    """Both desks begin before either has decided anything, and take the same id."""
    first, second = (Desk(layout.root, GraderTold("a-b", name)) for name in ("A. B", "A/B"))
    for desk, number in ((first, 1), (second, 1), (second, 2)):
        words = {"does": "comment", "student": "s0001", "text": desk.me.name}
        added = desk.add(Body([words], desk.now().revision))
        assert added.added == (f"{desk.me.id}:{number}",)
    assert (first.me.id, second.me.id) == ("a-b", "a-b-2")
    told = second.now().book.decided.of("s0001").comments
    assert {one.text: one.mine for one in told} == {"A. B": False, "A/B": True}


def test_words_for_all_of_a_large_cause_go_together(layout: Layout) -> None:
    desk = Desk(layout.root, GraderTold("huber", "R. Huber"))
    words = [{"does": "comment", "student": "s0001", "text": f"number {k}"} for k in range(1000)]
    added = desk.add(Body(words, desk.now().revision))
    assert len(set(added.added)) == len(desk.now().book.decided.of("s0001").comments) == 1000
    with pytest.raises(Refused):
        desk.add(Body([*words, {"does": "comment", "student": "s9"}], desk.now().revision))
    assert len(desk.now().book.decided.of("s0001").comments) == 1000
