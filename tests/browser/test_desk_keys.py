"""The desk by keys alone: every part, what is typed wrong, and undoing what others have used."""

import json
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.browser.support import Opened, until
from tests.browser.support_desk import at_desk
from tests.support_desk import write_desk_class
from tests.support_desk_server import DeskProcess
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import Comment, Give
from vrts.marking.layout import Layout

pytestmark = pytest.mark.browser

HAS = "document.activeElement"
NOTES = "document.getElementById('notes').textContent"
ASKED = "document.querySelector('#ask[open]')"
PLACES = {  # where each key leads
    "l": f"{HAS}.matches('#code button.n')",
    "r": f"{HAS}.id === 'tab-lost'",
    "d": f"{HAS}.matches('.graders input')",
    "m": f"{HAS}.id === 'hand-value'",
    "i": f"{HAS}.id === 'item-title'",
    "Escape": f"{HAS}.id === 'list'",
    "x": f"{HAS}.id === 'view-conflicts'",
    "s": f"{HAS}.id === 'view-statistics'",
    "a": f"{HAS}.id === 'view-causes'",
    "w": f"{HAS}.id === 'list'",
}


@pytest.fixture
def layout(tmp_path: Path) -> Layout:
    return write_desk_class(tmp_path, 6)


@pytest.fixture
def view(browser: Browser, layout: Layout) -> Iterator[Opened]:
    with DeskProcess(layout.root, "R. Huber") as server:
        view = at_desk(browser, server)
        yield view
        assert view.complaints() == []
        view.page.context.close()


def press(view: Opened, *keys: str) -> None:
    for key in keys:
        view.page.keyboard.press(key)


def write(view: Opened, text: str) -> None:
    view.page.keyboard.insert_text(text)


def last(layout: Layout) -> dict[str, Any]:
    """Return what was decided last here."""
    text = (layout.decisions / "huber.jsonl").read_text(encoding="utf-8")
    return json.loads(text.splitlines()[-1])


@pytest.mark.thorough
def test_every_part_is_reached_and_nothing_that_is_typed_is_cut(
    view: Opened, layout: Layout
) -> None:
    for key, place in PLACES.items():
        if key in "rdmi":
            press(view, "Escape")
        press(view, key)
        until(view, place)
    for key in ("m", "c"):  # out of every kind of field
        press(view, key, "Tab", "Escape")
        until(view, PLACES["Escape"])
    before = last(layout)
    press(view, "c")
    write(view, "z" * 10_000)
    press(view, "Control+Enter")
    until(view, f"{HAS}.validationMessage.includes('8,000 more')")
    assert view.page.evaluate(f"{HAS}.value.length") == 10_000
    press(view, "Control+a")
    write(view, "pass\u202eliaf")
    press(view, "Control+Enter")
    said = "document.querySelector('.said[dir=auto]')"
    until(view, f"{said}?.textContent === 'pass�liaf'")
    assert last(layout)["number"] == before["number"] + 1


@pytest.mark.thorough
def test_what_changes_others_too_is_undone_when_somebody_has_seen_whom(
    view: Opened, layout: Layout
) -> None:
    press(view, "i")
    write(view, "Grip late")
    press(view, "Tab")
    write(view, "-0.0004")
    press(view, "Enter")
    until(view, f"{HAS}.validationMessage.includes('three decimals')")
    press(view, "Control+a")
    write(view, "-1")
    press(view, "Enter")
    until(view, f"{NOTES}.includes('Added')")
    press(view, "Escape")
    add_decisions(
        layout.decisions, "S. Mayr", [Give(0, "", "grip-late", ("s0002",))], datetime.now(UTC)
    )
    count = "[...document.querySelectorAll('.items .count')].at(-1).textContent"
    until(view, f"{count} === '2'")
    press(view, "u")
    until(view, f"{ASKED}?.textContent.includes('nobody has “Grip late” any more')")
    assert view.page.locator("#ask tbody tr").count() == 1, "who has it from the other grader"
    press(view, "Escape")
    until(view, f"{ASKED} === null")
    assert last(layout)["does"] == "give"
    press(view, "u")
    until(view, f"{ASKED} !== null")
    press(view, "Enter")
    until(view, f"{NOTES}.includes('Undone')")
    assert last(layout)["records"] == ["huber:9", "huber:10"]
    # an item that is gone comes back, and a bulk is undone whole although the page is another one
    until(view, "!document.querySelector('details.versions').hidden")
    gives = [Give(0, "", "grip", (name,)) for name in ("s0000", "s0001", "s0002")]
    beyond = Comment(0, "", "s0002", "nowhere", line=4000)
    add_decisions(layout.decisions, "S. Mayr", [*gives, beyond], datetime.now(UTC))
    view.page.evaluate("history.replaceState(null, '', '#s=s0002')")
    view.page.reload()
    until(view, "document.querySelector('#row-name + .soft')?.textContent === 's0002'")
    until(view, "document.querySelector('.loose')?.textContent.includes('on line 4000, which')")
    press(view, "r", "ArrowRight", "ArrowRight")
    whole = view.page.locator("#panel-history button", has_text="for all 3 who got it at once")
    whole.press("Enter")
    until(view, f"{ASKED}?.textContent.includes('3 students')")
    press(view, "Enter")
    until(view, f"{NOTES}.includes('Undone: item grip given')")
    assert len(last(layout)["records"]) == 3
