"""What a notebook shows, in a real browser: the replay works within its frame, and stays in it."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser, Frame

import vrts
from tests.browser.support import PATIENCE, Opened, opened
from tests.places import ROOT

pytestmark = [pytest.mark.browser, pytest.mark.thorough]

HITS = ROOT / "examples" / "01-cans-on-bases" / "submissions" / "hits-base.v2"
NOTEBOOK = """<!doctype html><html lang="en"><meta charset="utf-8"><title>a notebook</title>
<body style="color: {ink}; background: {ground}">{shown}</body></html>"""


@pytest.fixture(scope="module")
def found() -> vrts.Assessment:
    return vrts.verify(HITS)


def _shown(browser: Browser, folder: Path, thing: object, *, dark: bool = False) -> Opened:
    html = str(thing._repr_html_())  # type: ignore[attr-defined] # pyright: ignore
    path = folder / "notebook.html"
    ink, ground = ("#eeeeee", "#111111") if dark else ("#111111", "#ffffff")
    path.write_text(NOTEBOOK.format(ink=ink, ground=ground, shown=html), "utf-8")
    return opened(browser, path, 900, dark=dark)


def _frame(view: Opened) -> Frame:
    (frame,) = view.page.main_frame.child_frames
    frame.locator("#clock").wait_for(timeout=PATIENCE * 1000)
    return frame


def test_the_top_and_the_replay_stand_in_the_frame(
    browser: Browser, tmp_path: Path, found: vrts.Assessment
) -> None:
    view = _shown(browser, tmp_path, found)
    frame = _frame(view)
    assert "7.0" in frame.inner_text(".first-screen")
    for _ in range(round(PATIENCE * 20)):
        if frame.evaluate("window.vrts !== undefined"):
            break
        view.page.wait_for_timeout(50)
    frame.evaluate("vrts.player.playing = false; vrts.player.seek(4.9)")
    assert frame.inner_text("#clock").strip().startswith("4.9")
    assert "can1 touches base1" in frame.inner_text("#overlay")
    assert view.page.evaluate("window.vrts === undefined")
    assert not [one for one in view.requests if one.startswith("http")]
    assert view.complaints() == []


def test_links_scroll_the_frame_and_leave_the_notebook_where_it_is(
    browser: Browser, tmp_path: Path, found: vrts.Assessment
) -> None:
    view = _shown(browser, tmp_path, found)
    frame = _frame(view)
    dead = "[...document.querySelectorAll('a')].filter((a) => a.hash"
    dead += " && !document.getElementById(a.hash.slice(1))).length"
    assert frame.locator(".dot").count() > 0
    assert frame.evaluate(dead) == 0
    frame.locator('a[href="#L10"]').first.click()
    seen = "(box => box !== undefined && box.top >= 0 && box.bottom <= innerHeight)"
    seen += "(document.getElementById('L10')?.getBoundingClientRect())"
    for _ in range(round(PATIENCE * 20)):
        if frame.evaluate(seen):
            break
        view.page.wait_for_timeout(50)
    assert frame.evaluate(seen)
    assert frame.url == "about:srcdoc"
    assert "7.0" in frame.inner_text(".first-screen")
    assert view.complaints() == []


class _Beside:
    """A drawing of a scene beside what is the notebook's own."""

    def _repr_html_(self) -> str:
        drawing = str(vrts.scene("cans-on-bases")._repr_html_())  # pyright: ignore
        own = '<p class="title" id="head">a</p><svg><text id="own" class="name">b</text></svg>'
        return drawing + own


def test_a_drawing_restyles_nothing_of_the_notebook(browser: Browser, tmp_path: Path) -> None:
    page = _shown(browser, tmp_path, _Beside()).page
    look = "e => [getComputedStyle(e).fontSize, getComputedStyle(e).fontWeight]"
    drawn = page.locator(".vrts-scene > .title")
    assert drawn.evaluate(look) == ["32px", "700"]
    assert page.locator("#head").evaluate(look) == ["16px", "400"]
    assert page.locator("#own").evaluate(look) == ["16px", "400"]
    assert page.locator("#own").evaluate("e => getComputedStyle(e).fill") == "rgb(0, 0, 0)"


@pytest.mark.parametrize("dark", [False, True], ids=["light", "dark"])
def test_curves_stand_out_on_light_and_on_dark(
    browser: Browser, tmp_path: Path, found: vrts.Assessment, *, dark: bool
) -> None:
    view = _shown(browser, tmp_path, found.run, dark=dark)
    color = "e => getComputedStyle(e).fill"
    ink = view.page.locator(".vrts-run .tick").first.evaluate(color)
    assert ink == ("rgb(238, 238, 238)" if dark else "rgb(17, 17, 17)")
    ground = 17 if dark else 255
    for k in range(6):
        line = view.page.locator(f".vrts-run polyline.s{k}").first
        red, green, blue = _numbers(line.evaluate("e => getComputedStyle(e).stroke"))
        assert max(abs(part - ground) for part in (red, green, blue)) > 100
    assert view.page.locator(".vrts-run svg").count() == 2
    assert view.complaints() == []


def _numbers(color: str) -> list[int]:
    return [int(part) for part in color.removeprefix("rgb(").rstrip(")").split(",")]
