"""Pages for everybody: axe-core's rules, keyboard, reduced motion, phones and paper."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import PIXEL, Opened, clock, opened, until
from tests.support_reports import broken
from tests.support_rows import some_class
from tests.support_runs import CONTACT_S
from tests.unit.marking.similarity.support import ORIGINAL
from tests.unit.report.test_audience import disputed
from vrts.marking.overview.page import overview_page
from vrts.marking.similarity.evidence import Evidence
from vrts.marking.similarity.groups import Group, Link
from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.pair_page import Side, pair_page
from vrts.marking.similarity.ranking import similarity
from vrts.report.audience import Audience
from vrts.report.page.page import page
from vrts.report.page.stills import contact_name

pytestmark = pytest.mark.browser

PHONE = 390  # [px]


def a_pair() -> str:
    """Return the page of two programs that share something."""
    link = Link("anna", "ben", 0.9, "strong")
    evidence = (Evidence("motion", "the tool stops at the same point", 3.2, 0, 2, 3),)
    group = Group(("anna", "ben", "cara"), 0.9, "strong", 0.01, (link,), evidence)
    sides = (
        Side("anna", "Anna", ORIGINAL.encode(), "data:text/html,<title>Replay</title>"),
        Side("ben", "Ben", ORIGINAL.encode(), None),
    )
    return pair_page(link, group, evidence, sides, "Group 3")


def write(folder: Path, name: str) -> Path:
    """Write one of the pages that vrts makes."""
    a = disputed()
    stills = {"moment": PIXEL, contact_name(0): PIXEL}
    programs = {name: ORIGINAL.encode() for name in ("anna", "ben")}
    texts = {
        "student": lambda: page(a, stills, more=2),
        "grader": lambda: page(a, {"moment": PIXEL}, audience=Audience.GRADER),
        "broken": lambda: page(broken(), {}),
        "overview": lambda: overview_page(some_class(20), similarity="similarity.html"),
        "similarity": lambda: similarity_page(similarity(programs), programs, "Group 3"),
        "pair": a_pair,
    }
    path = folder / f"{name}.html"
    path.write_text(texts[name](), encoding="utf-8")
    return path


ESSENTIAL = [(1280, False), (PHONE, True)]
ALL_LOOKS = [(width, dark) for width in (1280, PHONE) for dark in (False, True)]
# a student's page is a part of a grader's
PAGES = ("student", "grader", "broken", "overview", "similarity", "pair")


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "looks"),
    [
        *(pytest.param(name, ESSENTIAL, id=name) for name in PAGES if name != "student"),
        *(
            pytest.param(name, ALL_LOOKS, id=f"{name} every look", marks=pytest.mark.thorough)
            for name in PAGES
        ),
    ],
)
def test_axe_finds_nothing(
    browser: Browser, tmp_path: Path, name: str, looks: list[tuple[int, bool]]
) -> None:
    """Every rule that there is, also those of level AAA and those on trial.

    The page is loaded once for wide and narrow, light and dark.
    """
    view = opened(browser, write(tmp_path, name), looks[0][0], dark=looks[0][1])
    if name in ("student", "grader"):
        until(view, "window.vrts !== undefined")
    view.page.evaluate(AXE)
    for width, dark in looks:
        assert faults(view, width, dark=dark) == [], (width, dark)
    view.page.close()


@pytest.fixture(scope="module")
def report(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Opened:
    path = write(tmp_path_factory.mktemp("report"), "grader")
    view = opened(browser, path, still=True, drawn=True)
    until(view, "window.vrts !== undefined")
    return view


@pytest.mark.thorough
def test_every_control_can_be_reached_and_shows_that_it_is(report: Opened) -> None:
    report.page.evaluate("document.activeElement.blur()")
    reached: set[str] = set()
    for _ in range(80):
        report.page.keyboard.press("Tab")
        name, outline = report.page.evaluate(
            """() => { const e = document.activeElement;
                return [e.id || e.dataset.look || e.dataset.turn || e.dataset.zoom || e.className
                    || e.tagName, getComputedStyle(e).outlineStyle]; }"""
        )
        if name == "BODY":
            break
        assert outline != "none", name
        reached.add(name)
    looks = {"overview", "table", "front", "side", "top", "hand", "1", "-1", "0.8", "1.25"}
    controls = {"time", "event-before", "backward", "forward", "event-after", "speed"}
    assert looks | controls | {"show-trace", "show-goals", "seek", "source"} <= reached


@pytest.mark.thorough
def test_the_keyboard_works_wherever_the_focus_is(report: Opened) -> None:
    for focus in ("#time", "#forward", "#show-trace", "button.seek", "#events button"):
        report.page.focus(focus)
        report.page.keyboard.press("Home")
        assert clock(report) == 0.0, focus
        report.page.keyboard.press("ArrowRight")
        assert clock(report) == pytest.approx(0.1), focus
    report.page.select_option("#speed", "0.1")  # else it may have ended by itself on a busy machine
    report.page.focus("#forward")
    report.page.keyboard.press("Space")
    assert report.page.evaluate("vrts.player.playing")
    assert report.page.get_attribute("#forward", "aria-label") == "Pause"
    report.page.keyboard.press("Space")
    assert not report.page.evaluate("vrts.player.playing")
    report.page.select_option("#speed", "1")


@pytest.mark.thorough
def test_up_and_down_go_through_the_events_of_which_one_is_a_tab_stop(report: Opened) -> None:
    rows = report.page.locator("#events tr").all_inner_texts()
    assert report.page.locator("#events button:not([tabindex])").count() == 1
    first = report.page.locator("#events button").first
    first.focus()
    first.press("Enter")
    assert clock(report) == 0.0
    for _ in rows:
        report.page.keyboard.press("ArrowDown")
    assert "program over" in report.page.inner_text("#events .now")
    assert report.page.evaluate("document.activeElement.closest('tr').className") == ("program now")
    assert report.page.locator("#events button:not([tabindex])").count() == 1
    facts = report.page.inner_text("#events .contact small")
    assert facts == "until 1.600 s · deepest at 1.400 s · at 950, −100, −160 mm · holding can1"


def test_reduced_motion_shows_a_moment_without_playing(report: Opened) -> None:
    report.page.evaluate("scrollTo(0, 0)")
    report.page.click("figure.moment button.seek")
    assert clock(report) == pytest.approx(CONTACT_S[0], abs=1e-3)
    assert not report.page.evaluate("vrts.player.playing")


@pytest.mark.thorough
def test_the_view_turns_and_comes_nearer_without_a_mouse(report: Opened) -> None:
    eye = "vrts.viewer.camera.position.distanceTo(vrts.viewer.controls.target)"
    report.page.click("[data-look=overview]")
    away: float = report.page.evaluate(eye)
    report.page.click("[data-zoom='0.8']")
    assert report.page.evaluate(eye) == pytest.approx(0.8 * away, rel=1e-3)
    before: list[float] = report.page.evaluate("vrts.viewer.camera.position.toArray()")
    report.page.click("[data-turn='1']")
    assert report.page.evaluate("vrts.viewer.camera.position.toArray()") != before
    assert report.page.evaluate(eye) == pytest.approx(0.8 * away, rel=1e-3)


def test_a_contact_without_a_still_is_drawn_by_the_viewer(report: Opened) -> None:
    assert report.page.locator("canvas[data-contact='0']").is_visible()
    colours: int = report.page.evaluate(
        """() => { const c = document.querySelector("canvas[data-contact]");
            const d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data;
            return new Set(new Uint32Array(d.buffer)).size; }"""
    )
    assert colours > 100


def test_paper_has_everything_but_what_is_to_be_pressed(report: Opened) -> None:
    report.page.emulate_media(media="print")
    shown = report.page.locator("button:visible").all()
    assert all(button.evaluate("e => e.closest('#events') !== null") for button in shown)
    for gone in (".view", ".controls", "nav", ".status", "button.seek"):
        assert not report.page.locator(gone).first.is_visible(), gone
    for kept in (
        "img.still",
        ".lanes",
        "#source",
        "#events",
        ".card",
        ".chart",
        "#model",
        "#facts",
    ):
        assert report.page.locator(kept).first.is_visible(), kept
    assert (
        report.page.evaluate("getComputedStyle(document.querySelector('#events-scroll')).maxHeight")
        == "none"
    )
    assert report.page.pdf().startswith(b"%PDF")
    report.page.emulate_media(media="screen")
