"""Which of several attempts counts, after the table was edited and where one has no mark."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import datetime, timedelta, timezone
from pathlib import Path

import pytest
from msgspec import structs

from tests.support_rows import plain_result
from tests.unit.marking.intake.support import PDF, PICK, put
from vrts.check.task.late_rules import Keep, LateRules
from vrts.check.task.task import Task
from vrts.marking.by_hand.by_hand import load_by_hand, with_by_hand
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Extend
from vrts.marking.class_marks import class_row
from vrts.marking.class_plan import merged_class
from vrts.marking.intake.row import Row
from vrts.marking.intake.tables.intake_table import write_rows
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.layout import Layout
from vrts.marking.marking import Done, Entry
from vrts.marking.remote.at_home import AtHome
from vrts.marking.result import Kind, Result
from vrts.marking.row import Row as Marked
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.unsafe import Reason
from vrts.marking.whole_class import TakenIn, take_in_class
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.refused import Refused

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases" / "task.toml"
CET = timezone(timedelta(hours=1))
CLOSES = datetime(2026, 12, 1, 11, tzinfo=CET)
TWO = LateRules(CLOSES, closed=CLOSES, opens=CLOSES - timedelta(hours=2), attempts=2)
A, B, C = "2026-12-01-10-50-00", "2026-12-01-11-20-00", "2026-12-01-11-40-00"
MORE = "2026-12-01T11:30:00+01:00"
WORTH = {A: 3.0, B: 10.0, C: 5.0}


@pytest.fixture(scope="module")
def task() -> Task:
    """Return a task, to be given other rules."""
    found = Marker(Place(str(EXAMPLE)), Wanted(pages=False)).whole.task
    assert found is not None
    return found


def marked(
    change: Callable[[str, Result], Result] = lambda _, result: result,
) -> Callable[[Sequence[Entry]], Iterator[Done]]:
    """Return what marks attempts by the time of day that stands in them."""

    def mark(asked: Sequence[Entry]) -> Iterator[Done]:
        for entry in asked:
            (name,) = [name for name in WORTH if name.encode() in (entry.data or b"")]
            found = change(name, structs.replace(plain_result(entry.identifier), mark=WORTH[name]))
            yield Done(entry, found, found, False, 0.0, 0)

    return mark


def class_of(place: Path, task: Task, table: Path | None = None) -> TakenIn:
    """Return the class of a folder, by the table as it was edited."""
    with open_place(place) as tree:
        return take_in_class(task, tree, table, marked())


def with_due(taken: TakenIn, path: Path, due: str = MORE) -> Path:
    """Write the table of a class with more time for everybody."""
    rows = [replace(row, due=datetime.fromisoformat(due)) for row in taken.table]
    path.write_bytes(write_rows(rows))
    return path


def hand_ins(place: Path, *names: str) -> Path:
    return put(place, {f"ann/{name}/p.v2": PICK + name.encode() for name in names})


@pytest.mark.parametrize(
    ("names", "keep", "before", "after"),
    [
        ((A, B), Keep.BEST, A, B),
        ((A, B, C), Keep.BEST, A, B),
        ((B, C), Keep.BEST, C, B),  # nothing came while it was open
        ((A, B), Keep.LATEST, A, B),
    ],
)
def test_more_time_counts_in_a_class_that_was_marked_before(
    tmp_path: Path, task: Task, names: tuple[str, ...], keep: Keep, before: str, after: str
) -> None:
    exam = replace(task, late=TWO, keep=keep)
    place = hand_ins(tmp_path / "d", *names)
    first = class_of(place, exam)
    assert first.rows[0].file == f"ann/{before}/p.v2"
    table = tmp_path / "intake.csv"
    table.write_bytes(write_rows(first.table))
    again = class_of(place, exam, table)
    assert (again.rows, again.table) == (first.rows, first.table)
    later = class_of(place, exam, with_due(first, table))
    assert later.rows[0].file == f"ann/{after}/p.v2"
    assert later.rows[0].received is not None
    row = class_row(later.rows[0], structs.replace(plain_result("ann"), mark=WORTH[after]), TWO)
    assert row.final == WORTH[after]


def test_more_time_that_was_known_does_not_ask_to_mark_again(tmp_path: Path, task: Task) -> None:
    exam = replace(task, late=TWO, keep=Keep.BEST)
    layout = Layout(tmp_path / "out")
    said = Extend(0, "", ("ann",), MORE, "ill")
    add_decisions(layout.decisions, "R. Huber", (said,), CLOSES)
    by_hand = load_by_hand(layout, ("ann",), late=TWO)

    def later(_: str) -> datetime | None:
        return datetime.fromisoformat(MORE)

    def found(given: Callable[[str], datetime | None]) -> Marked:
        with open_place(hand_ins(tmp_path / "d", A, B)) as tree:
            (row,) = take_in_class(exam, tree, None, marked(), later=given).rows
        return with_by_hand(class_row(row, plain_result("ann"), TWO), by_hand)

    known, unknown = found(later), found(lambda _: None)
    assert (known.handed_in.file, known.unsafe) == (f"ann/{B}/p.v2", ())
    assert [doubt.reason for doubt in unknown.unsafe] == [Reason.LATE]


def test_a_file_that_the_teacher_chose_stays(tmp_path: Path, task: Task) -> None:
    exam = replace(task, late=replace(TWO, closed=CLOSES + timedelta(hours=1)), keep=Keep.BEST)
    place = hand_ins(tmp_path / "d", A, B)
    first = class_of(place, exam)
    table = tmp_path / "intake.csv"
    text = write_rows(first.table).decode().replace(f"ann/{A}/p.v2", f"ann/{B}/p.v2", 1)
    table.write_bytes(text.encode())
    (chosen,) = class_of(place, exam, table).rows
    assert (chosen.file, len(chosen.attempts)) == (f"ann/{B}/p.v2", 1)


def test_an_earlier_attempt_counts_by_the_table_of_the_intake(tmp_path: Path, task: Task) -> None:
    exam = replace(task, late=TWO, keep=Keep.BEST)
    place = hand_ins(tmp_path / "d", A)
    put(place, {f"ann/{B}/p.pdf": PDF})
    with open_place(place) as tree:
        fresh = take_in_class(replace(task, late=None, keep=Keep.LATEST), tree, None, marked())
    table = tmp_path / "intake.csv"
    table.write_bytes(write_rows(fresh.table))
    assert class_of(place, exam, table).rows[0].file == f"ann/{A}/p.v2"


def reasons(place: Path, task: Task, change: Callable[[str, Result], Result]) -> list[Reason]:
    """Return why the mark of the best attempt is unsafe."""
    with open_place(place) as tree:
        (row,) = take_in_class(task, tree, None, marked(change)).rows
    result = change(_name(row), structs.replace(plain_result("ann"), mark=WORTH[_name(row)]))
    return [doubt.reason for doubt in class_row(row, result, task.late).unsafe]


def _name(row: Row) -> str:
    return (row.file or "").split("/")[1]


def test_an_attempt_without_a_mark_may_be_the_best(tmp_path: Path, task: Task) -> None:
    best = replace(task, late=None, keep=Keep.BEST)
    place = hand_ins(tmp_path / "d", A, B)

    def without(name: str, kind: Kind) -> Callable[[str, Result], Result]:
        return lambda one, found: (
            structs.replace(found, kind=kind, mark=None, cause="ended") if one == name else found
        )

    assert reasons(place, best, without(B, Kind.RESOURCE)) == [Reason.RESOURCE]
    assert reasons(place, best, without(B, Kind.FAULT)) == [Reason.CRASHED]
    assert reasons(place, best, without(A, Kind.FAULT)) == []  # the other has the full mark
    shut = replace(best, late=replace(TWO, attempts=1))
    assert reasons(place, shut, without(B, Kind.FAULT)) == []  # it came too late anyway


def test_a_better_attempt_in_doubt_tells_of_the_other(tmp_path: Path, task: Task) -> None:
    best = replace(task, late=None, keep=Keep.BEST)
    place = hand_ins(tmp_path / "d", A, B)

    def between(lowest: float) -> Callable[[str, Result], Result]:
        return lambda one, found: structs.replace(found, lowest=lowest) if one == B else found

    assert reasons(place, best, between(2.0)) == [Reason.UNDETERMINED] * 2
    assert reasons(place, best, between(4.0)) == [Reason.UNDETERMINED]


def test_a_plan_that_did_not_know_of_more_time_is_not_merged(tmp_path: Path, task: Task) -> None:
    exam = replace(task, late=TWO, keep=Keep.BEST)
    place = hand_ins(tmp_path / "d", A, B)
    taken = class_of(place, exam)
    home = AtHome(
        Place("lab"), ("d",), Wanted(), taken.rows, (), (), b"", False, attempts=taken.as_found
    )
    marker = Marker(Place(str(EXAMPLE)), Wanted(pages=False))
    marker.whole = replace(marker.whole, task=exam)
    layout = Layout(tmp_path / "out")
    early = Extend(0, "", ("ann",), "2026-12-01T11:10:00+01:00", "ill")
    add_decisions(layout.decisions, "R. Huber", (early,), CLOSES)
    with pytest.raises(ValueError, match="zip"):  # no other attempt counts by that: it goes on
        merged_class(marker, home, layout)
    layout = Layout(tmp_path / "other")
    add_decisions(layout.decisions, "R. Huber", (structs.replace(early, due=MORE),), CLOSES)
    with pytest.raises(Refused) as refused:
        merged_class(marker, home, layout)
    (told,) = refused.value.diagnostics
    assert (told.rule.code, "`ann`" in told.notes[0]) == ("V829", True)
    in_table = replace(taken.as_found[0], due=datetime.fromisoformat(MORE))
    planned = structs.replace(home, attempts=(in_table,))
    with pytest.raises(ValueError, match="zip"):  # the plan knew of it
        merged_class(marker, planned, layout)
