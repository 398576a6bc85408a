"""What graders decided, as the page is told it."""

from vrts.desk.book.alone import seen_by
from vrts.desk.book.decided import Decided, told_of
from vrts.marking.by_hand.decisions.graders import Grader
from vrts.marking.by_hand.decisions.ledger import Filed, Ledger
from vrts.marking.by_hand.decisions.records import (
    Assign,
    ChangeMark,
    Comment,
    Decide,
    Decision,
    Finish,
    Undo,
)
from vrts.marking.by_hand.decisions.state import state_of

AT = "2026-11-21T09:00:00+01:00"
PROGRAMS = {"a": "1" * 64, "b": "2" * 64}


def told(me: str, *said: tuple[str, Decision]) -> Decided:
    names = {"huber": "R. Huber", "mayr": "S. Mayr"}
    records = tuple(Filed(f"{who}:{one.number}", who, names[who], one) for who, one in said)
    ledger = Ledger(tuple(Grader(*pair) for pair in names.items()), records)
    seen = seen_by(ledger, me, PROGRAMS).ledger
    return told_of(seen, state_of(seen, PROGRAMS), PROGRAMS, me)


def test_who_marks_by_themselves_sees_no_mark_of_the_other_before_finishing() -> None:
    both = ("huber", Assign(1, AT, ("a",), ("huber", "mayr")))
    theirs = ("mayr", Finish(1, AT, "a", "13/2"))
    before = told("huber", both, theirs).of("a")
    assert before.finished == ()
    assert [one.record for one in before.history] == ["huber:1"]
    mine = ("huber", Finish(2, AT, "a", "8"))
    after = told("huber", both, theirs, mine).of("a")
    assert [(one.who, one.mark) for one in after.finished] == [("huber", 8.0), ("mayr", 6.5)]
    assert after.conflict
    stale = ("huber", Finish(2, AT, "a", "8", "3" * 64))
    assert [one.who for one in told("huber", both, theirs, stale).of("a").finished] == ["huber"]
    onlooker = told("else", both, theirs).of("a")
    assert [one.who for one in onlooker.finished] == ["mayr"]


def test_history_tells_what_was_undone_and_decided() -> None:
    found = told(
        "huber",
        ("huber", ChangeMark(1, AT, ("a",), "x", delta="1")),
        ("huber", Undo(2, AT, ("huber:1",))),
        ("huber", ChangeMark(3, AT, ("a", "b"), "y", delta="-1/2")),
        ("mayr", ChangeMark(1, AT, ("b",), "z", mark="4")),
        ("mayr", Decide(2, AT, "huber:3", ("mayr:1",), "agreed")),
    )
    first = found.of("a")
    assert [(one.record, one.undone_by) for one in first.history] == [
        ("huber:1", "huber:2"),
        ("huber:3", None),
        ("mayr:2", None),
    ]
    assert [(one.record, one.delta) for one in first.changes] == [("huber:3", -0.5)]
    assert [one.record for one in found.of("b").changes] == ["huber:3"]
    assert found.conflicts == ()


def test_it_is_told_whose_mark_takes_the_place_and_for_whom_it_was_decided() -> None:
    found = told(
        "huber",
        ("huber", ChangeMark(1, AT, ("a", "b"), "x", mark="4")),
        ("mayr", ChangeMark(1, AT, ("a", "b"), "x", mark="5")),
        ("mayr", Decide(2, AT, "huber:1", ("mayr:1",), "agreed", ("a",))),
    )
    assert [found.of(name).set_by for name in "ab"] == [("huber",), ()]
    assert [one.student for one in found.conflicts] == ["b"]
    assert "mayr:2" in {one.record for one in found.of("a").history}
    assert "mayr:2" not in {one.record for one in found.of("b").history}


def test_a_comment_on_another_program_is_shown_as_such() -> None:
    found = told(
        "mayr",
        ("huber", Comment(1, AT, "a", "good", program="1" * 64)),
        ("huber", Comment(2, AT, "a", "old", program="9" * 64, line=3)),
    )
    comments = {one.text: one for one in found.of("a").comments}
    assert (comments["good"].stale, comments["good"].mine) == (False, False)
    assert (comments["old"].stale, comments["old"].line) == (True, 3)
