"""What a notebook shows of runs and assessments."""

import re
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest

import vrts

TURN = ".PROGRAM turn()\nDRIVE 1, 30, 100\n.END\n"


def _html(thing: object) -> str:
    return thing._repr_html_()  # type: ignore[attr-defined, no-any-return]


def test_a_run_shows_curves_that_are_legible_on_any_ground() -> None:
    shown = _html(vrts.run(TURN))
    root = ElementTree.fromstring(shown)
    assert [svg.attrib["aria-label"] for svg in root.iter("svg")] == [
        "JT1, JT2, JT3, JT4, JT5, JT6 over time, in degrees",
        "X, Y, Z over time, in mm",
    ]
    assert "fill:currentColor" in shown
    assert "background" not in shown


def test_a_run_that_takes_no_time_shows_words() -> None:
    assert "<svg" not in _html(vrts.run(".PROGRAM none()\n.END\n"))


def test_a_scene_shows_a_drawing() -> None:
    assert _html(vrts.scene("cans-on-bases")).lstrip().startswith("<svg")


def test_drawings_in_one_notebook_keep_to_themselves() -> None:
    clips: dict[str, dict[str, str]] = {}
    for name in ("cans-on-bases", "one-can-ur3", "one-can-puma560"):
        root = ElementTree.fromstring(_html(vrts.scene(name)))
        style = root.findtext("{*}style") or ""
        rules = re.findall(r"([^{}]+)\{", style)
        assert len(rules) > 10
        assert all(rule.strip().startswith(f".{root.attrib['class']} ") for rule in rules)
        for clip in root.iter("{http://www.w3.org/2000/svg}clipPath"):
            assert clips.setdefault(clip.attrib["id"], clip[0].attrib) == clip[0].attrib
            assert f"url(#{clip.attrib['id']})" in _html(vrts.scene(name))
    assert len(clips) > 2


def test_an_assessment_shows_its_top_and_the_replay_in_a_frame_of_its_own() -> None:
    shown = _html(vrts.verify(TURN, task="01-cans-on-bases"))
    assert shown.startswith("<iframe srcdoc=")
    assert 'sandbox="allow-scripts"' in shown
    assert shown.count("<iframe") == 1
    inner = unescape(shown)
    assert 'class="first-screen"' in inner
    assert 'id="replay"' in inner
    assert 'id="data"' in inner
    assert "Content-Security-Policy" in inner
    assert 'id="contacts"' not in inner


def test_what_does_not_compile_shows_its_top(tmp_path: Path) -> None:
    program = tmp_path / "<i>wrong.v2"
    program.write_text(".PROGRAM a()\nSPED 30\n.END\n")
    inner = unescape(_html(vrts.mark(program, "01-cans-on-bases")))
    assert 'class="first-screen"' in inner
    assert 'id="replay"' not in inner
    assert "&lt;i&gt;wrong.v2" in inner
    assert "<i>" not in inner


@pytest.mark.parametrize("reader", ["student", "grader"])
def test_the_page_is_written(reader: str, tmp_path: Path) -> None:
    found = vrts.verify(TURN, task="01-cans-on-bases")
    page = found.save_html(tmp_path / "page.html", reader=reader).read_text()
    assert ('id="facts"' in page) is (reader == "grader")
