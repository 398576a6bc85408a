"""The live pages for everybody: axe-core's rules, phones, the weight of a page, no inline code."""

from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import ALL_RULES, AXE
from tests.browser.support_sessions import Desk, desk, student, supervisor
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

PANELS = ("pendant", "pointer", "editor", "programs", "history", "chat", "people", "lead")
PHONE = 390  # [px]
HEAVIEST = 1024 * 1024  # bytes of everything but the scene, as they lie on the disk


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        yield server


@pytest.fixture(scope="module")
def lead(browser: Browser, server: LiveServer) -> Iterator[Desk]:
    lead = supervisor(browser, server, dark=True)
    yield lead
    assert lead.complaints() == []
    lead.context.close()


def faults(view: Desk) -> list[Any]:
    """Return what axe-core finds."""
    if not view.value("'axe' in window"):
        view.page.evaluate(AXE)
    found = view.page.evaluate(ALL_RULES)
    assert found["passes"] > 25
    return found["violations"]


@pytest.mark.thorough
def test_axe_finds_nothing_in_any_panel(lead: Desk) -> None:
    lead.page.click("#control-button")
    lead.until("vrts.store.operator")
    found: dict[str, list[Any]] = {}
    for name in PANELS:
        lead.page.click(f"#tab-{name}")
        if name == "editor":
            lead.until("window.editing !== undefined")
        found[name] = faults(lead)
    lead.page.get_by_label("Link into Class").click()
    lead.until("document.querySelector('#entrance .qr').src.startsWith('blob:')")
    found["link"] = faults(lead)
    lead.page.keyboard.press("Escape")
    lead.page.click("#code-button")
    lead.until("document.querySelector('#entrance .code').textContent.length >= 9")
    found["code"] = faults(lead)
    lead.page.keyboard.press("Escape")
    assert {name: rows for name, rows in found.items() if rows} == {}


@pytest.mark.thorough
def test_axe_finds_nothing_on_wall_and_projector(lead: Desk, server: LiveServer) -> None:
    for path, there in (
        ("/?wall", "document.querySelector('.room-card') !== null"),
        ("/?projector", "Boolean(window.vrts?.world?.state)"),
    ):
        lead.page.goto(f"http://{server.host}{path}")
        lead.until(there)
        assert faults(lead) == []


@pytest.mark.thorough
def test_the_door_and_a_phone(browser: Browser, server: LiveServer) -> None:
    door = desk(browser, server, width=PHONE)
    door.until("!document.getElementById('enter').hidden")
    assert faults(door) == []
    door.page.fill("#enter-code", "nosuch")
    door.page.fill("#enter-name", "Eve")
    door.page.click("#enter-form button")
    door.until("document.getElementById('enter-problem').textContent.includes('no such code')")
    door.context.close()
    phone = student(browser, server, "Carl", width=PHONE)
    phone.until("vrts.connection.rate === 15")
    assert phone.page.locator("#tab-monitor").is_visible()
    assert phone.page.locator("#actions").is_hidden()
    phone.page.click("#tab-chat")
    assert faults(phone) == []
    assert phone.value("document.documentElement.scrollWidth") <= PHONE
    box = phone.page.locator("#panel-chat button.main").bounding_box()
    assert box is not None
    assert box["x"] + box["width"] <= PHONE
    assert phone.complaints() == []
    phone.context.close()


def test_the_page_is_light_and_has_no_inline_code(browser: Browser, server: LiveServer) -> None:
    view = desk(browser, server)
    view.until("!document.getElementById('enter').hidden")
    sizes: list[int] = view.value(
        "performance.getEntriesByType('resource').map(entry => entry.decodedBodySize)"
    )
    assert 5 <= len(sizes) <= 8  # bundles: style, two of ours, three of three.js, a sign
    assert sum(sizes) <= HEAVIEST
    answer = server.request("GET", "/")
    text = answer.body.decode()
    assert "<style" not in text
    assert " style=" not in text
    assert " on" not in {word[:3] for word in text.split("<")[1:]}
    assert text.count("<script") == text.count('<script type="module" src="') == 2
    assert "script-src 'self'" in str(answer.headers.get("content-security-policy"))
    view.context.close()
