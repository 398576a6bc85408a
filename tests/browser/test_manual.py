"""The manual in Chromium, from plain files: for everybody, searched without a server, on paper."""

from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import Opened, opened, until
from tests.browser.test_accessibility import ALL_LOOKS, ESSENTIAL, PHONE
from tests.support_site import built_site

pytestmark = pytest.mark.browser

PAGES = (
    "index",
    "learn/01-cans-on-bases",
    "do/wait-a-time",
    "look-up/words/functions",
    "look-up/cheat-sheet",
    "look-up/files/scene",
    "look-up/commands/verify",
    "understand/assumptions",
    "search",
)
OFTEN = ("index", "look-up/cheat-sheet")


def page_of(name: str) -> Path:
    return built_site() / f"{name}.html"


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("name", "looks"),
    [
        *(pytest.param(name, ESSENTIAL, id=name) for name in OFTEN),
        *(
            pytest.param(name, ALL_LOOKS, id=f"{name} every look", marks=pytest.mark.thorough)
            for name in PAGES
        ),
    ],
)
def test_axe_finds_nothing(browser: Browser, name: str, looks: list[tuple[int, bool]]) -> None:
    view = opened(browser, page_of(name), looks[0][0], dark=looks[0][1])
    assert view.complaints() == []
    assert [url for url in view.requests if not url.startswith(("file:", "data:"))] == []
    view.page.evaluate(AXE)
    for width, dark in looks:
        found: list[Any] = faults(view, width, dark=dark)
        assert found == [], (width, dark)
    view.page.close()


def searched(browser: Browser, words: str) -> Opened:
    """Type a question into the first page and wait for the answer."""
    view = opened(browser, page_of("index"))
    view.page.fill("#ask", words)
    view.page.press("#ask", "Enter")
    until(view, "document.querySelectorAll('#search-results li').length > 0")
    return view


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("words", "title"),
    [("wait 2 seconds", "Wait 2 seconds"), ("MOVES", "MOVES"), ("V301", "V301 out-of-reach")],
)
def test_the_search_works_without_a_server(browser: Browser, words: str, title: str) -> None:
    view = searched(browser, words)
    first = view.page.locator("#search-results li a").first
    assert title in first.inner_text()
    first.click()
    until(view, "document.readyState === 'complete'")
    assert "search.html" not in view.page.url
    assert view.complaints() == []
    view.page.close()


@pytest.mark.thorough
def test_on_a_phone_the_list_of_pages_opens(browser: Browser) -> None:
    view = opened(browser, page_of("look-up/words/index"), PHONE)
    link = view.page.locator(".sidebar-tree a", has_text="VAL-II on two pages")
    assert not link.is_visible() or link.bounding_box()["x"] < 0  # pyright: ignore[reportOptionalSubscript]
    view.page.click("label[for='__navigation'] >> visible=true")
    until(view, "document.querySelector('.sidebar-drawer').getBoundingClientRect().x >= 0")
    view.page.close()


@pytest.mark.thorough
def test_the_cheat_sheet_fits_on_two_pages(browser: Browser) -> None:
    view = opened(browser, page_of("look-up/cheat-sheet"))
    document = view.page.pdf(format="A4", prefer_css_page_size=True)
    assert document.count(b"/Type /Page\n") == 2
    view.page.close()


@pytest.mark.thorough
def test_paper_has_the_text_and_nothing_to_press(browser: Browser) -> None:
    view = opened(browser, page_of("learn/01-cans-on-bases"))
    view.page.emulate_media(media="print")
    for gone in (".sidebar-drawer", ".toc-drawer", ".theme-toggle", "a.headerlink"):
        assert not view.page.locator(gone).first.is_visible(), gone
    assert view.page.locator("article h1").is_visible()
    assert view.page.locator("article img").first.is_visible()
    view.page.close()
