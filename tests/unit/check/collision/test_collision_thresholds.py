"""Depths and distances on both sides of a threshold, for pairs of several shapes whoever proposes.

Every case brings two shapes to a known depth, from above or from the side, waits, and goes back.
"""

import math
from collections.abc import Callable
from functools import cache
from typing import NamedTuple

import pytest

from tests.collision_runs import Story, down, fixed, movable, scene_of
from tests.laws import first
from tests.places import ROOT
from tests.proposers import PROPOSERS
from vrts.base.pose import IDENTITY, Pose, rotation_about, translation
from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.verdict import CollisionReport
from vrts.engine.memory.records import Lie, Placement
from vrts.geometry.proposing.proposer import Proposer
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.geometry.support import bounds
from vrts.scene.model import Body, Scene
from vrts.scene.reading.scene_file import read_scene

TOLERANCE = 2e-4  # [m] deeper is a contact
NEAR = 5e-3  # [m] nearer is a near miss
TIP = 0.015  # [m] the fingertips stand this far past the pad centre
FOOT = 0.075  # [m] so does the foot of a held can
LYING = Pose(rotation_about((1.0, 0.0, 0.0), math.pi / 2), (0.0, 0.0, 0.0))
CAN = Piece(Cylinder(0.03, 0.0575), translation(0.0, 0.0, 0.0575))


class Case(NamedTuple):
    """Two shapes that are brought together."""

    thing: Callable[[], Body]
    place: Callable[[float], Pose]  # of the pad centre at a depth
    away: tuple[float, float, float]  # where to come from
    carries: bool = False


def block() -> Body:
    return fixed("thing", Piece(Box((0.05, 0.2, 0.05)), IDENTITY), at=(0.9, 0.0, -0.35))


def roll() -> Body:
    return fixed("thing", Piece(Cylinder(0.05, 0.2), LYING), at=(0.9, 0.0, -0.35))


def post() -> Body:
    return fixed("thing", Piece(Cylinder(0.01, 0.2), IDENTITY), at=(0.94, 0.0, -0.3))


@cache
def dish() -> Body:
    path = ROOT / "scenes" / "dish-on-stand" / "scene.toml"
    scene, _ = read_scene(SourceFile("scene.toml", path.read_text(encoding="utf-8")))
    assert scene is not None
    pieces = scene.body("dish").pieces
    return fixed("thing", *pieces, at=(0.9, 0.0, -0.3 - bounds(pieces, IDENTITY).upper[2]))


def over(reach: float, x: float = 0.0) -> Callable[[float], Pose]:
    """The hand above z = -0.3 m, pressed into it by a depth."""
    return lambda depth: down(0.9 + x, 0.0, -0.3 + reach - depth)


def beside(depth: float) -> Pose:
    """The hand left of a post, its can pressed into it by a depth."""
    return down(0.9 + depth, 0.0, -0.2)


UP = (0.0, 0.0, 0.05)
CASES = {
    "box on box": Case(block, over(TIP), UP),
    "box on cylinder": Case(roll, over(TIP), UP),
    "box on dish": Case(dish, over(TIP, 0.085), UP),
    "cylinder on box": Case(block, over(FOOT), UP, carries=True),
    "cylinder on cylinder": Case(roll, over(FOOT), UP, carries=True),
    "cylinder on dish": Case(dish, over(FOOT, 0.1), UP, carries=True),
    "cylinder beside cylinder": Case(post, beside, (-0.05, 0.0, 0.0), carries=True),
}


def pressed(
    case: Case, depth: float, wait: float = 0.2, **settings: Proposer | float
) -> CollisionReport:
    can = movable("can", CAN, at=(0.9, 0.0, 9.0), on=None)
    scene: Scene = scene_of(*((case.thing(), can) if case.carries else (case.thing(),)))
    goal = case.place(depth)
    dx, dy, dz = case.away
    x, y, z = goal.translation
    away = Pose(goal.rotation, (x + dx, y + dy, z + dz))
    story = Story(scene, (0.0, -1.0, 1.5, 0.0, 1.0, 0.0))
    story.q = story.solved(away)
    if case.carries:
        X_FP = scene.robot.gripper.X_FP
        turned = Pose(goal.rotation, (0.0, 0.0, FOOT))  # its foot past the pads, upright
        story.placements["can"] = [Placement("can", 0.0, math.inf, Lie.HELD, X_FP @ turned, None)]
    story.line(goal)
    story.wait(wait)
    story.line(away)
    return check_collisions(scene, story.record(), **settings)  # type: ignore[arg-type]


def counts(report: CollisionReport) -> tuple[int, int, int, int]:
    found = report.contacts, report.undetermined, report.grazes, report.near_misses
    a, b, c, d = (sum(event.second == "thing" for event in events) for events in found)
    return a, b, c, d


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("beyond", [1.5e-5, 1.8e-4])
def test_a_graze_below_the_tolerance_and_a_contact_above(name: str, beyond: float) -> None:
    below = pressed(CASES[name], TOLERANCE - beyond)
    assert counts(below) == (0, 0, 1, 0)
    assert below.certified
    assert below.grazes[0].depth_m == pytest.approx(TOLERANCE - beyond, abs=5e-6)
    above = pressed(CASES[name], TOLERANCE + beyond)
    assert counts(above) == (1, 0, 0, 0)
    assert above.certified
    assert above.contacts[0].depth_m == pytest.approx(TOLERANCE + beyond, abs=5e-6)


def test_a_depth_just_below_what_cannot_be_told_is_a_graze() -> None:
    report = pressed(CASES["box on box"], TOLERANCE - 1.1e-5)
    assert counts(report) == (0, 0, 1, 0)
    assert report.certified


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("beside", [-5e-6, 0.0, 5e-6])
def test_within_a_hundredth_of_a_millimetre_it_cannot_be_told(name: str, beside: float) -> None:
    report = pressed(CASES[name], TOLERANCE + beside)
    assert counts(report) == (0, 1, 0, 0)
    assert not report.certified
    (event,) = report.undetermined
    assert abs(event.depth_m - TOLERANCE) <= 1e-5


@pytest.mark.parametrize("name", CASES)
def test_a_gap_of_two_tenths_of_a_millimetre_is_certified(name: str) -> None:
    report = pressed(CASES[name], -2e-4)
    assert counts(report) == (0, 0, 0, 1)
    assert report.certified
    assert report.clearance is not None
    assert report.clearance.distance_m == pytest.approx(2e-4, abs=5e-6)


@pytest.mark.parametrize("name", first(1, CASES))
@pytest.mark.parametrize("by", ["own", "liar", "off", "plausible"])
def test_whoever_proposes_the_answer_is_the_same(name: str, by: str) -> None:
    for depth in (TOLERANCE + 1.5e-5, TOLERANCE, TOLERANCE - 1.5e-5, -2e-4, -NEAR - 2e-4):
        one, other = (
            pressed(CASES[name], depth, proposer=PROPOSERS[who]()) for who in ("coal", by)
        )
        assert rounded(one) == rounded(other)


def rounded(report: CollisionReport) -> object:
    """Everything that is told of events and clearance, to a millisecond and a hundredth."""
    touches = (*report.contacts, *report.grazes, *report.undetermined)
    return (
        counts(report),
        [(t.parts, *(round(s, 3) for s in (t.start_s, t.end_s, t.deepest_s))) for t in touches],
        [round(touch.depth_m, 5) for touch in touches],
        [
            (m.parts, *(round(s, 3) for s in (m.start_s, m.end_s, m.nearest_s)))
            for m in report.near_misses
        ],
        [round(miss.distance_m, 5) for miss in report.near_misses],
        report.clearance
        and (
            report.clearance.bodies,
            round(report.clearance.time_s, 3),
            round(report.clearance.distance_m, 5),
        ),
    )


@pytest.mark.parametrize("name", CASES)
def test_a_near_miss_below_its_threshold_and_none_above(name: str) -> None:
    beyond = 2e-4
    below = pressed(CASES[name], beyond - NEAR)
    assert counts(below) == (0, 0, 0, 1)
    assert counts(pressed(CASES[name], -NEAR - beyond)) == (0, 0, 0, 0)


@pytest.mark.parametrize("depth", [2.15e-4, 3e-4, 1e-3])
def test_a_long_rest_in_contact_is_one_event_from_its_first_to_its_last_moment(
    depth: float,
) -> None:
    case = CASES["box on box"]
    short, long = (pressed(case, depth, wait=wait) for wait in (0.2, 5.0))
    (one,), (other,) = short.contacts, long.contacts
    assert long.certified
    assert other.start_s == pytest.approx(one.start_s, abs=1e-3)
    assert other.end_s == pytest.approx(one.end_s + 4.8, abs=1e-3)
    assert long.statistics["exact distances"] < 2 * short.statistics["exact distances"]


def test_a_long_rest_at_the_tolerance_costs_no_more_than_a_short_one() -> None:
    case = CASES["box on box"]
    short, long = (pressed(case, TOLERANCE, wait=wait) for wait in (0.2, 5.0))
    (one,), (other,) = short.undetermined, long.undetermined
    assert other.end_s - other.start_s == pytest.approx(one.end_s - one.start_s + 4.8, abs=1e-3)
    assert long.statistics["exact distances"] < 2 * short.statistics["exact distances"]
