"""More of a shared session in real browsers: keys that are held, the monitor, contacts, rooms."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, SHOWN, Desk, student, supervisor
from tests.support_live import LiveServer

pytestmark = [pytest.mark.browser, pytest.mark.live]


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
    operator.until(IDLE)
    assert operator.rests()
    assert operator.joint(6) < 170.0
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


def test_what_was_done_becomes_a_program(operator: Desk) -> None:
    operator.page.click("#tab-programs")
    operator.page.fill("#save-name", "lesson")
    operator.page.click("#save-preview")
    operator.until("document.getElementById('preview').textContent.includes('.PROGRAM lesson')")


LIT_UP = """(document.querySelector('#overlay .bad')?.textContent.includes('touches')
  && JSON.parse(vrts.world.viewer.highlighted || 'null')?.robot === true)"""


def test_a_contact_lights_up_and_names_the_bodies(operator: Desk, viewer: Desk) -> None:
    operator.ask("DO MOVE #PPOINT(0,-30,90,0,0,0)")
    viewer.value(f"vrts.world.watchers.push(() => {{ window.lit ||= {LIT_UP}; }})")
    operator.type("DO MOVE #PPOINT(0,10,90,0,0,0)")
    viewer.until("window.lit")  # what is lit up for a second may be gone when it is looked for
    operator.until("vrts.store.now.contacts.length > 0")
    operator.page.click("#tab-history")
    operator.until("document.querySelector('.events .contact')?.textContent.includes('touches')")
    operator.page.uncheck("#show-contacts")
    operator.until("document.querySelector('#overlay .bad') === null")
    operator.page.check("#show-contacts")


def test_the_supervisor_takes_over_freezes_and_makes_rooms(
    browser: Browser, server: LiveServer, operator: Desk, viewer: Desk
) -> None:
    lead = supervisor(browser, server, drawn=True)
    lead.page.on("dialog", lambda dialog: dialog.accept())
    lead.page.click("#tab-lead")
    lead.page.click("#panel-lead button:text('Take control')")
    lead.until("vrts.store.operator")
    operator.until("!vrts.store.operator")
    lead.page.click("#lead-freeze")
    operator.until("document.getElementById('turn').textContent.startsWith('Frozen')")
    lead.page.click("#lead-freeze")
    lead.page.fill("#new-rooms", "Group 1\nGroup 2")
    lead.page.click("button:text('Make rooms')")
    lead.until("document.querySelectorAll('#panel-lead .rooms li').length === 3")
    group = lead.value("vrts.store.now.rooms[1].id")
    lead.value(f"vrts.connection.send('project', {{ room: '{group}' }})")
    viewer.value(f"vrts.connection.enter('{group}')")
    viewer.until(f"{SHOWN} && vrts.store.now.room.id === '{group}'")
    lead.page.goto(f"http://{server.host}/?wall")
    lead.until("document.querySelectorAll('.room-card').length === 3")
    lead.until("vrts.store.now.wall.every(row => row.bodies.length === 2)")
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
    lead.until(f"{SHOWN} && vrts.store.now.room.id === '{group}'")
    fetched = "performance.getEntriesByType('resource').some(({name}) => name.includes('/scene/'))"
    assert not lead.value(fetched), "the page brought the scene of the room that is shown"
    eye = "vrts.world.viewer.camera.position.y"
    before = lead.value(eye)
    lead.page.press("#view", "ArrowLeft")
    lead.until(f"Math.abs({eye} - {before}) > 0.01")
    lead.value(f"vrts.connection.send('close_room', {{ room: '{group}' }})")
    viewer.until("vrts.world.viewer === null")  # nobody looks on at a room that is no more
    viewer.until("document.getElementById('picture-names').childElementCount === 0")
    viewer.until("document.getElementById('no-scene').innerText === 'The room was closed.'")
    lead.until(f"{SHOWN} && vrts.store.now.room.id !== '{group}'")  # the projector goes on
    assert lead.complaints() == []
    lead.context.close()
