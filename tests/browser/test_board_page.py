"""The board in a real browser: narrowed by a cause, told by itself, hostile names, axe."""

from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import PATIENCE, Opened
from tests.support_board import NOON, fill, write_course
from tests.support_live import LiveServer
from vrts.live.settings import DATABASE
from vrts.live.store.course.attempts import Attempt, Loss, add_attempt, keep_mark
from vrts.live.store.database import opened

pytestmark = pytest.mark.browser

WIDE, PHONE = 1366, 390
EVIL = "<img src=x onerror=alert(1)> drops `<b>can1</b>`"


@pytest.fixture
def board(browser: Browser, tmp_path: Path) -> Iterator[tuple[Opened, Path, list[int]]]:
    """Open the board of a class as somebody who teaches it."""
    kept = tmp_path / "kept"
    students = fill(kept, 12, 3)
    with closing(opened(kept / DATABASE)) as connection:
        connection.execute("UPDATE account SET name='<i>Eve</i>' WHERE id=?", (students[3],))
    with LiveServer(kept, scenes=(str(write_course(tmp_path / "course", 3)),)) as server:
        context = browser.new_context(viewport={"width": WIDE, "height": 900})
        context.add_init_script(AXE)
        for cookie in server.supervisor().split("; "):
            name, _, value = cookie.partition("=")
            context.add_cookies([{"name": name, "value": value, "url": f"http://{server.host}"}])
        view = Opened(context.new_page())
        view.page.set_default_timeout(PATIENCE * 1000)
        view.page.on("console", lambda message: view.messages.append(message.text))
        view.page.on("pageerror", lambda error: view.messages.append(str(error)))
        view.page.goto(f"http://{server.host}/course/board")
        view.page.wait_for_selector("#marks tbody tr")
        yield view, kept, students
        context.close()


def hand_in(kept: Path, account: int, mark: str, *losses: Loss) -> None:
    with closing(opened(kept / DATABASE)) as connection:
        number = add_attempt(connection, account, "pick-1", NOON + 9e7, account, "d")
        told = Attempt(account, "pick-1", number, 0.0, None, "d", "marked", mark, "10", "", losses)
        keep_mark(connection, told)


@pytest.mark.thorough
def test_the_board_shows_what_holds_people_up(board: tuple[Opened, Path, list[int]]) -> None:
    view, kept, students = board
    page = view.page
    rows = page.locator("#marks tbody tr")
    assert rows.count() == len(students)
    page.select_option("#assignment", "pick-1")
    cause = page.locator("#causes button").first
    many = int(cause.locator(".soft").inner_text().split()[0])
    cause.click()
    assert rows.count() == many < len(students)
    page.click("#everybody")
    assert rows.count() == len(students)
    page.fill("#search", "eve")
    assert rows.locator("th").first.locator("button").inner_text() == "<i>Eve</i>"
    for _ in range(3):  # somebody hands in, and loses by the same each time
        hand_in(kept, students[3], "4", Loss(EVIL, "6"))
    page.wait_for_selector("text=stuck ×3")
    rows.locator("button").first.click()
    page.wait_for_selector("#student li")
    assert EVIL.replace("`", "") in page.locator("#student li").first.inner_text()
    assert page.locator("#student img, #student b").count() == 0
    page.keyboard.press("Escape")
    assert page.locator("#student").is_hidden()
    assert view.messages == []


@pytest.mark.thorough
def test_nothing_stands_in_the_way_of_anybody(board: tuple[Opened, Path, list[int]]) -> None:
    view, _, _ = board
    for dark in (False, True):
        assert faults(view, WIDE, dark=dark) == []
    assert faults(view, PHONE, dark=False) == []
    view.page.locator("#marks tbody button").first.click()
    view.page.wait_for_selector("#student h3, #student-work p")
    assert faults(view, PHONE, dark=True) == []


@pytest.mark.thorough
def test_a_grade_book_is_saved_or_the_page_says_why_not(
    board: tuple[Opened, Path, list[int]], tmp_path: Path
) -> None:
    view, _, _ = board
    page = view.page
    page.click("#grades-open")
    assert page.is_disabled("#grades-go")
    assert "marked/cans" in page.inner_text("#grades-why"), "nobody has said where it was marked"
    page.select_option("#grades-assignment", "pick-3")
    course = tmp_path / "course" / "course.toml"
    course.write_text(course.read_text("utf-8") + 'marked = "marked"\n', encoding="utf-8")
    page.wait_for_selector("#grades-go:enabled")
    assert not page.is_visible("#grades-said")
    page.select_option("#grades-assignment", "pick-1")
    assert page.is_disabled("#grades-go")
    page.click("#grades-close")
    page.click("#grades-open")
    assert page.input_value("#grades-assignment") == "pick-3", "the one that is marked"
    page.select_option("#grades-to", "moodle")
    page.click("#grades-go")
    assert page.inner_text("#grades-why") == "Choose the file that you exported there."
    page.select_option("#grades-to", "csv")
    page.click("#grades-go")
    page.wait_for_selector("#grades-words:not([hidden])")
    assert page.inner_text("#grades-why") == "Nothing was exported."
    assert page.inner_text("#grades-words").strip(), "nothing was marked there yet"
    for wide, dark in ((WIDE, False), (PHONE, True)):
        assert faults(view, wide, dark=dark, least=21) == []  # a dialog hides the rest
    page.keyboard.press("Escape")
    assert not page.is_visible("#grades")
