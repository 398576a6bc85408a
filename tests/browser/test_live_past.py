"""The past of a room in real browsers: one looks back and goes on from there, the other sees on."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, Desk, student
from tests.support_live import LiveServer

pytestmark = [pytest.mark.browser, pytest.mark.thorough]

AT = "document.getElementById('past-clock').textContent"
LOOKS_BACK = "document.body.classList.contains('looks-back')"
JOINT = "vrts.world.state.q[0] * 180 / Math.PI"
LIVE = f"!{LOOKS_BACK} && {AT}.endsWith('live')"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        yield server


def turned(degrees: float) -> str:
    """Return the condition that joint 1 is shown at an angle."""
    return f"Boolean(vrts.world.state && Math.abs({JOINT} - {degrees}) < 0.01)"


def focus(desk: Desk) -> None:
    """Lead the keys to the slider."""
    desk.page.evaluate("document.getElementById('past-time').focus()")


def test_one_looks_back_and_goes_on_from_there_while_the_session_goes_on(
    browser: Browser, server: LiveServer
) -> None:
    anna, ben = (student(browser, server, name, width=1366) for name in ("Anna", "Ben"))
    anna.page.click("#control-button")
    anna.until("vrts.store.operator")
    for line in ("DO DRIVE 1,40,100", "DO SIGNAL 3", "DO DRIVE 1,-60,100"):
        anna.ask(line)
    ben.until(f"{turned(-20)} && {IDLE} && {LIVE}")
    off = "(window.changes = [], new MutationObserver((rows) => changes.push(...rows)))"
    ben.value(f"{off}.observe(document.getElementById('past-live'), {{ attributes: true }})")
    ben.page.wait_for_timeout(300)
    assert ben.value("changes.length") == 0, "what is off already is not put off at every frame"

    focus(ben)
    ben.page.keyboard.press("Home")
    ben.until(f"{LOOKS_BACK} && {turned(0)} && {AT}.includes('00:00:00')")
    assert ben.page.inner_text("#past-sign").startswith("You look at the past")
    assert ben.page.inner_text("#past-sign").count(" ago") == 1
    assert ben.page.get_attribute("#past-time", "aria-valuetext") == "00:00:00"
    assert ben.page.inner_text(".f-outputs dd") == "none"
    assert anna.value(f"{turned(-20)} && {LIVE}"), "nobody else looks back"
    ben.page.click("#tab-pendant")
    ben.until("document.querySelector('#axes .value').textContent === '0.00°'")
    assert ben.page.inner_text(".f-speed dd") == "–", "nobody knows it of then"
    tag = "getComputedStyle(document.querySelector('#terminal .of-now')).visibility"
    assert (ben.value(tag), anna.value(tag)) == ("visible", "hidden")

    ben.page.select_option("#past-jump", "line")
    ben.page.click("#past-after")
    ben.until("document.getElementById('line-now').textContent.includes('DRIVE 1,40,100')")
    ben.page.select_option("#past-jump", "all")
    ben.page.click("#past-after")
    ben.until("document.getElementById('toasts').textContent.includes('signal 3 on')")
    ben.until(f"{turned(40)} && document.querySelector('.f-outputs dd').textContent === '3'")
    moment = float(ben.value("Number(document.getElementById('past-time').value)"))
    ben.page.keyboard.press("Alt+l")
    ben.until(f"{LIVE} && {turned(-20)}")

    ben.page.click("#tab-history")
    ben.until("document.querySelector('.events button.moment') !== null")
    ben.page.click("tr:has-text('signal 3 on') button.moment")
    ben.until(f"{LOOKS_BACK} && {turned(40)}")
    assert float(ben.value("Number(document.getElementById('past-time').value)")) == moment
    ben.page.click("#past-play")
    ben.until(f"{JOINT} < 30", patience=30.0)
    ben.page.click("#past-play")  # stand still
    ben.page.click("tr:has-text('signal 3 on') button.moment")
    ben.until(turned(40))

    ben.page.click("#past-branch")
    ben.until("vrts.store.now.rooms.length === 2 && vrts.store.operator && vrts.store.now.alive")
    ben.until(f"{LIVE} && {turned(40)} && {IDLE}")
    ben.ask("DO DRIVE 1,5,100")
    ben.until(turned(45))
    assert anna.value(turned(-20))
    assert anna.value("vrts.store.now.rooms.length") == 1, "it is Ben's alone"
    ben.page.select_option("#room-choice", index=0)
    ben.until(f"{turned(-20)} && !vrts.store.operator")

    anna.page.evaluate("document.getElementById('past-time').focus()")
    anna.page.keyboard.press("PageDown")
    anna.until(LOOKS_BACK)
    anna.page.click("#ready")  # what is pressed by what one sees leads back, and no further
    anna.until(f"{LIVE} && document.getElementById('toasts').textContent.includes('press again')")
    assert anna.value("document.activeElement.id") == "ready"
    focus(anna)
    anna.page.keyboard.press("PageDown")
    anna.until(LOOKS_BACK)
    anna.until("!document.getElementById('past-live').disabled")  # at the next picture
    anna.page.press("#past-live", "Enter")
    anna.until(LIVE)
    assert anna.value("document.activeElement.id") == "past-live", "the keyboard stays where it was"
    focus(anna)
    anna.page.keyboard.press("PageDown")
    anna.until(LOOKS_BACK)
    anna.ask("DO DRIVE 1,30,100")  # what is typed is of now, and shows what follows
    anna.until(f"{LIVE} && {turned(10)}")
    for desk in (anna, ben):
        assert desk.complaints() == []
        desk.context.close()
