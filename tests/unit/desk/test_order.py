"""What to look at next: unsafe marks first, what is finished last."""

from msgspec.structs import replace

from tests.support_desk import HITS
from tests.support_rows import plain_row
from tests.unit.desk.test_figures import book_of
from vrts.desk.book.decided import Decided, Mine
from vrts.desk.rows.causes import causes_of
from vrts.desk.rows.order import places
from vrts.desk.told import Likeness, Looked
from vrts.marking.unsafe import Doubt, Reason


def test_each_place_has_its_reason() -> None:
    rows = [
        plain_row("done", losses=(HITS,)),
        plain_row("fine"),
        plain_row("alike"),
        plain_row("alone", losses=(replace(HITS, sentence="the palm hits `can1`"),)),
        plain_row("shared", losses=(HITS,)),
        plain_row("mine"),
        plain_row("theirs"),
        replace(plain_row("late"), unsafe=(Doubt(Reason.LATE, ""),)),
        replace(plain_row("crashed"), unsafe=(Doubt(Reason.CRASHED, ""),)),
        replace(plain_row("differing"), unsafe=(Doubt(Reason.LATE, ""),)),
        plain_row("again"),
    ]
    decided = Decided(
        {
            "done": Mine(assigned=("me",), finished=(Looked("me", 8.5, stale=False),)),
            "again": Mine(assigned=("me",), finished=(Looked("me", 8.5, stale=True),)),
            "mine": Mine(assigned=("me", "other")),
            "theirs": Mine(assigned=("other",)),
            "differing": Mine(conflict=True),
        }
    )
    book = book_of(rows, decided)
    book.likeness = {"alike": Likeness("1", "strong", ("fine",), 0.9)}
    found = places(book, causes_of(rows), "me")
    told = [(name, found[name].why) for name in sorted(found, key=lambda name: found[name].order)]
    assert told == [
        ("differing", "graders differ"),
        ("crashed", "unsafe: crashed"),
        ("late", "unsafe: late"),
        ("again", "assigned to you"),
        ("mine", "assigned to you"),
        ("alike", "strongly like 1 other"),
        ("shared", "the held can1 hits base1, as 1 other"),
        ("alone", "the palm hits can1"),
        ("fine", "no points lost"),
        ("theirs", "another grader's"),
        ("done", "finished"),
    ]
