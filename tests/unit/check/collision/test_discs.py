"""A cylinder that its joint turns round its own axis is where it was: nothing to look into."""

import numpy as np
import pytest

from tests.unit.check.collision.discs import turning
from vrts.base.pose import Pose, translation
from vrts.check.collision.collision import check_collisions
from vrts.geometry.boxes import boxes, travels
from vrts.geometry.shapes import Box, Cylinder, Shape
from vrts.geometry.solids import Frames, Instants, Motion, Solid, solids
from vrts.robots.catalog import robot
from vrts.robots.kinematics.batch import link_frames

DISC = Cylinder(0.1, 0.02)
TILTED = Pose((1.0, 0.0, 0.0, 0.0, 1.0, -1e-6, 0.0, 1e-6, 1.0), (0.0, 0.0, 0.3))


@pytest.mark.parametrize("name", ["puma560", "puma761"])
@pytest.mark.parametrize("frame", [1, 2, 4, 6])
def test_its_own_joint_moves_it_nowhere_and_the_others_as_any_point_of_it(
    name: str, frame: int
) -> None:
    random = np.random.default_rng(frame)
    count = 50
    q = random.uniform(-2.0, 2.0, (count, 6))
    state = Instants(np.zeros(count), np.zeros(count), Frames(*link_frames(robot(name).arm, q)))
    turn = random.uniform(0.0, 0.1, (count, 6))
    motion = Motion(np.ones(count), turn, np.zeros(count))
    every, disc = np.arange(count), np.zeros(count, dtype=np.int64)
    one = solids([Solid(DISC, frame, translation(0.0, 0.0, 0.3), "disc")])
    centres = one.places(state, disc, every, 9.81).centres
    bound, arms = one.travel(state, motion, disc, every, centres)
    still = turn.copy()
    still[:, frame - 1] = 0.0
    other = solids([Solid(DISC, frame, TILTED, "disc")])
    without, _ = other.travel(state, motion._replace(turn=still), disc, every, centres)
    assert np.allclose(bound, without, atol=1e-12)
    assert (arms[frame - 1] == 0.0).all()
    assert (bound[frame - 1] == 0.0).all()
    which = np.array([0])
    alike = travels(one, which, state, motion, boxes(one, which, state))
    assert np.allclose(alike[:, 0], bound, atol=1e-12)


@pytest.mark.parametrize(
    ("shape", "frame", "X_LP", "slide"),
    [
        (Box((0.1, 0.1, 0.02)), 6, translation(0.0, 0.0, 0.3), (0.0, 0.0, 0.0)),
        (DISC, 6, translation(2e-7, 0.0, 0.3), (0.0, 0.0, 0.0)),
        (DISC, 6, TILTED, (0.0, 0.0, 0.0)),
        (DISC, 6, translation(0.0, 0.0, 0.3), (0.0, 0.5, 0.0)),
        (DISC, 0, translation(0.0, 0.0, 0.3), (0.0, 0.0, 0.0)),
    ],
)
def test_what_is_not_round_about_its_joint_moves(
    shape: Shape, frame: int, X_LP: Pose, slide: tuple[float, float, float]
) -> None:
    assert not solids([Solid(shape, frame, X_LP, "thing", slide)]).spins.any()


def test_a_can_that_turns_beside_a_thing_needs_no_looking_into() -> None:
    report = check_collisions(*turning(2e-5))
    (miss,) = report.near_misses
    assert miss.distance_m == pytest.approx(2e-5, abs=1e-6)
    assert report.statistics["pairs of intervals"] < 50  # otherwise 1,900


def test_a_can_that_wobbles_hits_what_it_turns_beside() -> None:
    scene, run = turning(2e-5, off=-0.001)
    (hit,) = check_collisions(scene, run).contacts
    assert (hit.first, hit.second) == ("robot", "block")
    assert hit.depth_m == pytest.approx(0.001 * (1 - np.cos(1.5)) - 2e-5, abs=2e-5)
