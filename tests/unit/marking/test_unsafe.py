"""Which marks nobody should take for final, and that each way out of it is one."""

import csv
import io
import json

import pytest
from msgspec.structs import replace

from tests.support_rows import plain_result, plain_row
from vrts.cli.grade.options import DESPITE
from vrts.marking.exports.feedback import LOOKED_AT, feedback_text, unsure
from vrts.marking.exports.given import Returned
from vrts.marking.exports.marks_table import marks_csv
from vrts.marking.exports.unsafe_marks import after_marking, closing, refusal
from vrts.marking.lateness import FLAGGED, UNTIMED
from vrts.marking.overview.page import overview_page
from vrts.marking.result import Kind, OfVariant
from vrts.marking.row import (
    Change,
    Class,
    Decided,
    HandedIn,
    Lateness,
    Row,
    Student,
    class_from_bytes,
    class_to_bytes,
    row_of,
)
from vrts.marking.row_words import row_words
from vrts.marking.unsafe import ALL, OF_GRADERS, REASONS, REMEDIES, Reason

LATE = Lateness(0, "0", UNTIMED, review=True, untimed=True)
VERSION = "this is vrts 0.1.0: this mark does not count"
HIDDEN_SCENE = "marked in the hidden scene `b`, where the mark is lowest"
MADE_SO: dict[Reason, dict[str, object]] = {
    Reason.CRASHED: {"kind": Kind.FAULT, "mark": None, "review": ("vrts itself failed",)},
    Reason.RESOURCE: {"kind": Kind.RESOURCE, "mark": None, "cause": "memory was used up"},
    Reason.AMBIGUOUS: {"kind": Kind.AMBIGUOUS, "mark": None, "cause": "two programs"},
    Reason.VARIANT: {"variant": OfVariant("bcdf-ghjk", "its places are those of another")},
    Reason.UNREAD: {"kind": Kind.UNREAD, "mark": None, "cause": "permission denied"},
    Reason.ALTERED: {"stamps": ("modified scene: this mark does not count",)},
    Reason.VERSION: {"stamps": (VERSION,)},
    Reason.HIDDEN: {"more": 2},
    Reason.UNCHECKED: {"obstacles": ("collisions were not checked",)},
    Reason.UNDETERMINED: {"lowest": 8.5},
}


def late_row(change: Change | None = None, late: Lateness = LATE, mark: float = 10.0) -> Row:
    result = replace(plain_result("anna"), mark=mark)
    return row_of(result, Student("Anna"), HandedIn("a.v2"), late, change)


def reasons(row: Row) -> list[Reason]:
    return [doubt.reason for doubt in row.unsafe]


def of(*rows: Row) -> Class:
    return Class("vrts.class/1", "Lab", rows)


@pytest.mark.parametrize(("reason", "fields"), MADE_SO.items())
def test_each_reason_is_found_in_a_result(reason: Reason, fields: dict[str, object]) -> None:
    assert reasons(plain_row("anna", "", **fields)) == [reason]


def test_lateness_that_nobody_knows_is_one_and_known_lateness_is_none() -> None:
    assert reasons(late_row()) == [Reason.LATE]
    assert reasons(late_row(late=Lateness(0, "0", FLAGGED, review=True))) == [Reason.LATE]
    assert reasons(late_row(late=Lateness(3600, "1", "1 h late: 1 point less"))) == []
    assert reasons(late_row(mark=0.0)) == []  # it has nothing to lose


def test_what_is_no_doubt_about_a_mark() -> None:
    assert reasons(plain_row()) == []
    assert reasons(plain_row(stamps=(HIDDEN_SCENE,))) == []
    for kind in (Kind.MISSING, Kind.EXCUSED):
        assert reasons(plain_row(kind=kind, mark=None, more=2)) == []
    assert reasons(plain_row(mark=0.0, obstacles=("collisions were not checked",))) == []


def test_what_was_decided_by_hand_is_no_longer_in_doubt() -> None:
    for settles, left in (
        ((), [Reason.LATE]),
        (("late",), []),
        ((ALL,), []),
        (("hidden",), [Reason.LATE]),
    ):
        assert reasons(late_row(Change("0", "seen", "R", "2026-11-01", settles))) == left


def test_every_reason_has_a_remedy_and_can_be_named() -> None:
    assert set(REMEDIES) == set(Reason)
    assert (*REASONS, ALL) == DESPITE


def test_unsafe_marks_are_counted_and_come_first() -> None:
    whole = of(plain_row("ben"), plain_row("cem", lowest=8.5), late_row())
    written = json.loads(class_to_bytes(whole))
    assert written["unsafe"] == {"undetermined": 1, "late": 1}
    assert [row["id"] for row in written["rows"]] == ["cem", "anna", "ben"]
    assert [line[:4] for line in marks_csv(whole).decode().splitlines()[1:]] == [
        "cem,",
        "anna",
        "ben,",
    ]
    assert "undetermined: the mark is between 8.5 and 10" in marks_csv(whole).decode()
    assert f"unsafe: late: {UNTIMED}" in row_words(late_row(), "anna.v2")
    (told,) = after_marking(whole)
    assert told.headline == "2 of 3 marks are unsafe: `cem` (undetermined), `anna` (late)"


def test_no_list_says_that_unknown_lateness_costs_nothing() -> None:
    flagged = of(late_row(late=Lateness(0, "0", FLAGGED, review=True)))
    (line,) = csv.DictReader(io.StringIO(marks_csv(flagged).decode("utf-8-sig")))
    assert (line["deduction"], line["late"]) == ("", FLAGGED)
    page = overview_page(flagged)
    assert "costs nothing" not in page
    assert f"<span>not known</span><small>{FLAGGED}</small>" in page
    assert "1 unsafe mark: 1 late" in page
    assert "Late and changed marks" not in overview_page(of(late_row()))


def test_an_export_is_refused_in_one_sentence_and_says_what_to_do() -> None:
    whole = of(plain_row("ben"), late_row())
    (told,) = refusal(whole, ())
    assert told.is_error
    assert told.headline == "1 of 2 marks is unsafe, so nothing is written: `anna` (late)"
    assert "--roster" in told.help[0]
    assert "--settles late" in told.help[1]
    assert "--despite late" in told.help[2]
    for despite in ({"late"}, {ALL}):
        assert refusal(whole, despite) == ()
    assert refusal(whole, {"hidden"}) != ()
    (after,) = closing(whole)
    assert after.headline == (
        "1 of 2 marks is unsafe, and the export was made despite that: `anna` (late)"
    )
    assert refusal(of(plain_row()), ()) == closing(of(plain_row())) == ()


def test_students_learn_of_what_is_theirs_to_know() -> None:
    row = late_row()
    told = feedback_text(Returned(row, row.result)).decode()
    assert f"This mark is not sure yet: {UNTIMED}." in told
    hidden = plain_row("ben", lowest=8.5)
    told = feedback_text(Returned(hidden, plain_result("ben"))).decode()
    assert "not sure" not in told
    assert told.count("A person will look at this mark: it may still change.") == 1
    assert "8.5" not in told
    for reason in set(Reason) - {Reason.LATE, Reason.UNCHECKED, Reason.HIDDEN} - OF_GRADERS:
        row = plain_row("ben", "", **MADE_SO[reason])
        assert unsure(row) == [LOOKED_AT], reason
    assert unsure(plain_row()) == []
    result = plain_result("anna")
    for decided in (Decided(conflicts=("secret",)), Decided(lapsed=("secret",))):
        row = row_of(result, Student(), HandedIn(), decided=decided)
        assert unsure(row) == [LOOKED_AT]
        mark = Change("0", "so", "RH", "2026-11-30", (ALL,))
        assert reasons(row_of(result, Student(), HandedIn(), change=mark, decided=decided))


def test_what_an_earlier_vrts_wrote_is_read_and_judged_now() -> None:
    flagged = late_row(late=Lateness(0, "0", FLAGGED, review=True))
    written = json.loads(class_to_bytes(of(flagged, plain_row("ben"))))
    del written["unsafe"]
    for row in written["rows"]:
        del row["unsafe"]
        if row["late"]:
            del row["late"]["untimed"]
    read = class_from_bytes(json.dumps(written).encode())
    assert read.unsafe is None
    assert [reasons(row) for row in read.rows] == [[Reason.LATE], []]


def test_a_file_cannot_call_an_unsafe_mark_safe() -> None:
    written = json.loads(class_to_bytes(of(late_row())))
    written["rows"][0]["unsafe"], written["unsafe"] = [], {}
    read = class_from_bytes(json.dumps(written).encode())
    assert read.unsafe == {"late": 1}
    assert refusal(read, ()) != ()
