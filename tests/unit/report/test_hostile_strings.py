"""One corpus of hostile strings goes through every output and is read back with a parser."""

import csv
import io
import json
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from functools import cache
from html.parser import HTMLParser
from pathlib import Path

import pytest
import rerun as rr

from tests.places import TESTS
from tests.support_reports import SYNTAX
from tests.support_runs import assessment
from vrts.base.diagnostic import Label, error
from vrts.base.source import SourceFile, Span
from vrts.check.judgement import Judgement
from vrts.check.verdict import Clearance, NearMiss
from vrts.report.assessment import Assessment
from vrts.report.audience import Audience
from vrts.report.formats.csv_field import text_field
from vrts.report.formats.json_form import assessment_json
from vrts.report.formats.json_text import json_text
from vrts.report.formats.sarif import sarif
from vrts.report.page.html import json_script
from vrts.report.page.page import page
from vrts.report.recording.names import of_body
from vrts.report.screen.assessment_text import assessment_text
from vrts.report.screen.first_screen_text import first_screen_text
from vrts.report.screen.palette import Palette

DATA = TESTS / "data" / "hostile_strings.json"
CORPUS: list[str] = json.loads(DATA.read_text(encoding="utf-8"))
RERUN = Path(sys.executable).parent / "rerun"


class Skeleton(HTMLParser):
    """Collects which elements with which attributes there are, and the text of scripts."""

    def __init__(self, html: str) -> None:
        super().__init__(convert_charrefs=True)
        self.elements: set[tuple[str, tuple[str, ...]]] = set()
        self.scripts: list[str] = []
        self.text = ""
        self.tag = ""
        self.feed(html)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tag = tag
        self.elements.add((tag, tuple(name for name, _ in attrs)))
        if tag == "script":
            self.scripts.append("")

    def handle_endtag(self, tag: str) -> None:
        self.tag = ""

    def handle_data(self, data: str) -> None:
        if self.tag == "script":
            self.scripts[-1] += data
        elif self.tag != "style":
            self.text += data


def named(text: str) -> Assessment:
    """Return an assessment in which everything foreign is made of a text."""
    source = SourceFile(text, f".PROGRAM a()\n; {' '.join(text.splitlines())}\n.END\n")
    label = Label(Span(source, 0, 8), text)
    found = error(SYNTAX, f"found `{text}` here", label, notes=(text,), help=(text,))
    a = assessment()
    assert a.grade is not None
    losses = tuple(loss._replace(sentence=text, span=None) for loss in a.grade.losses)
    grade = replace(a.grade, losses=losses, obstacles=(text,), lowest=Fraction(3))
    judgement = judged(a, text)
    return replace(
        a, title=text, source=source, diagnostics=(found,), grade=grade, judgement=judgement
    )


def judged(a: Assessment, text: str) -> Judgement:
    """Return the judgement of a run with a text wherever a name or a sentence stands."""
    assert a.judgement is not None
    assert a.judgement.collisions is not None
    report = a.judgement.collisions
    (contact,) = report.contacts
    contact = contact._replace(first=text, second=text, parts=(text, text), held=text)
    witnesses = (contact.point, contact.point)
    miss = NearMiss(text, text, (text, text), 2.0, 2.1, 2.05, 0.001, witnesses, text, None)
    report = replace(
        report,
        contacts=(contact,),
        grazes=(contact,),
        undetermined=(contact,),
        near_misses=(miss,),
        near_miss_m=0.005,
        clearance=Clearance(0.001, 1e-6, 2.0, (text, text), witnesses),
        disagreements=(text,),
        engine=text,
        statistics={text: 1},
    )
    evidence = {"method": text, "disagreements": text}
    verdicts = tuple(
        replace(v, check=text, summary=text, evidence=evidence) for v in a.judgement.verdicts
    )
    return Judgement(verdicts, report)


@cache
def harmless(kind: str) -> Skeleton:
    return Skeleton(html(kind, named("harmless")))


def html(kind: str, a: Assessment) -> str:
    return page(a, {}, audience=Audience(kind), hidden=(a.title,), more=1)


@pytest.mark.parametrize("kind", ["student", "grader"])
@pytest.mark.parametrize("text", CORPUS)
def test_html_has_no_element_and_no_attribute_more(text: str, kind: str) -> None:
    written = html(kind, named(text))
    read = Skeleton(written)
    ours = harmless(kind).elements | {("code", ())}  # what stands between backticks
    assert {e for e in read.elements if e[0] != "span"} <= ours
    assert len(read.scripts) == len(harmless(kind).scripts)
    assert all(c.isprintable() or c == "\n" for c in read.text)
    assert json.loads(read.scripts[0])["moment"] is not None
    written.encode("utf-8")


@pytest.mark.parametrize("text", CORPUS)
def test_json_in_a_script_comes_back_and_ends_nothing(text: str) -> None:
    read = Skeleton(json_script("data", {"text": text}))
    assert json.loads(read.scripts[0]) == {"text": text}
    assert len(read.elements) == 1


@pytest.mark.parametrize("text", CORPUS)
def test_a_terminal_gets_only_what_has_a_shape(text: str) -> None:
    a = replace(named(text), run=None)
    for shown in (assessment_text(a, color=False), first_screen_text(a, Palette(color=False))):
        assert all(c.isprintable() or c == "\n" for c in shown)
        assert not any(line.lstrip().startswith("::") for line in shown.split("\n"))
        assert "##[" not in shown
        assert "##vso[" not in shown


@pytest.mark.parametrize("text", CORPUS)
def test_json_and_sarif_are_read_back(text: str) -> None:
    a = named(text)
    assert json.loads(json_text(assessment_json(a)))
    rows = [(text, d) for d in a.diagnostics]
    log = json.loads(json.dumps(sarif(rows)))
    place = log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]
    assert place["uri"].isascii()


@pytest.mark.parametrize("text", [t for t in CORPUS if "\0" not in t])
def test_a_name_is_one_field_of_a_table_and_no_formula(text: str) -> None:
    row = f"1,{text_field(text)},-2"
    number, name, last = next(csv.reader(io.StringIO(row, newline="")))
    assert (number, last) == ("1", "-2")
    assert name in (text, f"'{text}")
    assert name.lstrip(" ")[:1] not in set("=+-@\t\r\n")


def test_every_name_is_one_entity_of_a_recording(tmp_path: Path) -> None:
    names = [t for t in CORPUS if "\udcff" not in t]
    path = tmp_path / "names.rrd"
    stream = rr.RecordingStream("vrts", recording_id="names", send_properties=False)
    with stream:
        stream.save(path)
        for name in names:
            rr.log(of_body(name), rr.TextDocument("x"), static=True)
    stream.flush()
    stream.disconnect()
    shown = subprocess.run(
        [RERUN, "rrd", "stats", path], capture_output=True, text=True, check=True
    )
    assert f"num_entity_paths = {len(names)}" in shown.stdout
