"""Our kinematics against Pinocchio's, and joint velocities against finite differences.

The UR arms and the arm of a scene are read from their URDF files twice: by us and by Pinocchio.
"""

import math
import random
from importlib.metadata import distribution
from pathlib import Path
from typing import cast

import numpy as np
import pytest

from tests.places import ROOT
from vrts.base.pose import multiply, transpose
from vrts.base.source import SourceFile
from vrts.robots.catalog import arm as any_arm
from vrts.robots.catalog import puma
from vrts.robots.kinematics.batch import flange_frames
from vrts.robots.kinematics.chain import chain, columns
from vrts.robots.kinematics.kinematics import forward, joint_velocity
from vrts.robots.model import Arm, Configuration, SerialArm
from vrts.robots.pinocchio_model import (
    PinocchioArm,
    flange_pose,
    jacobian,
    pinocchio_arm,
    pinocchio_from_urdf,
)
from vrts.robots.urdf import universal
from vrts.scene.reading.scene_file import read_scene

SCENES = ROOT / "scenes"
PUMAS = ("puma761", "puma762", "puma560")
SERIAL = (*universal.names(), "small_arm")
ARMS = (*PUMAS, *SERIAL)
STEP = 1e-6  # [s]
TOLERANCE = 1e-10  # [m]; URDF writes quarter turns with 12 digits


def arm_named(name: str) -> Arm:
    if name != "small_arm":
        return any_arm(name)
    folder = SCENES / "one-can-urdf"
    scene, _ = read_scene(SourceFile("scene.toml", (folder / "scene.toml").read_text()), folder)
    assert scene is not None
    return scene.robot.arm


def other_opinion(name: str) -> PinocchioArm:
    if name in PUMAS:
        return pinocchio_arm(puma(name))
    if name == "small_arm":
        return pinocchio_from_urdf(SCENES / "one-can-urdf" / "arm.urdf", "tool0")
    share = Path(str(distribution(universal.WHEEL).locate_file(universal.SHARE)))
    folder = share / universal.WHEEL / "robots" / "ur_description" / "urdf"
    return pinocchio_from_urdf(folder / f"{name}_robot.urdf", "tool0")


def some(arm: Arm, count: int) -> list[Configuration]:
    numbers = random.Random(arm.name)
    limits = list(zip(arm.lower, arm.upper, strict=True))
    return [
        cast(Configuration, tuple(numbers.uniform(lo, hi) for lo, hi in limits))
        for _ in range(count)
    ]


@pytest.mark.parametrize("name", ARMS)
def test_forward_agrees_with_pinocchio(name: str) -> None:
    arm = arm_named(name)
    other = other_opinion(name)
    for q in some(arm, 200):
        rotation, origin = flange_pose(other, q)
        X_BF = forward(arm, q)
        assert X_BF.translation == pytest.approx(origin, abs=TOLERANCE)
        assert X_BF.rotation == pytest.approx(rotation.ravel(), abs=TOLERANCE)


@pytest.mark.parametrize("name", ARMS)
def test_joint_velocity_inverts_pinocchios_jacobian(name: str) -> None:
    arm = arm_named(name)
    other = other_opinion(name)
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
        if name in PUMAS and abs(math.sin(q[4])) < 0.1:
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


@pytest.mark.parametrize("name", SERIAL)
def test_our_jacobian_is_pinocchios(name: str) -> None:
    arm = arm_named(name)
    assert isinstance(arm, SerialArm)
    other = other_opinion(name)
    for q in some(arm, 50):
        ours = np.array(columns(chain(arm, q), 1.0)).T
        assert ours == pytest.approx(jacobian(other, q), abs=TOLERANCE)


@pytest.mark.parametrize("name", ARMS)
def test_many_at_once_are_the_same_as_one_by_one(name: str) -> None:
    arm = arm_named(name)
    rows = some(arm, 50)
    rotations, origins = flange_frames(arm, np.array(rows))
    for number, q in enumerate(rows):
        X_BF = forward(arm, q)
        assert origins[number] == pytest.approx(X_BF.translation, abs=1e-12)
        assert rotations[number].ravel() == pytest.approx(X_BF.rotation, abs=1e-12)
