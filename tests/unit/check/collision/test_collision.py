"""Contacts, grazes and clearance of runs whose truth is known."""

import math

import numpy as np
import pytest

from tests.collision_runs import Record, Story, down, fixed, movable, scene_of
from tests.places import ROOT
from vrts.base.pose import IDENTITY, Pose, rotation_about, translation
from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.verdict import CollisionReport
from vrts.engine.memory.records import Lie, Placement
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.scene.model import Body, Scene
from vrts.scene.reading.scene_file import read_scene

CAN = Piece(Cylinder(0.03, 0.0575), translation(0.0, 0.0, 0.0575))
TABLE = fixed("table", Piece(Box((0.4, 0.7, 0.02)), IDENTITY), at=(1.0, 0.0, -0.32))
GRIP = down(0.9, 0.0, -0.225)  # pad centre on a can at the middle of the table


def can(at: tuple[float, float, float] = (0.9, 0.0, -0.3), on: str | None = "table") -> Body:
    return movable("can1", CAN, at=at, on=on)


def above(X_WP: Pose, height: float) -> Pose:
    x, y, z = X_WP.translation
    return Pose(X_WP.rotation, (x, y, z + height))


def beside(X_WP: Pose, x: float, y: float) -> Pose:
    a, b, c = X_WP.translation
    return Pose(X_WP.rotation, (a + x, b + y, c))


def started(scene: Scene, at: Pose, opening: float = 0.08) -> Story:
    """A story that begins with the hand at a place."""
    story = Story(scene, (0.0, -1.0, 1.5, 0.0, 1.0, 0.0), opening)
    story.q = story.solved(at)
    return story


def checked(story: Story) -> CollisionReport:
    return check_collisions(story.scene, story.record())


def quiet(report: CollisionReport) -> None:
    assert report.contacts == ()
    assert report.grazes == ()
    assert report.undetermined == ()
    assert report.certified


@pytest.fixture(scope="module")
def cans() -> Scene:
    path = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    scene, problems = read_scene(SourceFile("scene.toml", path.read_text(encoding="utf-8")))
    assert scene is not None, problems
    return scene


def pick_and_place(scene: Scene, height: float) -> Story:
    story = Story(scene, scene.robot.arm.ready)
    grip, put = scene.locations["can1_grip"], scene.locations["base2_put"]
    story.move(above(grip, 0.2))
    story.line(grip)
    story.grasp("can1")
    story.line(above(grip, height))
    story.line(above(put, height + grip.translation[2] - put.translation[2]))
    story.line(put)
    story.release("can1", "base2")
    story.line(above(put, 0.2))
    return story


def test_a_high_way_is_certified_free(cans: Scene) -> None:
    report = checked(pick_and_place(cans, 0.32))
    quiet(report)
    clearance = report.clearance
    assert clearance is not None
    # the open fingers stand 80 mm apart round a can of 60 mm
    assert clearance.distance_m == pytest.approx(0.010, abs=1e-4)
    assert clearance.bodies[0] in ("left finger", "right finger")
    assert math.dist(*clearance.witnesses) == pytest.approx(clearance.distance_m, abs=1e-5)


def test_a_low_way_carries_the_can_into_a_base(cans: Scene) -> None:
    story = pick_and_place(cans, 0.06)
    report = checked(story)
    assert [event.second for event in report.contacts].count("base1") == 1
    event = next(event for event in report.contacts if event.second == "base1")
    assert event.first == "robot"
    assert event.parts == ("can1", "base1")
    assert event.held == "can1"
    across = story.motions[3]
    assert event.cause == across.cause
    assert across.start_s < event.start_s < event.deepest_s < event.end_s < across.end_s
    assert event.depth_m > 0.01
    assert report.clearance is None


def test_times_and_depth_of_a_passage_through_a_plate() -> None:
    # the fingertips stand 15 mm past the pad centre and pass a plate of 4 mm at 2 mm depth
    plate = fixed("plate", Piece(Box((0.002, 0.3, 0.1)), IDENTITY), at=(0.9, 0.0, -0.3))
    start = down(0.8, 0.0, -0.2 + 0.015 - 0.002)
    scene = scene_of(plate)
    story = started(scene, start)
    story.line(beside(start, 0.2, 0.0))
    (event,) = checked(story).contacts
    motion = story.motions[0]
    length, duration = 0.2, motion.end_s - motion.start_s

    def place(t: float) -> float:
        s = t / duration
        return 0.8 + length * s * s * (3 - 2 * s)

    # the fingers are 24 mm wide along the way; they touch at 0.2 mm from their edge and the plate's
    reach = 0.012 + 0.002 - 2e-4
    assert 0.9 - place(event.start_s) == pytest.approx(reach, abs=3e-4)
    assert place(event.end_s) - 0.9 == pytest.approx(reach, abs=3e-4)
    assert event.depth_m == pytest.approx(0.002, abs=2e-5)


def test_a_can_at_rest_and_touching_things_gives_nothing() -> None:
    neighbour = movable("can2", CAN, at=(0.96, 0.0, -0.3), on="table")
    story = started(scene_of(TABLE, can(), neighbour), above(GRIP, 0.3))
    story.wait(2.0)
    quiet(checked(story))


@pytest.mark.parametrize(("width", "contacts"), [(0.06, 0), (0.0584, 0), (0.0574, 1)])
def test_pads_may_press_one_millimetre_deep(width: float, contacts: int) -> None:
    story = started(scene_of(TABLE, can()), above(GRIP, 0.1))
    story.line(GRIP)
    story.grasp("can1", width)
    story.line(above(GRIP, 0.2))
    report = checked(story)
    assert len(report.contacts) == contacts
    assert report.grazes == ()


def test_open_fingers_that_come_down_on_a_can_count() -> None:
    story = started(scene_of(TABLE, can()), above(beside(GRIP, 0.0, 0.0), 0.2), 0.05)
    story.line(GRIP)
    (event,) = checked(story).contacts
    assert event.second == "can1"
    assert event.held is None
    assert event.parts[0] in ("left finger", "right finger")


def test_pads_count_again_once_they_have_come_off() -> None:
    story = started(scene_of(TABLE, can()), GRIP)
    story.grasp("can1")
    story.release("can1", "table")
    story.wait(0.5)
    story.line(beside(GRIP, 0.02, 0.02))
    contacts = checked(story).contacts
    assert [event.second for event in contacts] == ["can1"]
    assert contacts[0].cause == story.motions[0].cause


def test_setting_down_is_free_and_a_blow_to_the_side_is_not() -> None:
    base = fixed("base", Piece(Box((0.06, 0.06, 0.05)), IDENTITY), at=(1.1, 0.0, -0.25))
    scene = scene_of(TABLE, base, can())
    put = down(1.1, 0.0, -0.125)
    for sunk, contacts in ((0.0, 0), (0.0009, 0), (0.0015, 1)):
        story = started(scene, GRIP)
        story.grasp("can1")
        story.line(above(GRIP, 0.25))
        story.line(above(put, 0.15))
        story.line(above(put, -sunk))
        story.release("can1", "base")
        story.line(above(put, 0.15))
        assert len(checked(story).contacts) == contacts
    story = started(scene, GRIP)
    story.grasp("can1")
    story.line(above(GRIP, 0.05))
    story.line(beside(above(GRIP, 0.05), 0.2, 0.0))
    story.line(put)
    story.release("can1", "base")
    assert [event.parts for event in checked(story).contacts] == [("can1", "base")]


def test_a_dropped_can_that_passes_a_shelf_is_a_contact_of_free_objects() -> None:
    shelf = fixed("shelf", Piece(Box((0.02, 0.1, 0.002)), IDENTITY), at=(0.945, 0.0, -0.28))
    story = started(scene_of(TABLE, shelf, can()), above(GRIP, 0.1))
    X_FO = (GRIP @ story.scene.robot.gripper.X_FP.inverse()).inverse() @ translation(0.9, 0, -0.3)
    story.placements["can1"] = [Placement("can1", 0.0, math.inf, Lie.HELD, X_FO, None)]
    story.opening = 0.06
    story.wait(0.1)
    story.release("can1", "table", fall=0.1)
    story.wait(1.0)
    (event,) = checked(story).contacts
    assert (event.first, event.second) == ("can1", "shelf")
    # the can's foot meets the shelf's top 78 mm below where it was let go
    assert event.start_s == pytest.approx(0.1 + math.sqrt(2 * (0.0782 - 0.0) / 9.81), abs=2e-3)


def test_contacts_less_than_half_a_second_apart_are_one_event() -> None:
    plate = fixed("plate", Piece(Box((0.002, 0.3, 0.1)), IDENTITY), at=(0.9, 0.0, -0.3))
    start = down(0.85, 0.0, -0.19)
    for wait, events in ((0.0, 1), (1.0, 2)):
        story = started(scene_of(plate), start)
        story.line(beside(start, 0.1, 0.0), 0.5)
        story.wait(wait)
        story.line(start, 0.5)
        report = checked(story)
        assert len(report.contacts) == events
        assert report.certified


@pytest.mark.parametrize(
    ("depth", "contacts", "grazes", "undetermined"),
    [(-1e-3, 0, 0, 0), (0.0, 0, 0, 0), (1e-4, 0, 1, 0), (2e-4, 0, 0, 1), (3e-4, 1, 0, 0)],
)
def test_depth_decides(depth: float, contacts: int, grazes: int, undetermined: int) -> None:
    block = fixed("block", Piece(Box((0.05, 0.2, 0.05)), IDENTITY), at=(0.9, 0.0, -0.35))
    low = down(0.9, 0.0, -0.3 + 0.015 - depth)
    story = started(scene_of(block), above(low, 0.05))
    story.line(low)
    story.wait(0.5)
    story.line(above(low, 0.05))
    report = checked(story)
    assert len(report.contacts) == contacts
    assert len(report.grazes) == grazes
    assert len(report.undetermined) == undetermined
    assert report.certified is (undetermined == 0)


@pytest.mark.parametrize("seed", range(8))
def test_an_obstacle_moved_by_the_clearance_flips_the_verdict(seed: int) -> None:
    random = np.random.default_rng(seed)
    # a wide slab under the way, tilted, so that the way out is always along its normal
    tilt = rotation_about((math.sin(seed), math.cos(seed), 0.0), float(random.uniform(-0.3, 0.3)))
    slab = Piece(Box((0.4, 0.6, 0.1)), Pose(tilt, (0.0, 0.0, 0.0)))
    here = (0.9, 0.0, -0.6)

    def report(at: tuple[float, float, float]) -> CollisionReport:
        story = started(scene_of(fixed("slab", slab, at=at)), down(0.75, -0.25, 0.0))
        story.move(down(1.05, 0.3, -0.02), 0.8)
        return check_collisions(story.scene, story.record())

    def moved(distance: float) -> tuple[float, float, float]:
        assert clearance is not None
        share = distance / clearance.distance_m
        (x, y, z), (a, b, c) = clearance.witnesses
        return (here[0] + share * (x - a), here[1] + share * (y - b), here[2] + share * (z - c))

    clearance = report(here).clearance
    assert clearance is not None
    assert clearance.bodies[1] == "slab"
    tolerance = 2e-4
    nearer = report(moved(clearance.distance_m - 2e-4))
    quiet(nearer)
    assert nearer.clearance is not None
    assert 0.0 < nearer.clearance.distance_m <= 2e-4 + 1e-5
    assert report(moved(clearance.distance_m + tolerance + 2e-4)).contacts


def test_the_hand_that_meets_the_column_is_a_self_contact() -> None:
    story = Story(scene_of(), (0.0, -math.pi / 2, math.pi / 2, 0.0, 0.0, 0.0))
    story.move((0.0, 0.0, math.radians(200.0), 0.0, 0.0, 0.0))
    (event,) = checked(story).contacts
    assert (event.first, event.second) == ("robot", "robot")
    assert set(event.parts) == {"right finger", "base"}


def test_the_clock_of_a_run_may_start_late_and_bodies_need_no_history() -> None:
    story = started(scene_of(TABLE, can()), above(GRIP, 0.3))
    story.t = 5.0
    story.wait(1.0)
    record = story.record()
    bare = Record(record.timeline, record.motions, record.events, {})
    quiet(check_collisions(story.scene, bare))
