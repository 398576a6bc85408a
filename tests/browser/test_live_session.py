"""A shared session in real browsers: an operator and a viewer at one server."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, Desk, student, supervisor
from tests.support_live import LiveServer

pytestmark = [pytest.mark.browser, pytest.mark.live]

PROGRAM = """\
.PROGRAM wave
SPEED 8 ALWAYS
DRIVE 1, 60, 100
TYPE "half <b>way</b>"
DRIVE 1, -60, 100
.END
"""


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        yield server


@pytest.fixture(scope="module")
def operator(browser: Browser, server: LiveServer) -> Iterator[Desk]:
    operator = student(browser, server, "Anna")
    operator.page.click("#control-button")
    operator.until("vrts.store.operator")
    yield operator
    assert operator.complaints() == []
    assert all(url.split("/")[2] == server.host for url in operator.requests if "://" in url)
    operator.context.close()


@pytest.fixture(scope="module")
def viewer(browser: Browser, server: LiveServer, operator: Desk) -> Iterator[Desk]:
    viewer = student(browser, server, "Ben <img src=x onerror=alert(1)>")
    yield viewer
    assert viewer.complaints() == []
    viewer.context.close()


def test_a_step_of_the_pendant_moves_the_arm_in_both_browsers(operator: Desk, viewer: Desk) -> None:
    before = operator.joint(1)
    operator.page.click("[aria-label='Joint 1 plus']")
    for one in (operator, viewer):
        one.until(f"Math.abs(vrts.world.state.q[0] * 180 / Math.PI - {before + 5}) < 0.01")
    assert viewer.page.locator("#hand-open").is_disabled()
    assert viewer.page.locator("#panic").is_hidden()
    assert viewer.page.locator("#terminal-line").is_disabled()


def test_holding_a_key_moves_and_letting_go_stops(operator: Desk) -> None:
    operator.until(IDLE)
    operator.page.click("[data-way=hold]")
    before = operator.joint(6)
    operator.page.hover("[aria-label='Joint 6 plus']")
    operator.page.mouse.down()
    operator.until(f"vrts.world.state.q[5] * 180 / Math.PI > {before + 2}")
    operator.page.mouse.up()
    operator.page.wait_for_timeout(1000)
    stopped = operator.joint(6)
    operator.page.wait_for_timeout(300)
    assert operator.joint(6) == stopped < 170.0
    operator.page.click("[data-way=step]")


def test_monitor_completes_remembers_and_shows_what_was_said_to_all(
    operator: Desk, viewer: Desk
) -> None:
    operator.page.fill("#terminal-line", "WHE")
    operator.page.press("#terminal-line", "Tab")
    assert operator.page.input_value("#terminal-line") == "WHERE "
    operator.page.press("#terminal-line", "Enter")
    for one in (operator, viewer):
        one.until("document.getElementById('terminal-output').textContent.includes('X/JT1')")
    operator.page.press("#terminal-line", "ArrowUp")
    assert operator.page.input_value("#terminal-line") == "WHERE "
    operator.page.fill("#terminal-line", "")


def test_a_program_runs_with_its_line_lit_and_panic_stops_it(operator: Desk, viewer: Desk) -> None:
    page = operator.page
    page.click("#tab-programs")
    page.set_input_files(
        "#upload", {"name": "wave.v2", "mimeType": "text/plain", "buffer": PROGRAM.encode()}
    )
    viewer.page.click("#tab-programs")
    viewer.until("document.querySelector('.source li') !== null")
    page.click("text=Execute")
    for one in (operator, viewer):
        one.until("document.querySelector('.source .lit')?.textContent.includes('DRIVE 1, 60')")
    operator.until("document.body.classList.contains('runs')")
    page.keyboard.press("Escape")
    page.keyboard.press("Escape")
    operator.until("!document.body.classList.contains('runs')", 3.0)
    operator.until(
        "vrts.store.now.status.mode === 'stopped' || vrts.store.now.status.mode === 'idle'"
    )
    viewer.page.wait_for_timeout(1000)
    stopped = viewer.joint(1)
    viewer.page.wait_for_timeout(300)
    assert viewer.joint(1) == stopped


def test_what_was_done_becomes_a_program(operator: Desk) -> None:
    operator.page.click("#tab-programs")
    operator.page.fill("#save-name", "lesson")
    operator.page.click("#save-preview")
    operator.until("document.getElementById('preview').textContent.includes('.PROGRAM lesson')")


def test_chat_shows_text_as_text(operator: Desk, viewer: Desk) -> None:
    viewer.page.click("#tab-chat")
    viewer.page.fill("#chat-text", "<script>window.attacked = true</script> & more")
    viewer.page.press("#chat-text", "Enter")
    operator.until("document.querySelector('#panel-chat .text') !== null")
    assert operator.page.get_attribute("#tab-chat", "data-count") == "1"
    operator.page.click("#tab-chat")
    assert "<script>" in operator.page.inner_text("#panel-chat .said")
    assert "Ben <img" in operator.page.inner_text("#panel-chat .who")
    assert operator.value("document.images.length === 1 && window.attacked === undefined")


def test_the_right_passes_through_the_queue(operator: Desk, viewer: Desk) -> None:
    viewer.page.click("#control-button")
    viewer.until("document.getElementById('turn').textContent.startsWith('1st in the queue')")
    operator.page.click("#control-button")
    viewer.until("vrts.store.operator")
    assert operator.page.locator("#hand-open").is_disabled()
    viewer.page.click("#control-button")
    operator.page.click("#control-button")
    operator.until("vrts.store.operator")


def test_a_dropped_connection_comes_back_without_losing_chat(operator: Desk, viewer: Desk) -> None:
    operator.value("vrts.connection.socket.close()")
    viewer.page.fill("#chat-text", "while you were away")
    viewer.page.press("#chat-text", "Enter")
    operator.until("vrts.store.now.connection === 'open'")
    operator.until("vrts.store.now.chat.some(row => row.text === 'while you were away')")
    numbers = operator.value("vrts.store.now.chat.map(row => row.number)")
    assert numbers == sorted(set(numbers))
    operator.until("vrts.store.operator")
    operator.page.click("#hand-open")
    viewer.until("vrts.world.state.q[6] > 0.01")


def test_a_contact_lights_up_and_names_the_bodies(operator: Desk, viewer: Desk) -> None:
    for line in ("DO MOVE #PPOINT(0,-30,90,0,0,0)", "DO MOVE #PPOINT(0,10,90,0,0,0)"):
        operator.until("document.getElementById('terminal-prompt').textContent === '.'")
        operator.type(line)
        operator.until("document.getElementById('terminal-prompt').textContent === '*'")
    viewer.until(
        "document.querySelector('#overlay .bad')?.textContent.includes('touches')"
        " && JSON.parse(vrts.world.viewer.highlighted)?.robot === true"
    )
    operator.until("vrts.store.now.contacts.length > 0")
    operator.page.click("#tab-history")
    operator.until("document.querySelector('.events .contact')?.textContent.includes('touches')")
    operator.page.uncheck("#show-contacts")
    operator.until("document.querySelector('#overlay .bad') === null")
    operator.page.check("#show-contacts")


def test_the_supervisor_takes_over_freezes_and_makes_rooms(
    browser: Browser, server: LiveServer, operator: Desk
) -> None:
    lead = supervisor(browser, server)
    lead.page.on("dialog", lambda dialog: dialog.accept())
    lead.page.click("#tab-lead")
    lead.page.click("#panel-lead >> text=Take control")
    lead.until("vrts.store.operator")
    operator.until("!vrts.store.operator")
    lead.page.click("#lead-freeze")
    operator.until("document.getElementById('turn').textContent.startsWith('Frozen')")
    lead.page.click("#lead-freeze")
    lead.page.fill("#new-rooms", "Group 1\nGroup 2")
    lead.page.click("text=Make rooms")
    lead.until("document.querySelectorAll('#panel-lead .rooms li').length === 3")
    lead.page.goto(f"http://{server.host}/?wall")
    lead.until("document.querySelectorAll('.room-card').length === 3")
    drawn = """() => { const c = document.querySelector('.room-card canvas');
      return c.toDataURL().length; }"""
    for _ in range(100):
        if lead.value(drawn) > 8000:
            break
        lead.page.wait_for_timeout(100)
    assert lead.value(drawn) > 8000, "no still was drawn"
    lead.page.goto(f"http://{server.host}/?projector")
    lead.until("Boolean(window.vrts?.world?.state)")
    assert lead.page.locator("#control-button").is_hidden()
    assert lead.complaints() == []
    lead.context.close()
