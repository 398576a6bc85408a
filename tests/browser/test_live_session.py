"""A shared session in real browsers: an operator and a viewer at one server, hand in hand."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, SHOWN, Desk, student, supervisor
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

HOSTILE = "Ben <img src=x onerror=alert(1)>"
PROGRAM = """\
.PROGRAM wave
SPEED 40 ALWAYS
10 MOVE #PPOINT(60,-90,90,0,0,0)
TYPE "half <b>way</b>"
MOVE #PPOINT(-60,-90,90,0,0,0)
GOTO 10
.END
"""
RUNNING = "vrts.store.now.status.mode === 'running'"
STOPPED = "vrts.store.now.status.mode === 'stopped'"
HALF_WAYS = "vrts.store.now.output.split('half <b>way</b>').length - 1"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        yield server


@pytest.fixture(scope="module")
def operator(browser: Browser, server: LiveServer) -> Iterator[Desk]:
    operator = student(browser, server, "Anna")
    take_control(operator)
    yield operator
    assert operator.complaints() == []
    assert all(url.split("/")[2] == server.host for url in operator.requests if "://" in url)
    operator.context.close()


@pytest.fixture(scope="module")
def viewer(browser: Browser, server: LiveServer, operator: Desk) -> Iterator[Desk]:
    viewer = student(browser, server, HOSTILE)
    yield viewer
    assert viewer.complaints() == []
    viewer.context.close()


def take_control(desk: Desk) -> None:
    """Take the control right, unless it is there."""
    desk.until("vrts.store.operator || vrts.store.now.control.holder === ''")
    if not desk.value("vrts.store.operator"):
        desk.page.click("#control-button")
        desk.until("vrts.store.operator")


def begin(operator: Desk) -> None:
    """Let the program run, from its beginning or from where it was stopped."""
    operator.page.click("#tab-programs")
    if operator.value("vrts.store.now.status.mode !== 'stopped'"):
        file = {"name": "wave.v2", "mimeType": "text/plain", "buffer": PROGRAM.encode()}
        operator.page.set_input_files("#upload", file)  # type: ignore[arg-type]
        operator.until("document.querySelector('.source li') !== null")
        operator.until(IDLE)
        operator.page.click("button:text('Execute')")
    else:
        operator.page.click("button:text('Proceed')")
    operator.until("document.body.classList.contains('runs')")


def point_at(operator: Desk, *numbers: float) -> None:
    """Put the virtual pointer at X Y Z [mm] O A T [degrees]."""
    operator.page.click("#tab-pointer")
    for name, number in zip("XYZOAT", numbers, strict=True):
        operator.page.fill(f"[data-number={name}]", str(number))
        operator.page.press(f"[data-number={name}]", "Tab")
    operator.until("document.querySelector('[data-reach=yes]') !== null")


def tool_at(x: float, y: float, z: float) -> str:
    """Return the condition that the tool is shown at a place [mm], and that the arm rests."""
    off = f"Math.hypot(X[12] * 1000 - {x}, X[13] * 1000 - {y}, X[14] * 1000 - {z})"
    return f"(X => {off} < 0.1)(vrts.world.state.X_WT) && {IDLE}"


def drawn(name: str) -> str:
    """Return where a body is drawn [m]."""
    return f"vrts.world.viewer.bodies.get('{name}').group.matrix.elements.slice(12, 15)"


def down(operator: Desk, step: str) -> None:
    """Press the pendant's key for -Z of the world once."""
    operator.page.click("#tab-pendant")
    operator.page.click("[data-frame=world]")
    operator.page.select_option("#pendant-step", label=step)
    operator.page.click("[aria-label='Z minus']")


@pytest.mark.thorough
def test_a_can_is_carried_by_pointer_pendant_and_monitor(operator: Desk, viewer: Desk) -> None:
    assert viewer.page.locator("#hand-open").is_disabled()
    assert viewer.page.locator("#panic").is_hidden()
    assert viewer.page.locator("#terminal-line").is_disabled()
    viewer.until("vrts.world.viewer.bodies.size > 3")
    stood: list[float] = viewer.value(drawn("can1"))

    operator.page.click("#hand-open")
    viewer.until("vrts.world.state.q[6] > 0.07")
    point_at(operator, 800, -450, -105, 90, 90, 0)
    operator.page.click(".pointer-go")
    viewer.until(tool_at(800, -450, -105))
    for step, z in (("100 mm, 45°", -205), ("10 mm, 5°", -215), ("10 mm, 5°", -225)):
        operator.until(IDLE)
        down(operator, step)
        viewer.until(tool_at(800, -450, z))
    assert viewer.value(drawn("can1")) == stood

    operator.page.click("#hand-close")
    viewer.until("vrts.world.state.held.includes('can1')")
    operator.until("document.getElementById('held').textContent === 'holds can1'")
    operator.ask("DO DEPARTS 200")
    viewer.until(f"Math.abs({drawn('can1')}[2] - {stood[2] + 0.2}) < 1e-4")
    operator.ask("DO MOVE TRANS(1100,230,-5,90,90,0)")
    viewer.until(tool_at(1100, 230, -5))
    down(operator, "100 mm, 45°")
    viewer.until(tool_at(1100, 230, -105))

    operator.page.click("#hand-open")  # 20 mm above base2, which is 100 mm high
    viewer.until("vrts.world.state.held.length === 0")
    viewer.until(f"Math.abs({drawn('can1')}[2] - {stood[2] + 0.1}) < 1e-4")
    x, y, _ = viewer.value(drawn("can1"))
    assert (x, y) == pytest.approx((1.1, 0.23), abs=1e-3)
    operator.ask("DO DEPARTS 100")
    assert viewer.value(drawn("can1"))[:2] == [x, y]


@pytest.mark.thorough
def test_snapping_is_right_while_base_is_shifted(operator: Desk, viewer: Desk) -> None:
    operator.ask("BASE 100,50,20")
    operator.until("Math.abs(vrts.store.now.status.location[0] - 1100) > 90")
    operator.page.click("#tab-pointer")
    operator.page.click("button:text('Snap to gripper')")
    typed = [operator.page.input_value(f"[data-number={name}]") for name in "XYZOAT"]
    snapped = [float(number.replace("−", "-")) for number in typed]
    assert snapped == pytest.approx([1100, 230, -5, 90, 90, 0], abs=0.1)
    before = operator.value("[...vrts.world.state.q]")
    operator.until("document.querySelector('[data-reach=yes]') !== null")
    operator.page.click(".pointer-go")
    operator.until("vrts.connection.asked.size === 0")
    assert operator.rests()
    assert operator.value("[...vrts.world.state.q]") == pytest.approx(before, abs=1e-5)
    operator.page.uncheck(".pointer-shown")
    operator.ask("BASE 0,0,0")


@pytest.mark.thorough
def test_chat_and_names_are_text_whatever_they_hold(operator: Desk, viewer: Desk) -> None:
    viewer.page.click("#tab-chat")
    viewer.page.fill("#chat-text", "<script>window.attacked = true</script> & more")
    viewer.page.press("#chat-text", "Enter")
    operator.until("document.querySelector('#panel-chat .text') !== null")
    assert operator.page.get_attribute("#tab-chat", "data-count") == "1"
    operator.page.click("#tab-chat")
    assert "<script>" in operator.page.inner_text("#panel-chat .said")
    name = "Ben img src x onerror alert 1"  # signs are no part of names
    assert name in operator.page.inner_text("#panel-chat .who")
    operator.page.click("#tab-people")
    assert name in operator.page.inner_text("#panel-people")
    for one in (operator, viewer):
        assert one.value("window.attacked === undefined && !document.querySelector('[onerror]')")


def test_a_program_runs_with_its_line_lit_and_panic_stops_it(operator: Desk, viewer: Desk) -> None:
    viewer.page.click("#tab-programs")
    begin(operator)
    for one in (operator, viewer):
        one.until("document.querySelector('.source .lit')?.textContent.includes('#PPOINT(60')")
    operator.page.click("#panic")
    viewer.until(STOPPED)
    assert viewer.rests()
    written = viewer.value(HALF_WAYS)  # it may have come so far before it was stopped
    operator.page.click("button:text('Proceed')")
    viewer.until(RUNNING)  # so that it has not stopped yet is known where its end is waited for
    viewer.until(f"{HALF_WAYS} > {written}")
    operator.press_twice("Escape")
    viewer.until(STOPPED)
    assert viewer.rests()


@pytest.mark.thorough
def test_who_comes_back_has_missed_nothing(operator: Desk, viewer: Desk) -> None:
    begin(operator)
    for one in (operator, viewer):
        one.until(RUNNING)
    operator.context.set_offline(True)
    operator.value("vrts.connection.socket.close()")
    operator.until("vrts.store.now.connection === 'waiting'")
    rows = viewer.value("vrts.store.now.events.length")
    viewer.page.click("#tab-chat")
    viewer.page.fill("#chat-text", "while you were away")
    viewer.page.press("#chat-text", "Enter")
    viewer.until(f"vrts.store.now.events.length > {rows}")
    operator.context.set_offline(False)
    operator.until("vrts.store.now.connection === 'open'")
    operator.until("vrts.store.now.chat.some(row => row.text === 'while you were away')")
    numbers = operator.value("vrts.store.now.chat.map(row => row.number)")
    assert numbers == sorted(set(numbers))
    take_control(operator)  # on a slow machine it was away for too long to keep it
    operator.page.click("#panic")
    for one in (operator, viewer):
        one.until(STOPPED)
    told = "vrts.store.now.events.map(row => [row.time_s, row.text])"
    everything = viewer.value(told)
    operator.until(f"vrts.store.now.events.length === {len(everything)}")
    assert operator.value(told) == everything


def test_the_right_passes_through_the_queue(operator: Desk, viewer: Desk) -> None:
    viewer.page.click("#control-button")
    viewer.until("document.getElementById('turn').textContent.startsWith('1st in the queue')")
    assert operator.page.inner_text("#crowd") == "2 here"
    operator.page.click("#control-button")
    viewer.until("vrts.store.operator")
    operator.until("document.getElementById('hand-open').disabled")
    viewer.page.click("#hand-close")
    operator.until("vrts.world.state.q[6] < 0.01")
    viewer.page.click("#control-button")
    operator.until("vrts.store.now.control.holder === ''")
    operator.page.click("#control-button")
    operator.until("vrts.store.operator")


@pytest.mark.thorough
def test_a_supervisor_mutes_broadcasts_reads_logs_and_sends_away(
    browser: Browser, server: LiveServer, operator: Desk, viewer: Desk
) -> None:
    operator.type("WHERE")
    operator.until("vrts.store.now.output.includes('.WHERE')")
    lead = supervisor(browser, server)
    lead.page.on("dialog", lambda dialog: dialog.accept())
    lead.page.click("#tab-people")
    lead.page.get_by_label("Mute: Ben").click()
    viewer.page.click("#tab-chat")
    viewer.until("document.getElementById('panel-chat').textContent.includes('has muted you')")
    viewer.until("document.querySelector('#panel-chat form').hidden")
    lead.page.get_by_label("Unmute: Ben").click()
    viewer.until("!document.querySelector('#panel-chat form').hidden")

    lead.page.click("#tab-lead")
    lead.page.fill("#broadcast-text", "Five minutes left")
    lead.page.click("button:text('Send to all')")
    for one in (operator, viewer):
        one.until("vrts.store.now.chat.some(row => row.text === 'Five minutes left')")
    with lead.page.expect_download() as coming:
        lead.page.get_by_label("Log of").first.click()
    log = coming.value.path().read_text()
    assert '"line":"WHERE"' in log
    assert log.count("\n") > 3

    lead.page.click("#panel-lead button:text('Take control')")
    operator.until("!vrts.store.operator && document.getElementById('ready').disabled")
    operator.until(
        "document.getElementById('toasts').textContent.includes('no longer have control')"
    )
    lead.page.click("#panel-lead button:text('Free control')")
    for one in (lead, operator):
        one.until("vrts.store.now.control.holder === ''")
    lead.page.click("#tab-people")
    lead.page.get_by_label("Send away: Ben").click()
    viewer.until("vrts.store.now.connection === 'ended'")
    viewer.page.reload()
    viewer.until("window.vrts?.store.now.connection === 'ended'")
    lead.page.get_by_label("Let in again: Ben").click()
    lead.until("vrts.store.now.barred.length === 0")
    viewer.page.reload()
    viewer.until(SHOWN)
    assert lead.complaints() == []
    lead.context.close()


HEARD = """Promise.all(['intake', 'store'].map((name) => import(`/web/live/${name}.js`)))
.then(([{ Intake }, { Store }]) => {
  let jumps = 0;
  let lefts = 0;
  const store = new Store();
  const heard = {
    refused() {}, jumped: () => { jumps += 1; }, left: () => { lefts += 1; }, now: () => 9,
  };
  const intake = new Intake(store, { reset() {}, add() {} }, heard);
  const at = (time_s) => ({ status: { time_s }, bodies: [], programs: ['wave'], output: 'hello' });
  const came = (id, session, state) => {
    const room = { room: { id }, rooms: [], scenes: [], notes: [], chat: [] };
    intake.take({ type: 'snapshot', ...room, session, scene_url: '', state });
    return jumps;
  };
  const states = [['a', 1, at(10)], ['a', 1, at(10)], ['a', 1, at(5)], ['b', 1, at(10)]];
  const seen = [...states, ['c', 1, null]].map((one) => came(...one));
  return [...seen, lefts, store.now.output, store.now.programs.length];
})"""


def test_a_past_undone_and_what_another_room_showed_are_forgotten(viewer: Desk) -> None:
    assert viewer.value(HEARD) == [1, 1, 2, 3, 4, 2, "", 0]
