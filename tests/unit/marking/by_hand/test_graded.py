"""What graders' decisions make of a row: marks, lateness, doubts, words; and all of it undone."""

from datetime import UTC, datetime, timedelta
from fractions import Fraction

from msgspec.structs import replace

from tests.support_rows import plain_result
from tests.unit.marking.by_hand.support import AT, change, ledger
from vrts.base.source import SourceFile
from vrts.check.task.late_rules import LateRules
from vrts.check.task.manifest import IN_HIDDEN_SCENE
from vrts.marking.by_hand.by_hand import ByHand, all_lapses, with_by_hand
from vrts.marking.by_hand.decisions.listing import listing, with_file
from vrts.marking.by_hand.decisions.records import (
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
from vrts.marking.by_hand.decisions.sound import flaw_of
from vrts.marking.by_hand.decisions.state import prepared, state_of
from vrts.marking.by_hand.overrides import NONE, program_of, read_overrides
from vrts.marking.exports.feedback import feedback_text, said_by_graders
from vrts.marking.exports.given import Returned
from vrts.marking.exports.steps import steps
from vrts.marking.lateness import in_row, lateness
from vrts.marking.result import Kind, Program
from vrts.marking.row import (
    Class,
    HandedIn,
    MadeStep,
    Row,
    Student,
    class_from_bytes,
    class_to_bytes,
    row_of,
)
from vrts.marking.unsafe import Reason

DUE = datetime(2026, 11, 20, 12, tzinfo=UTC)
RULES = LateRules(DUE, per_day=Fraction(1))
OTHER = "b" * 64
ITEM = Item(1, AT, "comments", "no comments", "-1/2")
GIVEN = Give(1, AT, "comments", ("anna",), 9)


def row(mark: float = 8.0, received: datetime | None = DUE) -> Row:
    """Return the row of Anna, as marking makes it."""
    result = replace(plain_result("anna"), mark=mark)
    late = in_row(lateness(RULES, received), result)
    when = None if received is None else received.isoformat()
    return row_of(result, Student("Anna"), HandedIn("a.v2", received=when), late)


def by_hand(overrides: str = "", /, **files: tuple[Decision, ...]) -> ByHand:
    """Return decisions of graders beside an `overrides.toml`."""
    held = ledger(**files)
    read = read_overrides(SourceFile("o.toml", overrides), ("anna",)) if overrides else NONE
    return ByHand(read, held, prepared(held), RULES)


def decided(before: Row, overrides: str = "", /, **files: tuple[Decision, ...]) -> Row:
    """Return a row with decisions; they are taken off again without a trace."""
    after = with_by_hand(before, by_hand(overrides, **files))
    assert with_by_hand(after, ByHand()) == before
    assert with_by_hand(after, by_hand(overrides, **files)) == after
    (read,) = class_from_bytes(class_to_bytes(Class("vrts.class/1", "Lab", (after,)))).rows
    assert read == after
    return after


def reasons(found: Row) -> list[Reason]:
    """Return why a mark is unsafe."""
    return [doubt.reason for doubt in found.unsafe]


def added(found: Row) -> dict[str, Fraction]:
    """Return the steps by title; they add up."""
    made = steps(found)
    final, computed = found.exact_final, found.result.exact_mark
    assert final is not None
    assert computed is not None
    assert sum(one.points for one in made) == final - computed
    return {one.title: one.points for one in made}


def test_items_count_once_and_are_steps_with_who_gave_them() -> None:
    again = Give(1, AT, "comments", ("anna",), None, 3.2)
    found = decided(row(), huber=(ITEM, GIVEN), lang=(again,))
    assert found.final == 7.5
    assert added(found) == {"no comments": Fraction(-1, 2)}
    assert found.change is not None
    assert (found.change.who, found.change.date) == ("Huber, Lang", "2026-11-26")
    assert found.decided is not None
    assert found.decided.items[0].places == ((9, None), (None, 3.2))
    assert decided(row(), huber=(ITEM, GIVEN, replace(ITEM, points="-2"))).final == 6.0
    assert decided(row(), huber=(ITEM, GIVEN, replace(ITEM, withdrawn=True))).final == 8.0
    assert decided(row(), huber=(ITEM, GIVEN, Undo(1, AT, ("huber:2",)))) == row()


def test_marks_stay_between_nothing_and_all_points() -> None:
    assert decided(row(0.3), huber=(ITEM, GIVEN)).final == 0.0
    assert added(decided(row(0.3), huber=(ITEM, GIVEN)))["as marks are written"] == Fraction(1, 5)
    assert decided(row(), huber=(change("anna", delta="5"),)).final == 10.0


def test_items_come_before_what_is_changed_by_hand() -> None:
    found = decided(row(), huber=(ITEM, GIVEN), lang=(change("anna", delta="1"),))
    assert found.final == 8.5
    assert decided(row(), huber=(ITEM, GIVEN, change("anna", mark="7"))).final == 7.0


def test_points_add_up_and_only_marks_take_the_place_of_what_was_before() -> None:
    half = change("anna", delta="-1/2")
    both = (half, replace(half, reason="also this"))
    found = decided(row(), huber=both)
    assert (found.final, found.unsafe) == (7.0, ())
    assert [one.delta for one in steps_made(found)] == ["-1/2", "-1/2"]
    assert decided(row(), huber=(half, half)).final == 7.0  # twice, by one grader
    assert decided(row(), huber=(*both, change("anna", mark="7"))).final == 7.0
    assert decided(row(), huber=(change("anna", mark="7"), half)).final == 6.5
    ill = Excuse(1, AT, ("anna",), "ill")
    assert decided(row(), huber=(ill, half)).result.kind is Kind.EXCUSED
    assert decided(row(), huber=(ill,), lang=(half,)).result.kind is Kind.EXCUSED
    assert decided(row(), huber=(half, ill, Undo(1, AT, ("huber:2",)))).final == 7.5


def test_points_of_two_graders_add_up_unless_they_are_for_the_same_reason() -> None:
    half = change("anna", delta="-1/2")
    found = decided(row(), huber=(half,), lang=(replace(half, reason="also this"),))
    assert (found.final, found.unsafe) == (7.0, ())
    once = decided(row(), huber=(half,), lang=(replace(half, reason="Looked  at"),))
    assert (once.final, once.unsafe) == (7.5, ())
    assert once.change is not None
    assert once.change.who == "Huber, Lang"
    more = change("anna", delta="-1")
    assert reasons(decided(row(), huber=(half,), lang=(more,))) == [Reason.CONFLICT]


def test_a_mark_swallows_nothing_that_another_grader_has_given() -> None:
    seven = change("anna", mark="7")
    files = {"huber": (ITEM, seven), "mayr": (GIVEN,)}
    found = decided(row(), **files)
    assert (found.final, reasons(found)) == (7.5, [Reason.CONFLICT])
    mark = decided(row(), **files, boss=(Decide(1, AT, "huber:2", ("mayr:1",), "agreed"),))
    assert (mark.final, mark.unsafe) == (7.0, ())
    assert mark.decided is not None
    assert not mark.decided.items  # the student reads of nothing that does not count
    item = decided(row(), **files, boss=(Decide(1, AT, "mayr:1", ("huber:2",), "agreed"),))
    assert (item.final, item.unsafe) == (7.5, ())
    assert decided(row(), huber=(ITEM, seven, GIVEN)).final == 6.5  # behind the mark: added
    assert not decided(row(), huber=(ITEM, GIVEN, seven), mayr=(GIVEN,)).unsafe  # known to Huber
    points = {"huber": (seven,), "mayr": (change("anna", delta="-1/2"),)}
    assert reasons(decided(row(), **points)) == [Reason.CONFLICT]


def test_a_mark_in_the_file_swallows_only_items_of_days_before() -> None:
    head = '[[change]]\nstudent = "anna"\nreason = "r"\nwho = "w"\nmark = 7\n'
    for day, why in (("26", [Reason.CONFLICT]), ("25", [Reason.CONFLICT]), ("27", [])):
        found = decided(row(), f'{head}date = "2026-11-{day}"\n', huber=(ITEM, GIVEN))
        assert (found.final, reasons(found)) == (7.5 if why else 7.0, why)


def test_more_than_there_is_to_get_cannot_be_meant() -> None:
    for said in (change("anna", mark="75"), change("anna", delta="-11")):
        found = decided(row(), huber=(said,))
        assert (found.final, reasons(found)) == (8.0, [Reason.CONFLICT])
        assert "where marks are out of 10" in found.unsafe[0].sentence
        assert not decided(row(), huber=(said, Undo(1, AT, ("huber:1",)))).unsafe
    found = decided(row(), huber=(replace(ITEM, points="-20"), GIVEN))
    assert reasons(found) == [Reason.CONFLICT]


def steps_made(found: Row) -> tuple[MadeStep, ...]:
    """Return the parts of the change by hand."""
    assert found.decided is not None
    return found.decided.steps


def test_a_conflict_counts_for_neither_and_makes_the_mark_unsafe() -> None:
    files = {"huber": (change("anna", delta="1"),), "lang": (change("anna", delta="2"),)}
    found = decided(row(), **files)
    assert (found.final, reasons(found)) == (8.0, [Reason.CONFLICT])
    settled = decided(row(), **files, boss=(Decide(1, AT, "lang:1", ("huber:1",), "agreed"),))
    assert (settled.final, reasons(settled)) == (10.0, [])
    apart = {"huber": (ITEM, GIVEN, replace(ITEM, points="-2", after=("huber:1",)))}
    other = replace(ITEM, points="-1", after=("huber:1",))
    found = decided(row(), **apart, lang=(other,))
    assert (found.final, reasons(found)) == (8.0, [Reason.CONFLICT])


def test_marks_of_two_graders_that_differ_are_settled_by_one_of_them() -> None:
    files = {"huber": (Finish(1, AT, "anna", "9"),), "lang": (Finish(1, AT, "anna", "17/2"),)}
    assert reasons(decided(row(), **files)) == [Reason.CONFLICT]
    found = decided(row(), **files, boss=(Decide(1, AT, "lang:1", ("huber:1",), "agreed"),))
    assert (found.final, reasons(found)) == (8.5, [])
    assert found.change is not None
    assert found.change.who == "Lang, decided by Boss"


def test_whose_mark_counts_settles_no_doubt_and_holds_until_something_changes() -> None:
    late = row(8.0, None)
    files = {"huber": (Finish(1, AT, "anna", "9"),), "lang": (Finish(1, AT, "anna", "7"),)}
    settles = Decide(1, AT, "lang:1", ("huber:1",), "agreed")
    found = decided(late, **files, boss=(settles,))
    assert (found.final, reasons(found)) == (7.0, [Reason.LATE])
    before = (replace(ITEM, at="2026-11-26T19:00:00+00:00"), GIVEN)
    assert decided(row(), **files, boss=(settles,), mayr=before).final == 7.0
    given = replace(GIVEN, at="2026-11-26T20:00:01+00:00")
    found = decided(row(), **files, boss=(settles,), mayr=(ITEM, given))
    assert (found.final, reasons(found)) == (7.5, [Reason.CONFLICT])
    changed = (ITEM, GIVEN, replace(ITEM, points="-1", at="2026-11-26T20:00:01+00:00"))
    found = decided(row(), **files, boss=(settles,), mayr=changed)
    assert (found.final, reasons(found)) == (7.0, [])  # it comes to the same
    changed = (ITEM, GIVEN, replace(ITEM, points="-2", at="2026-11-26T20:00:01+00:00"))
    assert reasons(decided(row(), **files, boss=(settles,), mayr=changed)) == [Reason.CONFLICT]


def test_marks_that_are_written_alike_are_no_conflict() -> None:
    files = {"huber": (Finish(1, AT, "anna", "27/4"),), "lang": (Finish(1, AT, "anna", "34/5"),)}
    assert not decided(row(), **files).unsafe
    head = '[[change]]\nstudent = "anna"\nreason = "r"\nwho = "w"\ndate = "2026-11-30"\n'
    assert not decided(row(), f"{head}mark = 6.75\n", huber=(change("anna", mark="34/5"),)).unsafe
    two = {**files, "mayr": (Finish(1, AT, "anna", "5"),), "rest": (change("anna", delta="-5/4"),)}
    kept = decided(row(), **two, boss=(Decide(1, AT, "lang:1", ("mayr:1",), "agreed"),))
    assert (kept.final, kept.unsafe) == (6.8, ())
    assert [one.delta for one in steps_made(kept)] == ["-5/4", "0"]


def test_the_file_and_graders_who_differ_are_a_conflict_too() -> None:
    head = '[[change]]\nstudent = "anna"\nreason = "r"\nwho = "w"\ndate = "2026-11-30"\n'
    seven, half = f"{head}mark = 7\n", f"{head}delta = 0.5\n"
    found = decided(row(), seven, huber=(change("anna", mark="9"),))
    assert (found.final, reasons(found)) == (8.0, [Reason.CONFLICT])
    assert "`overrides.toml` (w): the mark 7" in found.unsafe[0].sentence
    told = with_file(listing(ledger(), state_of(ledger(), {})), (found,))
    assert [(one.student, one.records) for one in told.conflicts] == [("anna", ())]
    assert with_file(told, (found,)) == told, "what is told is not told twice"
    assert not decided(row(), seven, huber=(change("anna", mark="7"),)).unsafe
    assert decided(row(), half, huber=(change("anna", delta="1"),)).final == 9.5
    assert reasons(decided(row(), half, huber=(Excuse(1, AT, ("anna",), "ill"),))) == [
        Reason.CONFLICT
    ]


def test_what_graders_decide_again_is_not_settled_by_a_change() -> None:
    for reason, says in (("lapsed", "decide again"), ("conflict", "which side holds")):
        flaw = flaw_of(replace(change("anna", delta="1"), settles=(reason,)))
        assert f"`{reason}` cannot be settled by a change" in flaw
        assert says in flaw
    assert flaw_of(replace(change("anna", delta="1"), settles=("late", "all"))) == ""


def test_who_is_excused_has_no_mark_and_nothing_to_be_looked_at() -> None:
    late = row(4.0, DUE + timedelta(hours=30))
    doubtful = replace(late.result, review=("look",), lowest=3.0)
    before = row_of(doubtful, late.student, late.handed_in, late.late)
    found = decided(before, huber=(Excuse(1, AT, ("anna",), "ill"),))
    assert (found.result.kind, found.final, found.unsafe) == (Kind.EXCUSED, None, ())
    assert found.late is None
    told = feedback_text(Returned(found, found.result)).decode()
    assert "excused: ill (Huber)." in told
    assert "point" not in told


def test_a_later_deadline_changes_what_lateness_costs() -> None:
    late = row(8.0, DUE + timedelta(hours=30))
    assert late.final == 6.0
    one_day = Extend(1, AT, ("anna",), (DUE + timedelta(days=1)).isoformat(), "ill")
    assert decided(late, huber=(one_day,)).final == 7.0
    week = replace(one_day, due=(DUE + timedelta(days=7)).isoformat())
    found = decided(late, huber=(week,))
    assert (found.final, found.late) == (8.0, None)
    earlier = replace(one_day, due=(DUE - timedelta(days=7)).isoformat())
    assert decided(late, huber=(earlier,)).final == 6.0  # no extension takes time away
    assert decided(late, huber=(one_day,), lang=(week,)).final == 6.0
    assert reasons(decided(row(8.0, None), huber=(week,))) == [Reason.LATE]


def test_more_time_by_which_another_attempt_may_count_asks_to_mark_again() -> None:
    week = Extend(1, AT, ("anna",), (DUE + timedelta(days=7)).isoformat(), "ill")
    best = replace(row().handed_in, why="the best of 2 attempts, number 1")
    for handed_in, again in (
        (row().handed_in, False),
        (best, True),
        (replace(best, due=week.due), False),  # it was chosen by this deadline
    ):
        before = row_of(row().result, Student("Anna"), handed_in)
        found = decided(before, huber=(week,))
        assert (reasons(found) == [Reason.LATE]) is again
        assert ("mark again" in "".join(one.sentence for one in found.unsafe)) is again
    exam = by_hand(huber=(week,))._replace(late=LateRules(DUE, opens=DUE - timedelta(hours=1)))
    assert reasons(with_by_hand(row(), exam)) == [Reason.LATE]


def test_moments_of_a_run_that_students_do_not_see_are_not_told() -> None:
    item, place = replace(ITEM, points="-1"), replace(GIVEN, time_s=4.5)
    files = (item, place, Comment(1, AT, "anna", "too fast", 7, 3.2))
    hidden = replace(row().result, stamps=(f"{IN_HIDDEN_SCENE} `b`, where the mark is lowest",))
    for result, told in ((row().result, True), (hidden, False)):
        found = decided(row_of(result, Student("Anna"), HandedIn()), huber=files)
        text = " ".join(said_by_graders(found))
        assert "line 7" in text
        assert "line 9" in text
        assert ("3.20 s" in text) is told
        assert ("4.50 s" in text) is told


def test_who_has_no_mark_reads_of_no_points_that_do_not_count() -> None:
    unmarked = replace(row().result, mark=None, kind=Kind.RESOURCE)
    for before, more in (
        (row_of(unmarked, Student("Anna"), HandedIn()), ()),
        (row(), (Excuse(1, AT, ("anna",), "ill"),)),
    ):
        found = decided(before, huber=(ITEM, GIVEN, Comment(1, AT, "anna", "why?"), *more))
        assert found.final is None
        assert said_by_graders(found) == ("why? (Huber)",)


def test_what_was_decided_about_another_program_does_not_count() -> None:
    digest = program_of(row().result)
    files = (
        ITEM,
        replace(GIVEN, programs={"anna": digest}),
        replace(change("anna", delta="1"), programs={"anna": digest}),
        Comment(1, AT, "anna", "why?", program=digest),
    )
    same = decided(row(), huber=files)
    task = replace(plain_result(), task=replace(plain_result().task, sha256="c" * 64), mark=8.0)
    mended = row_of(task, Student("Anna"), row().handed_in)  # by another task
    assert (same.final, decided(mended, huber=files).final) == (8.5, 8.5)
    other = row_of(
        replace(row().result, program=Program("a.v2", OTHER, 1)), Student("Anna"), HandedIn()
    )
    found = decided(other, huber=files)
    assert found.final == 8.0
    assert set(reasons(found)) == {Reason.LAPSED}
    assert found.decided is not None
    assert not found.decided.comments
    told = all_lapses([found], by_hand(huber=files))
    assert [one.rule.code for one in told] == ["V774"] * 3


def test_students_read_comments_with_their_places_and_never_private_ones() -> None:
    files = (
        Comment(1, AT, "anna", "Why so slow?\n<b>", 9, 3.2),
        Comment(1, AT, "anna", "SECRET", private=True),
    )
    found = decided(row(), huber=files)
    told = feedback_text(Returned(found, found.result)).decode()
    assert "From your graders:\n  line 9, at 3.20 s: Why so slow? <b> (Huber)" in told
    assert b"SECRET" not in class_to_bytes(Class("vrts.class/1", "Lab", (found,)))
