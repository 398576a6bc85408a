"""The graders' desk in a real browser: by keyboard alone, two graders, hostile texts, axe."""

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser

from tests.browser.axe import AXE, faults
from tests.browser.support import PIXEL, Opened, until
from tests.browser.support_desk import at_desk
from tests.support_desk import HOSTILE, write_desk_class
from tests.support_desk_server import DeskProcess
from tests.support_runs import CONTACT_S, assessment
from tests.unit.marking.similarity.support import ORIGINAL
from vrts.marking.layout import Layout
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.files import write_similarity
from vrts.marking.similarity.kept import Kept
from vrts.report.page.page import page
from vrts.web.assets import asset

pytestmark = pytest.mark.browser

WIDE, PHONE = 1366, 390
MANUAL = Path(__file__).parents[2] / "vrts" / "manual" / "understand" / "desk.md"
NAME = "document.getElementById('row-name').textContent"
MARK = "document.querySelector('.final').textContent"
NOTES = "document.getElementById('notes').textContent"
CONFLICTS = "document.getElementById('conflict-count').textContent"
OVERRIDE = """[[change]]
student = "s0010"  # whom a grader has excused
delta = 0.5
reason = "shown in the lab"
who = "W. Lutz"
date = "2026-11-30"
"""
CHECKED = "document.querySelector('[name=comment-place]:checked').value"


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Return a class whose reports show a true replay, and whose first name is markup."""
    layout = write_desk_class(tmp_path, 12, hostile=True)
    layout.overrides.write_text(OVERRIDE, encoding="utf-8")
    report = page(assessment(), {"moment": PIXEL})
    for place in (layout.staff / "students").glob("*/report.html"):
        place.write_text(report, encoding="utf-8")
    return tmp_path / "out"


@pytest.fixture
def server(out: Path) -> Iterator[DeskProcess]:
    with DeskProcess(out, "R. Huber") as started:
        yield started


def decided(out: Path, who: str) -> list[dict[str, object]]:
    """Return the records of a grader."""
    text = (out / "staff" / "decisions" / f"{who}.jsonl").read_text(encoding="utf-8")
    return [json.loads(line) for line in text.splitlines()[1:]]


def press(view: Opened, *keys: str) -> None:
    for key in keys:
        view.page.keyboard.press(key)


def search(view: Opened, words: str) -> None:
    """Find one program by keyboard and look at it."""
    press(view, "/")
    view.page.keyboard.type(words)
    press(view, "Escape", "Home")
    until(view, f"{NAME}.includes({json.dumps(words)})")
    until(view, "document.querySelector('#code li code') !== null")


@pytest.mark.thorough
def test_a_program_is_marked_by_keyboard_alone(
    browser: Browser, server: DeskProcess, out: Path
) -> None:
    view = at_desk(browser, server)
    search(view, "Femi")
    name, before = view.page.evaluate(NAME), float(view.page.evaluate(MARK))
    press(view, "1")
    until(view, f"{NOTES}.includes('Gave')")
    until(view, f"{MARK} === '{before - 0.5:.1f}'")
    press(view, "u")
    until(view, f"{NOTES}.includes('Undone') && {MARK} === '{before:.1f}'")
    press(view, "1")
    until(view, f"{MARK} === '{before - 0.5:.1f}' && !document.querySelector('.pending')")

    # the replay goes where the keys say, and a comment stands at the moment that is shown
    until(view, "document.querySelector('[value=moment]').disabled === false")
    until(view, f"document.querySelector('.write').textContent.includes('{CONTACT_S[0]:.2f} s')")
    # who is not the replay in the frame tells the desk nothing, nor does the frame tell itself
    view.page.evaluate("window.postMessage({ vrts: 'shown', time_s: 0, line: 1, end_s: 9 }, '*')")
    view.page.frames[-1].evaluate("window.postMessage({ vrts: 'show', time_s: 0 }, '*')")
    press(view, "Shift+ArrowRight")
    moment = f"{CONTACT_S[0] + 1:.2f} s"
    until(view, f"document.querySelector('.write').textContent.includes('{moment}')")
    press(view, "c")
    assert view.page.evaluate(CHECKED) == "moment"
    view.page.keyboard.type("jumps & <b>n</b> are typed here")
    press(view, "Control+Enter")
    until(view, "document.querySelector('#code .comment, .loose .comment') !== null")
    assert view.page.evaluate("document.getElementById('comment').value") == ""
    shown = view.page.frame_locator("#frame iframe").locator(".noted .note p:first-child")
    assert shown.inner_text() == "jumps & <b>n</b> are typed here"  # at once, on the replay, too
    press(view, "Escape")
    assert view.page.evaluate("document.activeElement.id") == "list"

    press(view, "f")
    until(view, f"{NAME} !== {json.dumps(name)} && {NOTES}.includes('Finished')")
    search(view, name)
    until(view, "document.querySelector('.chips').textContent.includes('✓ R. Huber')")
    said = [one["does"] for one in decided(out, "huber")[8:]]
    assert said == ["give", "undo", "give", "comment", "finish"]
    assert view.complaints() == []
    view.page.context.close()


@pytest.mark.thorough
def test_keys_are_silent_while_typing_and_can_be_turned_off(
    browser: Browser, server: DeskProcess, out: Path
) -> None:
    view = at_desk(browser, server)
    before = decided(out, "huber")
    name = view.page.evaluate(NAME)
    press(view, "c")
    view.page.keyboard.type("jknf1u")
    assert view.page.evaluate("document.getElementById('comment').value") == "jknf1u"
    press(view, "Escape")
    view.page.click("#settings-button")
    view.page.uncheck("#setting-keys")
    press(view, "Escape", "j", "1", "f", "?")
    assert view.page.evaluate(NAME) == name
    assert not view.page.is_visible("#keys")
    assert decided(out, "huber") == before

    # typed text survives a server that is gone, and the page says so
    server.end()
    view.page.click(".write button")
    until(view, f"{NOTES}.includes('what you typed is kept')")
    assert view.page.evaluate("document.getElementById('comment').value") == "jknf1u"
    until(view, "document.getElementById('link-state').textContent !== ''")
    view.page.context.close()


@pytest.mark.thorough
def test_two_graders_see_each_other_and_settle_what_they_decide_differently(
    browser: Browser, server: DeskProcess, out: Path
) -> None:
    with DeskProcess(out, "S. Mayr") as other:
        mine, theirs = at_desk(browser, server), at_desk(browser, other)
        assert mine.page.evaluate(CONFLICTS) == theirs.page.evaluate(CONFLICTS) != ""
        count = int(mine.page.evaluate(CONFLICTS))
        for view in (mine, theirs):  # who marks it each alone
            search(view, "Femi")
        alone = theirs.page.evaluate(MARK)
        press(mine, "1")
        until(mine, f"{MARK} !== '{alone}' && {NOTES}.includes('Gave')")
        for view in (mine, theirs):
            search(view, "Daria")
        before = theirs.page.evaluate(MARK)
        press(mine, "1")
        until(theirs, f"{MARK} !== '{before}'")
        search(theirs, "Femi")
        assert theirs.page.evaluate(MARK) == alone, "and what came before that is hidden"
        assert "on your own" in (theirs.page.text_content(".chips") or "")
        mine.page.click("[data-go=conflicts]")
        first = mine.page.locator(".dispute").first
        first.locator("button.main").last.click()
        assert first.locator("input").evaluate("(one) => one.validationMessage") != ""
        first.locator("input").fill("the paper counts")
        first.locator("button.main").last.click()
        for view in (mine, theirs):
            until(view, f"Number({CONFLICTS}) === {count - 1}")
        assert decided(out, "huber")[-1]["does"] == "decide"
        for view in (mine, theirs):
            assert view.complaints() == []
            view.page.context.close()


@pytest.mark.thorough
def test_one_decision_for_all_who_lost_by_a_cause(
    browser: Browser, server: DeskProcess, out: Path
) -> None:
    view = at_desk(browser, server)
    view.page.click("[data-go=causes]")
    students = view.page.locator("#view-causes tbody input")
    count = students.count()
    assert count > 1
    students.first.uncheck()
    view.page.select_option("#view-causes select", " new")
    view.page.fill("#view-causes [placeholder='Title of the new item']", HOSTILE)
    view.page.fill("#view-causes .short", "−0,25")
    view.page.fill("#view-causes textarea", HOSTILE)
    view.page.click("#view-causes .main")
    until(view, f"document.getElementById('ask').textContent.includes('{count - 1} student')")
    view.page.click("#ask .main")
    until(view, f"{NOTES}.includes('Gave')")
    said = decided(out, "huber")[8:]
    assert [one["does"] for one in said] == [
        "item",
        *["give"] * (count - 1),
        *["comment"] * (count - 1),
    ]
    assert said[0]["points"] == "-1/4"
    view.page.click("#notes button >> text=Undo")
    until(view, f"{NOTES}.includes('Undone')")
    assert len(decided(out, "huber")[-1]["records"]) == len(said)  # pyright: ignore[reportArgumentType]
    assert view.complaints() == []
    view.page.context.close()


@pytest.mark.thorough
def test_axe_finds_nothing_and_hostile_texts_are_texts(
    browser: Browser, server: DeskProcess
) -> None:
    view = at_desk(browser, server)
    view.page.evaluate(AXE)
    search(view, HOSTILE[:8])
    assert HOSTILE in view.page.evaluate(NAME)
    assert HOSTILE in view.page.inner_text("#code")
    press(view, "c")
    view.page.keyboard.type(HOSTILE)
    press(view, "Control+Enter")
    said = "[...document.querySelectorAll('.said')].map((one) => one.textContent)"
    until(view, f"{said}.includes({json.dumps(HOSTILE)})")
    press(view, "Escape")
    assert view.page.locator("main script, #notes script").count() == 0
    for name in ("work", "conflicts", "causes", "statistics"):
        view.page.click(f"[data-go={name}]")
        if name == "conflicts":
            told = view.page.locator(".dispute", has_text="overrides.toml")
            assert "Delete the one in that file" in told.inner_text()
            assert told.locator("button.main").count() == 0, "there is no side to choose"
        if name == "statistics":
            until(view, "document.querySelector('#view-statistics svg') !== null")
        for dark in (False, True):
            assert faults(view, WIDE, dark=dark) == [], (name, dark)
    view.page.set_viewport_size({"width": PHONE, "height": 844})
    view.page.click("[data-go=work]")
    for part in ("list", "replay", "source", "reasons", "decide"):
        view.page.click(f"[data-to={part}]")
        assert view.page.locator(".pane[data-pane]:visible").count() == 1
        if part not in ("replay", "reasons"):
            assert faults(view, PHONE, dark=part == "list") == [], part
    for tab in ("hand", "student"):
        view.page.click(f"#tab-{tab}")
        assert faults(view, PHONE, dark=True) == [], tab
    press(view, "?")
    assert view.page.locator("#keys tbody tr").count() > 8
    assert faults(view, WIDE, dark=False) == []
    view.page.context.close()


@pytest.mark.thorough
def test_links_of_what_is_alike_lead_to_pairs_reports_and_back(
    browser: Browser, server: DeskProcess, out: Path
) -> None:
    programs = {"s0001": ORIGINAL.encode(), "s0002": ORIGINAL.encode()}
    kept = Kept("Group 3", {who: Program(data) for who, data in programs.items()}, {}, ())
    write_similarity(kept, Layout(out), names={})
    view = at_desk(browser, server)
    view.page.goto(f"{server.page}files/staff/similarity.html")
    view.page.click("text=side by side")
    assert view.page.url.endswith("/files/staff/similarity/pair-001.html")
    view.page.locator("iframe").nth(1).wait_for()
    for number in range(2):
        replay = view.page.frame_locator("iframe").nth(number)
        replay.locator("#source, #replay, main").first.wait_for(state="attached")
    view.page.click("text=Report of s0001")
    assert view.page.url.endswith("/files/staff/students/s0001/report.html")
    view.page.go_back()
    view.page.click("text=All groups")
    view.page.click("text=Overview of the class")
    view.page.wait_for_selector("#list [aria-selected=true]", state="attached")
    view.page.context.close()


def test_the_manual_has_the_keys_of_the_page() -> None:
    source = asset("desk/keys.js")
    rows = source.split("TABLE = [")[1].split("];")[0].strip().splitlines()
    keys = [json.loads(row.strip().rstrip(",")) for row in rows]
    text = MANUAL.read_text(encoding="utf-8")
    assert [f"| {key} | {does} |" for key, does in keys if f"| {key} | {does} |" not in text] == []
