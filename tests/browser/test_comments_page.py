"""What graders say stands on the replay of a report: marks, notes and words at lines."""

from collections.abc import Iterator
from itertools import pairwise

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import PIXEL, Opened, clock, opened, until
from tests.support_runs import CONTACT_S, END_S, assessment
from vrts.marking.renewing.section import with_section
from vrts.marking.row import Decided, Given, Told
from vrts.report.page.page import page

pytestmark = pytest.mark.browser

EVIL = "Look at <img src=x onerror=alert(1)> &amp; the fingers\nand come down later"
LONG = "You leave the arm here, as far as I can see, over the second base. " * 6
DECIDED = Decided(
    comments=(
        Told(EVIL, "R. <b>Huber</b>", 2, CONTACT_S[0]),
        Told("Slow.", "A. Lind", None, 0.3),
        Told("A good name.", "A. Lind", 3),
        Told(LONG, "A. Lind", None, END_S),
        Told("About all of it.", "A. Lind"),
        Told("About no line of it.", "A. Lind", 4000),
    ),
    items=(Given("x", "Approach missing", "-1/2", "A. Lind", ((3, CONTACT_S[0] + 0.05),)),),
)
MARKS = ".told button"
NOTES = "[...document.querySelectorAll('.noted .note p:first-child')].map(one => one.innerText)"


@pytest.fixture(scope="module")
def view(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Opened]:
    path = tmp_path_factory.mktemp("comments") / "report.html"
    text = page(assessment(), {"moment": PIXEL}).encode()
    path.write_bytes(with_section(text, DECIDED, staff=False))
    view = opened(browser, path, still=True)
    until(view, "window.vrts !== undefined && document.querySelector('.told button')")
    yield view
    assert view.complaints() == []
    view.page.close()


def seek(view: Opened, t: float) -> list[str]:
    """Show a time, and return what its notes say."""
    view.page.evaluate("t => { vrts.player.playing = false; vrts.player.seek(t); }", t)
    return view.page.evaluate(NOTES)


@pytest.mark.thorough
def test_marks_stand_at_their_moments_and_lead_there_by_keyboard(view: Opened) -> None:
    assert seek(view, 0.0) == []
    marks = view.page.locator(MARKS)
    titles = [marks.nth(k).get_attribute("title") for k in range(marks.count())]
    assert [(title or "").split(":")[0] for title in titles] == ["0.3 s", "1.2 s", f"{END_S:.1f} s"]
    first = "1.2 s: Look at <img src=x onerror=alert(1)> &amp; the fingers and …"
    assert titles[1] == f"{first}\n1.3 s: Approach missing"  # too near for marks of their own
    assert marks.nth(1).inner_text() == "2"
    assert (titles[2] or "").endswith("…")
    assert len(titles[2] or "") < 80
    view.page.focus("#time")
    view.page.keyboard.press("Tab")
    view.page.keyboard.press("Tab")
    assert view.page.evaluate("document.activeElement.title") == titles[1]
    view.page.keyboard.press("Enter")
    assert clock(view) == pytest.approx(CONTACT_S[0])
    assert view.page.evaluate(NOTES) == [EVIL]
    assert view.page.get_attribute(f"{MARKS}[aria-current]", "title") == titles[1]
    view.page.keyboard.press("Enter")  # the same mark again: what else it stands for
    assert view.page.evaluate(NOTES) == ["−0.5  Approach missing"]
    view.page.keyboard.press("Enter")
    assert clock(view) == pytest.approx(CONTACT_S[0])


def test_a_note_stays_until_it_can_be_read_forward_and_backward(view: Opened) -> None:
    assert seek(view, 0.2) == []
    assert seek(view, 0.31) == ["Slow."]
    assert seek(view, 1.1) == ["Slow."]
    assert seek(view, END_S - 0.02) == ["−0.5  Approach missing", LONG.strip()]
    view.page.evaluate("vrts.player.direction = -1")
    assert seek(view, 1.0) == [EVIL, "−0.5  Approach missing"]  # the nearest of those passed
    assert seek(view, 0.2)[0] == "Slow."
    view.page.evaluate("vrts.player.direction = 1")


def test_words_stand_at_their_line_and_in_the_list_and_are_text(view: Opened) -> None:
    assert view.page.locator("#L2 .said p").first.inner_text() == EVIL
    assert view.page.locator("#L2 .who").inner_text() == "R. <b>Huber</b> 1.2 s"
    assert view.page.locator("#L3 .said").count() == 2  # a comment and a rubric item
    assert view.page.locator("#source .said").count() == 3
    assert view.page.locator("#events .comment").count() == 4
    seek(view, 0.0)
    view.page.keyboard.press(".")
    assert clock(view) == pytest.approx(0.3)
    view.page.click("#L2 .said button")
    assert clock(view) == pytest.approx(CONTACT_S[0])
    assert view.page.locator("main img[src=x]").count() == 0
    assert view.page.locator("#graders li").count() == 7  # all of it, also without a place


@pytest.mark.thorough
def test_there_is_room_on_a_phone_and_axe_finds_nothing(view: Opened) -> None:
    view.page.evaluate(AXE)
    seek(view, END_S)
    assert faults(view, 1280, dark=False) == []
    assert faults(view, 390, dark=True) == []
    note, picture = (view.page.locator(one).bounding_box() for one in (".below", ".view"))
    assert note is not None
    assert picture is not None
    assert note["height"] < picture["height"] * 0.55
    boxes = [one.bounding_box() for one in view.page.locator(MARKS).all()]
    lefts = sorted(box["x"] for box in boxes if box)
    assert all(b - a >= 24 for a, b in pairwise(lefts))
