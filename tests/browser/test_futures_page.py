"""The page about every future in a real browser: lines are chosen, replays shown, all readable."""

from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import clock, opened, until
from tests.browser.test_accessibility import ALL_LOOKS
from tests.places import ROOT
from tests.support_commands import vrts_text

pytestmark = pytest.mark.browser

PROGRAM = """\
.PROGRAM main()
        MOVE over
        WAIT SIG(1001)
        IF SIG(1002) THEN
          MOVE low
        END
        IF SIG(1003) THEN
          x = 1/0
        END
.END
.LOCATIONS
over 900 0 100 90 90 0
low 700 0 -320 90 90 0
.END
"""


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    home = tmp_path_factory.mktemp("futures")
    (home / "prog.v2").write_text(PROGRAM)
    scene = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    done = vrts_text("prove", "prog.v2", "--scene", scene, "--html", "page.html", cwd=home)
    assert done.returncode == 1, done.stderr
    return home / "page.html"


@pytest.mark.thorough
def test_each_thing_that_goes_wrong_has_its_replay(browser: Browser, path: Path) -> None:
    view = opened(browser, path, still=True)
    until(view, "document.getElementById('clock').textContent.includes('/ ')")
    first = clock(view)
    assert view.page.inner_text("#shown").lower() in view.page.inner_text("#future-1 h3").lower()
    view.page.click("#future-2 .watch")
    until(view, "location.hash === '#future=2' && document.getElementById('shown') !== null")
    until(view, "document.getElementById('shown').textContent.startsWith('2. ')")
    until(view, "document.querySelectorAll('#lanes .lane').length > 0")
    until(view, "document.getElementById('clock').textContent.includes('/ ')")
    assert clock(view) != first
    assert view.complaints() == []
    view.page.close()


@pytest.mark.thorough
def test_a_line_of_the_tree_tells_its_story_and_its_scenario(browser: Browser, path: Path) -> None:
    view = opened(browser, path, still=True)
    wrong = view.page.locator(".tree a:has(.wrong)").first
    name = wrong.get_attribute("id")
    wrong.locator("path").first.click()
    until(view, f"document.getElementById('{name}').classList.contains('now')")
    assert "Watch 1" in view.page.inner_text("#chosen")
    view.page.locator("#node-1").focus()
    view.page.keyboard.press("Enter")
    until(view, "document.querySelector('#chosen h3').textContent === 'EXECUTE'")
    view.page.click("#chosen summary")
    assert 'title = "EXECUTE"' in view.page.inner_text("#chosen pre")
    assert view.complaints() == []
    view.page.close()


@pytest.mark.thorough
def test_axe_finds_nothing(browser: Browser, path: Path) -> None:
    view = opened(browser, path)
    view.page.evaluate(AXE)
    for width, dark in ALL_LOOKS:
        assert faults(view, width, dark=dark) == [], (width, dark)
    view.page.close()


@pytest.mark.thorough
def test_what_goes_right_can_be_watched_too(browser: Browser, path: Path) -> None:
    view = opened(browser, path, still=True)
    until(view, "document.getElementById('clock').textContent.includes('/ ')")
    key = view.page.evaluate(
        "JSON.parse(document.getElementById('nodes').textContent).nodes.find(n => n.replay).replay"
    )
    view.page.locator(f"#node-{key.removeprefix('n')}").focus()
    view.page.keyboard.press("Enter")
    view.page.click("#chosen .watch")
    until(view, f"location.hash === '#future={key}'")
    until(view, "document.getElementById('clock').textContent.includes('/ ')")
    title = view.page.inner_text("#chosen h3")
    until(view, f"document.getElementById('shown').textContent === {title!r}")
    assert view.complaints() == []
    view.page.close()
