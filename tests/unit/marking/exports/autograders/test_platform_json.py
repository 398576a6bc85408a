"""results.json of Gradescope and PrairieLearn: their schemas, sums, what stays hidden."""

import json
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

import jsonschema
import msgspec
import pytest
from hypothesis import given as of_any

from tests.support_exports import (
    DATA,
    HOSTILE,
    PNG,
    SECRET,
    given,
    hostile,
    result,
    row,
    rows,
    secret,
)
from tests.support_hostile import service_commands
from vrts.marking.exports.autograders import gradescope, prairielearn
from vrts.marking.exports.autograders.prairielearn import LARGEST
from vrts.marking.exports.given import Given, Options, Page, Product, Returned
from vrts.marking.result import Kind
from vrts.marking.row import Change, Lateness, Row


def documents(product: Product, platform: str) -> list[dict[str, Any]]:
    """Return the documents of an export, all of which keep to the format of the platform."""
    schema = json.loads((DATA / "exports" / f"{platform}-results.schema.json").read_text("utf-8"))
    found: list[dict[str, Any]] = []
    for _, data in product.files:
        assert len(data) <= LARGEST
        assert data.isascii()
        assert not service_commands(data.decode())
        found.append(json.loads(data))
        jsonschema.validate(found[-1], schema)
    return found


def on_gradescope(one: Given) -> list[dict[str, Any]]:
    return documents(gradescope.gradescope(one, Options()), "gradescope")


def on_prairielearn(one: Given) -> list[dict[str, Any]]:
    return documents(prairielearn.prairielearn(one, Options()), "prairielearn")


def total(tests: Iterable[dict[str, Any]]) -> Fraction:
    return sum((Fraction(repr(test.get("score", 0))) for test in tests), Fraction(0))


def test_gradescope_shows_checks_with_points_and_what_became_of_the_mark() -> None:
    late, change = Lateness(60, "1", "1 min late"), Change("1/2", "seen", "r", "d")
    (found,) = on_gradescope(given([row(late=late, change=change)]))
    assert found["score"] == 8
    assert [(test["name"], test["score"], test["status"]) for test in found["tests"]] == [
        ("can1 on base1", 10, "passed"),
        ("no contact", -1.5, "failed"),
        ("lateness", -1, "failed"),
        ("change by hand", 0.5, "passed"),
    ]
    assert {test["visibility"] for test in found["tests"]} == {"visible"}
    assert found["output"].startswith("Line 17, the held `can1` hits `base1`.")


def test_hidden_checks_are_hidden_on_gradescope_and_the_sum_is_the_mark() -> None:
    public = result()
    one = msgspec.structs.replace(row(mark=6.0), result=secret(public, 6.0))
    (found,) = on_gradescope(given([one], {"anna": public}))
    (hidden,) = [test for test in found["tests"] if test["visibility"] == "hidden"]
    assert (hidden["name"], hidden["output"]) == (SECRET, "Xyzzy-hidden (-1.5 of 0 points)")
    assert "score" not in hidden
    (later,) = [test for test in found["tests"] if test["visibility"] == "after_published"]
    assert (later["name"], later["score"]) == ("checks that are not shown", -2.5)
    assert total(found["tests"]) == found["score"] == 6
    seen = [test for test in found["tests"] if test["visibility"] != "hidden"]
    assert SECRET not in json.dumps([seen, found["output"]])


def test_what_lateness_costs_tells_nothing_of_a_hidden_mark() -> None:
    public = result()
    late = row(mark=0.5, late=Lateness(60, "2", "late"))
    one = msgspec.structs.replace(late, result=secret(public, 0.5))
    (found,) = on_gradescope(given([one], {"anna": public}))
    lateness = next(test for test in found["tests"] if test["name"] == "lateness")
    assert (lateness["score"], lateness["visibility"]) == (-0.5, "after_published")


def test_what_could_not_be_marked_says_so_and_names_no_machine() -> None:
    (found,) = on_gradescope(given([row(mark=None, kind=Kind.RESOURCE)]))
    assert found["score"] == 0
    assert "could not be marked" in found["output"]


@pytest.mark.thorough
@of_any(found=rows())
def test_gradescope_s_tests_add_up_to_the_mark_of_any_row(found: tuple[Row, ...]) -> None:
    for document, one in zip(on_gradescope(given(found)), found, strict=True):
        final = one.exact_final or Fraction(0)
        assert Fraction(repr(document["score"])) == final
        if one.final is not None and one.result.mark is not None:
            assert abs(total(document["tests"]) - final) < Fraction(1, 10**5)


def test_prairielearn_has_a_share_and_pictures() -> None:
    (found,) = on_prairielearn(given([row()]))
    assert (found["score"], found["gradable"]) == (0.85, True)
    assert [(test["points"], test["max_points"]) for test in found["tests"]] == [
        (10, 10),
        (-1.5, 0),
    ]
    assert found["images"] == [
        {"label": "Picture 1 of the run", "url": f"data:image/png;base64,{PNG}"}
    ]


@pytest.mark.parametrize("kind", [Kind.DOES_NOT_COMPILE, Kind.UNREADABLE])
def test_what_does_not_compile_is_no_attempt_on_prairielearn(kind: Kind) -> None:
    (found,) = on_prairielearn(given([row(mark=0.0, kind=kind)]))
    assert found["gradable"] is False
    assert found["format_errors"] == ["line 17: line 17, the held `can1` hits `base1`"]
    assert "tests" not in found


def test_nothing_hidden_gets_to_prairielearn() -> None:
    public = result()
    one = msgspec.structs.replace(row(mark=6.0), result=secret(public, 6.0))
    (found,) = on_prairielearn(given([one], {"anna": public}))
    assert found["score"] == 0.6
    assert SECRET not in json.dumps(found)


def test_pictures_that_are_too_large_are_left_out() -> None:
    one = row()
    picture = b'<img src="data:image/png;base64,' + b"A" * 600_000 + b'">'
    found = prairielearn.results(Returned(one, one.result), (Page("report.html", picture * 2),))
    assert len(json.dumps(found)) < LARGEST
    assert json.dumps(found).count("data:image/png") == 1


@pytest.mark.parametrize("words", HOSTILE)
def test_hostile_words_stay_in_their_strings(words: str) -> None:
    both = [hostile(words), hostile("SOMEBODY ELSE", 1)]
    first, other = on_gradescope(given(both))
    assert "SOMEBODY ELSE" not in json.dumps(first)
    assert "SOMEBODY ELSE" in json.dumps(other)
    assert len(on_prairielearn(given(both))) == 2
