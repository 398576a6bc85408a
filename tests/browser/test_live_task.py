"""The task beside the arm, in a real browser: what is asked for, what is lost, what is selected."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import IDLE, Desk, supervisor
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

EXAMPLE = Path("examples/01-cans-on-bases")
SECRETS = b'[[via]]\nname = "geheim"\nat_mm = [987.25, 0, 0]\n'
HOSTILE = "<img src=x onerror=window.attacked=1>"
MARK = "document.getElementById('task-mark').textContent"
CHOSEN = "(document.querySelector('.thing-list [aria-pressed=true]')?.dataset.body ?? '')"
DRAWN = "fetch(vrts.store.now.sceneUrl).then((answer) => answer.text())"
SEEN = "getComputedStyle(e).visibility === 'visible'"
LIT = "document.querySelector('.source .lit')?.textContent.trim()"
REACH = "(document.querySelector('.pointer-reach')?.textContent ?? '')"
FACTS = "document.querySelector('.thing-facts').textContent"
MIDDLE = """(() => {
  const { viewer } = vrts.world;
  viewer.camera.updateMatrixWorld();
  const { x, y } = viewer.bodies.get('can2').group.position.clone()
    .setFromMatrixPosition(viewer.bodies.get('can2').group.matrix).project(viewer.camera);
  const area = viewer.canvas.getBoundingClientRect();
  return [area.left + (x + 1) / 2 * area.width, area.top + (1 - y) / 2 * area.height];
})()"""


@pytest.fixture
def lead(browser: Browser, tmp_path: Path) -> Iterator[Desk]:
    """Return the page of a supervisor in a room whose task has a hidden part."""
    folder = tmp_path / "task"
    shutil.copytree(EXAMPLE, folder)
    text = (folder / "task.toml").read_text()
    text = text.replace('"Cans on bases"', f'"Cans {HOSTILE}"').replace("Two cans", HOSTILE)
    (folder / "task.toml").write_text(text)
    (folder / "staff").mkdir()
    (folder / "staff" / "task.toml").write_bytes(SECRETS)
    with LiveServer(tmp_path / "live", scenes=(str(folder / "task.toml"),)) as server:
        desk = supervisor(browser, server)
        yield desk
        desk.context.close()


@pytest.mark.thorough
def test_the_task_stands_beside_the_arm(lead: Desk) -> None:
    came: list[bytes] = []
    page = lead.page
    page.on("websocket", lambda s: s.on("framereceived", lambda data: came.append(_bytes(data))))
    page.reload()
    lead.until("Boolean(window.vrts?.world?.state) && vrts.store.now.marked !== null")
    assert page.is_visible("#panel-task"), "one comes for the task"
    assert page.inner_text("#task-title") == f"Cans {HOSTILE}"
    assert HOSTILE in page.inner_text(".task-text")
    assert lead.value("window.attacked === undefined && !document.querySelector('[onerror]')")
    lead.until(f"{MARK} === '0.0 / 10'")
    assert "750 mm away" in page.inner_text("#goal-list")
    assert lead.value("vrts.world.viewer.goals.visible") is False, "not green for all"

    # by keyboard, by a click in the picture, and away again
    page.focus("#thing-list [data-body=can1]")
    page.keyboard.press("Enter")
    lead.until(f"{CHOSEN} === 'can1' && {FACTS}.includes('800.0, −450.0, −300.0 mm')")
    assert "can1 on base2: 750 mm away" in page.inner_text(".thing-facts")
    page.click("[data-look=top]")
    page.mouse.click(*lead.value(MIDDLE))
    lead.until(f"{CHOSEN} === 'can2' && {FACTS}.includes('can2 on base1')")
    assert page.locator("#picture-names .chosen").count() >= 1
    page.uncheck("text=Names in the picture")
    assert page.is_hidden("#picture-names")
    page.uncheck("text=Goals in the picture")

    page.click("#control-button")
    lead.until("vrts.store.operator")
    page.click("#tab-programs")
    page.set_input_files("#upload", EXAMPLE / "submissions/hits-base.v2")
    lead.until("document.querySelector('.source li') !== null")
    lead.until(IDLE)
    page.click("button:text('Execute')")
    page.click("#tab-task")
    lead.until(f"{MARK} === '7.0 / 10'", 90)
    lead.until("document.querySelector('#lost .contact .points').textContent === '−1.5'")
    why = page.inner_text("#lost .contact .why")
    assert "line 11 APPROS base2_put, 60, the held can1 hits base1" in why
    assert page.locator("#goal-list .there").count() == 2
    told = page.inner_text("#lost .contact button")
    page.click("#lost .contact button")
    looked = lead.value("import('/web/live/looking.js').then((page) => page.lookedAt())")
    assert f"{looked:.1f} s" == told
    lead.until("document.querySelectorAll('#goal-list .there').length === 0")  # it was on its way
    assert page.locator(".task-mark .of-now").evaluate(f"(e) => {SEEN}"), "the mark is of now"
    assert page.inner_text("#goal-list .earned >> nth=0") == "now 4.25 of 4.25"
    assert page.inner_text(".f-mark dd") == "–"
    page.click("#tab-programs")
    lead.until(f"{LIT} === 'APPROS base2_put, 60'")
    page.click("#tab-pointer")
    lead.until(f"{REACH}.includes('does not show what is now')")
    page.click(".pointer-go")
    lead.until("document.querySelector('.pointer-said').textContent.includes('press again')")
    lead.until(f"{REACH}.includes('touches there') && {IDLE}")  # now it is asked
    page.click("#tab-task")
    page.click("#lost .contact button")

    page.keyboard.press("Alt+P")
    page.wait_for_selector("#desk", state="hidden")
    page.keyboard.press("Alt+N")
    assert page.inner_text("#note-form button") == "Note now"
    page.keyboard.type(f"here {HOSTILE}")
    page.keyboard.press("Enter")
    lead.until("document.querySelector('#panel-history tr.noted') !== null")
    assert f"here {HOSTILE}" in page.inner_text("#panel-history tr.noted")
    assert page.input_value("#note-text") == ""
    assert page.inner_text("#note-form button") == "Note this moment", "live again"

    page.reload()
    lead.until("Boolean(window.vrts?.world?.state)")
    lead.until("vrts.store.now.notes.length === 1")
    assert page.is_hidden("#picture-names"), "remembered"
    lead.until(f"{MARK} === '7.0 / 10'")
    assert lead.complaints() == []
    everything = b"".join([*came, _bytes(lead.value(DRAWN))])
    assert b"can1 on base2" in everything
    assert b"geheim" not in everything
    assert b"987.25" not in everything


def _bytes(data: str | bytes) -> bytes:
    return data.encode() if isinstance(data, str) else data
