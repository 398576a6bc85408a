"""coal and fcl, two code bases, answer alike about the pieces of robots and the things around."""

import math

import numpy as np

from vrts.base.pose import IDENTITY, Pose, Vector, rotation_about
from vrts.geometry import coal_engine, fcl_engine
from vrts.geometry.shapes import Box, Cylinder, Hull, Piece, Shape
from vrts.robots.catalog import robot

ARM: list[Shape] = [piece.shape for link in robot("puma761").arm.links for piece in link.pieces]
THINGS: list[Shape] = [
    Cylinder(0.03, 0.0575),
    Cylinder(0.001, 0.1),
    Box((0.001, 0.02, 0.02)),
    Box((0.4, 0.7, 0.02)),
    Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.1))),
]


def random_pose(random: np.random.Generator) -> Pose:
    x, y, z = (random.normal(size=3)).tolist()
    size = math.hypot(x, y, z)
    axis: Vector = (x / size, y / size, z / size)
    a, b, c = random.uniform(-0.5, 0.5, 3).tolist()
    return Pose(rotation_about(axis, float(random.uniform(-math.pi, math.pi))), (a, b, c))


def test_distances_and_verdicts_agree() -> None:
    random = np.random.default_rng(11)
    apart = touching = 0
    for _ in range(3000):
        first = Piece(ARM[int(random.integers(len(ARM)))], IDENTITY)
        other = Piece(THINGS[int(random.integers(len(THINGS)))], IDENTITY)
        X_WA, X_WB = random_pose(random), random_pose(random)
        ours = coal_engine.nearest(first, X_WA, other, X_WB)
        theirs = fcl_engine.nearest(first, X_WA, other, X_WB)
        if abs(ours.distance) > 2e-4:
            assert (ours.distance < 0.0) is (theirs.distance < 0.0)
        if ours.distance > 2e-4:
            apart += 1
            # both distances lie between points of the shapes: the smaller one is the better
            assert ours.distance < theirs.distance + coal_engine.ERROR
            if ours.distance < 0.3:
                assert theirs.distance < ours.distance + fcl_engine.ERROR + coal_engine.ERROR
        else:
            touching += 1
    assert apart > 500
    assert touching > 100


def test_both_measure_a_known_gap_and_a_known_depth() -> None:
    box, can = Piece(Box((0.1, 0.1, 0.1)), IDENTITY), Piece(Cylinder(0.03, 0.05), IDENTITY)
    for gap in (0.02, 0.0005, -0.0005, -0.01):
        X_WB = Pose(IDENTITY.rotation, (0.13 + gap, 0.01, 0.0))
        assert abs(coal_engine.distance(box, IDENTITY, can, X_WB) - gap) < coal_engine.ERROR
        assert abs(fcl_engine.distance(box, IDENTITY, can, X_WB) - gap) < fcl_engine.ERROR


def test_margins_and_the_normal_of_both() -> None:
    box = Box((0.1, 0.1, 0.1))
    for engine in (coal_engine, fcl_engine):
        X_WB = Pose(IDENTITY.rotation, (0.25, 0.0, 0.0))
        found = engine.nearest(Piece(box, IDENTITY), IDENTITY, Piece(box, IDENTITY), X_WB)
        assert math.dist(found.normal, (1.0, 0.0, 0.0)) < 1e-3
    here, there = (
        coal_engine.placed(IDENTITY),
        coal_engine.placed(Pose(IDENTITY.rotation, (0.25, 0, 0))),
    )
    assert coal_engine.pair(box, box).closer_than(here, there, 0.051)
    assert not coal_engine.pair(box, box).closer_than(here, there, 0.049)
