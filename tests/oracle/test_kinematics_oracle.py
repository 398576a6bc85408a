"""Our kinematics against Pinocchio's, and joint velocities against finite differences."""

import math
import random
from typing import cast

import numpy as np
import pytest

from vrts.base.pose import multiply, transpose
from vrts.robots.catalog import arm as arm_named
from vrts.robots.kinematics import forward, joint_velocity
from vrts.robots.model import Configuration, SphericalWristArm
from vrts.robots.pinocchio_model import flange_pose, jacobian, pinocchio_arm

ARMS = ("puma761", "puma762", "puma560")
STEP = 1e-6  # [s]


def some(arm: SphericalWristArm, count: int) -> list[Configuration]:
    numbers = random.Random(arm.name)
    limits = list(zip(arm.lower, arm.upper, strict=True))
    return [
        cast(Configuration, tuple(numbers.uniform(lo, hi) for lo, hi in limits))
        for _ in range(count)
    ]


@pytest.mark.parametrize("name", ARMS)
def test_forward_agrees_with_pinocchio(name: str) -> None:
    arm = arm_named(name)
    other = pinocchio_arm(arm)
    for q in some(arm, 200):
        rotation, origin = flange_pose(other, q)
        X_BF = forward(arm, q)
        assert X_BF.translation == pytest.approx(origin, abs=1e-12)
        assert X_BF.rotation == pytest.approx(rotation.ravel(), abs=1e-12)


@pytest.mark.parametrize("name", ARMS)
def test_joint_velocity_inverts_pinocchios_jacobian(name: str) -> None:
    arm = arm_named(name)
    other = pinocchio_arm(arm)
    compared = 0
    for q in some(arm, 200):
        J = jacobian(other, q)
        if np.linalg.cond(J) > 1e4:
            continue
        rates = np.array([0.3, -0.2, 0.5, 0.7, -0.4, 0.6])
        v = J @ rates
        found = joint_velocity(arm, q, (v[0], v[1], v[2]), (v[3], v[4], v[5]))
        assert found is not None
        assert found == pytest.approx(rates, abs=1e-8)
        compared += 1
    assert compared > 150


@pytest.mark.parametrize("name", ARMS)
def test_joint_velocity_agrees_with_finite_differences(name: str) -> None:
    arm = arm_named(name)
    for q in some(arm, 100):
        if abs(math.sin(q[4])) < 0.1:
            continue
        v, w = (0.2, -0.1, 0.3), (0.4, 0.5, -0.3)
        rates = joint_velocity(arm, q, v, w)
        if rates is None or max(map(abs, rates)) > 50.0:
            continue
        before, after = (
            forward(
                arm, cast(Configuration, tuple(a + h * b for a, b in zip(q, rates, strict=True)))
            )
            for h in (-STEP, STEP)
        )
        moved = [
            (b - a) / (2 * STEP) for a, b in zip(before.translation, after.translation, strict=True)
        ]
        assert moved == pytest.approx(v, abs=1e-5)
        d = multiply(after.rotation, transpose(before.rotation))
        turned = [(d[7] - d[5]) / 2, (d[2] - d[6]) / 2, (d[3] - d[1]) / 2]
        assert [x / (2 * STEP) for x in turned] == pytest.approx(w, abs=1e-5)
