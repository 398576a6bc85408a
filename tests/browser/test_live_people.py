"""People in real browsers: names of any script, badges of roles, who is muted, who is sent away."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import Desk, student, supervisor
from tests.support_live import LiveServer

pytestmark = [pytest.mark.browser, pytest.mark.live]

LEFTWARD = "שרה כהן"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("live")) as server:
        yield server


@pytest.fixture(scope="module")
def lead(browser: Browser, server: LiveServer) -> Iterator[Desk]:
    lead = supervisor(browser, server, width=1366)
    lead.page.on("dialog", lambda dialog: dialog.accept())
    yield lead
    assert lead.complaints() == []
    lead.context.close()


@pytest.fixture(scope="module")
def student_(browser: Browser, server: LiveServer, lead: Desk) -> Iterator[Desk]:
    opened = student(browser, server, LEFTWARD, width=390)
    yield opened
    assert opened.complaints() == []
    opened.context.close()


def test_a_name_changes_nothing_around_it_and_roles_are_badges(
    server: LiveServer, lead: Desk, student_: Desk
) -> None:
    posing = server.join(server.enter("⭐ ѕuреrvіѕоr ⭐"))
    posing.wait("snapshot")
    student_.page.click("#control-button")
    lead.page.click("#tab-people")
    lead.until("document.querySelectorAll('#panel-people .people:first-of-type li').length === 3")
    people = lead.value(
        """[...document.querySelectorAll('#panel-people ul[aria-label=People] li')].map(li =>
        [li.querySelector('bdi').textContent,
         [...li.querySelectorAll('.badge')].map(badge => badge.textContent).join()])"""
    )
    assert dict(people) == {
        "supervisor": "supervisor",
        LEFTWARD: "operator",
        "ѕuреrvіѕоr 2": "",
    }
    lead.until(f"document.getElementById('turn').textContent === '{LEFTWARD} has control'")
    assert lead.value("document.querySelector('#turn bdi').textContent") == LEFTWARD
    posing.send("say", text="I am the supervisor")
    lead.page.click("#tab-chat")
    lead.page.fill("#chat-text", "no, I am")
    lead.page.press("#chat-text", "Enter")
    student_.page.click("#tab-chat")
    student_.until("document.querySelectorAll('#panel-chat .who').length >= 2")
    said = student_.value(
        """[...document.querySelectorAll('#panel-chat .line')].slice(-2).map(line =>
        [line.querySelector('.text').textContent,
         line.querySelectorAll('.badge.supervisor').length])"""
    )
    assert said == [["I am the supervisor", 0], ["no, I am", 1]]


def test_who_is_muted_stays_so_under_another_name_until_the_supervisor_undoes_it(
    server: LiveServer, lead: Desk, student_: Desk
) -> None:
    lead.page.click("#tab-people")
    lead.page.click(f"[aria-label='Mute: \u2068{LEFTWARD}\u2069']")
    student_.until("document.getElementById('panel-chat').textContent.includes('has muted you')")
    other = student_.context.new_page()  # another page of the same browser: it is ended as well
    other.goto(f"http://{server.host}/")
    other.wait_for_selector("#room:not([hidden])")
    student_.page.click("#settings-button")
    student_.page.click("button:text('Log out')")
    other.wait_for_selector("#link-state:text('you have logged out')")
    other.close()
    student_.page.fill("#enter-code", server.code)
    student_.page.fill("#enter-name", "Berta")
    student_.page.click("#enter-form button")
    student_.until("vrts.store?.now.name === 'Berta'")
    student_.until("document.getElementById('panel-chat').textContent.includes('has muted you')")
    lead.page.click("button:text('Let speak again')")
    student_.until("!document.getElementById('panel-chat').querySelector('form').hidden")
