"""An arm as it stands: every part of vrts sees the same, and its bound holds."""

from dataclasses import replace

import numpy as np
import pytest

from vrts.base.units import DEG, MM
from vrts.check.proof.checker import frames
from vrts.geometry.shapes import Box, Cylinder, Piece
from vrts.robots.arms.puma import PUMA_761
from vrts.robots.built import as_built, at_the_ends, doubt_m
from vrts.robots.catalog import robot
from vrts.robots.kinematics.batch import flange_frames, link_frames
from vrts.robots.kinematics.kinematics import branch_of, forward, hand_pose, link_poses, solve
from vrts.robots.model import Arm, Configuration, Off, SphericalWristArm, Within

OFF = Off(
    shown=(0.01, -0.02, 0.005, 0.0, 0.03, 0.0),
    zeros=(0.0, 0.002, 0.0, -0.01, 0.0, 0.02),
    links=(1 * MM, -2 * MM, 0.5 * MM, 3 * MM),
    tool=(0.4 * MM, 0.0, -1.0 * MM),
    base=(2 * MM, -1 * MM, 0.5 * MM),
    turn=(0.001, 0.0, 0.004),
)
SOME: Configuration = (0.3, -1.0, 1.2, 0.4, -0.7, 2.0)


def plus(q: Configuration, *more: Configuration) -> Configuration:
    a, b, c, d, e, f = (sum(one) for one in zip(q, *more, strict=True))
    return (a, b, c, d, e, f)


def test_joints_that_stand_off_are_the_same_arm_turned_further() -> None:
    off = Off(shown=OFF.shown, zeros=OFF.zeros)
    arm = as_built(PUMA_761, off)
    found = hand_pose(arm, SOME)
    wanted = forward(PUMA_761, plus(SOME, off.shown, off.zeros))
    assert found.rotation == pytest.approx(wanted.rotation, abs=1e-12)
    assert found.translation == pytest.approx(wanted.translation, abs=1e-12)


def test_links_are_those_of_an_arm_that_has_them() -> None:
    longer = {
        link: getattr(PUMA_761, link) + by
        for link, by in zip(("a2", "a3", "d2", "d4"), OFF.links, strict=True)
    }
    wanted = forward(replace(PUMA_761, **longer), SOME)
    found = hand_pose(as_built(PUMA_761, Off(links=OFF.links)), SOME)
    assert found.translation == pytest.approx(wanted.translation, abs=1e-12)


def test_the_tool_moves_with_the_hand_and_the_base_does_not() -> None:
    nominal = forward(PUMA_761, SOME)
    tool = hand_pose(as_built(PUMA_761, Off(tool=OFF.tool)), SOME)
    assert tool.translation == pytest.approx(nominal.apply(OFF.tool), abs=1e-12)
    base = hand_pose(as_built(PUMA_761, Off(base=OFF.base)), SOME)
    moved = [a + b for a, b in zip(nominal.translation, OFF.base, strict=True)]
    assert base.translation == pytest.approx(moved, abs=1e-12)


@pytest.mark.parametrize("name", ["puma560", "puma761", "ur5"])
def test_one_pose_many_poses_and_the_checker_of_proofs_see_the_same_arm(name: str) -> None:
    arm = as_built(robot(name).arm, OFF)
    q = np.random.default_rng(7).uniform(-2.0, 2.0, (20, 6))
    rotations, origins = link_frames(arm, q)
    turns, places = frames(arm, q)
    assert rotations == pytest.approx(turns, abs=1e-12)
    assert origins == pytest.approx(places, abs=1e-12)
    hands, tips = flange_frames(arm, q)
    for k, row in enumerate(q.tolist()):
        a, b, c, d, e, f = row
        poses = link_poses(arm, (a, b, c, d, e, f))
        assert origins[:, k] == pytest.approx(np.array([X.translation for X in poses]), abs=1e-12)
        hand = hand_pose(arm, (a, b, c, d, e, f))
        assert tips[k] == pytest.approx(np.array(hand.translation), abs=1e-12)
        assert hands[k].ravel() == pytest.approx(np.array(hand.rotation), abs=1e-12)


def test_its_controller_counts_as_before() -> None:
    arm = as_built(PUMA_761, OFF)
    assert forward(arm, SOME) == forward(PUMA_761, SOME)
    X_BF = forward(PUMA_761, SOME)
    branch = branch_of(PUMA_761, SOME)
    assert branch is not None
    assert solve(arm, X_BF, branch, SOME) == solve(PUMA_761, X_BF, branch, SOME)


def corners(piece: Piece) -> list[tuple[float, float, float]]:
    shape, X = piece
    if isinstance(shape, Box):
        x, y, z = shape.half_extents
        own = [(a * x, b * y, c * z) for a in (-1, 1) for b in (-1, 1) for c in (-1, 1)]
    elif isinstance(shape, Cylinder):
        turns = np.linspace(0.0, 2 * np.pi, 8)
        r = shape.radius
        own = [
            (r * float(np.cos(t)), r * float(np.sin(t)), end * shape.half_length)
            for t in turns
            for end in (-1, 1)
        ]
    else:
        own = list(shape.points)
    return [X.apply(point) for point in own]


def points(arm: Arm, q: Configuration, hand: list[Piece]) -> np.ndarray:
    poses = link_poses(arm, q)
    found = [
        poses[link.joint].apply(p) for link in arm.links for x in link.pieces for p in corners(x)
    ]
    X_WF = hand_pose(arm, q)
    return np.array([*found, *(X_WF.apply(p) for piece in hand for p in corners(piece))])


@pytest.mark.parametrize("name", ["puma560", "puma761", "ur5"])
def test_no_point_of_the_robot_is_farther_off_than_the_bound(name: str) -> None:
    """All numbers anywhere in their intervals at once; and the bound is not idle."""
    whole = robot(name)
    long = 0.3 * MM if isinstance(whole.arm, SphericalWristArm) else 0.0
    half = Off(
        shown=(0.001, 0.001, 0.001, 0.001, 0.001, 0.001),
        zeros=(0.0005, 0.0005, 0.0005, 0.0005, 0.0005, 0.0005),
        links=(long, long, long, long),
        tool=(0.2 * MM, 0.2 * MM, 0.2 * MM),
        base=(0.1 * MM, 0.1 * MM, 0.1 * MM),
        turn=(0.0004, 0.0004, 0.0004),
    )
    arm = as_built(whole.arm, OFF, Within(half))
    bound = doubt_m(replace(whole, arm=arm))
    hand = [*whole.gripper.body]
    chance, worst = np.random.default_rng(11), 0.0
    for number in range(60):
        q = tuple(chance.uniform(arm.lower, arm.upper).tolist())
        ends = chance.choice((-1.0, 1.0), 40) if number % 2 else chance.uniform(-1.0, 1.0, 40)
        signs = iter(ends.tolist())
        other = Off(
            *(
                tuple(a + next(signs) * b for a, b in zip(value, span, strict=True))
                for value, span in zip(OFF, half, strict=True)
            )  # type: ignore[arg-type]
        )
        off = points(as_built(whole.arm, other), q, hand) - points(arm, q, hand)
        worst = max(worst, float(np.linalg.norm(off, axis=1).max()))
    assert worst <= bound
    assert worst > 0.15 * bound


def test_the_bound_is_near_where_one_joint_turns_a_straight_arm() -> None:
    """A hand with a long thing in it, level in front of the shoulder: joint 2 lifts all of it."""
    half = Off(zeros=(0.0, 0.001, 0.0, 0.0, 0.0, 0.0))
    whole, thing = robot("puma761"), 0.8
    arm = as_built(PUMA_761, Off(), Within(half))
    q: Configuration = (0.0, 0.0, 90 * DEG, 0.0, 0.0, 0.0)
    tip = hand_pose(arm, q).apply((0.0, 0.0, thing))
    raised = hand_pose(as_built(PUMA_761, Off(zeros=half.zeros)), q).apply((0.0, 0.0, thing))
    off = float(np.linalg.norm(np.subtract(tip, raised)))
    bound = doubt_m(replace(whole, arm=arm), [thing])
    assert off <= bound < 1.15 * off
    assert doubt_m(replace(whole, arm=arm)) < bound


def test_every_number_is_tried_at_both_ends_of_its_interval() -> None:
    arm = as_built(
        PUMA_761, OFF, Within(Off(shown=(0.0, 0.0, 0.1 * DEG, 0.0, 0.0, 0.0), tool=(0.0, 0.0, MM)))
    )
    assert arm.built is not None
    told = {one.what: one.off for one in at_the_ends(arm.built)}
    assert list(told) == [
        "joint 3 at the lower end of its interval",
        "joint 3 at the upper end of its interval",
        "Z of the tool at the lower end of its interval",
        "Z of the tool at the upper end of its interval",
    ]
    upper = told["joint 3 at the upper end of its interval"]
    assert upper.shown[2] == pytest.approx(OFF.shown[2] + 0.1 * DEG)
    assert upper._replace(shown=OFF.shown) == OFF
