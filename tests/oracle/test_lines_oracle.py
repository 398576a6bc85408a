"""What is said of random lines, against lines followed by Pinocchio's Jacobian in small parts."""

import math
import random
from typing import NamedTuple, cast

import numpy as np
import pytest

from tests.laws import first
from tests.oracle.line_oracle import Followed, followed, least_singular_value
from tests.oracle.test_kinematics_oracle import arm_named, other_opinion
from vrts.base.pose import IDENTITY, Pose, translation
from vrts.controllers.models import USUAL
from vrts.engine.faults import SINGULAR_JUMP, RuntimeFault
from vrts.engine.motion.lines.path import LinePath, line
from vrts.engine.motion.overspeed import fastest, slower
from vrts.engine.motion.plan import Intent, Planned, from_rest, parameter
from vrts.engine.motion.requests import Stance, to_line
from vrts.engine.motion.settings import Settings
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.robots.kinematics.branch import branch_of
from vrts.robots.kinematics.chain import extent
from vrts.robots.kinematics.choice import NOTHING_REQUESTED
from vrts.robots.kinematics.kinematics import forward
from vrts.robots.kinematics.singular import NEAR_SINGULAR, NEAR_WRIST
from vrts.robots.model import Arm, Configuration, SerialArm
from vrts.robots.pinocchio_model import PinocchioArm

X_FT = translation(0.02, -0.01, 0.15)
SPEEDS = (1.0, 0.5, 0.2, 0.05)
PLACE = 0.005  # [m] within which places on a line agree
BORDER = 0.02  # share of a limit within which either answer is right


class Case(NamedTuple):
    stance: Stance
    X_BT: Pose
    fraction: float


def cases(arm: Arm, count: int, seed: int) -> list[Case]:
    """Return lines from random configurations to places near, far, and often beyond reach."""
    numbers = random.Random(f"{arm.name} {seed}")
    limits = [
        (max(a, -math.pi), min(b, math.pi)) for a, b in zip(arm.lower, arm.upper, strict=True)
    ]
    found: list[Case] = []
    for _ in range(count):
        q0 = cast(Configuration, tuple(numbers.uniform(*pair) for pair in limits))
        near = tuple(q + numbers.uniform(-0.6, 0.6) for q in q0)
        far = tuple(numbers.uniform(*pair) for pair in limits)
        rotation, (x, y, z) = forward(arm, cast(Configuration, numbers.choice((near, far)))) @ X_FT
        by = numbers.uniform(0.8, 1.6) if numbers.random() < 0.3 else 1.0
        X_BT = Pose(rotation, (by * x, by * y, by * z))
        branch = branch_of(arm, q0)
        stance = Stance(arm, q0, branch, NOTHING_REQUESTED, IDENTITY, X_FT, USUAL)
        found.append(Case(stance, X_BT, numbers.choice(SPEEDS)))
    return found


@pytest.mark.thorough
@pytest.mark.parametrize("seed", first(1, range(8)))
@pytest.mark.parametrize("name", ["ur5", "puma761"])
def test_random_lines_are_what_the_oracle_finds(name: str, seed: int) -> None:
    arm, other = arm_named(name), other_opinion(name)
    told: dict[str, int] = {}
    for case in cases(arm, 24, seed):
        what = judged(arm, other, case)
        told[what] = told.get(what, 0) + 1
    assert told.get("followed", 0) + told.get("too fast", 0) > 3
    assert told.get("end out of reach", 0) > 0
    assert told.get("border", 0) <= 1


def judged(arm: Arm, other: PinocchioArm, case: Case) -> str:
    """Return what is said of a line, once the oracle has agreed."""
    stance = case.stance
    try:
        intent = to_line(stance, case.X_BT, Settings(), case.fraction, None)
    except RuntimeFault as fault:
        if fault.kind not in (RuntimeErrorKind.TOO_FAR, RuntimeErrorKind.TOO_CLOSE):
            return "not begun"
        there = line(stance.X_BT, case.X_BT, stance.model.lines.turn)
        assert followed(other, there, as_matrix(X_FT.inverse()), stance.configuration).lost
        return "end out of reach"
    assert isinstance(intent.path, LinePath)
    way = followed(other, intent.path, as_matrix(X_FT.inverse()), stance.configuration)
    planned = from_rest(arm, X_FT, intent)
    outside = way.first_outside(arm.lower, arm.upper)
    if planned.fault is None:
        if way.lost is not None:  # between two set points
            return "border"
        assert outside is None
        assert planned.goal == pytest.approx(way.q[-1], abs=1e-5)
        return speeds_agree(arm, intent, planned, way)
    assert intent.path.length > PLACE
    stopped = math.dist(
        (forward(arm, planned.goal) @ X_FT).translation, intent.path.X_BT0.translation
    )
    share = stopped / intent.path.length  # of the way: it stopped one set point before, at most
    step = 1.5 * arm.linear_speed * arm.tick * case.fraction / intent.path.length + PLACE
    if planned.fault.kind is RuntimeErrorKind.JOINT_OUT_OF_RANGE:
        assert outside is not None
        u, joint = outside
        assert joint == planned.fault.data["joint"]
        assert u - step < share < u + PLACE
        return "joint limit"
    if planned.fault.kind is not RuntimeErrorKind.ILLEGAL_MOTION_FROM_HERE:
        assert way.lost is not None
        assert way.lost - step < share < way.lost + PLACE
        return "reach lost"
    assert planned.fault.rule == SINGULAR_JUMP
    near = [row for u, row in zip(way.u, way.q, strict=True) if share - PLACE < u < share + step]
    assert min(nearness(arm, other, row) for row in near) < 1.1
    if way.lost is None and planned.fault.joint:
        needed = fastest_of(arm, intent, way, share + step)
        assert needed > 1.0 - BORDER
    return "singularity"


def speeds_agree(arm: Arm, intent: Intent, planned: Planned, way: Followed) -> str:
    """Return whether a joint is too fast; the oracle has differentiated its own joints."""
    share = fastest(planned.pieces, arm.speed).share
    other = fastest_of(arm, intent, way, 1.0)
    if max(share, other) > 0.8:  # a slow line may be fast for less than a set point
        assert share == pytest.approx(other, rel=0.1)
    return "too fast" if share > 1.0 else "followed"


def fastest_of(arm: Arm, intent: Intent, way: Followed, until: float) -> float:
    """Return the largest share of a speed limit, by differences of the oracle's joints."""
    scaling = intent.profile
    times = np.linspace(0.0, scaling.total, 4000)
    shares = np.array([min(max(parameter(scaling, t - scaling.rise)[0], 0.0), 1.0) for t in times])
    joints = np.array([np.interp(shares, way.u, way.q[:, joint]) for joint in range(6)])
    rates = np.abs(np.diff(joints, axis=1)) / np.diff(times) / np.array(arm.speed)[:, None]
    return float(rates[:, shares[1:] <= until].max())


def nearness(arm: Arm, other: PinocchioArm, q: np.ndarray) -> float:
    """Return how near a configuration is to a singularity; below 1 counts as singular."""
    if isinstance(arm, SerialArm):
        return least_singular_value(other, q, extent(arm)) / NEAR_SINGULAR
    forearm, bend = math.atan2(arm.d4, arm.a3), q[2]
    reach = arm.a2 * math.cos(q[1]) + arm.a3 * math.cos(q[1] + bend)
    reach += arm.d4 * math.sin(q[1] + bend)
    elbow = abs(math.sin(bend - forearm)) / math.sin(math.radians(1.0))
    return min(abs(math.remainder(q[4], math.pi)) / NEAR_WRIST, elbow, abs(reach) / 10e-3)


def as_matrix(X: Pose) -> np.ndarray:
    found = np.eye(4)
    found[:3, :3] = np.array(X.rotation).reshape(3, 3)
    found[:3, 3] = X.translation
    return found


def test_slower_is_what_speed_makes_of_a_line() -> None:
    arm = arm_named("ur5")
    case = next(c for c in cases(arm, 40, 0) if c.fraction == 1.0)
    intent = to_line(case.stance, case.X_BT, Settings(), 1.0, None)
    half = to_line(case.stance, case.X_BT, Settings(), 0.5, None)
    assert slower(arm, intent, 50).profile == half.profile
