"""Which of the turns of all joints is taken: the short way agrees with the one joint by joint."""

import math
import random
from typing import cast

import pytest

from vrts.robots.catalog import puma
from vrts.robots.kinematics.limits import TAU, all_turned, turned
from vrts.robots.model import Configuration

ARM = puma("puma761")


@pytest.mark.parametrize("far", [0.5, 2.9, 3.5, 9.0])
def test_all_joints_are_turned_as_each_is(far: float) -> None:
    draw = random.Random(7)
    for _ in range(200):
        near = [draw.uniform(a, b) for a, b in zip(ARM.lower, ARM.upper, strict=True)]
        angles = [q + draw.uniform(-far, far) for q in near]
        each = [turned(*values) for values in zip(angles, near, ARM.lower, ARM.upper, strict=True)]
        found = all_turned(
            cast(Configuration, tuple(angles)),
            cast(Configuration, tuple(near)),
            ARM.lower,
            ARM.upper,
        )
        assert list(found) == each
        whole = [(a - b) / TAU for a, b in zip(found, angles, strict=True)]
        assert whole == pytest.approx([round(turns) for turns in whole], abs=1e-9)


def test_no_joint_stands_at_minus_zero() -> None:
    nowhere: Configuration = (-0.0, -0.0, -0.0, -0.0, -0.0, -0.0)
    found = all_turned(nowhere, nowhere, ARM.lower, ARM.upper)
    assert all(math.copysign(1.0, q) == 1.0 for q in found)
