"""Which hand-ins of an exam count, and that nothing is dropped without a word."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from datetime import datetime, timedelta, timezone
from fractions import Fraction
from pathlib import Path

import pytest
from msgspec import structs

from tests.support_rows import plain_result
from tests.unit.marking.intake.support import PDF, PICK, put
from vrts.check.task.late_rules import LateRules
from vrts.marking.class_marks import class_row, with_best_attempts
from vrts.marking.intake.exam import SAME_SECOND, Counted, counted
from vrts.marking.intake.row import Attempt, Kind, Problem, Row, Student
from vrts.marking.intake.take_in import take_in
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.marking import Done, Entry
from vrts.marking.privacy.pseudonyms import pseudonymised
from vrts.marking.row import Class, class_from_bytes, class_to_bytes
from vrts.marking.unsafe import Reason

CET = timezone(timedelta(hours=1))
OPENS = datetime(2026, 12, 1, 9, tzinfo=CET)
CLOSES = datetime(2026, 12, 1, 11, tzinfo=CET)
SECOND, MINUTE = timedelta(seconds=1), timedelta(minutes=1)
ONE = LateRules(CLOSES, closed=CLOSES, opens=OPENS, attempts=1)
TWO = replace(ONE, attempts=2)
BEFORE, FIRST, SECOND_ONE, AFTER = OPENS - SECOND, OPENS, CLOSES, CLOSES + SECOND


def row(*times: datetime | None, problem: Problem | None = None) -> Row:
    """Return the row of a student who handed in at some times: a.v2, b.v2, ..."""
    attempts = tuple(Attempt(f"{'abcdef'[k]}.v2", time) for k, time in enumerate(times))
    last = attempts[-1]
    return Row(
        "ann",
        Student("Ann"),
        None if problem else last.file,
        "as found",
        last.received,
        attempts=attempts,
        problem=problem,
    )


def one(found: Row, rules: LateRules) -> tuple[str | None, list[str]]:
    """Return the file that counts, and what is told of it."""
    result = counted([found], rules)
    return result.rows[0].file, [note for d in result.warnings for note in d.notes]


@pytest.mark.parametrize(
    ("rules", "times", "file", "told"),
    [
        (ONE, (FIRST,), "a.v2", ""),
        (ONE, (FIRST, SECOND_ONE), "a.v2", "1 of 2 hand-ins counts: 1 came after the first"),
        (TWO, (FIRST, SECOND_ONE), "b.v2", ""),
        (ONE, (BEFORE, SECOND_ONE), "b.v2", "1 came before the exam opened"),
        (ONE, (FIRST, AFTER), "a.v2", "1 came after it closed"),
        (
            TWO,
            (BEFORE, FIRST, FIRST + MINUTE, FIRST + 2 * MINUTE, AFTER),
            "c.v2",
            "2 of 5 hand-ins count: 1 came before the exam opened, 1 came after it closed, 1 came",
        ),
        (ONE, (BEFORE, AFTER), "b.v2", "none of 2 hand-ins count"),
    ],
)
def test_the_first_while_it_is_open_count(
    rules: LateRules, times: Sequence[datetime], file: str, told: str
) -> None:
    found, notes = one(row(*times), rules)
    assert found == file
    assert [told in note for note in notes] == ([True] if told else [])


def test_two_in_the_same_second_are_two() -> None:
    found, told = one(row(FIRST, FIRST), ONE)
    assert found == "a.v2"
    assert told == [f"`ann`: 1 of 2 hand-ins counts: 1 came after the first; {SAME_SECOND}"]
    assert len(counted([row(FIRST, FIRST)], TWO).rows[0].attempts) == 2


def test_copies_that_came_in_one_hand_in_are_one() -> None:
    copies = (Attempt("a.v2", FIRST), Attempt("a (1).v2", FIRST))
    found = replace(row(FIRST), attempts=copies, file="a (1).v2")
    assert one(found, ONE) == ("a (1).v2", [])
    names = ("ann_31_901_a.v2", "ann_31_902_a-1.v2")  # as Canvas calls them
    found = replace(found, attempts=tuple(Attempt(name, FIRST) for name in names), file=names[1])
    assert one(found, ONE) == (names[1], [])


def test_without_an_exam_all_counts() -> None:
    late = LateRules(CLOSES, per_day=Fraction(1))
    rows = (row(BEFORE, AFTER),)
    assert counted(rows, late) == counted(rows, None) == Counted(rows, ())


def test_more_time_for_one_student() -> None:
    found, _ = one(replace(row(FIRST, AFTER), due=AFTER), TWO)
    assert found == "b.v2"


def doubts(found: Row, rules: LateRules = ONE) -> tuple[list[Reason], str]:
    """Return why a full mark is unsafe, and what is said of its time."""
    done = class_row(counted([found], rules).rows[0], plain_result("ann"), rules)
    return [doubt.reason for doubt in done.unsafe], "" if done.late is None else done.late.sentence


def test_what_is_not_known_is_unsafe() -> None:
    reasons, sentence = doubts(row(None))
    assert reasons == [Reason.LATE]
    assert sentence.startswith("nothing tells when it came")
    assert doubts(row(FIRST)) == ([], "")
    assert doubts(replace(row(None), late=False)) == ([], "")  # says the teacher
    assert doubts(replace(row(None), flagged=False))[0] == [Reason.LATE]  # says Canvas of the end


def test_an_unknown_time_makes_the_order_unknown() -> None:
    found = row(None, FIRST)
    assert doubts(found)[0] == [Reason.LATE]
    assert "which came first is not known" in one(found, ONE)[1][0]


def test_what_comes_outside_gets_0_and_says_why() -> None:
    for time, words in ((BEFORE, "1 s before the exam opened"), (AFTER, "after the exam closed")):
        done = class_row(counted([row(time)], ONE).rows[0], plain_result("ann"), ONE)
        assert (done.final, done.unsafe) == (0.0, ())
        assert done.late is not None
        assert words in done.late.sentence


NO_PROGRAM = Problem(Kind.NOT_TEXT, "`b.pdf` is a PDF")


def test_what_is_no_program_uses_up_no_attempt() -> None:
    unread = replace(row(FIRST, problem=NO_PROGRAM), received=SECOND_ONE)
    found = counted([unread], TWO)
    assert (found.rows[0].file, found.rows[0].problem) == ("a.v2", None)
    assert "no program" in found.warnings[0].notes[0]


@pytest.mark.parametrize(("rules", "settled"), [(ONE, True), (TWO, False)])
def test_several_programs_are_looked_at_where_they_may_count(
    rules: LateRules, settled: bool
) -> None:
    unclear = Problem(Kind.AMBIGUOUS, "two programs")
    found = replace(row(FIRST, problem=unclear), received=SECOND_ONE)
    assert (counted([found], rules).rows[0].problem is None) == settled


def test_whoever_is_excused_stays_excused() -> None:
    excused = row(FIRST, AFTER, problem=Problem(Kind.EXCUSED, "ill"))
    assert counted([excused], ONE) == Counted((excused,), ())


def test_a_class_is_told_of_in_one_warning() -> None:
    rows = [replace(row(FIRST, AFTER), identifier=f"s{number}") for number in range(30)]
    (told,) = counted(rows, ONE).warnings
    assert "30 students" in told.headline
    assert len(told.notes) == 21
    assert "10 more" in told.notes[-1]


def test_the_best_of_the_first_counts(tmp_path: Path) -> None:
    names = ("2026-12-01-09-30-00", "2026-12-01-10-00-00", "2026-12-01-10-30-00")
    files = {f"ann/{name}/p.v2": PICK + name.encode() for name in names}
    files["ann/2026-12-01-10-40-00/p.pdf"] = PDF
    place = put(tmp_path / "d", files)
    rows = take_in(place, program="pick", zone=CET).rows

    worth = {names[0]: 9.0, names[1]: 4.0, names[2]: 10.0}

    def marked(asked: Sequence[Entry]) -> Iterator[Done]:
        for entry in asked:
            (name,) = [name for name in names if name.encode() in (entry.data or b"")]
            found = structs.replace(plain_result(entry.identifier), mark=worth[name])
            yield Done(entry, found, found, False, 0.0, 0)

    with open_place(place) as tree:
        (best,) = with_best_attempts(tree, counted(rows, TWO).rows, TWO, marked)
        (all_of_them,) = with_best_attempts(tree, rows, LateRules(CLOSES), marked)
    assert (best.file, best.problem) == (f"ann/{names[0]}/p.v2", None)
    assert "2 of 3 hand-ins count" in best.why
    listed = class_row(best, structs.replace(plain_result("ann"), mark=9.0), TWO)
    told = [(one.file, one.received, one.mark) for one in listed.handed_in.attempts]
    assert told == [
        (f"ann/{names[0]}/p.v2", "2026-12-01T09:30:00+01:00", 9.0),
        (f"ann/{names[1]}/p.v2", "2026-12-01T10:00:00+01:00", 4.0),
    ], "those that may count were all marked, and their marks are kept"
    again = class_from_bytes(class_to_bytes(Class("vrts.class/1", "A class", (listed,))))
    assert again.rows[0].handed_in == listed.handed_in
    assert class_row(rows[0], plain_result("ann"), TWO).handed_in.attempts == ()
    _, (nameless,) = pseudonymised(tree, (best,), b"key")
    assert [one.mark for one in nameless.tried] == [9.0, 4.0]
    assert "ann" not in repr(nameless)
    assert (all_of_them.file, all_of_them.problem) == (f"ann/{names[2]}/p.v2", None)
