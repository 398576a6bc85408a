"""The virtual pointer in a real browser, its questions answered by a real session."""

import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.browser.pointer_page import Asked, pointer_page
from tests.browser.support import Opened, until
from vrts.base.oat import components, pose_from_components, rotation_from_oat
from vrts.base.pose import Pose

pytestmark = pytest.mark.browser

THERE = [900.0, -250.0, -50.0, 30.0, 60.0, 10.0]  # above the table, pointing down at a slant


@pytest.fixture(scope="module")
def asked(tmp_path_factory: pytest.TempPathFactory) -> Asked:
    return Asked(tmp_path_factory.mktemp("session"))


@pytest.fixture(scope="module")
def opened(
    browser: Browser, asked: Asked, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[Opened]:
    view = pointer_page(browser, tmp_path_factory.mktemp("page"), asked)
    yield view
    assert view.complaints() == []
    view.page.context.close()


@pytest.fixture
def view(opened: Opened) -> Opened:
    """Return the page with the pointer where the tests begin."""
    opened.page.evaluate(
        """there => { const { pointer, viewer, pose } = t;
        viewer.look("overview"); window.refusal = "";
        document.activeElement.blur(); pointer.show(true); pointer.setStage(1);
        document.querySelector("input[value=joint]").click();
        pointer.change({ ...pose.withNumbers(pointer.pose, there), length: 0.2 });
        t.gone.length = 0; }""",
        THERE,
    )
    return opened


def pose(view: Opened) -> dict[str, Any]:
    """Return the tool's point, the head of the arrow and its direction."""
    return view.page.evaluate(
        """() => ({ point: t.pointer.pose.point, tip: t.pose.tip(t.pointer.pose),
        ahead: t.pose.approach(t.pointer.pose), R: t.pointer.pose.R })"""
    )


def fields(view: Opened) -> list[float]:
    texts = view.page.eval_on_selector_all("[data-number]", "all => all.map(e => e.value)")
    return [float(text.replace("−", "-")) for text in texts]


def field(name: str) -> str:
    return f'[data-number="{name}"]'


def handle(view: Opened, number: int) -> tuple[float, float]:
    """Return where a handle is on the page: base, tip, their heights; in stage two the knobs."""
    at = view.page.evaluate(
        "n => { const d = t.pointer.drag; return d.onPage(d.handles()[n][1]); }", number
    )
    return at["x"], at["y"]


def drag(view: Opened, start: tuple[float, float], by: tuple[float, float]) -> None:
    mouse = view.page.mouse
    mouse.move(*start)
    mouse.down()
    mouse.move(start[0] + by[0] / 2, start[1] + by[1] / 2)
    mouse.move(start[0] + by[0], start[1] + by[1])
    mouse.up()


def eye(view: Opened) -> list[float]:
    return view.page.evaluate("() => t.viewer.camera.position.toArray()")


def near(a: list[float], b: list[float]) -> bool:
    return math.dist(a, b) < 1e-9


# --- stage one ------------------------------------------------------------------------------------


@pytest.mark.thorough
def test_the_pointer_begins_at_the_gripper(opened: Opened, asked: Asked) -> None:
    opened.page.click("text=Snap to gripper")
    shown = fields(opened)
    X = asked.location
    expected = components(Pose(tuple(X[:9]), (X[9], X[10], X[11])))  # type: ignore[arg-type]
    assert shown == pytest.approx(list(expected), abs=0.006)


@pytest.mark.thorough
def test_dragging_the_base_moves_it_level_and_leaves_the_tip(view: Opened) -> None:
    before, camera = pose(view), eye(view)
    start = handle(view, 0)
    drag(view, start, (40, 25))
    after = pose(view)
    assert math.dist(before["point"], after["point"]) > 0.02
    assert after["point"][2] == pytest.approx(before["point"][2], abs=1e-9)
    assert near(before["tip"], after["tip"])
    assert not near(before["ahead"], after["ahead"])
    assert near(camera, eye(view)), "the camera moved too"
    x, y = handle(view, 0)
    # a drag is finer than the mouse, and goes by steps of 10 mm
    assert 10 < x - start[0] < 40
    assert 2 < y - start[1] < 25
    way = [b - a for a, b in zip(before["point"], after["point"], strict=True)]
    assert way == pytest.approx([round(100 * by) / 100 for by in way], abs=1e-9)


def test_dragging_the_tip_turns_the_approach_and_leaves_the_base(view: Opened) -> None:
    before = pose(view)
    drag(view, handle(view, 1), (-50, 10))
    after = pose(view)
    assert near(before["point"], after["point"])
    assert after["tip"][2] == pytest.approx(before["tip"][2], abs=1e-9)
    assert math.dist(before["tip"], after["tip"]) > 0.02


@pytest.mark.parametrize(("number", "end"), [(2, "point"), (3, "tip")])
def test_the_blue_axes_move_an_end_up_and_down_only(view: Opened, number: int, end: str) -> None:
    before = pose(view)
    drag(view, handle(view, number), (6, -50))
    after = pose(view)
    assert after[end][2] > before[end][2] + 0.05
    assert after[end][:2] == pytest.approx(before[end][:2], abs=1e-9)
    other = "tip" if end == "point" else "point"
    assert near(before[other], after[other])


def test_the_arrow_slides_along_itself(view: Opened) -> None:
    before = pose(view)
    (x, y), (u, v) = handle(view, 0), handle(view, 1)
    share = 0.6
    drag(view, (x + share * (u - x), y + share * (v - y)), (0.8 * (u - x), 0.8 * (v - y)))
    after = pose(view)
    way = [b - a for a, b in zip(before["point"], after["point"], strict=True)]
    along = sum(w * a for w, a in zip(way, before["ahead"], strict=True))
    assert along > 0.03
    assert math.hypot(*way) == pytest.approx(along, abs=1e-9)
    assert before["R"] == after["R"]


def test_dragging_beside_the_pointer_turns_the_camera(view: Opened) -> None:
    before, camera = pose(view), eye(view)
    drag(view, (60, 640), (50, 0))
    assert pose(view) == before
    assert not near(camera, eye(view))


def test_align_makes_the_arrow_vertical_and_keeps_the_point(view: Opened) -> None:
    before = pose(view)
    view.page.click("text=Align")
    after = pose(view)
    assert after["ahead"] == [0, 0, -1]
    assert near(before["point"], after["point"])
    assert fields(view)[4] == 90.0
    assert determinant_error(after["R"]) < 1e-12


def test_buttons_go_along_the_arrow_by_the_step(view: Opened) -> None:
    view.page.select_option("[aria-label='Step in millimetres']", "50")
    before = pose(view)
    view.page.click("[aria-label='Approach along the arrow']")
    after = pose(view)
    expected = [p + 0.05 * a for p, a in zip(before["point"], before["ahead"], strict=True)]
    assert near(after["point"], expected)
    view.page.click("[aria-label='Back off along the arrow']")
    assert near(pose(view)["point"], before["point"])
    view.page.select_option("[aria-label='Step in millimetres']", "10")


# --- stage two ------------------------------------------------------------------------------------


def test_the_ring_turns_the_gripper_about_the_approach(view: Opened) -> None:
    view.page.click("text=Next")
    before = pose(view)
    drag(view, handle(view, 0), (-30, 30))
    after = pose(view)
    assert near(before["point"], after["point"])
    assert near(before["ahead"], after["ahead"])
    assert not near(before["R"], after["R"])
    assert determinant_error(after["R"]) < 1e-12
    view.page.click("[data-stage='1']")
    assert view.page.is_visible("[data-pad='base']")


def test_turning_by_the_step_adds_to_t_with_the_sign_of_the_approach(view: Opened) -> None:
    view.page.click("[data-stage='2']")
    view.page.click("[aria-label^='Turn counter']")
    assert fields(view) == pytest.approx([*THERE[:5], THERE[5] + 5.0], abs=0.006)
    view.page.focus("[data-pad='turn']")
    view.page.keyboard.press("ArrowRight")
    assert fields(view) == pytest.approx(THERE, abs=0.006)


# --- numbers --------------------------------------------------------------------------------------


def test_numbers_are_typed_and_stepped(view: Opened) -> None:
    view.page.fill(field("X"), "812,5")
    view.page.keyboard.press("Tab")
    assert pose(view)["point"][0] == pytest.approx(0.8125, abs=1e-12)
    assert view.page.evaluate("document.activeElement.dataset.number") == "Y"
    view.page.keyboard.press("ArrowUp")
    view.page.keyboard.press("Shift+ArrowDown")
    assert fields(view)[:3] == [812.5, -241.0, -50.0]
    view.page.click("[aria-label='A down']")
    assert fields(view)[3:] == [30.0, 55.0, 10.0]
    view.page.fill(field("Z"), "-50")
    view.page.keyboard.press("Enter")
    assert view.page.input_value(field("Z")) == "−50.00"
    view.page.fill(field("Z"), "-50.004")
    view.page.keyboard.press("Enter")
    assert pose(view)["point"][2] == pytest.approx(-0.050004, abs=1e-12)
    expected = rotation_from_oat(30.0, 55.0, 10.0)
    assert pose(view)["R"] == pytest.approx(list(expected), abs=1e-15)


def test_what_is_no_number_is_marked_and_changes_nothing(view: Opened) -> None:
    before = pose(view)
    for text in ("abc", "", "1e9", "12 13", "0x10", "Infinity"):
        view.page.fill(field("Z"), text)
        view.page.keyboard.press("Enter")
        assert view.page.get_attribute(field("Z"), "aria-invalid") == "true"
        assert pose(view) == before
    view.page.keyboard.press("Escape")
    assert fields(view) == THERE
    view.page.fill(field("Z"), "99999")
    view.page.keyboard.press("Enter")
    assert pose(view)["point"][2] == 3.0, "the pointer stays in the room"


def test_angles_that_were_typed_stay_where_the_tool_is_vertical(view: Opened) -> None:
    for name, text in (("A", "90"), ("T", "25"), ("O", "-40")):
        view.page.fill(field(name), text)
        view.page.keyboard.press("Enter")
    assert fields(view)[3:] == [-40.0, 90.0, 25.0]
    view.page.fill(field("O"), "190")
    view.page.keyboard.press("Enter")
    assert fields(view)[3] == -170.0


def test_angles_of_the_browser_are_those_of_python(view: Opened) -> None:
    cases = [
        (o, a, t)
        for o in (-180.0, -135.0, -90.0, 0.0, 37.5, 90.0, 180.0)
        for a in (-90.0, -45.0, 0.0, 60.0, 90.0)
        for t in (-120.0, 0.0, 90.0, 180.0)
    ]
    cases += [(12.3, 89.9999999, 45.6), (-77.7, -33.3, 179.9)]
    found = view.page.evaluate(
        """cases => cases.map(([o, a, t_]) => {
        const p = t.pose.withNumbers(t.pointer.pose, [100, 200, 300, o, a, t_]);
        return { R: p.R, numbers: t.pose.numbersOf({ ...p, typed: null }) }; })""",
        cases,
    )
    for (o, a, angle), there in zip(cases, found, strict=True):
        assert there["R"] == pytest.approx(list(rotation_from_oat(o, a, angle)), abs=1e-15)
        X = pose_from_components(100.0, 200.0, 300.0, o, a, angle)
        assert there["numbers"] == pytest.approx(list(components(X)), abs=1e-7)


# --- reach and go ---------------------------------------------------------------------------------


def test_reach_is_shown_in_colour_and_in_words(view: Opened) -> None:
    until(view, "t.pointer.figure.reach === 'yes'")
    text = view.page.inner_text(".pointer-reach")
    assert text.startswith("in reach: left arm, elbow above, wrist")
    green = view.page.evaluate("t.pointer.figure.shaft.material.color.getHex()")
    view.page.fill(field("X"), "1900")
    view.page.keyboard.press("Enter")
    until(view, "t.pointer.figure.reach === 'no'")
    assert "mm beyond reach" in view.page.inner_text(".pointer-reach")
    assert view.page.evaluate("t.pointer.figure.shaft.material.color.getHex()") != green
    assert view.page.get_attribute(".pointer-reach", "role") == "status"


def test_questions_are_asked_twenty_times_a_second_at_most_and_the_last_one_counts(
    view: Opened,
) -> None:
    asked = view.page.evaluate(
        """async () => { t.asked.length = 0; const { pointer, pose } = t;
        for (let i = 0; i <= 40 || (t.asked.length <= 3 && i < 3000); i++) {
          const x = i <= 40 ? 900 + 30 * i : 2100 - 30 * (i % 2);
          pointer.change(pose.withNumbers(pointer.pose, [x, -250, -50, 30, 60, 10]));
          await new Promise((done) => setTimeout(done, 10));
        } return t.asked; }"""
    )
    assert len(asked) > 3
    assert min(b - a for a, b in pairwise(asked)) >= 49.0
    until(view, "t.pointer.figure.reach === 'no'")


def test_go_sends_the_numbers_and_the_way(view: Opened) -> None:
    view.page.check("input[value=straight]")
    view.page.click("text=Go")
    until(view, "t.gone.length === 1")
    gone = view.page.evaluate("t.gone[0]")
    assert gone["type"] == "go"
    assert gone["straight"] is True
    assert gone["position_m"] == pytest.approx([n / 1000 for n in THERE[:3]], abs=1e-12)
    assert gone["oat_rad"] == pytest.approx([math.radians(n) for n in THERE[3:]], abs=1e-12)


def test_a_refusal_is_said_and_go_can_be_taken_away(view: Opened) -> None:
    view.page.evaluate("window.refusal = 'a program is running <b>'")
    view.page.click("text=Go")
    until(view, "!document.querySelector('.pointer-said').hidden")
    assert view.page.inner_text(".pointer-said") == "a program is running <b>"
    view.page.evaluate("t.pointer.enable(false, 'you are a viewer')")
    assert view.page.is_disabled(".pointer-go")
    assert view.page.get_attribute(".pointer-go", "title") == "you are a viewer"
    view.page.evaluate("t.pointer.enable(true)")


# --- keyboard and touch ---------------------------------------------------------------------------


def test_everything_can_be_reached_by_the_keyboard(view: Opened) -> None:
    view.page.focus(".pointer-shown")
    seen: list[str] = []
    for _ in range(24):
        view.page.keyboard.press("Tab")
        seen.append(
            view.page.evaluate(
                """() => { const e = document.activeElement;
                return e.dataset.number ?? e.dataset.pad ?? e.value + e.textContent; }"""
            )
        )
    text = " ".join(seen)
    for name in (
        "X",
        "Y",
        "Z",
        "O",
        "A",
        "T",
        "base",
        "tip",
        "hand",
        "Align",
        "Snap",
        "joint",
        "Go",
    ):
        assert name in text, name


def test_the_arrow_keys_move_as_seen(view: Opened) -> None:
    view.page.focus("[data-pad='hand']")
    before, place = pose(view), handle(view, 0)
    view.page.keyboard.press("ArrowRight")
    assert handle(view, 0)[0] > place[0] + 1, "right is right on the screen"
    view.page.keyboard.press("PageUp")
    after = pose(view)
    assert after["point"][2] == pytest.approx(before["point"][2] + 0.01, abs=1e-9)
    assert math.dist(before["point"][:2], after["point"][:2]) == pytest.approx(0.01, abs=1e-9)
    assert after["R"] == before["R"]
    view.page.focus("[data-pad='tip']")
    view.page.keyboard.press("ArrowUp")
    assert near(pose(view)["point"], after["point"])
    assert not near(pose(view)["ahead"], after["ahead"])


def test_ends_that_meet_keep_their_distance(view: Opened) -> None:
    found = view.page.evaluate(
        """() => { const { pose, pointer } = t; const p = pointer.pose;
        const met = [pose.withTip(p, p.point), pose.withBase(p, pose.tip(p)),
          pose.directed(p, pose.approach(p).map(n => -n))];
        return met.map(m => [...m.R, ...m.point, m.length]); }"""
    )
    for numbers in found:
        assert all(math.isfinite(n) for n in numbers)
        assert determinant_error(numbers[:9]) < 1e-12
        assert numbers[12] >= 0.05


@pytest.mark.thorough
def test_a_finger_drags_too(browser: Browser, tmp_path: Path, asked: Asked) -> None:
    view = pointer_page(browser, tmp_path, asked, phone=True)
    view.page.evaluate("n => { t.pointer.change(t.pose.withNumbers(t.pointer.pose, n)); }", THERE)
    assert view.page.evaluate("document.documentElement.scrollWidth") <= 400
    before = pose(view)
    x, y = handle(view, 1)
    session: Any = view.page.context.new_cdp_session(view.page)

    def touch(kind: str, *points: tuple[float, float]) -> None:
        at = [{"x": px, "y": py} for px, py in points]
        session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": at})

    touch("touchStart", (x + 12, y + 12))  # a thumb is not exact
    touch("touchMove", (x + 30, y + 20))
    touch("touchMove", (x + 50, y + 30))
    touch("touchEnd")
    after = pose(view)
    assert math.dist(before["tip"], after["tip"]) > 0.02
    assert near(before["point"], after["point"])
    assert view.complaints() == []
    view.page.context.close()


@pytest.mark.thorough
def test_a_pointer_that_is_disposed_of_leaves_nothing(
    browser: Browser, tmp_path: Path, asked: Asked
) -> None:
    view = pointer_page(browser, tmp_path, asked)
    left = view.page.evaluate(
        """() => { const all = t.viewer.scene.children.length;
        t.pointer.show(true); t.pointer.dispose();
        const panel = document.querySelector("#panel");
        return [all - t.viewer.scene.children.length, panel.children.length]; }"""
    )
    assert left == [1, 0]
    view.page.context.close()


def determinant_error(R: list[float]) -> float:
    """Return how far nine numbers are from a rotation."""
    rows = [R[0:3], R[3:6], R[6:9]]
    off = [
        sum(a * b for a, b in zip(u, v, strict=True)) - (1.0 if i == k else 0.0)
        for i, u in enumerate(rows)
        for k, v in enumerate(rows)
    ]
    cross = [
        rows[0][1] * rows[1][2] - rows[0][2] * rows[1][1],
        rows[0][2] * rows[1][0] - rows[0][0] * rows[1][2],
        rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0],
    ]
    return max(abs(n) for n in (*off, math.dist(cross, rows[2])))
