"""What inverse kinematics costs, and how exact it is."""

import math
import random
from time import perf_counter
from typing import cast

from vrts.base.pose import distance
from vrts.robots.branch import branch_of
from vrts.robots.catalog import arm as arm_named
from vrts.robots.kinematics import forward, solve
from vrts.robots.model import Configuration

POSES = 100_000


def test_inverse_kinematics() -> None:
    arm = arm_named("puma761")
    numbers = random.Random(1)
    limits = list(zip(arm.lower, arm.upper, strict=True))
    rows = [
        cast(Configuration, tuple(numbers.uniform(lo, hi) for lo, hi in limits))
        for _ in range(POSES)
    ]
    cases = [(forward(arm, q), branch_of(arm, q), q) for q in rows]
    begin = perf_counter()
    found = [solve(arm, X_BF, branch, q) for X_BF, branch, q in cases]
    seconds = perf_counter() - begin
    worst = 0.0
    for (X_BF, _, _), q in zip(cases, found, strict=True):
        assert q is not None
        again = forward(arm, q)
        worst = max(worst, distance(again.translation, X_BF.translation))
        worst = max(
            worst,
            *map(
                abs, map(math.fsum, zip(again.rotation, (-r for r in X_BF.rotation), strict=True))
            ),
        )
    print(f"\none solution: {1e6 * seconds / POSES:.1f} us; worst round trip {worst:.1e}")
    assert worst < 1e-8
