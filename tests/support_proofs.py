"""Runs whose certificates are looked at: free, with contacts, with a fall, of another arm."""

from functools import cache
from typing import NamedTuple

from tests.collision_runs import Record, Story, down, fixed, movable, scene_of
from tests.places import ROOT
from vrts.base.pose import IDENTITY, Pose, rotation_about, translation
from vrts.base.source import SourceFile
from vrts.check.collision.collision import check_collisions
from vrts.check.proof.record import Certified, certified
from vrts.check.verdict import CollisionReport
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece
from vrts.robots.catalog import robot
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene

CAN = Piece(Cylinder(0.03, 0.0575), translation(0.0, 0.0, 0.0575))
HALVES = tuple(  # the upper one first
    Piece(Cylinder(0.03, 0.02875), translation(0.0, 0.0, z)) for z in (0.08625, 0.02875)
)
TABLE = fixed("table", Piece(Box((0.4, 0.7, 0.02)), IDENTITY), at=(1.0, 0.0, -0.32))
GRIP = down(0.9, 0.0, -0.225)
POST = Hull(tuple((x, y, z) for x in (-0.02, 0.02) for y in (-0.02, 0.02) for z in (-0.05, 0.05)))


class Case(NamedTuple):
    """A run, what was found in it, and its certificate."""

    scene: Scene
    run: Record
    report: CollisionReport
    certified: Certified


def above(X_WP: Pose, height: float) -> Pose:
    x, y, z = X_WP.translation
    return Pose(X_WP.rotation, (x, y, z + height))


@cache
def case(name: str) -> Case:
    """Return a case by its name: "free", "contact", "fall", "again" or "serial"."""
    stories = {"free": free, "contact": contact, "fall": fall, "again": again, "serial": serial}
    story = stories[name]()
    run = story.record()
    report = check_collisions(story.scene, run)
    return Case(story.scene, run, report, certified(story.scene, run, report))


def free() -> Story:
    """A can is carried from base to base, high enough."""
    return carried(0.32)


def contact() -> Story:
    """The same, too low: it hits both bases."""
    return carried(0.05)


def carried(height: float) -> Story:
    path = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    scene, problems = read_scene(SourceFile("scene.toml", path.read_text(encoding="utf-8")))
    assert scene is not None, problems
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


def fall() -> Story:
    """A can is let go 20 cm above the table, and hits a post of the shape of a hull."""
    can = movable("can1", CAN, at=(0.9, 0.0, -0.3), on="table")
    post = fixed("post", Piece(POST, IDENTITY), at=(0.94, 0.0, -0.2))
    scene = scene_of(TABLE, can, post)
    story = Story(scene, (0.0, -1.0, 1.5, 0.0, 1.0, 0.0))
    story.q = story.solved(above(GRIP, 0.1))
    story.line(GRIP)
    story.grasp("can1")
    story.line(above(GRIP, 0.2))
    story.release("can1", "table", 0.2)
    story.wait(0.5)
    story.line(above(GRIP, 0.3))
    return story


def again() -> Story:
    """A can comes near its table again on the way, and open fingers come near it after that."""
    can = movable("can1", *HALVES, at=(0.9, 0.0, -0.3), on="table")
    story = Story(scene_of(TABLE, can), (0.0, -1.0, 1.5, 0.0, 1.0, 0.0))
    turn = Pose(rotation_about((0.0, 0.0, 1.0), 0.5), (0.0, 0.0, 0.0))  # boxes show less then
    grip = Pose((turn @ GRIP).rotation, GRIP.translation)
    story.q = story.solved(grip)
    story.grasp("can1")
    put = Pose(grip.rotation, (0.9, 0.1, GRIP.translation[2]))
    for height in (0.004, 0.002):  # nearer than a near miss, as it is on purpose
        story.line(above(grip, height))
    for at, height in ((grip, 0.03), (grip, 0.01), (put, 0.03), (put, 0.012), (put, 0.03)):
        story.line(above(at, height))
    story.line(put)
    story.release("can1", "table")
    story.wait(0.3)
    for aside in (0.003, 0.0):  # fingers 10 mm from the can on either side
        story.line(put @ translation(0.0, aside, 0.0))
    story.line(above(put, 0.2))
    return story


def serial() -> Story:
    """A UR5 swings beside a wall, with its hand turning."""
    wall = fixed("wall", Piece(Box((0.02, 0.3, 0.3)), IDENTITY), at=(0.75, 0.0, 0.4))
    machine = robot("ur5")
    story = Story(scene_of(wall, machine=machine), machine.arm.ready)
    a, b, c, d, e, f = machine.arm.ready
    story.move((a + 0.6, b + 0.2, c - 0.3, d, e, f + 1.0))
    story.move((a - 0.6, b, c, d + 0.5, e - 0.4, f - 1.0))
    return story
