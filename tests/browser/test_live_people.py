"""People in real browsers: names of any script, badges of roles, who is muted, who is sent away."""

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser

from tests.browser.support_sessions import Desk, desk, student, supervisor
from tests.support_live import LiveServer
from vrts.live.new_account import add_user

pytestmark = [pytest.mark.browser, pytest.mark.live]

LEFTWARD = "שרה כהן"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    folder = tmp_path_factory.mktemp("live")
    add_user(folder, "Dr. Lee", "correct horse", supervisor=True)
    with LiveServer(folder) as server:
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
    student_.until("window.vrts?.store.now.name === 'Berta'")
    student_.until("document.getElementById('panel-chat').textContent.includes('has muted you')")
    lead.page.click("button:text('Let speak again')")
    student_.until("!document.getElementById('panel-chat').querySelector('form').hidden")


SHOWN = (
    "document.querySelector('.announced:not([hidden]) .what')?.textContent === 'Read <b>page 4</b>'"
)


def test_an_announcement_stands_on_top_of_every_page_until_it_is_closed(
    server: LiveServer, lead: Desk, student_: Desk
) -> None:
    wall, projector = (lead.context.new_page() for _ in range(2))
    wall.goto(f"http://{server.host}/?wall")
    projector.goto(f"http://{server.host}/?projector")
    for page in (wall, projector):
        page.wait_for_selector(".notices", state="attached")
    lead.page.click("#tab-lead")
    lead.page.fill("#broadcast-text", "Read <b>page 4</b>")
    lead.page.click("button:text('Send to all')")
    for page in (lead.page, student_.page, wall, projector):
        page.wait_for_selector(".announced:not([hidden]) .what")
        assert page.text_content(".announced .what") == "Read <b>page 4</b>"
        assert page.get_attribute(".announced", "role") == "alert"
    assert not student_.page.locator(".announced .seen").count()
    assert student_.page.locator("#panic, #control-button").first.is_visible()
    seen = "document.querySelector('.announced .seen').textContent"
    lead.until(f"/^Seen by 1 of [12], closed by 0$/.test({seen})")
    student_.page.click(".announced .close")
    assert student_.page.locator(".announced").is_hidden()
    lead.until(f"/^Seen by 1 of [12], closed by 1$/.test({seen})")
    late = student(lead.context.browser, server, "Late")  # pyright: ignore[reportArgumentType]
    late.until(SHOWN)
    student_.page.reload()
    student_.until("Boolean(window.vrts?.world?.state)")
    assert student_.page.locator(".announced").is_hidden(), "it stays closed"
    lead.page.click("button:text('Take it down')")
    for page in (late.page, wall, projector):
        page.wait_for_selector(".announced", state="hidden")
    for one in (late.context,):
        one.close()
    wall.close()
    projector.close()


STOPPED = "document.querySelector('.stopped:not([hidden], .waits)')?.textContent ?? ''"


def test_everybody_sees_who_stopped_the_arm_and_how_to_go_on(lead: Desk, student_: Desk) -> None:
    student_.page.click("#control-button")
    student_.until("vrts.store.operator")
    viewer = "the viewer has no button that the server would refuse"
    for id_ in ("hand-open", "hand-close", "ready", "terminal-line", "terminal-interrupt"):
        assert lead.page.is_disabled(f"#{id_}"), viewer
        assert "take control first" in (lead.page.get_attribute(f"#{id_}", "title") or "")
    student_.page.click("#panic")
    student_.until(f"{STOPPED}.includes('You pressed PANIC')")
    assert "RETRY" in student_.value(STOPPED)
    lead.until(f"{STOPPED}.includes('Berta')")
    assert "with control" in lead.value(STOPPED)
    assert lead.value("document.querySelector('.stopped .badge').textContent") == "operator"
    lead.page.click("#tab-lead")
    lead.page.click("#lead-freeze")
    student_.until("document.getElementById('hand-open').title.includes('frozen')")
    student_.until(f"{STOPPED}.includes('goes on when they unfreeze it')")
    lead.page.click("#lead-freeze")
    student_.until("!document.getElementById('hand-open').disabled")
    student_.page.click("#tab-monitor")
    student_.type("DO DRIVE 1,10,100")
    for one in (student_, lead):
        one.page.wait_for_selector(".stopped", state="hidden")


def test_the_empty_line_says_what_the_monitor_waits_for(student_: Desk) -> None:
    hint = "document.getElementById('terminal-line').placeholder"
    student_.until("vrts.store.now.status.mode === 'idle'")
    student_.until(f"{hint}.startsWith('WHERE')")
    for line, expected in (
        ("POINT p1", "Up to six numbers"),
        ("", "WHERE"),
        ("TEACH p", "R records"),
        ("", "WHERE"),
        ("EDIT pick", "A step"),
        ("E", "WHERE"),
        ("ZERO", "Y to do it"),
        ("N", "WHERE"),
    ):
        student_.type(line)
        student_.until(f"{hint}.startsWith('{expected}')")


def test_the_admin_page_is_for_supervisors_with_an_account(
    browser: Browser, server: LiveServer, lead: Desk
) -> None:
    page = lead.context.new_page()
    page.goto(f"http://{server.host}/admin")
    page.wait_for_selector("#admin [role=alert]:text('Only a supervisor with an account')")
    page.close()
    admin = desk(browser, server, "/admin", width=390)
    admin.page.click("summary:text('Log in with an account')")
    admin.page.fill("[name=user]", "Dr. Lee")
    admin.page.fill("[name=password]", "correct horse")
    admin.page.press("[name=password]", "Enter")
    text = "document.getElementById('admin-blocks').textContent"
    for words in ("all is well", "Class code", "of 5000", "No copy of the database"):
        admin.until(f"(document.getElementById('admin').textContent).includes('{words}')")
    admin.until(f"/Sessions1 of 1 run/.test({text})")
    assert admin.value("document.documentElement.scrollWidth") <= 390, "nothing stands out"
    assert admin.complaints()[1:] == [], "and the first: nobody was logged in"
    admin.context.close()
