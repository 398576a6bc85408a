"""The class code as supervisors see it: on walls and in panels, renewed, listed and ended."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Dialog

from tests.browser.support_sessions import Desk, student, supervisor
from tests.support_live import LiveServer

pytestmark = [pytest.mark.browser, pytest.mark.live]

CODE = "vrts.store.now.code.code"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("ways") / "live") as server:
        yield server


def press(desk: Desk, name: str) -> None:
    """Press a button of the list of ways in, and agree."""

    def agree(dialog: Dialog) -> None:
        dialog.accept()

    desk.page.once("dialog", agree)
    desk.page.get_by_role("button", name=name).first.click()


def test_another_code_is_on_the_wall_at_once_and_a_link_ends(
    browser: Browser, server: LiveServer
) -> None:
    boss = supervisor(browser, server, width=1366)
    wall = boss.context.new_page()
    wall.goto(f"http://{server.host}/?wall")
    shown = f"Class code {boss.value(CODE)}"
    wall.get_by_role("button", name=shown).click()
    large = wall.locator("#entrance .code")
    assert f"Class code {large.inner_text()}" == shown
    anna = student(browser, server, "Anna")

    boss.page.get_by_role("tab", name="People").click()
    assert boss.page.locator(".class-code").inner_text() == shown
    boss.page.get_by_role("tab", name="Lead").click()
    boss.page.click("#ways-in summary")
    boss.until("document.querySelector('#ways-in').textContent.includes('1 entry')")
    before = boss.value(CODE)
    press(boss, f"Renew: Class code {before}")
    boss.until(f"{CODE} !== '{before}'")
    after = boss.value(CODE)
    wall.get_by_text(after, exact=True).wait_for()
    assert wall.locator("#wall-code").inner_text() == f"Class code {after}"
    server.code = after.replace("-", "")

    late = anna.context.browser
    assert late is not None
    page = late.new_page()
    page.goto(f"http://{server.host}/#enter={before.replace('-', '')}")
    page.get_by_role("alert").wait_for()
    assert page.locator("#enter-problem").inner_text() == (
        "there is another class code now; look at the wall"
    )
    page.close()

    ben = server.join(server.enter("Ben"))
    ben.wait("control")
    boss.page.get_by_role("button", name="Refresh").click()
    press(boss, f"End and send away: Class code {after}")
    closed = ben.closed()
    assert closed is not None
    assert closed["code"] == "kicked"
    boss.until(f"{CODE} === ''")
    assert wall.locator("#wall-code").inner_text() == "Class code"
    boss.page.get_by_role("button", name="New class code").click()
    boss.until(f"Boolean({CODE})")
    assert anna.value("vrts.store.now.connection") == "open", "who came by the first one stays"
    assert boss.complaints() == []
    boss.context.close()
    anna.context.close()
