"""Entering by account, one's own colours and frame rate, and teaching alone."""

import math
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, SHOWN, Desk, desk, supervisor
from tests.support_live import LiveServer
from tests.unit.live.test_teaching import Teaching
from vrts.live.new_account import add_user

pytestmark = pytest.mark.browser
PASSWORD = "correct horse"
DARK = "getComputedStyle(document.body).backgroundColor === 'rgb(17, 19, 23)'"


@pytest.fixture(scope="module")
def teaching(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Teaching]:
    server = Teaching(tmp_path_factory.mktemp("teaching"))
    with server:
        yield server


@pytest.fixture(scope="module")
def teacher(browser: Browser, teaching: Teaching) -> Iterator[Desk]:
    opened = supervisor(browser, teaching)
    opened.until("vrts.store.operator")
    yield opened
    assert opened.complaints() == []
    opened.context.close()


@pytest.mark.thorough
def test_an_account_lets_in_and_logging_out_lets_nobody_in(
    browser: Browser, tmp_path_factory: pytest.TempPathFactory
) -> None:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        add_user(server.folder, "Carla", PASSWORD, supervisor=False)
        view = desk(browser, server)
        view.until("!document.getElementById('enter').hidden")
        view.page.click("summary")
        for password in ("wrong", PASSWORD):
            view.page.fill("[name=user]", "Carla")
            view.page.fill("[name=password]", password)
            view.page.click("#login-form button")
            if password != PASSWORD:
                view.until("document.getElementById('enter-problem').textContent.includes('wrong')")
        view.until(SHOWN)
        view.page.click("#settings-button")
        view.page.click("#log-out", no_wait_after=True)
        view.until("!document.getElementById('enter').hidden")
        view.context.close()


@pytest.mark.thorough
def test_colours_and_frame_rate_are_ones_own_and_stay(teacher: Desk) -> None:
    assert not teacher.value(DARK)
    teacher.page.click("#settings-button")
    teacher.page.click("[data-theme=dark]")
    assert teacher.value(DARK)
    assert teacher.value("vrts.world.viewer.theme") == "dark"
    teacher.page.fill("#rate-wanted", "5")
    teacher.page.keyboard.press("Escape")
    teacher.until("/^[3-7] frames/.test(document.getElementById('rate').textContent)")
    teacher.page.reload()
    teacher.until(SHOWN)
    assert teacher.value(DARK)
    assert teacher.value("vrts.connection.rate") == 5
    teacher.page.click("#settings-button")
    teacher.page.click("[data-theme=system]")
    assert not teacher.value(DARK)
    teacher.page.fill("#rate-wanted", "50")
    teacher.page.keyboard.press("Escape")


@pytest.mark.thorough
def test_points_are_taught_and_time_goes_back(teacher: Desk, teaching: Teaching) -> None:
    teacher.page.click("#tab-pendant")
    teacher.page.fill("#record-name", "p1")
    teacher.page.click("button:text('Record')")
    teacher.until("document.getElementById('record-name').value === 'p2'")
    before = float(teacher.value("vrts.store.now.status.time_s"))
    teacher.page.click("[aria-label='Joint 1 plus']")
    teacher.until("Math.abs(vrts.world.state.q[0] * 180 / Math.PI - 5) < 0.01")
    teacher.until(IDLE)  # nearly there is still on the way
    assert teacher.rests()
    teacher.page.click("button:text('Record')")
    teacher.until("document.getElementById('record-name').value === 'p3'")
    for name in ("chat", "people", "lead"):
        assert teacher.page.locator(f"#tab-{name}").is_hidden(), "nobody else comes"
    assert teacher.page.locator("#control-button").is_hidden()
    names = [row.split()[0] for row in teaching.output.read_text().splitlines()]
    assert names == [".LOCATIONS", "p1", "p2", ".END"]

    teacher.page.click("#tab-history")
    teacher.page.fill("#rewind-time", f"{math.floor(before * 10) / 10:.1f}")
    teacher.page.click("button:text('Rewind')")
    teacher.until("Math.abs(vrts.world.state.q[0]) < 1e-5")
    teacher.page.click("#tab-pendant")
    teacher.page.click("[aria-label='Joint 2 plus']")
    teacher.until("Math.abs(vrts.world.state.q[1] * 180 / Math.PI + 85) < 0.01")
    teacher.page.click("#tab-history")
    teacher.page.click("button:text('Reset the scene')")
    teacher.until("Math.abs(vrts.world.state.q[1] * 180 / Math.PI + 90) < 1e-3")
