"""Near misses: found for every instant, told once, without touches and what is near on purpose."""

import math

import numpy as np
import pytest

from tests.collision_runs import Record, Story, down, fixed, movable, scene_of
from tests.near_misses import near_miss
from tests.proposers import PROPOSERS
from vrts.base.diagnostic import Severity
from vrts.base.pose import IDENTITY, Pose, translation
from vrts.check.collision.collision import check_collisions
from vrts.check.collision.in_words import verdict
from vrts.check.collision.pairs.arm_state import Prober
from vrts.check.collision.pairs.pairs import plan
from vrts.check.curves.timeline_arrays import curves
from vrts.check.verdict import Answer, CollisionReport
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.proving.prover import Prover
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.scene.model import Body, Scene

THRESHOLD = 5e-3  # [m] of near misses, when nobody says otherwise
MISSED = 1.1e-5  # [m] what comes nearer than the threshold by more than this is found
TIP = 0.015  # [m] the fingertips stand this far past the pad centre
BLOCK = fixed("block", Piece(Box((0.05, 0.2, 0.05)), IDENTITY), at=(0.9, 0.0, -0.35))
TABLE = fixed("table", Piece(Box((0.4, 0.7, 0.02)), IDENTITY), at=(1.0, 0.0, -0.32))
CAN = Piece(Cylinder(0.03, 0.0575), translation(0.0, 0.0, 0.0575))
GRIP = down(0.9, 0.0, -0.225)  # pad centre on a can at the middle of the table


def can() -> Body:
    return movable("can1", CAN, at=(0.9, 0.0, -0.3), on="table")


def moved(X_WP: Pose, x: float, y: float, z: float) -> Pose:
    a, b, c = X_WP.translation
    return Pose(X_WP.rotation, (a + x, b + y, c + z))


def started(scene: Scene, at: Pose) -> Story:
    story = Story(scene, (0.0, -1.0, 1.5, 0.0, 1.0, 0.0))
    story.q = story.solved(at)
    return story


def stooping(gap: float, wait: float = 0.5) -> Story:
    """The fingertips go down to a distance above a block, and up again."""
    low = down(0.9, 0.0, -0.3 + TIP + gap)
    story = started(scene_of(BLOCK), moved(low, 0.0, 0.0, 0.05))
    story.line(low)
    story.wait(wait)
    story.line(moved(low, 0.0, 0.0, 0.05))
    return story


def checked(story: Story, **settings: float | Proposer) -> CollisionReport:
    return check_collisions(story.scene, story.record(), **settings)  # type: ignore[arg-type]


@pytest.mark.parametrize("name", PROPOSERS)
@pytest.mark.parametrize("threshold", [None, 0.008])
def test_the_threshold_decides(name: str, threshold: float | None) -> None:
    limit = threshold or THRESHOLD
    settings: dict[str, float | Proposer] = {"proposer": PROPOSERS[name]()}
    if threshold is not None:
        settings["near_miss"] = threshold
    # what keeps the threshold exactly, but for rounding, is no near miss
    for hardly in (2e-4, 0.0, -4e-6):
        far = checked(stooping(limit + hardly), **settings)
        assert far.near_misses == ()
    for beyond in (MISSED, 2e-4):
        (miss,) = checked(stooping(limit - beyond), **settings).near_misses
        assert miss.distance_m == pytest.approx(limit - beyond, abs=1e-6)
    assert (miss.first, miss.second) == ("robot", "block")
    assert (far.near_miss_m, far.near_miss_assumed) == (limit, threshold is None)


def test_a_near_miss_tells_when_where_and_why() -> None:
    # 24 mm wide fingers pass 3 mm above a plate of 4 mm; 5 mm from edge to edge at 4 mm beside it
    plate = fixed("plate", Piece(Box((0.002, 0.3, 0.1)), IDENTITY), at=(0.9, 0.0, -0.3))
    start = down(0.8, 0.0, -0.2 + TIP + 0.003)
    story = started(scene_of(plate), start)
    story.line(moved(start, 0.2, 0.0, 0.0))
    report = checked(story)
    (miss,) = report.near_misses
    duration = story.motions[0].end_s

    def place(t: float) -> float:
        s = t / duration
        return 0.8 + 0.2 * s * s * (3 - 2 * s)

    def when(x: float) -> float:
        times = np.linspace(0.0, duration, 100_001)
        return float(times[np.argmin(np.abs([place(t) - x for t in times.tolist()]))])

    reach = 0.012 + 0.002 + 0.004
    assert miss.start_s == pytest.approx(when(0.9 - reach), abs=1e-3)
    assert miss.end_s == pytest.approx(when(0.9 + reach), abs=1e-3)
    assert miss.distance_m == pytest.approx(0.003, abs=1e-5)
    assert abs(place(miss.nearest_s) - 0.9) < 0.0141
    assert math.dist(*miss.witnesses) == pytest.approx(miss.distance_m, abs=1e-6)
    assert miss.witnesses[0][2] > miss.witnesses[1][2] == pytest.approx(-0.2, abs=1e-6)
    assert miss.parts[0] in ("left finger", "right finger")
    assert miss.parts[1] == "plate"
    assert miss.held is None
    assert miss.cause == story.motions[0].cause
    assert report.clearance is not None
    assert miss.distance_m == pytest.approx(report.clearance.distance_m, abs=1e-5)


@pytest.mark.parametrize("gap", [-2e-3, -2e-4, -1e-4])
def test_what_touches_is_no_near_miss(gap: float) -> None:
    report = checked(stooping(gap))
    assert len(report.contacts + report.undetermined + report.grazes) == 1
    assert report.near_misses == ()


def test_a_contact_hides_no_near_miss_of_another_pair() -> None:
    post = fixed("post", Piece(Cylinder(0.01, 0.1), IDENTITY), at=(0.9, 0.083, -0.3))
    story = started(scene_of(BLOCK, post), down(0.9, 0.0, -0.2))
    story.line(down(0.9, 0.0, -0.3 + TIP - 0.002))
    report = checked(story)
    assert [event.second for event in report.contacts] == ["block"]
    assert [miss.second for miss in report.near_misses] == ["post"]


def test_near_misses_less_than_half_a_second_apart_are_one() -> None:
    for wait, count in ((0.0, 1), (1.0, 2)):
        low = down(0.9, 0.0, -0.3 + TIP + 0.003)
        story = started(scene_of(BLOCK), low)
        story.line(moved(low, 0.0, 0.0, 0.01), 0.5)
        story.wait(wait)
        story.line(low, 0.5)
        assert len(checked(story).near_misses) == count


def test_lifting_and_setting_down_are_near_on_purpose() -> None:
    story = started(scene_of(TABLE, can()), GRIP)
    story.grasp("can1")
    story.line(moved(GRIP, 0.0, 0.0, 0.1))
    story.line(moved(GRIP, 0.1, 0.0, 0.1))
    story.line(moved(GRIP, 0.1, 0.0, 0.0))
    story.release("can1", "table")
    story.line(moved(GRIP, 0.1, 0.0, 0.1))
    report = checked(story)
    assert report.contacts == ()
    assert report.near_misses == ()


def test_what_is_carried_low_after_it_was_high_is_a_near_miss() -> None:
    for lift, count in ((0.004, 0), (0.05, 1)):
        story = started(scene_of(TABLE, can()), GRIP)
        story.grasp("can1")
        story.line(moved(GRIP, 0.0, 0.0, lift))
        story.line(moved(GRIP, 0.1, 0.0, 0.003))
        story.line(moved(GRIP, 0.1, 0.3, 0.003))
        story.line(moved(GRIP, 0.1, 0.3, 0.1))
        report = checked(story)
        assert report.contacts == ()
        assert len(report.near_misses) == count
        for miss in report.near_misses:
            assert (miss.parts, miss.held) == (("can1", "table"), "can1")
            assert miss.distance_m == pytest.approx(0.003, abs=1e-5)


def test_a_larger_threshold_keeps_lifting_out_for_longer() -> None:
    story = started(scene_of(TABLE, can()), GRIP)
    story.grasp("can1")
    story.line(moved(GRIP, 0.0, 0.0, 0.008))
    story.line(moved(GRIP, 0.0, 0.0, 0.006))
    story.line(moved(GRIP, 0.0, 0.0, 0.2))
    usual, wide = checked(story).clearance, checked(story, near_miss=0.01).clearance
    assert usual is not None
    assert usual.distance_m == pytest.approx(0.006, abs=1e-4)
    assert wide is not None
    assert wide.bodies == ("palm", "can1")


def test_a_hand_that_rests_at_the_threshold_keeps_the_search_short() -> None:
    report = checked(stooping(THRESHOLD, wait=10.0))
    assert report.certified
    assert len(report.near_misses) <= 1


@pytest.mark.parametrize("seed", range(26))
def test_no_sample_is_near_outside_a_near_miss(seed: int) -> None:
    case = near_miss(seed, high=seed % 2 == 1)
    report = check_collisions(case.scene, case.record)
    motion = curves(case.record.timeline.segments)
    todo = plan(case.scene, case.record, motion)
    prober = Prober(case.scene.robot.arm, motion, todo.solids, Prover(todo.solids, here()))
    touches = (*report.contacts, *report.undetermined, *report.grazes)
    touched = {event.second for event in touches}  # such an approach is told as a touch
    times = np.linspace(0.0, case.duration, 1001)
    hand = [k for k, part in enumerate(todo.solids.parts) if "finger" in part or part == "palm"]
    rows = np.flatnonzero(todo.pairs.counts & np.isin(todo.pairs.first, hand))
    nearest: dict[str, float] = {}
    for row in rows.tolist():
        first = np.full(len(times), todo.pairs.first[row])
        second = np.full(len(times), todo.pairs.second[row])
        distances = prober.distances(first, second, times)
        name = todo.groups[int(todo.pairs.group[row])][1]
        nearest[name] = min(nearest.get(name, np.inf), float(distances.min()))
        for t in times[distances < THRESHOLD - MISSED].tolist():
            spans = [(m.start_s, m.end_s) for m in report.near_misses if m.second == name]
            assert any(a - 1e-3 <= t <= b + 1e-3 for a, b in spans) or name in touched, (name, t)
    for miss in report.near_misses:
        assert miss.distance_m < THRESHOLD
        assert miss.distance_m <= nearest.get(miss.second, np.inf) + 1e-4


def test_a_near_miss_is_a_warning_that_says_what_is_near() -> None:
    story = stooping(0.0032)
    run: Record = story.record()
    answer = verdict(check_collisions(story.scene, run), run)
    assert answer.answer is Answer.HOLDS
    (finding,) = answer.findings
    assert (finding.rule.code, finding.rule.slug) == ("V411", "near-miss")
    assert finding.severity is Severity.WARNING
    assert finding.headline.endswith("finger comes within 3.2 mm of `block`")
    assert finding.primary is not None
    assert finding.primary.text.endswith(
        "nearer than 5 mm (assumed) is a near miss and costs nothing"
    )
    assert finding.moment is not None
    assert len(finding.moment.configuration) == 7
    assert finding.data["distance_mm"] == pytest.approx(3.2)
    assert answer.evidence["near_misses"] == 1
    assert answer.evidence["near_miss_mm"] == pytest.approx(5.0)
    assert answer.evidence["near_miss_setting"] == "assumed"
    set_by_task = verdict(check_collisions(story.scene, run, near_miss=0.006), run)
    assert set_by_task.evidence["near_miss_setting"] == "of the task"
    (finding,) = set_by_task.findings
    assert finding.primary is not None
    assert "nearer than 6 mm is" in finding.primary.text


@pytest.mark.parametrize("wait", [0.0, 0.5])
@pytest.mark.parametrize("depth", [1.4e-5, 3e-5, 1e-4])
def test_a_touch_too_light_to_count_is_a_graze_and_no_near_miss_of_nothing(
    depth: float, wait: float
) -> None:
    report = checked(stooping(-depth, wait))
    (touch,) = report.grazes
    assert touch.depth_m == pytest.approx(depth, abs=2e-6)
    assert report.contacts == report.undetermined == report.near_misses == ()


def test_shapes_that_just_meet_are_a_near_miss_at_no_distance() -> None:
    (miss,) = checked(stooping(-5e-6)).near_misses
    assert miss.distance_m == 0.0


@pytest.mark.parametrize("name", PROPOSERS)
@pytest.mark.parametrize("gap", [THRESHOLD, 4.98e-3, 4.9e-3])
def test_whoever_proposes_the_same_is_near_on_a_long_way(name: str, gap: float) -> None:
    # 24 mm wide fingers slide along a block for half a second, at a distance, then across its edge
    start = down(0.9, -0.1, -0.3 + TIP + gap)
    story = started(scene_of(BLOCK), start)
    story.line(moved(start, 0.0, 0.15, 0.0))
    story.line(moved(start, 0.2, 0.15, 0.0))
    report = checked(story, proposer=PROPOSERS[name]())
    misses = [(m.second, m.distance_m) for m in report.near_misses]
    if gap < THRESHOLD:
        assert misses == [("block", pytest.approx(gap, abs=3e-6))]
    else:
        assert misses == []


def test_a_way_at_the_threshold_keeps_the_search_short() -> None:
    start = down(0.9, -0.15, -0.3 + TIP + THRESHOLD)
    story = started(scene_of(BLOCK), start)
    story.line(moved(start, 0.0, 0.3, 0.0), 0.05)
    report = checked(story)
    assert report.near_misses == ()
    assert report.statistics["exact distances"] < 4000, dict(report.statistics)
