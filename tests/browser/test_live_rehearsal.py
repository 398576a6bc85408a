"""A rehearsal in a real browser: breakpoints, steps both ways, a collision; the room stays."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, Desk, student
from tests.browser.test_live_pages import faults
from tests.support_live import LiveServer

pytest.importorskip("pygls", reason='needs pip install "vrts[ide]"')
pytestmark = [pytest.mark.browser, pytest.mark.thorough]

EXAMPLE = Path("examples/01-cans-on-bases")
PROGRAM = (EXAMPLE / "submissions/hits-base.v2").read_text()
STATE = "document.getElementById('rehearsal-state').textContent"
ROOT = "document.querySelector('.bench .host').shadowRoot"
HERE = f"({ROOT}.querySelector('.cm-rehearsed')?.textContent ?? '')"
SHOWN = "document.body.classList.contains('rehearses')"
BESIDE = "document.getElementById('rehearsal-beside').textContent"
AT = "Number(document.getElementById('rehearsal-time').value)"
JOINTS = "[...vrts.world.state.q].map((q) => q.toFixed(4)).join()"
SIGN = f"{ROOT}.querySelector('.cm-break')?.getAttribute('aria-label')"
DOC = "editing.view.state.doc"
CHANGE = "((changes) => editing.view.dispatch({changes}))"
LINES = """import('/web/live/rehearsal/gutter.js').then(({ breakpointLines }) =>
    breakpointLines(editing.view))"""
HELD = "document.getElementById('held').textContent"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    task = (str(EXAMPLE / "task.toml"),)
    with LiveServer(tmp_path_factory.mktemp("live"), scenes=task) as started:
        yield started


def line(number: int) -> str:
    """Return a line of the program as the editor shows it."""
    return PROGRAM.splitlines()[number - 1]


def to_line(anna: Desk, number: int) -> None:
    """Put the cursor at the end of a line."""
    at = f"editing.view.state.doc.line({number}).to"
    anna.value(f"editing.view.dispatch({{selection: {{anchor: {at}}}, scrollIntoView: true}})")


def press_beside(anna: Desk, number: int) -> None:
    """Press the gutter beside a line."""
    to_line(anna, number)
    where = f"editing.view.coordsAtPos(editing.view.state.doc.line({number}).from)"
    host = "document.querySelector('.bench .host').getBoundingClientRect()"
    anna.until(f"{where}?.top > {host}.top && {where}.bottom < {host}.bottom")
    x = anna.value(f"{ROOT}.querySelector('.cm-breakpoints').getBoundingClientRect().left + 10")
    anna.page.mouse.click(x, anna.value(f"({where}.top + {where}.bottom) / 2"))


def stands(anna: Desk, words: str, number: int) -> None:
    """Wait until the rehearsal stands at a line, and the picture shows the moment."""
    anna.until(f"{STATE} === {f'{words}, line {number}: {line(number)}'!r}")
    anna.until(f"{HERE} === {line(number)!r} && {SHOWN}")


def test_a_program_is_rehearsed_both_ways_and_nothing_moves(
    browser: Browser, server: LiveServer
) -> None:
    anna = student(browser, server, "Anna", width=1366)
    page, keyboard = anna.page, anna.page.keyboard
    page.click("#tab-editor")
    anna.until("window.editing?.help.now === 'on' && vrts.store.now.alive")
    live = anna.value(JOINTS)
    page.click(".cm-content")
    keyboard.press("ControlOrMeta+a")
    keyboard.insert_text(PROGRAM.replace("MOVE safe", "MOVEE safe", 1))

    # what does not compile is marked, and nothing begins
    page.click("#rehearse")
    anna.until(f"{STATE} === 'Not rehearsed: 1 mistake in the text.'")
    anna.until(f"{ROOT}.querySelector('.cm-lintRange-error')?.textContent === 'MOVEE'")
    assert anna.value(f"!{SHOWN} && document.getElementById('rehearsal-beside').hidden")
    keyboard.press("ControlOrMeta+a")
    keyboard.insert_text(PROGRAM)

    # breakpoints by a click and by a key, with names; one stands where nothing can stop
    press_beside(anna, 11)
    anna.until(f"({SIGN}) === 'Breakpoint at line 11'")
    for wanted in (6, 24):
        to_line(anna, wanted)
        keyboard.press("F9")
    at = f"{ROOT}.querySelector('.cm-activeLine [role=img][aria-label=breakpoint]')"
    anna.until(f"{at} !== null")
    keyboard.press("F9")
    anna.until(f"{at} === null")

    # to the breakpoints, with keys; F5 stays the browser's
    keyboard.press("ControlOrMeta+Shift+Enter")
    stands(anna, "Breakpoint", 6 + 1)
    keyboard.press("F2")
    stands(anna, "Breakpoint", 11)
    assert page.inner_text("#rehearsal-sign").startswith("Rehearsal: nobody else sees this")
    assert "can1_grip" in anna.value(BESIDE)
    assert "Mark 7.0 of 10" in anna.value(BESIDE)
    anna.until(f"{HELD} === 'holds can1' && {JOINTS} !== {live!r}")
    moment, there = anna.value(AT), anna.value(JOINTS)

    # a step, and back to the very same
    keyboard.press("F10")
    stands(anna, "Step", 12)
    anna.until(f"{AT} > {moment} && {JOINTS} !== {there!r}")
    keyboard.press("Control+F10")
    stands(anna, "Breakpoint", 11)
    anna.until(f"{AT} === {moment} && {JOINTS} === {there!r}")
    page.click("[aria-label='Run back to the breakpoint before']")
    stands(anna, "Breakpoint", 7)

    # the collision is a mark: it leads there, and the slider goes on from there by keys
    assert anna.value("document.querySelectorAll('#rehearsal-track .is-contact').length") == 1
    page.click(".rehearsal-events .is-contact")
    anna.until("document.getElementById('overlay').textContent.startsWith('can1 touches base1')")
    anna.until(f"{STATE}.startsWith('At 4.9 s, line 11')")
    assert anna.value("document.querySelector('.f-contacts dd').textContent") == "1"
    page.focus("#rehearsal-time")
    keyboard.press("Home")
    anna.until(f"{STATE}.startsWith('At 0.0 s') && {JOINTS} === {live!r}")
    keyboard.press("End")
    anna.until(f"{BESIDE}.includes('finished') && {AT} > 12")
    assert faults(anna) == []

    # the text goes on; the rehearsal is of the earlier one, and its lines move along
    page.click("[aria-label='Run back to the breakpoint before']")
    stands(anna, "Breakpoint", 11)
    anna.value("editing.view.dispatch({changes: {from: 0, insert: '; one more\\n'}})")
    anna.until(
        f"{STATE}.startsWith('Breakpoint, line 12: ') && {STATE}.endsWith('(of an earlier text)')"
    )
    anna.until(f"{HERE} === {line(11)!r}")

    # back to the room, where nothing has moved
    keyboard.press("Alt+l")
    anna.until(f"!{SHOWN} && {JOINTS} === {live!r} && {IDLE}")
    assert anna.value("vrts.store.now.contacts.length") == 0
    assert anna.value("vrts.store.now.programs.length") == 0, "nothing was loaded"
    page.click("[aria-label='Step over']")
    anna.until(f"{SHOWN} && {JOINTS} !== {live!r}")
    page.click("#rehearsal-stop")
    anna.until(f"!{SHOWN} && {STATE} === 'The rehearsal has been ended.' && {HERE} === ''")

    # breakpoints keep to their lines while one writes
    assert anna.value(LINES) == [7, 12]
    anna.value(f"{CHANGE}({{from: 0, to: {DOC}.length, insert: {DOC}.toString()}})")
    assert anna.value(LINES) == [7, 12], "the text was laid out anew"
    anna.value(f"{CHANGE}({{from: {DOC}.line(12).from, insert: '  '}})")
    anna.value(f"{CHANGE}({{from: {DOC}.line(7).from, to: {DOC}.line(8).from}})")
    assert anna.value(LINES) == [11], "its line is gone"
    assert anna.complaints() == []
    anna.context.close()
