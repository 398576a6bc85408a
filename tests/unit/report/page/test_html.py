"""Escaping, checked by reading the page back with a parser."""

import json
from html.parser import HTMLParser

import pytest

from tests.support_reports import HOSTILE, SYNTAX, broken, compiled, contact_loss, grade, span
from vrts.base.diagnostic import Label, error
from vrts.base.source import SourceFile
from vrts.report.page.html import Markup, element, joined, json_script, prose, raw
from vrts.report.page.page import page


class Reader(HTMLParser):
    """Collects elements with their attributes, and the text of scripts and of everything else."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.text = ""
        self.scripts: list[str] = []
        self.inside = ""
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        self.inside = tag
        if tag == "script":
            self.scripts.append("")

    def handle_endtag(self, tag: str) -> None:
        self.inside = ""

    def handle_data(self, data: str) -> None:
        if self.inside == "script":
            self.scripts[-1] += data
        elif self.inside != "style":
            self.text += data


@pytest.mark.parametrize("text", [HOSTILE, "a & b < c", "\ue000error\ue001x\ue002"])
def test_text_and_attributes_come_back_as_text(text: str) -> None:
    read = Reader(element("p", text, title=text))
    assert [tag for tag, _ in read.elements] == ["p"]
    shown = read.elements[0][1]["title"]
    assert shown == read.text
    assert read.text.isprintable()


def test_only_markup_passes_unescaped() -> None:
    assert element("p", Markup("<b>x</b>"), "<b>") == "<p><b>x</b>&lt;b&gt;</p>"
    assert joined(["<", None, ">"]) == "&lt;&gt;"


def test_attributes_that_say_nothing_are_left_out() -> None:
    assert element("a", class_="x", href=None, hidden=False, open=True, data_t=1.5) == (
        '<a class="x" open data-t="1.5"></a>'
    )


def test_data_for_scripts_cannot_end_its_element() -> None:
    data = {"a": HOSTILE, "b": [1.5, None, True]}
    read = Reader(json_script("data", data))
    assert len(read.elements) == 1
    assert json.loads(read.scripts[0]) == data
    assert not set("<>&\u2028\u2029") & set(read.scripts[0])


def test_our_own_scripts_are_refused_when_they_would_end_themselves() -> None:
    with pytest.raises(ValueError, match="ends its own script"):
        raw("script", 'x = "</script>"')


def test_backticks_become_code_only_in_pairs() -> None:
    assert prose("the `can1`<") == "the <code>can1</code>&lt;"
    assert prose("a ` b") == "a ` b"


def test_a_hostile_submission_adds_no_element_and_no_attribute() -> None:
    source = SourceFile(f"x{HOSTILE}.v2", f"TYPE {HOSTILE}\n; {HOSTILE}\n")
    d = error(
        SYNTAX,
        f"bad `{HOSTILE}`",
        Label(span("TYPE", source), HOSTILE),
        notes=(HOSTILE,),
        help=(HOSTILE,),
    )
    harmless = broken(error(SYNTAX, "bad", Label(span("TYPE"), "x"), notes=("n",), help=("h",)))
    hostile = broken(d, title=HOSTILE)
    hostile = type(hostile)("id", HOSTILE, source, (d,), task=hostile.task, grade=hostile.grade)
    read = Reader(page(hostile, {}))
    known = {tag for tag, _ in Reader(page(harmless, {})).elements}
    assert {tag for tag, _ in read.elements} <= known
    assert not [a for _, a in read.elements if any(key.startswith("on") for key in a)]
    assert "onerror=alert(1)" in read.text


def test_the_page_names_nothing_outside_itself() -> None:
    html = page(compiled(grade(contact_loss())), {"moment": b"\x89PNG"})
    read = Reader(html)
    links = [value for _, a in read.elements for key, value in a.items() if key in ("src", "href")]
    assert links
    assert all(link and link.startswith(("#", "data:")) for link in links)
    policy = next(a["content"] for _, a in read.elements if "http-equiv" in a)
    assert policy is not None
    assert policy.startswith("default-src 'none'")


def test_the_first_screen_stands_in_order_on_the_page() -> None:
    text = Reader(page(compiled(grade(contact_loss())), {"moment": b"\x89PNG"})).text
    parts = (
        "8.5",
        "Ready for the real robot: no",
        "the held can1 hits base1 (−1.5)",
        "Hint: how high",
        "Lost by",
        "Watch this moment",
    )
    places = [text.index(part) for part in parts]
    assert places == sorted(places)
