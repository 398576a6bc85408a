"""A room's first picture: drawn before the 3D view is there, and followed by it without a jump."""

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Route

from tests.browser.first_picture import BARE, BOX, WITHOUT, arm_share, pixels
from tests.browser.support import PATIENCE
from tests.browser.support_sessions import SHOWN, Desk
from tests.support_live import LiveServer

pytestmark = pytest.mark.browser

MOVED = "DO DRIVE 1,40,100"
STILL = "document.querySelector('#view canvas.still')"


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[LiveServer]:
    with LiveServer(tmp_path_factory.mktemp("still") / "live") as started:
        yield started


@pytest.fixture(scope="module")
def cookie(server: LiveServer) -> str:
    """Somebody who has moved the arm, so that it stands elsewhere than at the beginning."""
    cookie = server.enter("Anna")
    anna = server.join(cookie)
    anna.wait("now")
    lease = anna.take_control()
    of = anna.command(lease, "line", line=MOVED)
    anna.wait("result", lambda m: m["of"] == of)
    anna.wait("now", lambda m: m["status"]["mode"] == "idle")
    server.close_browsers()
    return cookie


def held_back(
    browser: Browser,
    server: LiveServer,
    cookie: str,
    size: tuple[int, int],
    *,
    path: str,
    dark: bool,
    before: str = "",
) -> tuple[Desk, Callable[[], None]]:
    """Open the room while all that is not needed for the first picture stays on its way.

    `before` is what a script does before the page begins.
    """
    context = browser.new_context(
        viewport={"width": size[0], "height": size[1]},
        color_scheme="dark" if dark else "light",
        reduced_motion="reduce",
    )
    context.set_default_timeout(PATIENCE * 1000)
    context.add_init_script(before)
    view = Desk(context.new_page(), context)
    view.page.on("console", lambda m: view.messages.append(f"{m.type}: {m.text}"))
    view.page.on("pageerror", lambda e: view.messages.append(f"exception: {e}"))
    for one in cookie.split("; "):
        name, value = one.split("=", 1)
        context.add_cookies([{"name": name, "value": value, "url": f"http://{server.host}"}])
    waiting: list[Route] = []
    view.page.route("**/web/live/main.js", lambda route: waiting.append(route))
    view.page.goto(f"http://{server.host}{path}", wait_until="commit")

    def go_on() -> None:
        for route in waiting:
            route.continue_()
        view.page.unroute("**/web/live/main.js")

    return view, go_on


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("size", "path", "dark"),
    [
        ((390, 844), "/", False),
        pytest.param((1366, 768), "/", True, marks=pytest.mark.thorough),
        pytest.param((1366, 768), "/?projector", False, marks=pytest.mark.thorough),
    ],
)
def test_the_3d_view_takes_over_from_a_still_without_a_jump(
    browser: Browser,
    server: LiveServer,
    cookie: str,
    size: tuple[int, int],
    path: str,
    dark: bool,
) -> None:
    view, go_on = held_back(browser, server, cookie, size, path=path, dark=dark)
    view.until(f"Boolean({STILL})")
    box, still = view.value(f"({BOX})()"), pixels(view.page)
    assert view.page.locator("#settings-button").is_visible() is False, "it does not work yet"
    link = "document.getElementById('link-state').className"
    view.value(f"{link} = 'chip waiting'")
    assert view.page.locator("#link-state").is_visible(), "a connection that is lost is told"
    view.value(f"{link} = 'chip'")
    go_on()
    view.until(SHOWN)
    gone = "['early', 'unready'].every((name) => !document.body.classList.contains(name))"
    view.until(f"{STILL} === null && {gone}")
    assert view.page.locator("#settings-button").is_visible()
    assert view.value(f"({BOX})()") == pytest.approx(box, abs=0.5), "nothing moves"
    view.page.evaluate(BARE)
    with_arm = pixels(view.page)
    view.page.evaluate(WITHOUT)
    assert arm_share(still, with_arm, pixels(view.page)) > 0.85
    assert view.complaints() == []
    view.context.close()


BROKEN = (
    "CanvasRenderingContext2D.prototype.putImageData = () => { throw new Error('no picture'); };"
)


@pytest.mark.thorough
def test_a_still_that_cannot_be_drawn_hides_nothing(
    browser: Browser, server: LiveServer, cookie: str
) -> None:
    view, _ = held_back(browser, server, cookie, (390, 844), path="/", dark=False, before=BROKEN)
    view.until(f"{STILL} === null && !document.body.classList.contains('early')")
    view.page.locator("#link-state").wait_for(state="visible")
    (said,) = view.complaints()
    assert "the first picture could not be drawn: Error: no picture" in said
    view.context.close()


@pytest.mark.thorough
def test_a_page_of_before_an_upgrade_says_that_it_has_to_be_loaded_again(
    browser: Browser, server: LiveServer, cookie: str
) -> None:
    view, go_on = held_back(browser, server, cookie, (1366, 768), path="/", dark=False)
    go_on()
    view.until(SHOWN)
    view.value("document.querySelector('meta[name=vrts-made]').content = 'before'")
    view.page.click("#tab-pointer")
    told = "document.getElementById('toasts').textContent"
    again = "(the server has another version of vrts now): load the page again"
    view.until(f"{told}.includes({again!r})")
    view.page.click("#tab-editor")
    view.until("document.getElementById('panel-editor').innerText.includes('load the page again')")
    assert view.complaints() == []
    view.context.close()
