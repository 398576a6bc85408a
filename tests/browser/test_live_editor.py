"""The editor in the page: mistakes told while one writes, mended, saved in versions, run."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import Desk, student
from tests.support_live import LiveServer

pytest.importorskip("pygls", reason='needs pip install "vrts[ide]"')
pytestmark = pytest.mark.browser

WRONG = """\
.PROGRAM wave
; there and back
SPEED 40 ALWAYS

10 MOVEE #PPOINT(60,-90,90,0,0,0)
MOVE #PPOINT(-60,-90,90,0,0,0)
GOTO 10
.END
"""
HELPED = "window.editing?.help.now === 'on'"
TEXT = "editing.view.state.doc.toString()"
MISTAKES = "document.querySelector('.told .bad')?.textContent ?? ''"
SHADOW = "document.querySelector('.bench .host').shadowRoot"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("editor") / "live") as started:
        yield started


def opened(browser: Browser, server: LiveServer, name: str) -> Desk:
    """Return the page of somebody who has opened the editor."""
    person = student(browser, server, name)
    assert not any("codemirror" in url for url in person.requests)  # the first picture came first
    person.page.click("#tab-editor")
    person.until(HELPED)
    person.until("document.querySelector('select.open option[value=new]') !== null")
    return person


def write(person: Desk, text: str) -> None:
    """Type a text over what is there."""
    person.page.click(".cm-content")
    person.page.keyboard.press("ControlOrMeta+a")
    person.page.keyboard.insert_text(text)
    person.until(f"{TEXT} === {text!r}")


def at(person: Desk, words: str) -> None:
    """Put the cursor behind some words, as an arrow key would."""
    line = f"{TEXT}.indexOf({words!r}) + {len(words)}"
    person.value(f"editing.view.dispatch({{selection: {{anchor: {line}}}}}), editing.view.focus()")


@pytest.mark.thorough
def test_a_program_is_written_with_help_saved_and_run(browser: Browser, server: LiveServer) -> None:
    anna = opened(browser, server, "Anna")
    page, keyboard = anna.page, anna.page.keyboard
    assert page.is_disabled("button:text-is('Run')")
    assert page.inner_text("#editor-why") == (
        "Only the person with control can do this: take control first."
    )

    write(anna, WRONG)
    anna.until(f"({MISTAKES}).startsWith('1 mistake')")
    anna.until(f"{SHADOW}.querySelector('.cm-lintRange-error').textContent === 'MOVEE'")
    at(anna, "MOVEE")
    keyboard.press("ControlOrMeta+.")
    anna.until(f"{TEXT}.includes('10 MOVE #')")
    anna.until(f"({MISTAKES}) === ''")

    at(anna, "SPEED 40 ALWAYS\n")
    keyboard.type("TYP")
    anna.until(f"{SHADOW}.querySelector('.cm-tooltip-autocomplete')?.textContent.includes('TYPE')")
    page.wait_for_timeout(100)  # what is shown may be chosen only after a moment: no key is lost
    keyboard.press("Tab")
    anna.until(f"{TEXT}.includes('ALWAYS\\nTYPE\\n')")
    keyboard.type(' "half <b>way</b>"')
    at(anna, "10 MOV")
    keyboard.press("F1")
    anna.until(
        f"{SHADOW}.querySelector('.cm-tooltip .cm-said')?.textContent.includes('MOVE location')"
    )
    keyboard.press("Escape")
    anna.until(f"{SHADOW}.querySelector('.cm-tooltip .cm-said') === null")

    keyboard.press("ControlOrMeta+s")
    anna.until("document.querySelector('.told').textContent.startsWith('saved, version 1')")

    page.click("#control-button")
    anna.until("vrts.store.operator")
    keyboard_focus(anna)
    keyboard.press("ControlOrMeta+Enter")
    anna.until("vrts.store.now.status.mode === 'running'")
    lit = f"{SHADOW}.querySelector('.cm-at-work')?.textContent ?? ''"
    moments: dict[str, float] = {}
    for words in ("#PPOINT(60", "#PPOINT(-60"):
        anna.until(f"({lit}).includes({words!r})")
        told = "vrts.store.now.status"  # what is drawn lags behind it
        anna.until(f"{told}.text.includes({words!r}) && (window.then = {told}.time_s)")
        moments[words] = anna.value("window.then")
    assert page.is_disabled("button:text-is('Run')")
    page.click(".bench button:text-is('Abort')")
    anna.until("vrts.store.now.status.mode === 'stopped'")
    look = "import('/web/live/looking.js').then((looking) => looking"
    for words, moment in moments.items():  # who looks back sees the line of then
        anna.value(f"{look}.look({moment}))")
        anna.until(f"({lit}).includes({words!r})")
    anna.value(f"{look}.backToLive())")

    anna.value("void (vrts.panic = () => { window.panicked = true; })")
    keyboard_focus(anna)
    anna.press_twice("Escape")
    assert anna.value("window.panicked === undefined"), "who leaves the editor stops nothing"
    keyboard.press("Escape")
    keyboard.press("Tab")
    assert anna.value(
        f"{SHADOW}.activeElement === null && document.activeElement.tagName === 'BUTTON'"
    )
    anna.press_twice("Escape")
    anna.until("window.panicked")
    assert anna.complaints() == []
    anna.context.close()


@pytest.mark.thorough
def test_what_one_writes_comes_along_into_another_room(
    browser: Browser, server: LiveServer
) -> None:
    dora = opened(browser, server, "Dora")
    text = ".PROGRAM along\n.END\n"
    asks = """(() => {
        const leaving = new Event('beforeunload', { cancelable: true });
        return dispatchEvent(leaving), leaving.defaultPrevented; })()"""
    assert dora.value(asks) is False
    write(dora, text)
    assert dora.value(asks) is True
    home = dora.value("vrts.store.now.room.id")
    for room, more in (("elsewhere", "; there"), (home, "; here")):
        dora.value(f"vrts.store.set({{room: {{...vrts.store.now.room, id: {room!r}}}}})")
        assert dora.value(TEXT) == text
        text += f"{more}\n"
        dora.value(
            f"editing.view.dispatch({{changes: {{from: {TEXT}.length, insert: '{more}\\n'}}}})"
        )
    for room in ("elsewhere", home):
        assert dora.value(f"JSON.parse(sessionStorage.getItem('vrts draft {room}')).text") == text
    dora.context.close()


def keyboard_focus(person: Desk) -> None:
    """Have keys go to the editor."""
    person.value("editing.view.focus()")


@pytest.mark.thorough
def test_two_persons_lose_nothing_of_one_program(browser: Browser, server: LiveServer) -> None:
    anna, ben = opened(browser, server, "Cleo"), opened(browser, server, "Ben")
    for person, text in ((anna, ".PROGRAM both\n.END\n"), (ben, ".PROGRAM both\nSTOP\n.END\n")):
        write(person, text)
        person.page.select_option("[aria-label='Where it is kept']", "room")
        person.until("document.querySelector('#panel-editor button.main').disabled")
        reason = person.page.get_attribute("button:text-is('Save')", "title")
        assert "take control" in str(reason)
        person.page.click("#control-button")
        person.page.click("button:text-is('Save')")  # Playwright waits until it can be pressed
        if person is anna:
            anna.until("document.querySelector('.told').textContent.startsWith('saved, version 1')")
            anna.page.click("#control-button")
            ben.until("vrts.store.now.control.holder === ''")
    ben.until(
        "document.querySelector('dialog.asking h2')?.textContent === 'There is a newer version'"
    )
    assert "Cleo saved version 1 of both" in ben.page.inner_text("dialog.asking")
    ben.page.click("button:text('Save mine as version 2')")
    ben.until("document.querySelector('.told').textContent.startsWith('saved, version 2')")
    ben.page.click("button:text-is('Versions')")
    ben.until("document.querySelectorAll('.versions li').length === 2")
    ben.page.click(".versions li:last-child button")
    ben.until("document.querySelector('dialog .preview').textContent === '.PROGRAM both\\n.END\\n'")
    ben.page.click("button:text-is('Take this text')")
    ben.until(f"{TEXT} === '.PROGRAM both\\n.END\\n'")
    ben.page.reload()  # what is not saved is not lost
    ben.until(HELPED)
    ben.until(f"{TEXT} === '.PROGRAM both\\n.END\\n'")
    ben.until("document.querySelector('.told').textContent.startsWith('not saved')")
    for person in (anna, ben):
        assert person.complaints() == []
        person.context.close()
