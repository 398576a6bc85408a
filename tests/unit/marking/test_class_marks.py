"""From what was handed in to rows: where a file came from tells what is known of its lateness."""

from dataclasses import replace
from datetime import UTC, datetime
from fractions import Fraction
from pathlib import Path

import pytest

from tests.support_rows import plain_result
from tests.unit.marking.intake.support import PICK, put
from vrts.check.task.late_rules import LateRules
from vrts.marking.class_marks import class_row, entries, nothing_late
from vrts.marking.intake.row import Row
from vrts.marking.intake.take_in import take_in, take_in_tree
from vrts.marking.intake.tree.opening import open_place
from vrts.marking.intake.tree.store import Unreadable
from vrts.marking.marking import without_program
from vrts.marking.privacy.pseudonyms import pseudonymised
from vrts.marking.result import Kind
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.marking.unsafe import Reason
from vrts.pipeline.files import CHECKOUT

DUE = datetime(2026, 11, 30, 23, tzinfo=UTC)
RULES = LateRules(DUE, per_day=Fraction(1))
ANNA, BEN = "bergeranna_31_901_pick.v2", "wolfben_32_902_pick.v2"
LATE_CARA = "cobbcara_LATE_33_903_pick.v2"
TASK = str(CHECKOUT / "examples" / "01-cans-on-bases" / "task.toml")


def taken(place: Path, *names: str) -> tuple[Row, ...]:
    return take_in(put(place, dict.fromkeys(names, PICK)), program="pick").rows


def reasons(row: Row) -> list[Reason]:
    """Return why the full mark of a hand-in is unsafe."""
    return [doubt.reason for doubt in class_row(row, plain_result(row.identifier), RULES).unsafe]


def test_a_canvas_class_has_the_same_doubts_with_pseudonyms(tmp_path: Path) -> None:
    put(tmp_path / "d", dict.fromkeys((ANNA, BEN, LATE_CARA), PICK))
    with open_place(tmp_path / "d") as tree:
        rows = take_in_tree(tree, program="pick").rows
        _, nameless = pseudonymised(tree, rows, b"k" * 32)
    expected = {"bergeranna": [], "wolfben": [], "cobbcara": [Reason.LATE]}
    assert {row.student.name: reasons(row) for row in rows} == expected
    assert [reasons(row) for row in nameless] == [reasons(row) for row in rows]


def test_an_id_of_canvas_does_not_make_a_file_on_time(tmp_path: Path) -> None:
    anna, _ = taken(tmp_path, ANNA, BEN)
    mailed = replace(anna, file="mailed.v2", flagged=None)
    assert anna.student.ids == {"canvas": "31"}
    assert (reasons(anna), reasons(mailed)) == ([], [Reason.LATE])
    assert reasons(replace(mailed, late=False)) == []
    assert reasons(replace(anna, late=True)) == [Reason.LATE]
    assert reasons(replace(mailed, received=DUE)) == []


def test_that_canvas_calls_nothing_late_is_a_warning_for_who_has_no_time(tmp_path: Path) -> None:
    anna, ben = taken(tmp_path / "a", ANNA, BEN)
    (told,) = nothing_late(RULES, (anna, ben))
    assert told.rule.code == "V756"
    assert told.headline == (
        "Canvas calls nothing LATE, and 2 hand-ins have no time: taken as on time"
    )
    timed = replace(anna, received=DUE)
    (told,) = nothing_late(RULES, (timed, ben))
    assert "1 hand-in has no time" in told.headline
    assert nothing_late(RULES, (timed, replace(ben, late=False))) == ()
    assert nothing_late(None, (anna, ben)) == ()
    assert nothing_late(RULES, taken(tmp_path / "b", ANNA, LATE_CARA)) == ()
    elsewhere = replace(anna, flagged=None), replace(ben, flagged=None)
    assert nothing_late(RULES, elsewhere) == ()


def test_a_file_that_this_machine_cannot_read_is_no_zero(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = ("anna.v2", "ben.v2", "cara.v2", "dora.v2")
    put(tmp_path / "d", {**dict.fromkeys(names, PICK), "ben.v2": b"", "cara.v2": b"\0\1\2\xff"})
    marker = Marker(Place(TASK), Wanted(pages=False))
    with open_place(tmp_path / "d") as tree:
        start = tree.store.start

        def failing(name: str, length: int) -> bytes:
            if name == "anna.v2":
                raise Unreadable("cannot be read: permission denied")
            return start(name, length)

        monkeypatch.setattr(tree.store, "start", failing)
        rows = take_in_tree(tree, program="pick").rows
        (tmp_path / "d" / "dora.v2").unlink()  # between looking and reading
        asked = tuple(entries(tree, rows))
    kinds = {entry.identifier: entry.kind for entry in asked}
    assert kinds == {
        "anna": Kind.UNREAD,
        "ben": Kind.UNREADABLE,
        "cara": Kind.UNREADABLE,
        "dora": Kind.UNREAD,
    }
    for row, entry in zip(rows, asked, strict=True):
        whole = class_row(row, without_program(marker, entry, None).result, None)
        if entry.kind is Kind.UNREAD:
            assert (whole.final, [doubt.reason for doubt in whole.unsafe]) == (
                None,
                [Reason.UNREAD],
            )
        else:
            assert (whole.final, whole.unsafe) == (0.0, ())
