"""The JSON form: schema keys, exact points, numbers rounded by the shared rule."""

import json
from fractions import Fraction
from typing import Any

from tests.support_reports import HOSTILE, SYNTAX, broken, compiled, contact_loss, grade, span
from vrts.base.diagnostic import Label, Moment, error
from vrts.base.units import DEG
from vrts.check.mark.grade import Loss
from vrts.report.formats.json_form import assessment_json, diagnostic_json, result_json


def as_read(value: object) -> Any:
    return json.loads(json.dumps(value, allow_nan=False))


def test_a_row_tells_status_mark_and_losses() -> None:
    first, second = (as_read(result_json(a)) for a in (compiled(grade(contact_loss())), broken()))
    assert (first["id"], first["status"], first["mark"]) == ("submission-07", "graded", 8.5)
    assert (second["id"], second["status"], second["mark"]) == ("broken", "does not compile", 0.0)
    assert first["losses"][0]["points_exact"] == "3/2"
    assert first["line"] == 2
    assert first["time_s"] == 12.4


def test_points_are_kept_exactly_beside_the_number() -> None:
    third = Loss(Fraction(1, 3), "target", "a third", "", None, None)
    row = as_read(assessment_json(compiled(grade(third))))
    assert row["losses"][0]["points"] == 0.333333
    assert row["losses"][0]["points_exact"] == "1/3"


def test_an_assessment_says_which_schema_and_what_is_missing() -> None:
    document = as_read(assessment_json(compiled()))
    assert document["schema"] == "vrts.assessment/1"
    assert document["mark"] is None
    assert document["run"] is None
    assert document["verdicts"] == []


def test_exact_values_are_rounded_by_their_unit() -> None:
    d = error(
        SYNTAX,
        "bad",
        Label(span("MOVES base2_put"), "here"),
        data={
            "time_s": 1.23456,
            "depth_m": 0.0231234567,
            "depth_mm": 23.1234567,
            "limit_deg_s": 240.123456,
            "share": 0.123456789,
            "count": 3,
            "axis": (1.00000049, 0.0),
            "far": float("inf"),
        },
        moment=Moment(12.44449, (0.1 * DEG,) * 6 + (0.0801234,), ("can1",)),
    )
    row = as_read(diagnostic_json(d))
    assert row["data"] == {
        "time_s": 1.235,
        "depth_m": 0.02312,
        "depth_mm": 23.12,
        "limit_deg_s": 240.12,
        "share": 0.123457,
        "count": 3,
        "axis": [1.0, 0.0],
        "far": "inf",
    }
    assert row["moment"] == {
        "time_s": 12.444,
        "joints_deg": [0.1] * 6,
        "hand_mm": 80.12,
        "bodies": ["can1"],
    }
    assert row["primary"] == {
        "file": "submission-07.v2",
        "line": 2,
        "column": 2,
        "end_line": 2,
        "end_column": 17,
        "text": "here",
    }


def test_hostile_text_survives_as_data() -> None:
    assert as_read(result_json(broken(title=HOSTILE)))["title"] == HOSTILE
