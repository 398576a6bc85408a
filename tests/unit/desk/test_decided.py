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
    Give,
    Item,
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
    assert [one.undone for one in first.history] == [1, 0, 0]
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


def test_items_tell_all_their_versions_and_those_of_which_all_is_undone_are_not_forgotten() -> None:
    first = ("huber", Item(1, AT, "grip", "The grip", "-1/2"))
    given = ("mayr", Give(1, AT, "grip", ("a",)))
    second = ("mayr", Item(2, AT, "grip", "The grip", "-2", ("huber:1",)))
    undo = ("huber", Undo(2, AT, ("mayr:2",)))
    (item,) = told("huber", first, given, second, undo).items
    assert (item.points, item.version, item.students) == (-0.5, "huber:1", ("a",))
    assert [(one.record, one.points, one.undone_by) for one in item.versions] == [
        ("huber:1", -0.5, None),
        ("mayr:2", -2.0, "huber:2"),
    ]
    (gone,) = told("huber", first, ("mayr", Undo(1, AT, ("huber:1",)))).items
    assert (gone.version, gone.withdrawn, gone.versions[0].undone_by) == ("", True, "mayr:1")


def test_what_one_deed_gave_to_many_stands_together_until_it_is_undone() -> None:
    later = AT.replace("09:00:00", "09:00:01")
    said = [("huber", Item(1, AT, "grip", "The grip", "-1"))]
    said += [
        ("huber", Give(k, AT, "grip", (who,), programs={who: "1" * 64}))
        for k, who in ((2, "a"), (3, "b"))
    ]
    said += [("huber", Comment(k, AT, who, "look")) for k, who in ((4, "a"), (5, "b"))]
    said += [("huber", Comment(6, later, "a", "look")), ("mayr", Comment(1, AT, "a", "look"))]
    found = told("huber", *said)
    assert found.at_once == (("huber:2", "huber:3"), ("huber:4", "huber:5"))
    assert (found.beside("huber:3"), found.beside("huber:6")) == (("huber:2", "huber:3"), ())
    assert told("huber", *said, ("mayr", Undo(2, AT, ("huber:2",)))).at_once[0][0] == "huber:4"
