"""The report page in a real browser, opened from a file: it plays, both ways, without a network."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from playwright.sync_api import Browser

from tests.browser.support import PIXEL, Opened, clock, opened, until
from tests.support_runs import CONTACT_S, END_S, GRASP_S, RUN_S, assessment, with_segments
from tests.support_segments import blend, sampled, segment, slowed
from vrts.base.pose import Pose, distance
from vrts.debug.marks.links import anchor
from vrts.engine.memory.records import Segment
from vrts.report.page.page import page
from vrts.robots.kinematics.kinematics import forward, link_poses
from vrts.robots.model import Configuration

pytestmark = pytest.mark.browser

PHONE = 360  # [px]


@pytest.fixture(scope="module")
def report(browser: Browser, tmp_path_factory: pytest.TempPathFactory) -> Opened:
    path = tmp_path_factory.mktemp("report") / "submission-07.html"
    path.write_text(page(assessment(), {"moment": PIXEL}), encoding="utf-8")
    view = opened(browser, path, drawn=True)
    until(view, "window.vrts !== undefined")
    view.first_clock = clock(view)
    return view


def seek(view: Opened, t: float) -> None:
    view.page.evaluate("t => { vrts.player.playing = false; vrts.player.seek(t); }", t)


def pixels(view: Opened) -> bytes:
    """Return the canvas as drawn at this instant."""
    url: str = view.page.evaluate("() => { vrts.viewer.draw(); return canvas.toDataURL(); }")
    return url.encode()


def test_the_first_screen_stands_in_order(report: Opened) -> None:
    text = report.page.inner_text("header")
    parts = ("8.5", "Ready for the real robot: no", "the held can1 hits base1 (−1.5)", "Hint:")
    parts += ("Lost by", "Mark, of 10", "Watch this moment")
    places = [text.index(part) for part in parts]
    assert places == sorted(places)
    alt = report.page.get_attribute("img.still", "alt")
    assert alt is not None
    assert "base1" in alt


def test_it_opens_at_the_moment_of_the_cause(report: Opened) -> None:
    assert report.page.is_hidden("#no-replay")
    assert report.first_clock == pytest.approx(CONTACT_S[0], abs=1e-3)


@pytest.mark.thorough
def test_it_opens_at_the_time_of_its_address_to_every_digit(
    report: Opened, browser: Browser
) -> None:
    asked = 0.6 * RUN_S + 1.2345e-5
    view = Opened(browser.new_page())
    view.page.goto(report.page.url.partition("#")[0] + anchor(asked))
    until(view, "window.vrts !== undefined")
    assert view.page.evaluate("vrts.player.t") == asked
    # ... and goes on to another one: it is the same page still
    view.page.evaluate("at => { window.same = true; location.hash = at; }", anchor(asked / 2))
    until(view, f"vrts.player.t === {asked / 2!r}")
    assert view.page.evaluate("window.same")
    view.page.close()


@pytest.mark.thorough
def test_it_can_be_scrubbed_both_ways(report: Opened) -> None:
    seen: dict[float, bytes] = {}
    for t in (0.2, 1.3, 2.4, 1.3, 0.2):
        seek(report, t)
        assert clock(report) == pytest.approx(t, abs=1e-3)
        picture = pixels(report)
        assert seen.setdefault(t, picture) == picture, "the same time looks different"
    assert len(set(seen.values())) == 3


@pytest.mark.thorough
def test_it_plays_forward_and_backward(report: Opened) -> None:
    middle = 0.6 * RUN_S  # far from both ends, where playing stops by itself
    seek(report, middle)
    report.page.evaluate("vrts.player.speed = 0.2")  # so that a slow machine stays far from them
    report.page.focus("#stage")
    report.page.keyboard.press("Space")
    until(report, f"vrts.player.t > {middle + 0.1}")
    report.page.keyboard.press("b")
    until(report, f"vrts.player.direction < 0 && vrts.player.t < {middle - 0.1}")
    report.page.keyboard.press("b")
    stopped = clock(report)
    assert not report.page.evaluate("vrts.player.playing")
    report.page.evaluate("vrts.player.speed = 1")
    report.page.keyboard.press("ArrowRight")
    assert clock(report) == pytest.approx(stopped + 0.1, abs=2e-3)
    report.page.keyboard.press("End")
    assert clock(report) == pytest.approx(RUN_S, abs=1e-3)


def test_line_events_and_contact_follow_the_time(report: Opened) -> None:
    seek(report, 1.4)
    assert report.page.get_attribute("li.lit", "id") == "L2"
    assert "can1 touches base1" in report.page.inner_text("#overlay")
    assert "holds can1" in report.page.inner_text("#overlay")
    assert "can1 touches base1" in report.page.inner_text("#events .now")
    seek(report, 3.0)
    assert report.page.get_attribute("li.lit", "id") == "L3"
    assert report.page.inner_text("#overlay") == ""


def test_the_lanes_show_the_run_and_go_where_they_are_clicked(report: Opened) -> None:
    report.page.locator("#lanes").scroll_into_view_if_needed()
    names = report.page.locator("#lanes .name").all_inner_texts()
    assert names[0] == "Line"
    assert {"Gripper", "Contacts"} <= set(names)
    hit = report.page.locator("#lanes i.contact")
    assert "can1 touches base1" in (hit.get_attribute("title") or "")
    band = report.page.locator("#lanes .band").first.bounding_box()
    where = hit.bounding_box()
    assert band is not None
    assert where is not None
    assert where["x"] == pytest.approx(band["x"] + CONTACT_S[0] / RUN_S * band["width"], abs=2)
    assert report.page.locator("#lanes i.held").inner_text() == "can1"
    report.page.mouse.click(band["x"] + 0.25 * band["width"], band["y"] + 5)
    assert clock(report) == pytest.approx(0.25 * RUN_S, abs=0.02)
    report.page.mouse.down()
    report.page.mouse.move(band["x"] + 0.75 * band["width"], band["y"] + 5)
    report.page.mouse.up()
    assert clock(report) == pytest.approx(0.75 * RUN_S, abs=0.02)


@pytest.mark.thorough
def test_an_event_row_and_a_loss_jump_to_their_time(report: Opened) -> None:
    report.page.click("#events >> text=can1 grasped")
    assert clock(report) == pytest.approx(GRASP_S, abs=1e-3)
    report.page.click("table.losses button.seek")
    until(report, f"vrts.player.t >= {CONTACT_S[0]}")
    report.page.evaluate("vrts.player.pause()")


def test_a_double_click_on_a_line_goes_to_when_it_is_at_work(report: Opened) -> None:
    seek(report, 0.0)
    report.page.dblclick("#L2 code")
    lines: list[list[float]] = report.page.evaluate("vrts.replay.run.lines")
    assert clock(report) == pytest.approx(next(t for t, line in lines if line == 2), abs=1e-3)


def test_poses_in_the_browser_are_those_in_python(report: Opened) -> None:
    a = assessment()
    assert a.run is not None
    segments = a.run.timeline.segments
    arm = a.run.scene.robot.arm
    for t in (0.0, 0.17, 0.9, 1.4, 2.31, 2.5, 2.55, 3.1):
        q = configuration(segments, t)
        state = report.page.evaluate(
            """t => { const s = vrts.replay.at(t); return {
                flange: [...s.X_WF], tool: [...s.X_WT], links: s.X_WL.map(X => [...X]),
                can: [...s.bodies.get("can1")], held: s.held }; }""",
            t,
        )
        X_WF = forward(arm, q)
        near(state["flange"], X_WF)
        near(state["tool"], X_WF @ a.run.scene.X_FT)
        for link, X_WL in zip(state["links"], link_poses(arm, q), strict=True):
            near(link, X_WL)
        placement = [p for p in a.run.placements["can1"] if p.start_s <= t][-1]
        held = GRASP_S <= t < END_S
        assert state["held"] == (["can1"] if held else [])
        X_WO = X_WF @ placement.X if held else placement.X
        drop = 9.81 / 2 * (t - END_S) ** 2 if placement.lie.value == "falling" else 0.0
        near(state["can"], X_WO, lower=drop)


@pytest.mark.thorough
def test_blends_and_what_is_slowed_down_are_evaluated_in_full(
    browser: Browser, tmp_path: Path
) -> None:
    quartic, stopping = blend(0.3, 0.0, -1.0, 0.8), slowed(blend(-0.1, -1.0, 0.5, 1.0), 1.0, -0.6)
    pieces = (
        segment((0.3,), (0.1, 0.0, 0.75, -0.5)),
        segment(quartic, (0.35, 0.2), start_s=1.0, length=0.8),
        segment(stopping, (0.51,), start_s=1.8, length=1.4),
    )
    path = tmp_path / "blends.html"
    a = replace(assessment(), run=with_segments(*pieces))
    path.write_text(page(a, {"moment": PIXEL}), encoding="utf-8")
    view = opened(browser, path)
    until(view, "window.vrts !== undefined")
    for t in (0.0, 0.4, 1.0, 1.1, 1.37, 1.799, 1.8, 1.93, 2.5, 3.0, 3.19):
        piece = next(p for p in reversed(pieces) if p.start_s <= t)
        u = np.array([t - piece.start_s])
        state = view.page.evaluate(
            "t => { const s = vrts.replay.at(t); return { q: [...s.q], v: [...s.v] }; }", t
        )
        for row, q, v in zip(piece.coefficients, state["q"], state["v"], strict=True):
            assert q == pytest.approx(float(sampled(row, u)[0]), abs=1e-6)
            assert v == pytest.approx(float(sampled(row, u, 1)[0]), abs=1e-5)
    assert view.complaints() == []
    view.page.close()


def configuration(segments: "list[Segment] | tuple[Segment, ...]", t: float) -> Configuration:
    segment = next(s for s in reversed(segments) if s.start_s <= t)
    u = t - segment.start_s
    a, b, c, d, e, f = (
        sum(c * u**k for k, c in enumerate(row)) for row in segment.coefficients[:6]
    )
    return (a, b, c, d, e, f)


def near(matrix: list[float], X: Pose, *, lower: float = 0.0) -> None:
    """Assert that a column-major matrix is a pose within 0.1 mm, at 0.5 m from its origin too."""
    for point in ((0.0, 0.0, 0.0), (0.5, 0.0, 0.0), (0.0, 0.5, 0.0)):
        x, y, z = (
            sum(matrix[row + 4 * k] * point[k] for k in range(3)) + matrix[12 + row]
            for row in range(3)
        )
        assert math.isfinite(x)
        assert distance((x, y, z + lower), X.apply(point)) < 1e-4


def test_charts_show_times_and_limits_and_can_be_clicked(report: Opened) -> None:
    assert report.page.locator(".chart").count() >= 4
    charts = report.page.inner_text("#chart-list")
    assert "mm/s" in charts
    assert "limit" in charts
    report.page.locator(".chart svg").first.click(position={"x": 280, "y": 60})
    assert 0.5 < clock(report) < 2.5


def test_nothing_was_complained_about_or_asked_for(report: Opened) -> None:
    assert report.complaints() == []
    foreign = [url for url in report.requests if not url.startswith(("data:", "file:"))]
    assert foreign == []
    assert len([url for url in report.requests if url.startswith("file:")]) == 1


def test_a_browser_that_cannot_unpack_the_replay_says_so(browser: Browser, tmp_path: Path) -> None:
    path = tmp_path / "old.html"
    path.write_text(page(assessment(), {"moment": PIXEL}), encoding="utf-8")
    view = opened(browser, path, before="delete window.DecompressionStream;")
    until(view, "!document.getElementById('no-replay').hidden")
    assert "cannot show the replay" in view.page.inner_text("#no-replay")
    assert "the held can1 hits base1" in view.page.inner_text("header")
    assert not view.page.evaluate("window.vrts")


@pytest.mark.thorough
def test_it_fits_a_phone(report: Opened) -> None:
    report.page.set_viewport_size({"width": PHONE, "height": 900})
    assert report.page.evaluate("document.documentElement.scrollWidth") <= PHONE
    report.page.set_viewport_size({"width": 1280, "height": 900})
