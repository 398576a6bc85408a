"""Diagnostics in every format, checked against what the format's readers expect."""

import json
import re
from typing import Any

import pytest

from tests.support_sarif import schema_errors
from vrts.base.diagnostic import Diagnostic, Fix, Label, Moment, Rule, error, warning
from vrts.base.source import SourceFile, Span
from vrts.cli.language.problems import Form, render
from vrts.report.formats.checked import Checked
from vrts.report.formats.sarif import uri
from vrts.report.rule_page import rule_page

COMMA = Rule("V131", "missing-comma")
NOT_TEXT = Rule("V102", "not-text")
NO_PAGE = Rule("V999", "without-page")

SOURCE = SourceFile("robot arm/pick.v2", '.PROGRAM a\n  TYPE "語" part 50\n  IF x THEN\n.END\n')
SCENE = SourceFile("scene.toml", "[objects.can1]\n")


def span(text: str, source: SourceFile = SOURCE) -> Span:
    start = source.text.index(text)
    return Span(source, start, start + len(text))


MISSING = error(
    COMMA,
    "a comma is missing between `part` and `50`",
    Label(span("part"), "after this"),
    secondary=(Label(span("50"), "before this"), Label(span("can1", SCENE))),
    notes=("VAL-II says *Unexpected text*",),
    help=("write `part, 50`",),
    fix=Fix(span(" 50"), ", 50"),
    data={"depth_mm": 1.23456},
)
LONG = warning(COMMA, "100% of the lines", Label(Span(SOURCE, 13, 40)))
PICTURE = error(NOT_TEXT, "`p.v2` is a picture, not program text")


def as_text(form: Form, *found: Diagnostic, name: str = "robot arm/pick.v2") -> str:
    return render([Checked(name, found, compiles=False)], form)


def log(*found: Diagnostic, name: str = "robot arm/pick.v2") -> dict[str, Any]:
    document = json.loads(as_text("sarif", *found, name=name))
    assert schema_errors(document) == []
    return document["runs"][0]


def test_concise_is_one_line_for_each() -> None:
    assert as_text("concise", MISSING, PICTURE, name="p.v2") == (
        "robot arm/pick.v2:2:12: error[V131 missing-comma]"
        " a comma is missing between `part` and `50`\n"
        "p.v2: error[V102 not-text] `p.v2` is a picture, not program text"
    )


def test_github_gets_place_title_and_all_the_words() -> None:
    assert as_text("github", MISSING) == (
        "::error file=robot arm/pick.v2,line=2,col=12,endLine=2,endColumn=16,"
        "title=V131 missing-comma::a comma is missing between `part` and `50`%0Aafter this"
        "%0Anote: VAL-II says *Unexpected text*%0Ahelp: write `part, 50`"
    )


def test_github_gets_no_columns_where_lines_differ_and_no_line_where_there_is_none() -> None:
    first, second = as_text("github", LONG, PICTURE, name="a,b:c%.v2").split("\n")
    assert first == (
        "::warning file=robot arm/pick.v2,line=2,endLine=3,"
        "title=V131 missing-comma::100%25 of the lines"
    )
    assert second.startswith("::error file=a%2Cb%3Ac%25.v2,title=V102 not-text::")


def test_json_tells_which_file_compiles() -> None:
    files = [Checked("a.v2", (), compiles=True), Checked("p.v2", (PICTURE,), compiles=False)]
    document = json.loads(render(files, "json"))
    assert document["schema"] == "vrts.diagnostics/1"
    assert document["compiles"] is False
    assert document["files"] == [
        {"file": "a.v2", "compiles": True},
        {"file": "p.v2", "compiles": False},
    ]
    assert [(d["file"], d["code"]) for d in document["diagnostics"]] == [("p.v2", "V102")]


def test_without_findings_json_and_sarif_are_still_documents() -> None:
    clean = [Checked("a.v2", (), compiles=True)]
    assert json.loads(render(clean, "json"))["compiles"] is True
    document = json.loads(render(clean, "sarif"))
    assert schema_errors(document) == []
    assert document["runs"][0]["results"] == []
    lines: tuple[Form, ...] = ("full", "concise", "github")
    assert [render(clean, form) for form in lines] == ["", "", ""]


def test_sarif_names_the_tool_and_explains_every_rule_it_uses() -> None:
    run = log(MISSING, PICTURE, LONG)
    driver = run["tool"]["driver"]
    assert driver["name"] == "vrts"
    assert re.fullmatch(r"\d+\.\d+\.\d+\S*", driver["version"])
    assert [(rule["id"], rule["name"]) for rule in driver["rules"]] == [
        ("V102", "not-text"),
        ("V131", "missing-comma"),
    ]
    rule = driver["rules"][1]
    assert rule["shortDescription"]["text"] == "Two operands stand side by side without a comma."
    assert rule["fullDescription"]["text"].endswith("by commas, not by blanks.")
    assert "```val2" in rule["help"]["markdown"]
    assert "`" not in rule["help"]["text"]
    assert "Put a comma between them." in rule["help"]["text"]
    assert run["columnKind"] == "unicodeCodePoints"
    assert [result["ruleIndex"] for result in run["results"]] == [1, 0, 1]
    assert [result["level"] for result in run["results"]] == ["error", "error", "warning"]


def test_sarif_counts_code_points_and_ends_behind_the_last() -> None:
    result = log(MISSING)["results"][0]
    assert result["locations"] == [
        {
            "physicalLocation": {
                "artifactLocation": {"uri": "robot%20arm/pick.v2"},
                "region": {"startLine": 2, "startColumn": 12, "endLine": 2, "endColumn": 16},
            }
        }
    ]
    places = [related["physicalLocation"] for related in result["relatedLocations"]]
    assert [place["artifactLocation"]["uri"] for place in places] == [
        "robot%20arm/pick.v2",
        "scene.toml",
    ]
    assert result["relatedLocations"][0]["message"]["text"] == "before this"
    assert [related["id"] for related in result["relatedLocations"]] == [1, 2]


def test_the_fix_in_sarif_repairs_the_text() -> None:
    fix = log(MISSING)["results"][0]["fixes"][0]
    replacement = fix["artifactChanges"][0]["replacements"][0]
    region = replacement["deletedRegion"]
    lines = SOURCE.text.split("\n")
    line = lines[int(region["startLine"]) - 1]
    new = str(replacement["insertedContent"]["text"])
    repaired = line[: int(region["startColumn"]) - 1] + new + line[int(region["endColumn"]) - 1 :]
    assert repaired == '  TYPE "語" part, 50'
    assert fix["description"]["text"] == "write `part, 50`"


def test_sarif_says_all_the_words_and_keeps_exact_values() -> None:
    result = log(MISSING)["results"][0]
    assert result["message"]["text"].split("\n") == [
        "a comma is missing between `part` and `50`",
        "after this",
        "note: VAL-II says *Unexpected text*",
        "help: write `part, 50`",
    ]
    assert result["properties"] == {"data": {"depth_mm": 1.23}}


def test_sarif_tells_the_moment_of_a_finding() -> None:
    d = error(COMMA, "hit", moment=Moment(12.4, (0.0,) * 6 + (0.08,), ("can1", "base1")))
    result = log(d)["results"][0]
    assert "at 12.4 s: can1 and base1" in result["message"]["text"]
    assert result["properties"]["moment"]["time_s"] == 12.4
    assert result["properties"]["moment"]["hand_mm"] == 80.0


def test_a_file_that_is_no_text_is_named_without_a_region() -> None:
    place = log(PICTURE, name="p.v2")["results"][0]["locations"][0]["physicalLocation"]
    assert place == {"artifactLocation": {"uri": "p.v2"}}


def test_placeholders_and_links_of_a_program_stay_text() -> None:
    d = error(COMMA, "`{0}` [click](https://example.org)", Label(span("part"), "{1}"))
    text = log(d)["results"][0]["message"]["text"]
    assert text == "`{{0}}` [click] (https://example.org)\n{{1}}"


def test_a_rule_without_a_page_has_id_and_name() -> None:
    assert log(error(NO_PAGE, "bad"))["tool"]["driver"]["rules"] == [
        {"id": "V999", "name": "without-page"}
    ]
    assert rule_page("V999") is None


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("a b/c#1.v2", "a%20b/c%231.v2"),
        ("../x.v2", "../x.v2"),
        ("c:x.v2", "c%3Ax.v2"),
        ("/tmp/ö.v2", "file:///tmp/%C3%B6.v2"),
        ("\udcff.v2", "%FF.v2"),
        ("\ud800.v2", "%ED%A0%80.v2"),
        ("\u202e\x1b", "%E2%80%AE%1B"),
    ],
)
def test_a_name_becomes_a_uri(name: str, expected: str) -> None:
    assert uri(name) == expected


def test_the_schema_refuses_what_is_no_sarif() -> None:
    assert schema_errors({"version": "2.0.0", "runs": []})
    assert schema_errors({"version": "2.1.0", "runs": [{"tool": "vrts"}]})
