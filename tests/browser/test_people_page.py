"""The people of a course in a real browser: first entry, the list for teachers, the door, axe."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import ALL_RULES, AXE
from tests.browser.support import PATIENCE, Opened
from tests.support_course import PASSWORD, course_folder, letter
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

WIDE, PHONE = 1366, 390
LOGIN = """
[login]
issuer = "https://id.example.org"
client = "vrts"
name = "Log in with the school"
"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("people")
    course = course_folder(folder / "course", guests=False, more=LOGIN)
    (course / "roster.csv").write_text(
        "name,email,team\nCy <b>Dahl</b>,cy@example.org,\nDi Ek,di@example.org,Red\n"
    )
    with LiveServer(folder / "live", scenes=(str(course),)) as started:
        yield started


@pytest.fixture
def view(browser: Browser) -> Iterator[Opened]:
    context = browser.new_context(viewport={"width": WIDE, "height": 900})
    context.add_init_script(AXE)
    opened = Opened(context.new_page())
    opened.page.set_default_timeout(PATIENCE * 1000)
    opened.page.on("console", lambda message: opened.messages.append(message.text))
    opened.page.on("pageerror", lambda error: opened.messages.append(str(error)))
    yield opened
    context.close()


def nothing_in_the_way(view: Opened, name: str) -> None:
    for width, dark in ((WIDE, False), (PHONE, True)):
        view.page.set_viewport_size({"width": width, "height": 900})
        view.page.emulate_media(color_scheme="dark" if dark else "light")
        found = view.page.evaluate(ALL_RULES)
        assert found["passes"] > 15  # there is little on some of these pages
        assert found["violations"] == []
        assert view.page.evaluate("document.documentElement.scrollWidth") <= width
        if shots := os.environ.get("SHOTS"):
            view.page.screenshot(path=f"{shots}/{name}-{width}.png")
    view.page.set_viewport_size({"width": WIDE, "height": 900})


@pytest.mark.thorough
def test_a_teacher_comes_in_for_the_first_time_and_adds_another(
    server: LiveServer, view: Opened
) -> None:
    page, address = view.page, f"http://{server.host}"
    page.goto(address)
    page.wait_for_selector("#enter-provider:visible")
    assert page.inner_text("#enter-title") == "Robotics"
    assert page.locator("#enter-code").is_hidden()
    nothing_in_the_way(view, "door")
    assert all("401" in said for said in view.messages)  # nobody was logged in
    view.messages.clear()
    page.goto(f"{address}/course/first#{letter(server, 'Ada Lind')}")
    page.wait_for_selector("#first-form:visible")
    assert page.url == f"{address}/course/first"  # the link is not left in the address
    nothing_in_the_way(view, "first")
    page.fill("[name=password]", PASSWORD)
    page.fill("[name=again]", "something else")
    page.click("button")
    page.wait_for_selector("#first-problem:visible")
    page.fill("[name=again]", PASSWORD)
    page.click("button")
    page.wait_for_selector("#room:visible")
    page.goto(f"{address}/course/people")
    view.messages.clear()  # what graphics without a card say of themselves
    page.wait_for_selector("#people-rows tr >> nth=3")
    assert page.locator("#people-rows b").count() == 0  # names are text
    page.click("text=Board")  # and back
    page.wait_for_selector("#people:visible")
    page.click("#people")
    page.wait_for_selector("#people-rows tr >> nth=3")
    view.messages.clear()
    page.fill("#people-find", "red")
    assert page.locator("#people-rows tr").count() == 1
    page.fill("#people-find", "")
    page.fill("#people-add [name=name]", "Eva Falk")
    page.fill("#people-add [name=email]", "eva@example.org")
    page.select_option("#people-add [name=rank]", "assistant")
    page.check("#people-rooms input[value=Class]")
    page.click("#people-add button")
    page.wait_for_selector("#people-new:visible")
    link = page.input_value("#people-new-url")
    assert link.startswith(f"{address}/course/first#")
    row = page.locator("#people-rows tr", has_text="Eva Falk")
    row.wait_for()
    assert "assistant in Class" in row.inner_text()
    assert "added here" in row.inner_text()
    nothing_in_the_way(view, "people")
    code = link.partition("#")[2]
    told = server.request("POST", "/course/letter", {"code": code}).json
    assert told["name"] == "Eva Falk"
    row.get_by_role("button", name="End for Eva Falk").click()
    page.locator("#people-rows tr.away", has_text="Eva Falk").wait_for()
    assert server.request("POST", "/course/letter", {"code": code}).status == 403
    assert view.messages == []


@pytest.mark.thorough
def test_a_log_in_that_does_not_answer_says_so(server: LiveServer, view: Opened) -> None:
    view.page.goto(f"http://{server.host}/course/login/back")
    view.page.wait_for_selector("h1")
    assert "has not begun to log in" in view.page.inner_text("main")
    nothing_in_the_way(view, "refused")


def test_a_link_that_is_not_whole_says_so(server: LiveServer, view: Opened, tmp_path: Path) -> None:
    view.page.goto(f"http://{server.host}/course/first#half")
    view.page.wait_for_selector("#first-problem:visible")
    assert "not whole" in view.page.inner_text("#first-problem")
