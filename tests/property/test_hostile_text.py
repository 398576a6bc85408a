"""No text of a program, and no name of a file, steers a terminal, a build service or a page."""

import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import PurePath
from typing import Any
from urllib.parse import unquote

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_hostile import diagnostics, names, service_commands, steering, texts
from tests.support_reports import SYNTAX, broken
from tests.support_sarif import schema_errors
from vrts.base.diagnostic import Diagnostic, error
from vrts.base.source import SourceFile
from vrts.cli.language.problems import FORMS, Form, render
from vrts.report.formats.checked import Checked
from vrts.report.formats.sarif import uri
from vrts.report.page.html import joined, painted
from vrts.report.page.listing import listing
from vrts.report.page.page import page
from vrts.report.plain import shown, visible
from vrts.report.screen.assessment_text import assessment_text

few = settings(max_examples=examples(40))
FOR_PEOPLE: tuple[Form, ...] = ("full", "concise")
COLOR = re.compile(r"\x1b\[[0-9;]*m")
COMMAND = re.compile(
    r"::(error|warning|notice) file=[^:,\r\n]*"
    r"(,line=\d+(,col=\d+)?,endLine=\d+(,endColumn=\d+)?)?,title=V\d{3} [a-z-]+::[^\r\n]*"
)
URI = re.compile(r"(file:///)?(%[0-9A-F]{2}|[A-Za-z0-9_.~/-])*")


def rendered(name: str, found: list[Diagnostic], form: Form, *, color: bool = False) -> str:
    return render([Checked(name, tuple(found), compiles=False)], form, color=color)


@pytest.mark.thorough
@pytest.mark.parametrize("form", FORMS)
@few
@given(names, st.lists(diagnostics(), min_size=1, max_size=2))
def test_no_format_lets_a_character_through_that_steers(
    form: Form, name: str, found: list[Diagnostic]
) -> None:
    assert steering(rendered(name, found, form)) == []


@pytest.mark.thorough
@pytest.mark.parametrize("form", FOR_PEOPLE)
@few
@given(names, diagnostics())
def test_colours_are_ours_alone(form: Form, name: str, d: Diagnostic) -> None:
    colored = rendered(name, [d], form, color=True)
    assert COLOR.sub("", colored) == rendered(name, [d], form)


@pytest.mark.parametrize("form", [form for form in FORMS if form != "github"])
@few
@given(names, diagnostics())
def test_no_line_is_a_command_of_a_build_service(form: Form, name: str, d: Diagnostic) -> None:
    assert service_commands(rendered(name, [d], form)) == []


@few
@given(names, st.lists(diagnostics(), min_size=1, max_size=3))
def test_every_line_for_github_is_one_command_of_ours(name: str, found: list[Diagnostic]) -> None:
    lines = rendered(name, found, "github").split("\n")
    assert len(lines) == len(found)
    for line in lines:
        assert COMMAND.fullmatch(line), line


@few
@given(names, st.lists(diagnostics(), max_size=2))
def test_sarif_stays_valid_and_links_nowhere(name: str, found: list[Diagnostic]) -> None:
    log = json.loads(rendered(name, found, "sarif"))
    assert schema_errors(log) == []
    for result in log["runs"][0]["results"]:
        said = [result["message"], *(place.get("message") for place in related(result))]
        said += [fix.get("description") for fix in result.get("fixes", [])]
        for text in (message["text"] for message in said if message):
            assert steering(text) == []
            assert "](" not in text
            assert not re.search(r"(?<!\{)(\{\{)*\{\d", text)


def related(result: dict[str, Any]) -> list[dict[str, Any]]:
    return result.get("relatedLocations", [])


@few
@given(names.filter(lambda name: "\ud800" not in name))
def test_a_file_name_comes_back_from_its_uri(name: str) -> None:
    found = uri(name)
    assert URI.fullmatch(found)
    assert unquote(found.removeprefix("file://")) == PurePath(name).as_posix()


@few
@given(names, diagnostics())
def test_json_gives_everything_back_exactly(name: str, d: Diagnostic) -> None:
    document = json.loads(rendered(name, [d], "json"))
    row = document["diagnostics"][0]
    assert document["files"] == [{"file": name, "compiles": False}]
    assert row["headline"] == d.headline
    assert row["notes"] == list(d.notes)
    assert row["data"] == dict(d.data)


@few
@given(texts)
def test_a_line_keeps_its_columns(line: str) -> None:
    line = line.replace("\n", " ")
    text, columns = shown(line)
    assert steering(text) == []
    assert len(columns) == len(line) + 1
    assert list(columns) == sorted(columns)


@few
@given(texts)
def test_visible_text_is_not_changed_again(text: str) -> None:
    assert visible(visible(text)) == visible(text)


class Tags(HTMLParser):
    """Collects the names of all elements, and what scripts hold."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.found: list[str] = []
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append(tag)


@few
@given(names, st.lists(diagnostics(), min_size=1, max_size=2))
def test_a_page_holds_no_element_of_the_programs_making(name: str, found: list[Diagnostic]) -> None:
    html = page(broken(*found, title=name), {})
    assert steering(html) == []
    assert "script" not in Tags(html).found


@few
@given(texts)
def test_a_listing_and_painted_text_are_escaped(text: str) -> None:
    assert set(Tags(listing(SourceFile("a.v2", text), ())).found) <= {"ol", "li", "code", "span"}
    assert Tags(painted(visible(text))).found == []
    assert Tags(joined([text])).found == []


@few
@given(names, diagnostics())
def test_the_first_screen_steers_nothing(name: str, d: Diagnostic) -> None:
    marked = broken(d, title=name)
    for a in (marked, replace(marked, task=None, grade=None)):
        text = assessment_text(a, color=False)
        assert steering(text) == []
        assert service_commands(text) == []


def test_neither_title_nor_cause_begins_a_command() -> None:
    d = error(SYNTAX, "::error::a headline that stands first")
    a = replace(broken(d, title="::debug::a title"), task=None, grade=None)
    text = assessment_text(a, color=False)
    assert "∶:error::a headline" in text
    assert "∶:debug::a title" in text
    assert service_commands(text) == []
