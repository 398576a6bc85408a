"""result.json of Classroom 50: its schema, whole numbers that add up, nothing hidden."""

import json
from datetime import UTC, datetime
from typing import Any

import jsonschema
import msgspec
import pytest
from hypothesis import given as of_any

from tests.support_exports import DATA, HOSTILE, SECRET, given, hostile, result, row, rows, secret
from vrts.marking.exports.autograders.classroom50 import classroom50, from_environment
from vrts.marking.exports.given import Given, Options
from vrts.marking.row import Row
from vrts.pipeline.refused import Refused

SCHEMA = json.loads((DATA / "exports" / "classroom50-result.schema.json").read_text("utf-8"))
RUN = {
    "CLASSROOM": "robots",
    "ASSIGNMENT": "lab1",
    "SUBMISSION_TAG": "submit/2026-06-01T14-32-05Z-a1b2c3d",
    "COMMIT_URL": "https://example.org/commit",
    "RELEASE_URL": "https://example.org/release",
    "TOKEN": "not to be told",
}
NOW = datetime(2026, 11, 30, 12, 0, 5, tzinfo=UTC)


def document(one: Given, **environment: str) -> dict[str, Any]:
    told = from_environment({**RUN, **environment})
    ((_, data),) = classroom50(one, Options(environment=told, now=NOW)).files
    found = json.loads(data)
    jsonschema.validate(found, SCHEMA)
    assert sum(test["score"] for test in found["tests"]) == found["score"]
    assert sum(test["max-score"] for test in found["tests"]) == found["max-score"] == 100
    assert all(len(test["test-name"].encode()) <= 100 for test in found["tests"])
    return found


def test_a_mark_is_a_whole_number_of_a_hundred() -> None:
    found = document(given([row(mark=8.5)]))
    assert (found["score"], found["review"]) == (85, RUN["COMMIT_URL"])
    assert found["datetime"] == "2026-11-30T12:00:05Z"
    assert [(test["test-name"], test["passed"]) for test in found["tests"]] == [
        ("mark", False),
        ("can1 on base1", True),
        ("no contact", False),
    ]
    assert document(given([row()]), REVIEW_URL="https://example.org/r")["review"].endswith("/r")


def test_nothing_hidden_and_no_other_variable_is_told() -> None:
    public = result()
    one = msgspec.structs.replace(row(mark=6.0), result=secret(public, 6.0))
    found = document(given([one], {"anna": public}))
    assert found["score"] == 60
    assert SECRET not in json.dumps(found)
    assert "not to be told" not in json.dumps(found)


@of_any(found=rows())
def test_the_mark_of_any_row_comes_back(found: tuple[Row, ...]) -> None:
    for one in found:
        assert document(given([one]))["score"] == (one.exact_final or 0) * 10


@pytest.mark.parametrize("words", HOSTILE)
def test_hostile_words_are_names_of_tests_at_most(words: str) -> None:
    assert document(given([hostile(words)]))["score"] == 41


@pytest.mark.parametrize(
    ("one", "environment"),
    [
        (given([row()]), {}),
        (given([row()]), {**RUN, "COMMIT_URL": ""}),
        (given([row("a"), row("b")]), RUN),
        (given([]), RUN),
    ],
)
def test_outside_a_run_it_is_refused(one: Given, environment: dict[str, str]) -> None:
    with pytest.raises(Refused) as refused:
        classroom50(one, Options(environment=environment, now=NOW))
    assert [d.rule.code for d in refused.value.diagnostics] == ["V751"]
