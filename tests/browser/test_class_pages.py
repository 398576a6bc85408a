"""The page of a class in a real browser: sorting, searching, filtering, printing, many rows."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support import Opened, opened
from tests.support_rows import some_class
from vrts.marking.overview.page import overview_page

pytestmark = pytest.mark.browser

COUNT = 400
MANY = 1000
SHOWN = "document.querySelectorAll('#submissions tbody tr:not([hidden])').length"
FIRST = "#submissions tbody tr:not([hidden]) td:nth-child(2) >> nth=0"


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("class") / "index.html"
    path.write_text(overview_page(some_class(COUNT)), encoding="utf-8")
    return path


@pytest.fixture
def view(browser: Browser, path: Path) -> Iterator[Opened]:
    view = opened(browser, path, still=True)
    yield view
    assert view.messages == []
    assert all(url.startswith("file:") for url in view.requests)
    view.page.close()


@pytest.mark.thorough
def test_columns_sort_both_ways_numbers_as_numbers(view: Opened) -> None:
    page = view.page
    page.click("#submissions th >> text=Final")
    assert page.get_attribute("#submissions th:nth-child(2)", "aria-sort") == "ascending"
    assert page.inner_text(FIRST) == "–"
    page.click("#submissions th >> text=Final")
    assert page.inner_text(FIRST) == "10.0"
    page.click("#submissions th >> text=Time")
    page.click("#submissions th >> text=Time")
    times: list[float] = page.eval_on_selector_all(
        "#submissions td:nth-child(6)", "cells => cells.map(cell => Number(cell.dataset.sort))"
    )
    assert times == sorted(times, reverse=True)
    assert page.locator("#submissions th[aria-sort]").count() == 1


@pytest.mark.thorough
def test_search_status_and_boxes_narrow_the_table_together(view: Opened) -> None:
    page = view.page
    page.keyboard.press("/")
    page.keyboard.type("ömer login2")
    found: int = page.evaluate(SHOWN)
    assert 0 < found < COUNT / 6
    assert page.inner_text("#count") == f"{found} of {COUNT}"
    page.check("#filters input[value=late]")
    late: int = page.evaluate(SHOWN)
    assert 0 < late < found
    page.select_option("#kind", "missing")
    page.fill("#search", "no such student")
    assert page.evaluate(SHOWN) == 0
    assert page.locator("#none").is_visible()
    page.fill("#search", "")
    page.uncheck("#filters input[value=late]")
    kinds: list[str] = page.eval_on_selector_all(
        "#submissions tbody tr:not([hidden])", "rows => rows.map(row => row.dataset.kind)"
    )
    assert set(kinds) == {"missing"}


@pytest.mark.thorough
def test_what_became_of_them_filters_the_table(view: Opened) -> None:
    page = view.page
    page.focus("button[data-kind=ambiguous]")
    page.keyboard.press("Enter")
    assert page.get_attribute("button[data-kind=ambiguous]", "aria-pressed") == "true"
    assert page.input_value("#kind") == "ambiguous"
    assert 0 < page.evaluate(SHOWN) < COUNT / 10
    page.keyboard.press("Enter")
    assert page.evaluate(SHOWN) == COUNT


@pytest.mark.thorough
def test_a_thousand_rows_stay_quick(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "index.html"
    path.write_text(overview_page(some_class(MANY)), encoding="utf-8")
    view = opened(browser, path, still=True)
    spent: float = view.page.evaluate(
        """() => { const begin = performance.now();
            const search = document.getElementById("search");
            for (const text of ["a", "an", "ann", "anna", ""]) {
              search.value = text;
              search.dispatchEvent(new Event("input"));
              document.body.offsetHeight;
            }
            for (const head of document.querySelectorAll("#submissions th")) head.click();
            document.body.offsetHeight;
            return performance.now() - begin; }"""
    )
    assert spent < 10_000  # far above what it takes, far below what a slow way would
    view.page.close()


def test_paper_has_the_table_and_not_what_steers_it(view: Opened) -> None:
    page = view.page
    page.emulate_media(media="print")
    for gone in ("nav", "#filters"):
        assert not page.locator(gone).is_visible(), gone
    for kept in (".bars", ".kinds", "#checks", "#changes", "#submissions"):
        assert page.locator(kept).is_visible(), kept
    page.emulate_media(media="screen")


@pytest.mark.thorough
def test_every_control_is_reached_by_keyboard_and_shows_it(view: Opened) -> None:
    page = view.page
    page.focus("#search")
    reached: set[str] = set()
    for _ in range(16):
        page.keyboard.press("Tab")
        name, outline = page.evaluate(
            """() => { const e = document.activeElement;
                return [e.id || e.textContent, getComputedStyle(e).outlineStyle]; }"""
        )
        assert outline != "none", name
        reached.add(name)
    assert {"kind", "Final", "Costliest cause"} <= reached
