"""What is alike in a class marked without names: the desk compares it, and names nobody.

Whose they are is found as for all else there: by the pseudonym in a table that is the owner's.
"""

import csv
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.support import Opened, until
from tests.browser.support_desk import at_desk
from tests.places import ROOT
from tests.support_commands import vrts_text
from tests.support_desk_server import DeskProcess

pytestmark = [pytest.mark.browser, pytest.mark.thorough]

TASK = ROOT / "examples" / "01-cans-on-bases"
NAMES = (  # which no page has by chance
    *("annquist", "hubrow", "benzlak", "mayrholt"),
    *("carlotz", "lutzen", "dorvik", "abelson"),
)
EVERYTHING = "document.documentElement.outerHTML.toLowerCase()"


@pytest.fixture(scope="module")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a marked class: Anna and Ben alike, and like Ben and Dora a year before."""
    home = tmp_path_factory.mktemp("class")
    text = (TASK / "solution.v2").read_text(encoding="utf-8")
    for folder, names in {
        "class": ("annquist-hubrow", "benzlak-mayrholt"),
        "before": ("benzlak-mayrholt", "dorvik-abelson"),
    }.items():
        (home / folder).mkdir()
        for k, name in enumerate(names):
            own = text.replace("; ", f";{' ' * (k + 2)}")
            (home / folder / f"{name}.v2").write_text(own, encoding="utf-8")
    other = '.PROGRAM main()\n  TYPE "no time"\n.END\n'
    (home / "class" / "carlotz-lutzen.v2").write_text(other, encoding="utf-8")
    call = ("grade", TASK, home / "class", "-o", home / "out", "--pseudonyms", "--no-collisions")
    found = vrts_text(*call, "--corpus", home / "before", "-q")
    assert found.returncode == 0, found.stderr
    return home / "out"


@pytest.fixture(scope="module")
def server(out: Path) -> Iterator[DeskProcess]:
    with DeskProcess(out, "R. Huber") as started:
        yield started


def named(view: Opened) -> list[str]:
    """Return the names of students in everything that is on a page, seen or not."""
    pages = [str(frame.evaluate(EVERYTHING)) for frame in view.page.frames]
    return [name for name in NAMES if any(name in one for one in pages)]


def whose(table: Path) -> dict[str, dict[str, str]]:
    """Return the lines of a table by pseudonym."""
    with table.open(encoding="utf-8-sig", newline="") as file:
        return {line["pseudonym"]: line for line in csv.DictReader(file)}


def test_two_programs_side_by_side_name_nobody_and_tables_tell_whose_they_are(
    browser: Browser, server: DeskProcess, out: Path
) -> None:
    own = whose(out / "staff" / "names.csv")
    called = {line["id"]: name for name, line in own.items()}
    anna, ben = called["annquist-hubrow"], called["benzlak-mayrholt"]
    view = at_desk(browser, server)
    view.page.keyboard.press("/")
    view.page.keyboard.type(anna)
    view.page.keyboard.press("Escape")
    view.page.keyboard.press("Home")
    until(view, f"document.getElementById('row-name').textContent.includes('{anna}')")
    view.page.click(f"[aria-label='Compare with {ben}']")
    until(view, "document.querySelectorAll('#compare iframe').length === 2")
    assert view.page.inner_text("#compare-title") == f"{anna} and {ben}"
    for frame in view.page.frames[1:]:
        frame.wait_for_selector("#replay, #source, main", state="attached")
    assert named(view) == []
    view.page.click("#compare >> text=Close")
    link = f"a[aria-label='Compare with before/{ben}']"
    assert view.page.get_attribute(link, "href") == "/files/staff/similarity.html"

    view.page.goto(f"{server.page}files/staff/similarity.html")
    assert named(view) == []
    again = False
    for address in view.page.eval_on_selector_all(
        "table.groups a[href*=pair]", "all => all.map((one) => one.href)"
    ):
        view.page.goto(address)
        assert named(view) == []
        again |= "the same identifier" in view.page.inner_text("main, body")
    assert again, "who hands in again has one pseudonym in both years"
    view.page.context.close()

    before = whose(out / "staff" / "similarity" / "names.csv")
    assert {(one["folder"], one["id"]) for one in before.values()} == {
        ("before", "benzlak-mayrholt"),
        ("before", "dorvik-abelson"),
    }
    assert before[ben]["id"] == own[ben]["id"] == "benzlak-mayrholt"
    assert (out / "staff" / "similarity" / "names.csv").stat().st_mode & 0o077 == 0
