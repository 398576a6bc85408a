"""A student hands in from the live room, then from the shelf of files, and sees the marks."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support import PATIENCE
from tests.browser.support_sessions import SHOWN, Desk, desk
from tests.support_handing import PASSWORD, STUDENTS, course_folder, enrol, example, log_in
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

TEXT = "editing.view.state.doc.toString()"


@pytest.fixture
def student(browser: Browser, tmp_path: Path) -> Iterator[tuple[Desk, str]]:
    """Come into the room of a course as a student of it."""
    kept = tmp_path / "kept"
    course = course_folder(tmp_path / "course", "attempts = 3\n")
    enrol(kept, password=PASSWORD)
    with LiveServer(kept, scenes=(str(course),)) as server:
        address = f"http://{server.host}"
        one = desk(browser, server, width=1366)
        for cookie in log_in(server, STUDENTS[0][0]).split("; "):
            name, _, value = cookie.partition("=")
            one.context.add_cookies([{"name": name, "value": value, "url": address}])
        one.page.goto(address)
        one.until(SHOWN)
        yield one, address
        one.context.close()


def in_the_editor(one: Desk, text: str) -> None:
    """Put a text over what is in the editor, as somebody pastes it."""
    one.page.click(".cm-content")
    one.page.keyboard.press("ControlOrMeta+a")
    one.page.keyboard.insert_text(text)
    one.until(f"{TEXT} === {text!r}")


@pytest.mark.thorough
def test_what_is_handed_in_from_the_room_and_the_shelf_has_its_mark_on_the_page(
    student: tuple[Desk, str],
) -> None:
    one, address = student
    page = one.page
    page.click("#tab-editor")
    one.until("window.editing !== undefined")
    in_the_editor(one, example("hits-base"))
    hand = ".bench button:text-is('Hand in …')"
    page.click(hand)
    assert "becomes attempt 1 of 3. You are on time." in page.inner_text("#hand-in-what")
    page.click("dialog[open] button:text-is('Not now')")  # nothing happens
    page.click(hand)
    assert "becomes attempt 1 of 3" in page.inner_text("#hand-in-what")
    page.click("dialog[open] button:text-is('Hand in')")
    toasts = "document.getElementById('toasts').textContent"
    one.until(f"{toasts}.includes('Handed in: attempt 1 at Cans on bases')")
    page.click(hand)  # the same once more costs no attempt
    page.click("dialog[open] button:text-is('Hand in')")
    one.until(f"{toasts}.includes('the same program as attempt 1')")

    in_the_editor(one, example("solution"))
    page.fill(".bench input[aria-label=Name]", "better")
    page.click(".bench button:text-is('Save')")
    one.until("document.querySelector('.told').textContent.startsWith('saved, version 1')")

    page.goto(f"{address}/course/work")
    attempts = page.locator(".attempt")
    page.set_default_timeout(2 * PATIENCE * 1000)
    page.wait_for_selector(".attempt .mark")
    assert attempts.count() == 1
    assert attempts.locator(".mark").inner_text() == "7.0 of 10.0"
    assert "2 of 3 left" in page.inner_text(".facts")

    page.select_option("select[aria-label='Program of mine']", label="better (version 1)")
    page.click("text=Hand in …")
    assert "better becomes attempt 2 of 3" in page.inner_text("#hand-in-what")
    page.click("dialog[open] button:text-is('Hand in')")
    attempts.nth(1).wait_for()
    page.wait_for_selector(".attempt .mark >> nth=1")
    assert attempts.locator(".mark").all_inner_texts() == ["10.0 of 10.0", "7.0 of 10.0"]
    assert one.complaints() == []
