"""The operator's sheet in a real browser: one printed page, asking for nothing."""

import pytest
from playwright.sync_api import Browser

from tests.browser.support import Opened, opened
from vrts.dispatch.planning.plan import plan
from vrts.dispatch.planning.reasons.refusals import Promise, finding_of
from vrts.dispatch.planning.wish import Wish
from vrts.dispatch.profile import find_profile
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import CHECKOUT
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task

pytestmark = [pytest.mark.browser, pytest.mark.thorough]

PAGE_MM = 279.0  # of A4, between the margins
MM_PER_PIXEL = 25.4 / 96.0


@pytest.fixture(scope="module")
def view(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Opened:
    """Open the sheet of the largest example, with a waiver on it."""
    example = CHECKOUT / "examples" / "04-final-project"
    data = (example / "solution.v2").read_bytes()
    why = "the oven was measured twice, to half a millimetre"
    request = Request(ProgramFile(data, "solution.v2"), load_task(example))
    wish = Wish(request, find_profile("mark2-val2"), 14.0)
    refused = plan(wish).refused
    promises = tuple(Promise(finding_of(one), why, "R. Huber") for one in refused)
    found = plan(wish._replace(promises=promises, fails_first=True))
    assert found.bundle is not None, found.refused
    path = tmp_path_factory.mktemp("sheet") / "sheet.html"
    path.write_text(found.bundle.sheet, "utf-8")
    return opened(browser, path, 718)


def test_it_is_one_page_on_paper(view: Opened) -> None:
    view.page.emulate_media(media="print")
    bottom = view.page.evaluate("document.querySelector('footer').getBoundingClientRect().bottom")
    assert float(bottom) * MM_PER_PIXEL < PAGE_MM
    paper = view.page.pdf(prefer_css_page_size=True)
    assert paper.count(b"/Type /Page") - paper.count(b"/Type /Pages") == 1


def test_it_asks_for_nothing_and_complains_of_nothing(view: Opened) -> None:
    assert len(view.requests) == 1
    assert view.complaints() == []


def test_everything_is_within_the_page(view: Opened) -> None:
    view.page.emulate_media(media="print")
    wide = view.page.evaluate(
        "[...document.querySelectorAll('body *')].filter(e => e.getBoundingClientRect().right >"
        " document.body.getBoundingClientRect().right + 1 && !e.closest('svg')).length"
    )
    assert wide == 0


def test_waivers_stand_above_everything_else(view: Opened) -> None:
    text: str = view.page.inner_text("body")
    assert text.index("R. Huber") < text.index("What it does")
    assert "NOT ALL PROVEN" in text
    assert "14 mm are asked for" in text


def test_the_drawing_names_every_object(view: Opened) -> None:
    names: list[str] = view.page.evaluate(
        "[...document.querySelectorAll('svg text.name')].map(e => e.textContent)"
    )
    assert {"can1", "dish", "oven", "table", "robot"} <= set(names)
