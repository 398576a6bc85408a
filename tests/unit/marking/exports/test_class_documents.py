"""Documents of a whole class: the published JSON, JUnit XML, SARIF."""

import json
from xml.etree import ElementTree

import jsonschema
import pytest
from hypothesis import given as of_any

from tests.support_exports import HOSTILE, given, hostile, row, rows
from tests.support_hostile import steering
from tests.support_sarif import schema_errors
from vrts.marking.exports.class_json import class_json
from vrts.marking.exports.findings import findings
from vrts.marking.exports.given import Options, Product
from vrts.marking.exports.junit import junit
from vrts.marking.result import Kind
from vrts.marking.row import Row, class_from_bytes, counted
from vrts.marking.schemas import schema

TAGS = {
    "testsuites": {"name", "tests", "failures", "errors", "skipped"},
    "testsuite": {"name", "tests", "failures", "errors", "skipped", "time"},
    "properties": set[str](),
    "property": {"name", "value"},
    "testcase": {"classname", "name", "time"},
    "failure": {"message", "type"},
    "error": {"message", "type"},
    "skipped": {"message"},
}


def only(product: Product) -> bytes:
    ((_, data),) = product.files
    return data


def suites(*found: Row) -> list[ElementTree.Element]:
    """Return the suites of a class, whose document keeps to the common part of the format."""
    root = ElementTree.fromstring(only(junit(given(found), Options())))
    for element in root.iter():
        assert set(element.keys()) == TAGS[element.tag]
    assert root.tag == "testsuites"
    for holder in (root, *root):
        cases = list(holder.iter("testcase"))
        assert int(holder.attrib["tests"]) == len(cases)
        for count, tag in (("failures", "failure"), ("errors", "error"), ("skipped", "skipped")):
            assert int(holder.attrib[count]) == len(list(holder.iter(tag)))
    return list(root)


@pytest.mark.thorough
@of_any(found=rows())
def test_the_document_of_any_class_is_the_published_one(found: tuple[Row, ...]) -> None:
    clean = given([one for one in found if not steering(one.student.name)])
    clean = clean._replace(whole=counted(clean.whole))
    data = only(class_json(clean, Options()))
    jsonschema.validate(json.loads(data), schema("class"))
    assert class_from_bytes(data) == counted(clean.whole)


@of_any(found=rows())
def test_the_marks_of_any_class_come_back_from_junit(found: tuple[Row, ...]) -> None:
    for suite, one in zip(suites(*found), found, strict=True):
        values = {p.attrib["name"]: p.attrib["value"] for p in suite.iter("property")}
        assert values["final mark"] == ("" if one.final is None else f"{one.final:.1f}")


def test_a_check_that_does_not_hold_is_a_failure() -> None:
    (suite,) = suites(row())
    good, bad = suite.findall("testcase")
    assert list(good) == []
    failure = bad.find("failure")
    assert failure is not None
    assert "(-1.5 of 0 points)" in failure.attrib["message"]


@pytest.mark.parametrize(
    ("kind", "tag"),
    [
        (Kind.DOES_NOT_COMPILE, "failure"),
        (Kind.LIMIT, "failure"),
        (Kind.RESOURCE, "error"),
        (Kind.FAULT, "error"),
        (Kind.AMBIGUOUS, "error"),
        (Kind.MISSING, "skipped"),
        (Kind.EXCUSED, "skipped"),
    ],
)
def test_what_became_of_a_submission_is_a_case_of_its_own(kind: Kind, tag: str) -> None:
    (suite,) = suites(row(mark=None, kind=kind))
    (case,) = suite.findall("testcase")
    assert [part.tag for part in case] == [tag]


def test_hostile_words_leave_junit_whole() -> None:
    found = suites(*(hostile(words, n) for n, words in enumerate(HOSTILE)))
    assert len(found) == len(HOSTILE)


def test_sarif_tells_rule_file_line_and_column() -> None:
    log = json.loads(only(findings(given([row()]), Options())))
    assert schema_errors(log) == []
    first, second = log["runs"][0]["results"]
    place = first["locations"][0]["physicalLocation"]
    assert place["artifactLocation"]["uri"] == "anna/pick.v2"
    assert (place["region"]["startLine"], place["region"]["startColumn"]) == (17, 3)
    assert (first["ruleId"], first["level"], second["level"]) == ("V401", "error", "warning")
    assert "region" not in second["locations"][0]["physicalLocation"]


def test_hostile_words_leave_sarif_valid() -> None:
    found = [hostile(words, n) for n, words in enumerate(HOSTILE)]
    log = json.loads(only(findings(given(found), Options())))
    assert schema_errors(log) == []
    uris = {
        place["physicalLocation"]["artifactLocation"]["uri"]
        for entry in log["runs"][0]["results"]
        for place in entry["locations"]
    }
    assert all(uri.startswith("s") and ".." not in uri for uri in uris)
