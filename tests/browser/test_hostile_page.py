"""Names that try to become markup or scripts, in what the page's scripts write themselves."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support import PIXEL, opened, until
from tests.support_runs import assessment
from tests.unit.report.test_hostile_strings import CORPUS, judged
from vrts.report.audience import Audience
from vrts.report.page.page import page

pytestmark = pytest.mark.browser

MARKUP = [text for text in CORPUS if set(text) & set("<>&\"'`")]


def test_events_lanes_and_overlays_write_names_as_text(browser: Browser, tmp_path: Path) -> None:
    name = " ".join(MARKUP)
    a = assessment()
    path = tmp_path / "hostile.html"
    a = replace(a, title=name, judgement=judged(a, name))
    path.write_text(page(a, {"moment": PIXEL}, audience=Audience.GRADER), encoding="utf-8")
    view = opened(browser, path, before="window.alert = () => { window.attacked = true; }")
    until(view, "window.vrts !== undefined")
    view.page.evaluate("vrts.player.seek(1.4)")
    counts: dict[str, int] = view.page.evaluate(
        """() => ({ images: document.images.length, scripts: document.scripts.length,
            handlers: document.querySelectorAll("[onerror], [onmouseover], [onfocus]").length })"""
    )
    assert counts == {"images": 1, "scripts": 3, "handlers": 0}
    assert view.page.evaluate("window.attacked === undefined")
    assert view.complaints() == []
    shown = view.page.locator("#events .contact span").inner_text()
    assert "<img src=x onerror=alert(1)>" in shown
    assert "<img src=x onerror=alert(1)>" in view.page.inner_text("#overlay")
    held = view.page.evaluate("JSON.parse(document.getElementById('data').textContent).contacts[0]")
    assert json.dumps(held["held"]) == json.dumps(name)
    view.page.close()
