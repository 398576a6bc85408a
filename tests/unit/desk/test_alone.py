"""Rows that two graders mark: neither sees what the other thinks before both have finished."""

from fractions import Fraction
from pathlib import Path

import msgspec
import pytest

from tests.support_desk import write_desk_class, write_grader
from vrts.desk.adding.asked import Body, require_seen
from vrts.desk.book.alone import Seen, by_one, seen_by, shared_rows
from vrts.desk.desk import Desk
from vrts.desk.figures.statistics import statistics
from vrts.desk.following import is_behind
from vrts.desk.front.file_pages import FilePages
from vrts.desk.rows.row_view import one_row
from vrts.desk.told import GraderTold
from vrts.marking.by_hand.decisions.graders import Grader
from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Excuse,
    Extend,
    Finish,
    Give,
    Item,
    Undo,
)
from vrts.marking.layout import Layout
from vrts.marking.renewing.renewed import renewed
from vrts.pipeline.refused import Refused

AT = "2026-11-21T09:00:00+01:00"
ONE = "1" * 64
PROGRAMS = {"a": ONE, "b": "2" * 64}
BOTH = ("huber", Assign(1, AT, ("a",), ("huber", "mayr")))


def ledger_of(*said: tuple[str, Decision]) -> Ledger:
    names = {"huber": "R. Huber", "mayr": "S. Mayr"}
    records = tuple(Filed(f"{who}:{one.number}", who, names[who], one) for who, one in said)
    return Ledger(tuple(Grader(*pair) for pair in names.items()), records)


def names(seen: Seen) -> list[str]:
    return [one.name for one in seen.ledger.records]


def test_who_marks_alone_sees_no_opinion_of_anybody_else() -> None:
    ledger = ledger_of(
        BOTH,
        ("huber", Give(2, AT, "grip", ("a",))),
        ("mayr", Item(1, AT, "grip", "The grip", "-1")),
        ("mayr", Give(2, AT, "grip", ("a", "b"))),
        ("mayr", ChangeMark(3, AT, ("a",), "x", delta="-1/2")),
        ("mayr", Comment(4, AT, "a", "poor", private=True)),
        ("mayr", Comment(5, AT, "b", "good")),
        ("mayr", Finish(6, AT, "a", "6")),
        ("mayr", Decide(7, AT, "mayr:6", ("huber:9",), "agreed")),
        ("mayr", Extend(8, AT, ("a",), AT, "ill")),
        ("mayr", Excuse(9, AT, ("b",), "ill")),
        ("mayr", Undo(10, AT, ("mayr:3",))),
    )
    seen = seen_by(ledger, "huber", PROGRAMS)
    assert seen.alone == {"a"}
    assert seen.hidden == {f"mayr:{number}" for number in (2, 3, 4, 6, 7)}
    left = ["huber:1", "huber:2", "mayr:1", "mayr:2", "mayr:5", "mayr:8", "mayr:9", "mayr:10"]
    assert names(seen) == left
    given = next(one.said for one in seen.ledger.records if one.name == "mayr:2")
    assert isinstance(given, Give)
    assert given.students == ("b",), "and who has it elsewhere is seen"
    assert names(seen_by(ledger, "mayr", PROGRAMS)) == [
        one.name for one in ledger.records if one.name != "huber:2"
    ]
    assert seen_by(ledger, "onlooker", PROGRAMS) == Seen(ledger), "who does not mark it sees all"


def test_all_is_seen_when_all_have_finished_the_program_of_now() -> None:
    theirs = ("mayr", Finish(1, AT, "a", "6", ONE))
    mine = ("huber", Finish(2, AT, "a", "8", ONE))
    assert seen_by(ledger_of(BOTH, theirs), "huber", PROGRAMS).alone == {"a"}
    assert seen_by(ledger_of(BOTH, mine), "huber", PROGRAMS).alone == {"a"}, "mayr goes on"
    assert not seen_by(ledger_of(BOTH, theirs, mine), "huber", PROGRAMS).alone
    earlier = ("huber", Finish(2, AT, "a", "8", "3" * 64))
    assert seen_by(ledger_of(BOTH, theirs, earlier), "huber", PROGRAMS).alone == {"a"}
    undone = ("huber", Undo(3, AT, ("huber:2",)))
    assert seen_by(ledger_of(BOTH, theirs, mine, undone), "huber", PROGRAMS).alone == {"a"}
    single = ("huber", Assign(4, AT, ("a",), ("huber",)))
    assert not shared_rows(ledger_of(BOTH, single), PROGRAMS), "it is assigned to one again"


def test_a_decision_about_several_is_kept_for_those_that_are_seen() -> None:
    said = Decide(3, AT, "mayr:1", ("huber:9",), "agreed")
    ledger = ledger_of(
        ("mayr", Finish(1, AT, "a", "6")), ("mayr", Finish(2, AT, "b", "6")), ("mayr", said)
    )
    assert names(by_one(ledger, "huber", {"a"})) == ["mayr:2"]
    both = msgspec.structs.replace(said, students=("a", "b"))
    seen = by_one(ledger_of(("mayr", Finish(1, AT, "a", "6")), ("mayr", both)), "huber", {"a"})
    assert [one.said for one in seen.ledger.records] == [
        msgspec.structs.replace(both, students=("b",))
    ]


def test_nothing_is_undone_of_which_only_a_part_is_seen() -> None:
    require_seen((Undo(1, AT, ("mayr:1",)),), frozenset({"mayr:2"}))
    with pytest.raises(Refused) as refused:
        require_seen((Undo(1, AT, ("mayr:1", "mayr:2")),), frozenset({"mayr:2"}))
    assert refused.value.diagnostics[0].headline.startswith("mayr:2 is also about a row")


# the desk


@pytest.fixture
def layout(tmp_path: Path) -> Layout:
    """A class of which Huber and Mayr both mark `s0000`."""
    layout = write_desk_class(tmp_path, 4, decisions=False)
    write(layout, mayr_finishes=False)
    return layout


def write(layout: Layout, *, mayr_finishes: bool, delta: str = "-1/2") -> None:
    computed = Desk(layout.root, GraderTold("x", "X")).now().listed.rows["s0000"].computed
    assert computed is not None
    said: list[Decision] = [
        Item(1, AT, "grip", "The grip", "-1"),
        Give(2, AT, "grip", ("s0000", "s0001")),
        Comment(3, AT, "s0000", "poor"),
    ]
    if mayr_finishes:
        said.append(Finish(4, AT, "s0000", exact(computed - 1)))
    write_grader(layout, "mayr", "S. Mayr", said)
    write_grader(
        layout,
        "huber",
        "R. Huber",
        [
            Assign(1, AT, ("s0000",), ("huber", "mayr")),
            ChangeMark(2, AT, ("s0000",), "untidy", delta=delta),
        ],
    )


def exact(mark: float) -> str:
    return str(Fraction(str(round(mark, 1))))


def sit(layout: Layout, who: str) -> Desk:
    return Desk(layout.root, GraderTold(who, who))


def finish(desk: Desk) -> float:
    shown = desk.now()
    own = shown.listed.rows["s0000"].own
    assert own is not None
    said = {"does": "finish", "student": "s0000", "mark": exact(own)}
    desk.add(Body([said], shown.revision))
    return own


def test_each_is_shown_and_finishes_with_the_mark_that_they_alone_would_give(
    layout: Layout,
) -> None:
    huber = Desk(layout.root, GraderTold("huber", "R. Huber"))
    mayr = Desk(layout.root, GraderTold("mayr", "S. Mayr"))
    shown = huber.now()
    row = shown.listed.rows["s0000"]
    assert row.computed is not None
    assert (row.final, row.own) == (row.computed - 0.5, row.computed - 0.5)
    assert (row.items, row.comments, row.alone) == ((), 0, True)
    detail = one_row(shown.book, row, None, None)
    assert (detail.given, detail.comments) == ((), ())
    assert {one.who for one in detail.history} == {"huber"}
    assert {one.who for one in detail.changes} == {"huber"}
    assert [one.students for one in shown.book.decided.items] == [("s0001",)]
    other = mayr.now().listed.rows["s0000"]
    assert (other.final, other.change) == (row.computed - 1.0, -1.0)
    assert sit(layout, "else").now().listed.rows["s0000"].final == row.computed - 1.5
    renewed(layout)
    assert not is_behind(huber.now().book), "the lists have what is hidden here"
    assert finish(huber) == row.computed - 0.5
    assert huber.now().listed.rows["s0000"].alone, "Mayr has not finished"
    assert finish(mayr) == row.computed - 1.0
    after = huber.now().listed.rows["s0000"]
    assert (after.alone, after.conflict) == (False, True)
    assert [(one.who, one.stale) for one in after.finished] == [("huber", False), ("mayr", False)]
    assert (after.final, after.own) == (row.computed - 1.5, row.computed - 0.5)
    assert statistics(huber.now().book, ()).double[0].difference == 0.5


def test_who_would_give_another_mark_now_has_not_finished(layout: Layout) -> None:
    huber = Desk(layout.root, GraderTold("huber", "R. Huber"))
    finish(huber)
    change = {"does": "change", "students": ["s0000"], "delta": "-1/10", "reason": "late"}
    huber.add(Body([change], huber.now().revision))
    row = huber.now().listed.rows["s0000"]
    assert [(one.who, one.stale) for one in row.finished] == [("huber", True)]
    finish(huber)
    row = huber.now().listed.rows["s0000"]
    assert [(one.who, one.stale) for one in row.finished] == [("huber", False)]


def test_agreed_marks_that_are_not_the_final_one_are_told(layout: Layout) -> None:
    write(layout, mayr_finishes=True, delta="-1")
    huber = Desk(layout.root, GraderTold("huber", "R. Huber"))
    finish(huber)
    row = huber.now().listed.rows["s0000"]
    assert row.computed is not None
    assert row.final == row.computed - 2.0, "both took a point, for their own reasons"
    assert not row.conflict
    told = f"R. Huber and S. Mayr both finished with {row.computed - 1:g}, and it is {row.final:g}"
    assert row.otherwise.startswith(told)
    assert row.why_next == "graders agree on another mark"


def test_the_report_tells_nothing_of_who_is_hidden(layout: Layout) -> None:
    renewed(layout)
    desk = Desk(layout.root, GraderTold("huber", "R. Huber"))
    place = layout.grader("s0000") / "report.html"
    assert b"The grip" in place.read_bytes()
    page = FilePages(desk).report("s0000", "report.html", staff=True)
    assert b"untidy" in bytes(page.body) or b"Final mark" in bytes(page.body)
    assert b"The grip" not in bytes(page.body)
    assert b"poor" not in bytes(page.body)
