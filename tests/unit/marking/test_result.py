"""Results and rows: the published schema, what is refused, how final marks are made."""

import json
from fractions import Fraction
from typing import Any

import jsonschema
import msgspec
import pytest

from vrts.base.diagnostic import Severity
from vrts.marking.result import (
    Check,
    Damaged,
    Finding,
    Kind,
    Loss,
    Metrics,
    Named,
    Parts,
    Program,
    Result,
    Versions,
    from_bytes,
    key_of,
    to_bytes,
)
from vrts.marking.row import (
    Change,
    Class,
    HandedIn,
    Lateness,
    Row,
    Student,
    class_from_bytes,
    class_to_bytes,
    final_mark,
    row_of,
)
from vrts.marking.schemas import schema

DIGEST = 64 * "a"


def result(mark: float | None = 8.5, kind: Kind = Kind.GRADED) -> Result:
    """Return a result with something in every part."""
    return Result(
        schema="vrts.result/1",
        id="anna",
        kind=kind,
        mark=mark,
        lowest=None,
        review=(),
        ready=False,
        obstacles=("the held can1 hits base1",),
        cause="At 12.4 s the held can1 hits base1",
        hint="how high is base1?",
        line=17,
        time_s=12.4,
        parts=Parts(6.0, 2.5, 1.5, 0.0, 0.0),
        losses=(Loss(1.5, "3/2", "contact", "the held can1 hits base1", None, 17, 12.4),),
        checks=(Check("goal-1", "can1 on base1", "goal", "holds", 3.0, 3.0, False, ""),),
        metrics=Metrics(duration_s=12.5, contacts=1),
        findings=(
            Finding("V301", "contact", Severity.ERROR, "can1 hits base1", 17, 3, 12.4, ("x",)),
        ),
        stamps=(),
        more=0,
        task=Named("cans", "Cans on bases", DIGEST),
        scene=Named("cans", "Cans on bases", DIGEST),
        program=Program("anna.v2", DIGEST, 120),
        versions=Versions("0.1", 1, "coal"),
        key=DIGEST,
    )


def test_a_result_survives_being_written() -> None:
    assert from_bytes(to_bytes(result())) == result()
    assert to_bytes(from_bytes(to_bytes(result()))) == to_bytes(result())


def test_what_is_written_fits_the_published_schema() -> None:
    jsonschema.validate(json.loads(to_bytes(result())), schema("result"))
    row = row_of(result(), Student("Anna", ids={"moodle": "12"}), HandedIn("anna.v2"))
    rows = json.loads(class_to_bytes(Class("vrts.class/1", "Lab 1", (row,))))
    jsonschema.validate(rows, schema("class"))
    jsonschema.Draft202012Validator.check_schema(schema("class"))
    for name, value in (("mark", 1001), ("kind", "perfect"), ("key", "short"), ("other", 1)):
        broken = {**json.loads(to_bytes(result())), name: value}
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(broken, schema("result"))


@pytest.mark.parametrize(
    "change",
    [
        {"schema": "vrts.result/2"},
        {"mark": 10.5},
        {"mark": "8"},
        {"kind": "perfect"},
        {"losses": [{"points": 1}]},
        {"extra": 1},
        {"key": "a" * 63},
    ],
)
def test_what_is_no_result_is_refused(change: dict[str, Any]) -> None:
    with pytest.raises(Damaged):
        from_bytes(json.dumps({**json.loads(to_bytes(result())), **change}).encode())


@pytest.mark.parametrize("data", [b"", b"{", b"[]", b"\xff\xfe", b"[" * 100_000, b"null"])
def test_bytes_that_are_no_json_are_refused(data: bytes) -> None:
    with pytest.raises(Damaged):
        from_bytes(data)
    with pytest.raises(Damaged):
        class_from_bytes(data)


def test_the_key_depends_on_everything_named_and_on_where_it_ends() -> None:
    keys = {
        key_of(b"program", "task", "scene"),
        key_of(b"program2", "task", "scene"),
        key_of(b"program", "task2", "scene"),
        key_of(b"program", "tasks", "cene"),
        key_of(b"program", "task"),
    }
    assert len(keys) == 5
    assert key_of(b"program", "task") == key_of(b"program", "task")


def late(points: str) -> Lateness:
    return Lateness(3600, points, "an hour late")


def by_hand(points: str) -> Change:
    return Change(points, "checked in the lab", "jb", "2026-11-01")


@pytest.mark.parametrize(
    ("mark", "deduction", "delta", "final"),
    [
        ("17/2", None, None, "17/2"),
        ("17/2", "1/2", None, "8"),
        ("1/2", "2", None, "0"),
        ("1/2", "2", "1", "1"),
        ("9", None, "2", "10"),
        ("9", None, "-20", "0"),
        ("9", "1/3", None, "87/10"),
        ("9", "1/20", None, "9"),
        (None, None, None, None),
        (None, None, "4", "4"),
        (None, "1", None, None),
    ],
)
def test_final_marks(
    mark: str | None, deduction: str | None, delta: str | None, final: str | None
) -> None:
    found = final_mark(
        None if mark is None else Fraction(mark),
        None if deduction is None else late(deduction),
        None if delta is None else by_hand(delta),
    )
    assert found == (None if final is None else Fraction(final))


def test_a_row_keeps_the_computed_mark_beside_the_final_one() -> None:
    row = row_of(result(), Student(), HandedIn(), late("1"), by_hand("1/2"))
    assert (row.result.mark, row.final) == (8.5, 8.0)
    assert row.exact_final == 8
    (back,) = class_from_bytes(class_to_bytes(Class("vrts.class/1", "Lab", (row,)))).rows
    assert back == row
    assert isinstance(back, Row)
    assert msgspec.structs.replace(back, final=None).exact_final is None
