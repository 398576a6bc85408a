"""Our extension in a real VS Code: code-server, and Chromium before it. All of it in one session.

To start one costs more than everything that is done in it.
"""

import re
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest
from playwright.sync_api import Browser, Frame

from tests.browser.code_server import Code, copied, installed, serving
from tests.places import ROOT

pytestmark = [pytest.mark.browser, pytest.mark.thorough, installed]

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
MOVES_GOAL = 20  # line of `MOVES goal`
SAFE = re.compile(r"^safe +(\S+) +(\S+) +(\S+) +90.00 +90.00 +0.00$")


@pytest.fixture
def code(browser: Browser) -> Iterator[Code]:
    with tempfile.TemporaryDirectory() as name:  # short: paths of sockets are bounded
        folder = Path(name)
        workspace = copied(EXAMPLE, folder / "cans")
        with serving(folder, workspace) as address:
            opened = Code(browser, address)
            yield opened
            opened.page.close()


def time_of(arm: Frame) -> float:
    return float(arm.evaluate("window.vrts.stage.player.t"))


def lines_of(arm: Frame) -> dict[int, float]:
    """Return when each line is at work first [s]."""
    rows: list[list[float]] = arm.evaluate("window.vrts.stage.replay.run.lines")
    return {int(line): t for t, line in reversed(rows)}


def note(arm: Frame) -> str:
    return arm.inner_text("#note")


def keys_go_to(code: Code, arm: Frame) -> None:
    """After a scrub the arrows scrub on; Escape gives the keys back to the text."""
    arm.click("#time", position={"x": 200, "y": 5})
    code.until(lambda: note(arm) == f"The debugger stands at {time_of(arm):.3f} s.", "a scrub")
    code.until(lambda: arm.evaluate("document.hasFocus()"), "the keys come back to the panel")
    before = time_of(arm)
    code.page.keyboard.press("ArrowRight")
    code.until(lambda: abs(time_of(arm) - before - 0.1) < 1e-6, "0.1 s further")
    code.until(lambda: note(arm) == f"The debugger stands at {time_of(arm):.3f} s.", "with it")
    code.until(lambda: arm.evaluate("document.hasFocus()"), "the keys come back again")
    code.page.keyboard.press("Escape")
    code.until(lambda: not arm.evaluate("document.hasFocus()"), "the keys are the text's")


def numbers_of_safe(code: Code) -> tuple[str, ...]:
    """Return X, Y and Z of the location `safe` as the text has them."""
    found = SAFE.match(code.text("safe      "))
    return found.groups() if found else ()


def place_of(code: Code, arm: Frame, name: str) -> tuple[float, float]:
    """Return the middle of a location's handle on the page, where it stays."""
    code.until(lambda: not arm.evaluate("window.vrts.stage.viewer.pending"), "all is drawn")
    box = arm.locator(".place", has_text=name).bounding_box()
    assert box is not None
    return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2


def a_location_is_dragged(code: Code, arm: Frame) -> None:
    """The text changes by one edit, undo brings it back; Escape gives up; keys do it, too."""
    before = ("900.00", "30.00", "100.00")
    code.until(lambda: numbers_of_safe(code) == before, "the line of the location")
    mouse, keys = code.page.mouse, code.page.keyboard
    handle = arm.locator(".place", has_text="safe")
    handle.wait_for()

    def drag(x: int, y: int) -> None:
        left, top = place_of(code, arm, "safe")
        mouse.move(left, top)
        mouse.down()
        mouse.move(left + x, top + y, steps=4)

    drag(20, -6)
    code.until(lambda: "mm: reachable" in arm.inner_text(".moving"), "the arm reaches it")
    told = arm.inner_text(".moving")
    mouse.up()
    code.until(lambda: numbers_of_safe(code) not in ((), before), "the text has other numbers")
    at = [f"{axis} {float(x):.1f}" for axis, x in zip("XYZ", numbers_of_safe(code), strict=True)]
    assert told.startswith(f"safe  {'  '.join(at)} mm".replace("-", "−"))
    code.until(lambda: note(arm).startswith("Click a line"), "it is verified")
    keys.press("Control+z")
    code.until(lambda: numbers_of_safe(code) == before, "undo")
    code.until(lambda: note(arm).startswith("Click a line"), "it is verified again")

    drag(150, 0)
    code.until(lambda: "mm: not reachable" in arm.inner_text(".moving"), "it is out of reach")
    keys.press("Escape")
    mouse.up()
    assert arm.locator(".moving").is_hidden()

    keys.down("Shift")
    drag(30, -10)
    code.until(lambda: "X 900.0  Y 30.0  Z 1" in arm.inner_text(".moving"), "upward alone")
    keys.press("Escape")
    mouse.up()
    keys.up("Shift")
    assert numbers_of_safe(code) == before, "given up"

    handle.focus()
    keys.press("ArrowLeft")
    keys.press("Control+ArrowUp")
    keys.press("PageUp")
    keys.press("Enter")
    code.until(lambda: numbers_of_safe(code) == ("899.90", "31.00", "100.10"), "keys")
    code.line("MOVES goal")
    keys.press("Control+z")
    code.until(lambda: numbers_of_safe(code) == before, "one undo of the text")
    code.until(lambda: note(arm).startswith("Click a line"), "it is verified once more")


def another_future_is_drawn(code: Code, arm: Frame) -> None:
    """A location dragged while debugging makes a future; the one before stands beside it."""

    def debugged() -> list[float]:
        return list(arm.evaluate("window.vrts.places.handles.get('safe').row.numbers"))

    before = debugged()
    left, top = place_of(code, arm, "safe")
    code.page.mouse.move(left, top)
    code.page.mouse.down()
    code.page.mouse.move(left + 18, top - 18, steps=4)
    code.page.mouse.up()
    code.until(lambda: arm.locator("#futures").is_visible(), "the debugger has two futures")
    assert debugged() != before
    arm.select_option("#other", label="1: the program as it was opened")
    code.until(lambda: "than this one" in arm.inner_text("#apart"), "the other future")
    arm.evaluate("window.vrts.stage.jump(1.2)")
    code.until(lambda: "mm apart now" in arm.inner_text("#apart"), "both at the same time")
    assert arm.evaluate("window.vrts.futures.ghost.robot.group.visible")
    with_both = arm.locator("#canvas").screenshot()
    code.until(lambda: arm.locator("#compared").is_visible(), "both side by side")
    assert "clearance" in str(arm.locator("#compared pre").text_content())
    arm.select_option("#other", label="no other future")
    code.until(lambda: not arm.inner_text("#apart"), "the present one alone")
    code.until(lambda: arm.locator("#canvas").screenshot() != with_both, "nothing else is drawn")
    code.page.keyboard.press("Control+z")
    code.until(lambda: debugged() == before, "undo: the debugger follows, too")
    code.until(lambda: arm.locator("#other option").count() == 3, "another future")


def test_the_arm_stands_where_text_and_debugger_stand(code: Code) -> None:
    code.open("solution.v2")
    code.until(lambda: "10.0 / 10 · ready" in code.status(), "the mark in the status bar")
    code.command("Show the Arm")
    arm = code.arm()
    first = lines_of(arm)

    code.line("MOVES goal")  # a click on a line: the arm stands where it begins
    code.until(lambda: abs(time_of(arm) - first[MOVES_GOAL]) < 1e-6, "the arm at the line")
    assert note(arm).startswith(f"line {MOVES_GOAL}, at ")
    arm.evaluate(f"window.vrts.stage.jump({first[5] + 0.3})")  # the time bar: the line is lit
    code.until(lambda: code.lit() == 5, "the line of that time")

    a_location_is_dragged(code, arm)
    code.line("SPEED 100")
    code.page.keyboard.press("F5")
    code.until(lambda: note(arm) == "The debugger stands at 0.000 s, line 3.", "debugging")
    assert time_of(arm) == 0.0
    assert arm.inner_text("#goals-check").strip() == "goals 0 of 2"
    arm.evaluate("window.vrts.stage.jump(4.5)")
    code.until(lambda: note(arm) == "The debugger stands at 4.500 s.", "the debugger went there")
    code.until(lambda: code.stands() == MOVES_GOAL + 1, "the line of the step that comes next")
    code.until(lambda: "goal = 1100 230 −125" in code.text("MOVES goal"), "values behind the line")
    assert "goal =" not in code.text("MOVE safe"), "of another program"
    keys_go_to(code, arm)
    scrubbed = time_of(arm)
    code.page.keyboard.press("F10")
    code.until(lambda: time_of(arm) > scrubbed, "a step from there")
    later = time_of(arm)
    code.page.click(".debug-toolbar .codicon-debug-step-back")
    code.until(lambda: time_of(arm) < later, "a step back")
    another_future_is_drawn(code, arm)
    code.page.keyboard.press("Shift+F5")
    code.until(lambda: note(arm).startswith("Click a line"), "the end of debugging")

    code.line("SPEED 100")  # what is typed is verified
    code.page.keyboard.press("Home")
    code.page.keyboard.type("X")
    code.until(lambda: "does not compile" in code.status(), "a mistake")
    code.until(lambda: code.page.locator(".squiggly-error").count() > 0, "a wavy line")
    code.until(lambda: "has errors" in note(arm), "the panel says so")
    code.page.keyboard.press("Backspace")
    code.until(lambda: "10.0 / 10 · ready" in code.status(), "the mark again")
    a_task_is_shown_while_it_is_written(code, arm)


def a_task_is_shown_while_it_is_written(code: Code, arm: Frame) -> None:
    """Its scene and goals; a fault is told, and the last scene that could be read stays."""
    code.open("task.toml")
    code.until(lambda: note(arm) == "The scene as the text has it.", "the scene")
    assert arm.evaluate("window.vrts.stage.data.scene.goals.length") == 2
    code.line('on = "base2"')
    code.page.keyboard.press("Home")
    code.page.keyboard.type("x")
    code.until(lambda: note(arm).startswith("The file has errors"), "a mistake")
    code.until(lambda: code.page.locator(".squiggly-error").count() > 0, "a wavy line")
    assert arm.evaluate("window.vrts.stage.data.scene.goals.length") == 2
    code.page.keyboard.press("Backspace")
    code.until(lambda: note(arm) == "The scene as the text has it.", "the scene again")
    code.page.keyboard.press("End")
    code.page.keyboard.press("Enter")
    code.page.keyboard.type("wei")
    row = code.page.locator(".suggest-widget.visible .monaco-list-row.focused")
    code.until(lambda: row.count() and "weight" in row.inner_text(), "a key is proposed")
    code.page.keyboard.press("Enter")
    code.until(lambda: code.text("weight = 1.0"), "the key with its value")
