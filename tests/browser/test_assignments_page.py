"""A student's assignments in a real browser: read, hand in, see mark and why; axe."""

import os
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import PATIENCE, Opened
from tests.support_commands import vrts_text
from tests.support_handing import (
    EXAMPLE,
    PASSWORD,
    STUDENTS,
    course_folder,
    enrol,
    log_in,
)
from tests.support_live import LiveServer
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Comment
from vrts.marking.layout import Layout
from vrts.marking.row import class_from_bytes

pytestmark = pytest.mark.browser

WIDE, PHONE = 1366, 390
LATE = "[late]\ndue = 2026-11-20T12:00:00+01:00\nper_day = 1\nmost = 3\n"


@pytest.fixture
def work(browser: Browser, tmp_path: Path) -> Iterator[tuple[Opened, LiveServer]]:
    """Open the assignments of a course as a student of it."""
    kept = tmp_path / "kept"
    course = course_folder(tmp_path / "course", "attempts = 3\n", LATE)
    enrol(kept, password=PASSWORD)
    with LiveServer(kept, scenes=(str(course),)) as server:
        context = browser.new_context(viewport={"width": WIDE, "height": 900})
        context.add_init_script(AXE)
        for cookie in log_in(server, STUDENTS[0][0]).split("; "):
            name, _, value = cookie.partition("=")
            context.add_cookies([{"name": name, "value": value, "url": f"http://{server.host}"}])
        view = Opened(context.new_page())
        view.page.set_default_timeout(2 * PATIENCE * 1000)
        view.page.on("console", lambda message: view.messages.append(message.text))
        view.page.on("pageerror", lambda error: view.messages.append(str(error)))
        view.page.goto(f"http://{server.host}/course/work")
        view.page.wait_for_selector("#work-title")
        yield view, server
        context.close()


@pytest.mark.thorough
def test_a_student_hands_in_sees_why_and_reads_what_graders_say(
    work: tuple[Opened, LiveServer],
) -> None:
    view, server = work
    page = view.page
    assert page.inner_text("#work-title") == "Cans on bases"
    assert "the deadline is over" in page.inner_text(".facts")
    page.wait_for_selector(".words h3")
    page.set_input_files("#work-file", EXAMPLE / "submissions" / "hits-base.v2")
    page.click("text=Hand in …")
    question = page.inner_text("#hand-in-what")
    assert "becomes attempt 1 of 3" in question
    assert "late: 3 points less" in question
    page.click("dialog .main")
    page.wait_for_selector(".attempt .mark")
    assert page.inner_text(".attempt .mark") == "7.0 of 10.0"
    assert "7.0 of 10.0, attempt 1" in page.inner_text(".facts")
    page.click(".losses summary")
    assert "can1 is 59 mm too low" in page.inner_text(".losses ol")
    for dark in (False, True):
        assert faults(view, WIDE, dark=dark) == []
        _picture(view, f"work-{'dark' if dark else 'light'}")
    assert faults(view, PHONE, dark=False) == []
    _picture(view, "work-phone")
    with page.context.expect_page() as opened:
        page.click("text=Report and replay")
    report = opened.value
    report.wait_for_selector("canvas")
    assert "hits base1" in report.inner_text("body")
    _publish(server.folder.parent)
    page.reload()
    page.wait_for_selector(".final")
    assert page.inner_text("#work-final") == "Final mark: 4.0 of 10"
    assert "line 11, 4.90 s: look at the height" in page.inner_text(".final")
    assert faults(view, WIDE, dark=True) == []
    _picture(view, "work-final")
    with page.context.expect_page() as opened:
        page.click("text=Report with comments")
    final = opened.value
    final.wait_for_selector("canvas")
    assert "look at the height" in final.inner_text("body")
    assert view.messages == []
    page.click("text=Work on it with my robot")
    page.wait_for_url("**/?room=*")
    page.wait_for_selector("#room")


def _publish(home: Path) -> None:
    """Mark, comment on a line and a moment, and publish, as a teacher does."""
    course, out = str(home / "course"), home / "out"
    assert vrts_text("course", "mark", course, "cans", "-o", str(out)).returncode == 0
    rows = class_from_bytes(Layout(out).results.read_bytes()).rows
    cy = next(one.id for one in rows if one.student.email == STUDENTS[0][1])
    said = Comment(0, "", cy, "look at the height", 11, 4.9)
    add_decisions(Layout(out).decisions, "R. Huber", (said,), datetime(2026, 12, 1, tzinfo=UTC))
    assert vrts_text("course", "publish", course, "cans", str(out)).returncode == 0


def _picture(view: Opened, name: str) -> None:
    folder = os.environ.get("VRTS_PICTURES")
    if folder:
        view.page.screenshot(path=f"{folder}/{name}.png")
