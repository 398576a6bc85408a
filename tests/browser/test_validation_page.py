"""The page of a comparison with a real robot in a real browser: wide, narrow, dark, on paper."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support import opened
from tests.browser.test_accessibility import ALL_LOOKS, AXE, faults
from tests.unit.validate.support import EXAMPLE, path_run
from vrts.validate.comparison import read_and_compare
from vrts.validate.log.log import GivenLog
from vrts.validate.offsets import Wanted
from vrts.validate.reports.comparison_page import comparison_page

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the page of the lesson's log."""
    data = (EXAMPLE / "robot.csv").read_bytes()
    found = read_and_compare(
        path_run(), GivenLog("robot.csv", (data,)), Wanted(time=True, base=True)
    )
    page = tmp_path_factory.mktemp("validation") / "report.html"
    page.write_text(comparison_page(found, "path.v2"), encoding="utf-8")
    return page


@pytest.mark.thorough
def test_axe_finds_nothing(browser: Browser, path: Path) -> None:
    view = opened(browser, path)
    view.page.evaluate(AXE)
    for width, dark in ALL_LOOKS:
        assert faults(view, width, dark=dark) == [], (width, dark)
    assert (len(view.requests), view.complaints()) == (1, [])
    view.page.close()


def test_figures_are_on_paper(browser: Browser, path: Path) -> None:
    view = opened(browser, path)
    view.page.emulate_media(media="print")
    heights = view.page.evaluate(
        "[...document.querySelectorAll('svg')].map(e => e.getBoundingClientRect().height)"
    )
    assert len(heights) == 8
    assert all(60.0 < height < 420.0 for height in heights)
    view.page.close()
