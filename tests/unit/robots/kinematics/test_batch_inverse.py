"""The batched closed form is the scalar one, row by row."""

import random
from typing import cast

import numpy as np
import pytest

from vrts.robots.catalog import puma
from vrts.robots.kinematics.batch import flange_frames
from vrts.robots.kinematics.batch_inverse import solve_batch
from vrts.robots.kinematics.branch import ALL_BRANCHES
from vrts.robots.kinematics.kinematics import forward, solve
from vrts.robots.model import ArmBranch, Configuration

NUMBERS = random.Random(4)


def some(name: str, count: int) -> list[Configuration]:
    arm = puma(name)
    limits = list(zip(arm.lower, arm.upper, strict=True))
    return [
        cast(Configuration, tuple(NUMBERS.uniform(lo, hi) for lo, hi in limits))
        for _ in range(count)
    ]


@pytest.mark.parametrize("branch", ALL_BRANCHES, ids=str)
@pytest.mark.parametrize("name", ["puma761", "puma560"])
def test_rows_are_those_of_the_scalar_form(name: str, branch: ArmBranch) -> None:
    arm = puma(name)
    rows, near = some(name, 60), some(name, 60)
    rotations, origins = flange_frames(arm, np.array(rows))
    found = solve_batch(arm, rotations, origins, branch, np.array(near))
    for q, start, row in zip(rows, near, found, strict=True):
        wanted = solve(arm, forward(arm, q), branch, start)
        assert wanted is not None
        assert row == pytest.approx(wanted, abs=1e-9)


def test_a_pose_out_of_reach_is_a_row_of_nan() -> None:
    arm = puma("puma761")
    rotations, origins = flange_frames(arm, np.array([arm.ready, arm.ready]))
    origins[1] *= 2.0
    found = solve_batch(arm, rotations, origins, ALL_BRANCHES[0], np.array(arm.ready))
    assert np.isfinite(found[0]).all()
    assert np.isnan(found[1]).all()


def test_joint_4_stays_where_it_is_when_the_wrist_is_straight() -> None:
    arm = puma("puma761")
    q = (0.3, -0.7, 1.9, 0.4, 0.0, 0.5)
    rotations, origins = flange_frames(arm, np.array([q]))
    found = solve_batch(arm, rotations, origins, ALL_BRANCHES[0], np.array([q]))
    assert found[0] == pytest.approx(q, abs=1e-7)
