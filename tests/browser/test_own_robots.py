"""A robot of one's own in two browsers: a hand goes up, the teacher comes, helps, and goes."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import Opened
from tests.browser.support_sessions import SHOWN, Desk, desk, supervisor
from tests.support_course import came_in, course_folder
from tests.support_live import LiveServer

pytestmark = [pytest.mark.browser, pytest.mark.live]

SLOTS = """
[slots]
time_zone = "Europe/Berlin"
days = ["mon", "tue", "wed", "thu", "fri", "sat", "sun"]
"""
SEEN = os.environ.get("VRTS_SEEN", "")  # folder for pictures to look at


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("own")
    course = course_folder(folder / "course", more=SLOTS)
    with LiveServer(folder / "live", scenes=(str(course),)) as server:
        yield server


def logged_in(browser: Browser, server: LiveServer, cookie: str, *, dark: bool = False) -> Desk:
    """Open the page as somebody who has come in."""
    opened = desk(browser, server, width=1366, dark=dark, drawn=bool(SEEN))
    parts = [part.split("=", 1) for part in cookie.split("; ")]
    url = f"http://{server.host}"
    opened.context.add_cookies([{"name": n, "value": v, "url": url} for n, v in parts])
    opened.page.goto(url)
    opened.until(SHOWN)
    return opened


def picture(one: Desk, name: str) -> None:
    """Keep a picture for somebody to look at."""
    if SEEN:
        one.page.screenshot(path=str(Path(SEEN) / f"{name}.png"))


def test_a_hand_brings_the_teacher_in_who_takes_control_and_gives_it_back(
    browser: Browser, server: LiveServer
) -> None:
    student = logged_in(browser, server, came_in(server, "Cy Dahl"))
    student.page.click("#tab-own")
    slot = student.page.locator(".slots details[open] button:text('Book')").last
    slot.click()
    student.until("document.querySelectorAll('.slots .tag').length === 1")
    picture(student, "student-slots")
    student.page.click("#panel-own button:text('Open')")
    student.until("vrts.store.now.room?.own === 'Cy Dahl' && vrts.store.operator")
    student.until("vrts.store.now.alive")
    lead = supervisor(browser, server, width=1366, dark=True, drawn=bool(SEEN))
    lead.page.click("#tab-own")
    student.page.fill("#hand-text", "the hand does not close")
    student.page.click("button:text('Raise hand')")
    student.until("document.getElementById('panel-own').textContent.includes('1st in the queue')")
    lead.until("document.getElementById('hands-button')?.textContent.includes('Cy Dahl')")
    asks = "document.querySelector('#panel-own .asks')?.textContent"
    lead.until(f"{asks} === 'the hand does not close'")
    picture(lead, "lead-hand")
    lead.page.click("#hands-button")
    lead.until("vrts.store.now.room?.own === 'Cy Dahl' && vrts.store.now.alive")
    sign = "document.querySelector('.own-bar.looked-at:not([hidden]) .own-who')?.textContent"
    student.until(f"{sign} === 'supervisor looks in'")
    assert student.page.get_attribute(".own-who", "role") == "alert"
    picture(student, "student-looked-at")
    lead.page.click(".own-bar button:text('Take control')")
    lead.until("vrts.store.operator")
    student.until(f"{sign} === 'supervisor looks in and has control'")
    thing = str(lead.value("[...vrts.world.viewer.bodies.keys()][0]"))
    lead.page.evaluate(f"vrts.connection.send('point', {{ body: {thing!r} }})")
    points = "document.querySelector('.own-points').textContent"
    student.until(f"{points} === 'supervisor points at {thing}'")
    for one in (student, lead):
        one.page.evaluate(AXE)
        assert faults(Opened(one.page), 1366, dark=one is lead) == []
    picture(student, "student-pointed")
    picture(lead, "lead-inside")
    lead.page.click(".own-bar button:text('Give control to Cy Dahl')")
    student.until("vrts.store.operator")
    lead.until("!vrts.store.operator")
    lead.page.click("button:text('Helped: hand down')")
    student.until("vrts.store.now.hands.hands.length === 0")
    lead.page.click(".own-bar button:text('Leave')")
    lead.until("!vrts.store.now.room?.own")
    student.until("document.querySelector('.own-bar').hidden")
    for one in (student, lead):
        assert one.complaints() == []
        one.context.close()
