"""axe-core as the tests have it finds all that it finds by itself."""

import json
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, PLAIN
from tests.browser.support import opened

pytestmark = [pytest.mark.browser, pytest.mark.thorough]

FAULTY = """<!doctype html><title>Faults</title>
<style>
  body { background: #fff; color: rgb(130 130 130) }
  .over { background: rgba(0, 0, 0, 0.4); color: hsl(200deg 40% 50%) }
  .pale { opacity: 0.5 }
  .mixed { color: color-mix(in srgb, red 30%, white); mix-blend-mode: multiply }
  .shadow { color: oklch(0.7 0.1 0.5turn); text-shadow: 0 0 2px #777 }
  a { color: #767676; text-decoration: none }
</style>
<img src="data:,"><input><button></button><ul><p>no row</p></ul>
<p>grey on white, <a href="#x">a link</a> in a sentence
<p class="over">on a grey <b class="pale">and pale</b> <i class="mixed">and mixed</i>
<p class="shadow">with a shadow <a href="#x">and a link</a>
<div tabindex="5" role="button" aria-labelledby="nobody" style="width: 9px; height: 9px"></div>
"""
EVERYTHING = """async () => {
  const rules = Object.fromEntries(axe.getRules().map(rule => [rule.ruleId, { enabled: true }]));
  const found = await axe.run(document, { rules });
  return ["violations", "passes", "incomplete", "inapplicable"].map(kind => found[kind]);
}"""


def test_made_quicker_it_finds_the_same(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "faulty.html"
    path.write_text(FAULTY, encoding="utf-8")
    found: list[list[list[Any]]] = []
    for axe in (PLAIN, AXE):
        view = opened(browser, path)
        view.page.evaluate(axe)
        found.append(view.page.evaluate(EVERYTHING))
        view.page.close()
    plain, quick = found
    names = {one["id"] for one in plain[0]}
    assert {"color-contrast", "color-contrast-enhanced", "image-alt", "list"} <= names
    assert len(plain[2]) > 0, "of something it is not sure"
    assert json.dumps(quick) == json.dumps(plain)
