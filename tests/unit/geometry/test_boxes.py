"""Boxes and bounds of all solids at once are those of one solid at a time."""

import math

import numpy as np

from vrts.base.pose import Pose, rotation_about, translation
from vrts.geometry.boxes import boxes, travels
from vrts.geometry.shapes import Box, Cylinder, Hull
from vrts.geometry.solids import Frames, Instants, Motion, Solid, solids
from vrts.robots.catalog import robot
from vrts.robots.kinematics.batch import link_frames

TURN = Pose(rotation_about((0.36, 0.48, 0.8), 0.7), (0.05, -0.1, 0.2))
TIP = Hull(((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.0, 0.05, 0.0), (0.0, 0.0, 0.2)))
MEMBERS = solids(
    [
        Solid(Box((0.1, 0.2, 0.3)), 2, TURN, "upper arm"),
        Solid(Cylinder(0.05, 0.2), 4, TURN, "wrist"),
        Solid(TIP, 6, TURN, "left finger", (0.0, 0.5, 0.0)),
        Solid(Box((0.5, 0.5, 0.01)), 0, translation(1.0, 0.0, -0.3), "table"),
    ]
)


def test_every_solid_at_every_instant() -> None:
    random = np.random.default_rng(7)
    count = 9
    q = random.uniform(-math.pi, math.pi, (count, 6))
    state = Instants(
        np.zeros(count),
        random.uniform(0, 0.08, count),
        Frames(*link_frames(robot("puma761").arm, q)),
    )
    motion = Motion(
        np.full(count, 0.1), random.uniform(0, 0.3, (count, 6)), random.uniform(0, 0.01, count)
    )
    which = np.arange(len(MEMBERS.shapes))
    at = boxes(MEMBERS, which, state)
    bound = travels(MEMBERS, which, state, motion, at)
    solid, instant = np.repeat(which, count), np.tile(np.arange(count), len(which))
    places = MEMBERS.places(state, solid, instant, 9.81)
    one_by_one = MEMBERS.travel(state, motion, solid, instant, places.centres)[0]
    assert np.allclose(at.centre.reshape(3, -1).T, places.centres, atol=1e-14)
    assert np.allclose(at.half.reshape(3, -1).T, places.halves, atol=1e-14)
    assert np.allclose(bound.reshape(7, -1), one_by_one, atol=1e-14)
