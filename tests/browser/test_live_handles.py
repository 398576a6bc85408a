"""Handles of the virtual pointer: large and apart at every angle, fine; and what it touches."""

import math
from collections.abc import Iterator
from typing import Any

import pytest
from playwright.sync_api import Browser

from tests.browser.pointer_page import Asked, pointer_page
from tests.browser.support import Opened, until

pytestmark = pytest.mark.browser

TARGET = 24.0  # [px] WCAG 2.2, 2.5.8: least width and height of what is pointed at
ABOVE = [900.0, -250.0, -50.0, 0.0, 90.0, 0.0]
INSIDE = [950.0, -130.0, -200.0, 0.0, 90.0, 0.0]

# from all sides, from near and far, with arrows down, level and up; what each handle measures
_ALL_ANGLES = """poses => {
  const { pointer, viewer, pose } = t, { camera, controls } = viewer, { drag, figure } = pointer;
  let [least, smallest, largest, seen] = [Infinity, Infinity, 0, 0];
  for (const numbers of poses) {
    pointer.change({ ...pose.withNumbers(pointer.pose, numbers), length: 0.2 });
    for (const stage of [1, 2]) {
      pointer.setStage(stage);
      for (const up of [-20, 0, 15, 35, 60, 89.9]) for (let round = 0; round < 360; round += 40) {
        for (const away of [0.4, 1.1, 3, 7]) {
          const [a, b] = [up, round].map((degrees) => degrees * Math.PI / 180);
          controls.target.set(...pointer.pose.point);
          camera.position.set(away * Math.cos(a) * Math.cos(b), away * Math.cos(a) * Math.sin(b),
            away * Math.sin(a)).add(controls.target);
          camera.lookAt(controls.target);
          const at = drag.handles().map(([, point]) => drag.onPage(point));
          at.forEach((p, i) => at.slice(i + 1).forEach((q) => {
            least = Math.min(least, Math.hypot(p.x - q.x, p.y - q.y)); }));
          const { base, tip, knobs } = figure.handles;
          for (const ball of stage === 1 ? [base.ball, tip.ball] : knobs) {
            const side = ball.position.clone().setFromMatrixColumn(camera.matrixWorld, 0);
            const edge = drag.onPage(side.multiplyScalar(9 * ball.scale.x).add(ball.position));
            const middle = drag.onPage(ball.position);
            const radius = Math.hypot(edge.x - middle.x, edge.y - middle.y);
            [smallest, largest] = [Math.min(smallest, radius), Math.max(largest, radius)];
          }
          seen++;
        }
      }
    }
  }
  pointer.setStage(1);
  viewer.look("overview");
  return { least, smallest, largest, seen };
}"""


@pytest.fixture(scope="module")
def view(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Opened]:
    asked = Asked(tmp_path_factory.mktemp("session"))
    view = pointer_page(browser, tmp_path_factory.mktemp("page"), asked)
    view.page.evaluate("() => t.pointer.show(true)")
    yield view
    assert view.complaints() == []
    view.page.context.close()


def put(view: Opened, numbers: list[float], length: float = 0.2) -> None:
    view.page.evaluate(
        """([numbers, length]) => { const { pointer, pose } = t;
        pointer.change({ ...pose.withNumbers(pointer.pose, numbers), length }); }""",
        [numbers, length],
    )


def point(view: Opened) -> list[float]:
    return view.page.evaluate("() => t.pointer.pose.point")


def dragged(view: Opened, number: int, by: tuple[float, float], shift: bool = False) -> list[float]:
    """Drag a handle; return how far the pointer went [mm]."""
    at: Any = view.page.evaluate(
        "n => { const d = t.pointer.drag; return d.onPage(d.handles()[n][1]); }", number
    )
    before, mouse = point(view), view.page.mouse
    mouse.move(at["x"], at["y"])
    mouse.down()
    if shift:
        view.page.keyboard.down("Shift")
    mouse.move(at["x"] + by[0] / 2, at["y"] + by[1] / 2)
    mouse.move(at["x"] + by[0], at["y"] + by[1])
    shown = view.page.inner_text(".drag-note")
    mouse.up()
    view.page.keyboard.up("Shift")
    moved = [1000.0 * (b - a) for a, b in zip(before, point(view), strict=True)]
    assert shown.startswith(f"{math.hypot(*moved):.1f} mm")
    assert view.page.is_hidden(".drag-note")
    return moved


@pytest.mark.thorough
def test_handles_are_as_large_and_apart_from_every_side(view: Opened) -> None:
    poses = [ABOVE, [900, -250, -50, 30, 20, 10], [900, -250, -50, 0, -90, 0]]
    found = view.page.evaluate(_ALL_ANGLES, poses)
    assert found["seen"] == 3 * 2 * 6 * 9 * 4
    near = view.page.evaluate("import('vrts/live/pointer_drag.js').then(m => m.NEAR)")
    for kind in ("mouse", "pen"):
        assert 2 * near[kind] >= TARGET
    # no two places at which a handle is taken have a point in common
    assert found["least"] >= 2 * near["mouse"]
    assert found["smallest"] == pytest.approx(9.0, rel=0.05)
    assert found["largest"] == pytest.approx(9.0, rel=0.05)


@pytest.mark.thorough
def test_places_of_handles_are_apart_for_fingers_too(view: Opened) -> None:
    least = view.page.evaluate(
        """() => import("vrts/live/pointing/handle_places.js").then(({ placesOf }) => {
        let least = Infinity;
        for (let x = -90; x <= 90; x += 6) for (let y = -90; y <= 90; y += 6)
          for (let turn = 0; turn <= 360; turn += 30) for (const way of [1, -1]) {
            const [s, c] = [Math.sin(turn / 57.2958), Math.cos(turn / 57.2958)];
            const up = turn === 360 ? null : { x: s, y: c };
            const at = { base: { x: 0, y: 0 }, tip: { x, y }, up, way };
            const all = Object.values(placesOf(at, "coarse"));
            all.forEach((p, i) => all.slice(i + 1).forEach((q) => {
              least = Math.min(least, Math.hypot(p.x - q.x, p.y - q.y)); }));
          }
        return least; })"""
    )
    near = view.page.evaluate("import('vrts/live/pointer_drag.js').then(m => m.NEAR.touch)")
    assert least >= 2 * near > TARGET


@pytest.mark.thorough
def test_a_drag_is_fine_and_goes_by_steps_and_says_how_far(view: Opened) -> None:
    put(view, ABOVE)
    view.page.evaluate("() => { t.viewer.look('overview'); t.viewer.zoom(1.42); }")
    for by in ((30, 0), (0, 30), (0, -30), (21, 21)):
        put(view, ABOVE)
        moved = dragged(view, 0, by)
        # it was 286 mm
        assert 10 <= math.hypot(*moved) <= 80
        assert moved == pytest.approx([10 * round(n / 10) for n in moved], abs=1e-6)
    put(view, ABOVE)
    fine = dragged(view, 0, (30, 0), shift=True)
    assert 1 <= math.hypot(*fine) <= 8
    put(view, ABOVE)
    view.page.evaluate("() => t.viewer.look('top')")
    up = dragged(view, 2, tuple(_headward(view)))  # type: ignore[arg-type]
    assert up[:2] == pytest.approx([0, 0], abs=1e-6)
    assert up[2] >= 10, "the height can be dragged from above, too"


def test_shift_makes_the_rest_of_a_drag_fine_and_keeps_how_far_it_went(view: Opened) -> None:
    put(view, ABOVE)
    view.page.evaluate("() => { t.viewer.look('overview'); t.viewer.zoom(1.42); }")
    at: Any = view.page.evaluate(
        "() => { const d = t.pointer.drag; return d.onPage(d.handles()[0][1]); }"
    )
    before, mouse = point(view), view.page.mouse
    mouse.move(at["x"], at["y"])
    mouse.down()
    mouse.move(at["x"] + 40, at["y"])
    coarse = point(view)
    went = 1000.0 * math.dist(before, coarse)
    assert went >= 10
    view.page.keyboard.down("Shift")
    mouse.move(at["x"] + 41, at["y"])
    assert 1000.0 * math.dist(coarse, point(view)) <= 2, "it does not jump back"
    mouse.move(at["x"] + 70, at["y"])
    assert 1 <= 1000.0 * math.dist(coarse, point(view)) <= 8
    shown = view.page.inner_text(".drag-note")
    assert shown.startswith(f"{1000.0 * math.dist(before, point(view)):.1f} mm")
    mouse.up()
    view.page.keyboard.up("Shift")


def _headward(view: Opened) -> list[float]:
    """Return 30 px in the direction in which the handle for the height stands."""
    return view.page.evaluate(
        """() => { const d = t.pointer.drag, [a, , b] = d.handles().map(([, p]) => d.onPage(p));
        const n = Math.hypot(b.x - a.x, b.y - a.y);
        return [30 * (b.x - a.x) / n, 30 * (b.y - a.y) / n]; }"""
    )


def test_a_ring_seen_from_its_edge_turns_too(view: Opened) -> None:
    put(view, ABOVE)
    view.page.evaluate(
        """() => { const { camera, controls } = t.viewer;
        controls.target.set(...t.pointer.pose.point);
        camera.position.copy(controls.target); camera.position.x += 2; controls.update();
        t.pointer.setStage(2); }"""
    )
    before = view.page.evaluate("() => [...t.pointer.pose.R]")
    at = view.page.evaluate(
        "() => { const d = t.pointer.drag; return d.onPage(d.handles()[0][1]); }"
    )
    view.page.mouse.move(at["x"], at["y"])
    view.page.mouse.down()
    view.page.mouse.move(at["x"] + 30, at["y"])
    assert "°" in view.page.inner_text(".drag-note")
    view.page.mouse.up()
    assert view.page.evaluate("() => [...t.pointer.pose.R]") != before
    assert view.page.evaluate("() => t.pointer.pose.point") == pytest.approx([0.9, -0.25, -0.05])
    view.page.evaluate("() => { t.pointer.setStage(1); t.viewer.look('overview'); }")


def test_what_touches_is_shown_in_words_and_shapes_and_colour(view: Opened) -> None:
    put(view, INSIDE)
    until(view, "t.pointer.figure.reach === 'touches'")
    assert "touches there: " in view.page.inner_text(".pointer-reach")
    assert "base1" in view.page.inner_text(".pointer-reach")
    sign = "getComputedStyle(document.querySelector('.pointer-reach i'), '::before').content"
    assert view.page.evaluate(sign) == '"✕"'
    way = "t.pointer.figure.way"
    assert view.page.evaluate(f"{way}.marks.children.some((m) => m.isSprite)"), "with words"
    assert view.page.evaluate("t.pointer.figure.arm.visible"), "the arm at the pointer"
    red = view.page.evaluate("t.pointer.figure.outline.color.getHex()")
    put(view, ABOVE)
    until(view, "t.pointer.figure.reach === 'yes'")
    assert "nothing touches on the way" in view.page.inner_text(".pointer-reach")
    assert view.page.evaluate(f"{way}.visible && !{way}.marks.children.some((m) => m.isSprite)")
    assert view.page.evaluate("t.pointer.figure.outline.color.getHex()") != red
    put(view, [1900.0, -250.0, -50.0, 0.0, 90.0, 0.0])
    until(view, "t.pointer.figure.reach === 'no'")
    assert not view.page.evaluate(f"{way}.visible || t.pointer.figure.arm.visible")
    words = view.page.evaluate(
        """() => import("vrts/live/pointer_reach.js").then(({ words, stateOf }) => {
        const touch = { text: "left finger touches base1, 3 mm deep", at_goal: false, start: 0.63 };
        const reached = { reachable: true, branch: [], touches: [touch, touch], way: "touches" };
        const lost = { reachable: true, branch: [], touches: [], way: "unknown", why: "slow" };
        return [stateOf(reached), words(reached), stateOf(lost), words(lost)]; })"""
    )
    assert words == [
        "way",
        "touches on the way, 63 % along: left finger touches base1, 3 mm deep (and 1 more)",
        "unknown",
        "in reach; slow",
    ]
