"""The board: which attempt counts, what holds people up, what a page that follows is told."""

import csv
import io

from vrts.course.board.board import Column, Presence, board, work_of
from vrts.course.board.changed import changed
from vrts.course.board.table import COLUMNS, marks_csv
from vrts.course.board.told import BoardTold, WaitTold
from vrts.live.store.course.attempts import Attempt, Loss
from vrts.live.store.course.people import Person

ADA = Person(1, "Ada", "ada@example.org", "ada@example.org", {"moodle": "77"}, "student", "Red")
BO = Person(2, "Bo", "bo@example.org", "bo@example.org", {}, "student")
LEE = Person(3, "Lee", "lee@example.org", "lee@example.org", {}, "teacher")
GONE = Person(4, "Gone", "gone@example.org", "", {}, "student", listed=False)
HITS = ("at 3.2 s, line 14, the hand hits `base1`", "at 7.9 s, line 20, the hand hits `base1`")
COLUMN = Column("pick", "Pick", due=50.0)


def attempt(
    account: int,
    number: int,
    *losses: tuple[str, str],
    mark: str | None = "",
    state: str = "marked",
) -> Attempt:
    left = f"{10 - sum(float(points) for _, points in losses):g}" if mark == "" else mark
    causes = tuple(Loss(*one) for one in losses)
    at = 100.0 * number + account
    return Attempt(account, "pick", number, at, account, "d", state, left, "10", "", causes)


WAITING = attempt(2, 1, mark=None, state="waiting")
STUCK = [attempt(1, number + 1, (HITS[number % 2], "2")) for number in range(3)]


def made(*attempts: Attempt, best: bool = False, hands: tuple[WaitTold, ...] = ()) -> BoardTold:
    columns = (COLUMN._replace(best=best),)
    presence = Presence({1: "Class"}, hands)
    return board("Robotics", columns, (ADA, BO, LEE, GONE), attempts, presence, 1000.0)


def test_students_have_rows_and_staff_has_none() -> None:
    told = made()
    assert [(row.name, row.room, row.team) for row in told.students] == [
        ("Ada", "Class", "Red"),
        ("Bo", "", ""),
    ]
    assert [row.id for row in made(attempt(4, 1)).students] == [1, 2, 4]  # the work stays


def test_the_last_attempt_counts_or_the_best() -> None:
    three = (
        attempt(1, 1),
        attempt(1, 2, ("it drops `can1`", "4")),
        attempt(1, 3, mark=None, state="waiting"),
    )
    last, best = (made(*three, best=best).students[0].cells[0] for best in (False, True))
    assert (last.tries, last.mark, last.last, last.state) == (3, 6.0, None, "waiting")
    assert best.mark == 10.0
    assert made(*three, best=True).columns[0].full == 1


def test_who_loses_by_the_same_again_and_again_is_stuck() -> None:
    told = made(*STUCK, attempt(2, 1, (HITS[0], "2"), ("`can1` rests 3 mm away", "1")))
    assert told.students[0].cells[0].same == 3
    first, second = told.causes
    assert (first.words, first.students, first.stuck, first.points) == (
        "the hand hits `base1`",
        (1, 2),
        1,
        4.0,
    )
    assert (second.words, second.students, second.stuck) == ("`can1` rests … mm away", (2,), 0)
    assert told.students[1].cells[0].cause == first.key


def test_a_cause_that_is_gone_counts_for_nobody() -> None:
    told = made(*STUCK, attempt(1, 4))
    assert told.causes == ()
    assert told.students[0].cells[0].same == 0


def test_hands_come_before_marks_that_are_awaited() -> None:
    hand = WaitTold(1, "Ada", "hand", 900.0, "r1", "where is the can?")
    assert [one.why for one in made(WAITING, hands=(hand,)).waits] == ["hand", "marking"]


def test_a_page_is_told_what_is_another_and_nothing_else() -> None:
    before, after = made(*STUCK, WAITING), made(*STUCK, attempt(2, 1))
    news = changed(before, after)
    assert news is not None
    assert [row.id for row in news.students] == [2]
    assert news.columns is not None
    assert news.columns[0].mean == 9.0
    assert (news.causes, news.gone) == (None, ())
    assert news.waits == ()
    assert changed(before, made(*STUCK, WAITING)) is None


def test_the_work_of_one_is_told_whole() -> None:
    work = work_of(ADA, STUCK)
    assert [(one.number, one.mark, one.losses) for one in work.attempts] == [
        (k + 1, 8.0, ((HITS[k % 2], 2.0),)) for k in range(3)
    ]


def test_the_table_guards_what_people_write() -> None:
    evil = ADA._replace(name="=cmd()", key="ada, the first")
    told = board("R", (COLUMN,), (evil, BO), STUCK, Presence({}), 1.0)
    data = marks_csv(told, (evil, BO))
    rows = list(csv.DictReader(io.StringIO(data.decode("utf-8-sig"))))
    assert tuple(rows[0]) == COLUMNS
    first = rows[0]
    assert not first["name"].startswith("=")
    assert (first["id"], first["public mark"], first["of"], first["attempts"]) == (
        "ada, the first",
        "8.0",
        "10.0",
        "3",
    )
    assert first["lost most by"] == "the hand hits `base1`"
    assert (rows[1]["attempts"], rows[1]["public mark"]) == ("0", "")
