"""Every export that has a place for words carries what graders gave and wrote, and no formula."""

import json
from collections.abc import Mapping

import pytest
from msgspec.structs import replace

from tests.support_rows import plain_result
from vrts.marking.exports.feedback import feedback_html
from vrts.marking.exports.formats import FORMATS
from vrts.marking.exports.given import Given, Options, Returned
from vrts.marking.row import (
    Change,
    Class,
    Decided,
    HandedIn,
    MadeStep,
    Row,
    Student,
    Told,
    row_of,
)
from vrts.marking.row import Given as Item

FORMULA = '=HYPERLINK("http://x.example","<b>look</b>")'
DECIDED = Decided(
    (Told(FORMULA, "R. Huber", 9, 3.2),),
    (Item("style", "no comments", "-1/2", "A. Lang", ((4, None),)),),
    (MadeStep("no comments", "-1/2", "by A. Lang"),),
)


def decided() -> Row:
    """Return a row with a comment and an item."""
    result = replace(plain_result("anna"), mark=8.0)
    change = Change("-1/2", "no comments", "A. Lang", "2026-11-26")
    return row_of(result, Student("Anna"), HandedIn(), None, change, DECIDED)


def exported(name: str) -> str:
    """Return the only file of a format."""
    row = decided()
    whole = Class("vrts.class/1", "Lab", (row,))
    public: Mapping[str, object] = {row.id: row.result}
    product = FORMATS[name].export(Given(whole, public, lambda _: ()), Options())  # type: ignore[arg-type]
    ((_, data),) = product.files
    return data.decode("utf-8-sig")


@pytest.mark.parametrize("name", ["csv", "json", "gradescope", "prairielearn", "folders", "junit"])
def test_items_and_comments_are_in_it(name: str) -> None:
    text = exported(name)
    for words in ("no comments", "HYPERLINK", "7.5"):
        assert words in text, words


def test_a_comment_is_no_formula_and_no_markup() -> None:
    assert ",=HYPERLINK" not in exported("csv")
    assert '"=HYPERLINK' not in exported("csv")
    html = feedback_html(Returned(decided(), decided().result))
    assert "&lt;b&gt;look&lt;/b&gt;" in html
    assert "line 9, at 3.20 s: " in html


def test_the_tests_of_gradescope_add_up_with_items() -> None:
    found = json.loads(exported("gradescope"))
    assert found["score"] == 7.5
    assert {"name": "no comments", "score": -0.5}.items() <= found["tests"][-1].items()
