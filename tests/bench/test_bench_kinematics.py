"""What inverse kinematics costs, and how exact it is, beside numeric solvers.

Medians of several rounds. Every row solves poses of configurations within the limits; numeric rows
start five degrees away, which suits them.
"""

import math
import random
import statistics
from collections.abc import Callable
from importlib import import_module
from importlib.util import find_spec
from time import perf_counter
from typing import Any, cast

import numpy as np
import pytest

from vrts.base.pose import distance
from vrts.robots.catalog import arm as arm_named
from vrts.robots.catalog import puma
from vrts.robots.kinematics.batch import flange_frames
from vrts.robots.kinematics.batch_inverse import solve_batch
from vrts.robots.kinematics.branch import INITIAL_BRANCH, branch_of
from vrts.robots.kinematics.kinematics import forward, solve
from vrts.robots.kinematics.tracking import track
from vrts.robots.model import Arm, Configuration
from vrts.robots.pinocchio_model import pinocchio_arm, step_to

POSES = 20_000
NUMERIC = 200
ROUNDS = 5
AWAY = math.radians(5)


def some(arm: Arm, count: int) -> list[Configuration]:
    numbers = random.Random(1)
    limits = list(zip(arm.lower, arm.upper, strict=True))
    return [
        cast(Configuration, tuple(numbers.uniform(lo, hi) for lo, hi in limits))
        for _ in range(count)
    ]


def away(q: Configuration) -> Configuration:
    return cast(Configuration, tuple(angle + AWAY for angle in q))


def timed(count: int, work: Callable[[], object]) -> float:
    """Return the median time of one of `count` solutions [us]."""
    seconds: list[float] = []
    for _ in range(ROUNDS):
        begin = perf_counter()
        work()
        seconds.append(perf_counter() - begin)
    return 1e6 * statistics.median(seconds) / count


def show(what: str, us: float, note: str = "") -> None:
    print(f"  {what:<46} {us:9.2f} us  {note}".rstrip())


def test_inverse_kinematics() -> None:
    arm = puma("puma761")
    rows = some(arm, POSES)
    cases = [(forward(arm, q), branch_of(arm, q), q) for q in rows]
    print("\none solution:")
    us = timed(POSES, lambda: [solve(arm, X, branch, q) for X, branch, q in cases])
    worst = 0.0
    for X_BF, branch, q in cases:
        found = solve(arm, X_BF, branch, q)
        assert found is not None
        again = forward(arm, found)
        worst = max(worst, distance(again.translation, X_BF.translation))
        worst = max(
            worst, *(abs(a - b) for a, b in zip(again.rotation, X_BF.rotation, strict=True))
        )
    show("closed form, one pose at a time", us, f"worst round trip {worst:.1e}")
    assert worst < 1e-8
    us = timed(POSES, lambda: [track(arm, X, branch, q) for X, branch, q in cases])
    show("closed form, along a straight line", us)
    rotations, origins = flange_frames(arm, np.array(rows))
    near = np.array(rows)
    us = timed(POSES, lambda: solve_batch(arm, rotations, origins, INITIAL_BRANCH, near))
    show("closed form, all poses at once", us)


def test_numeric_inverse_kinematics() -> None:
    arm = arm_named("ur5")
    cases = [(forward(arm, q), away(q)) for q in some(arm, NUMERIC)]
    us = timed(NUMERIC, lambda: [track(arm, X, INITIAL_BRANCH, q) for X, q in cases])
    kept = sum(track(arm, X, INITIAL_BRANCH, q) is not None for X, q in cases)
    print()
    show("ur5: ours, from five degrees away", us, f"{kept} of {NUMERIC} found")
    few = cases[:20]
    us = timed(len(few), lambda: [solve(arm, X, INITIAL_BRANCH, q) for X, q in few])
    show("ur5: ours, the nearest from 17 starts", us)
    other = puma("puma761")
    rows = some(other, NUMERIC)
    model = pinocchio_arm(other)
    poses = [forward(other, q) for q in rows]

    def pinocchio() -> list[bool]:
        return [step_to(model, X, away(q)) for X, q in zip(poses, rows, strict=True)]

    us = timed(NUMERIC, pinocchio)
    show("puma761: Pinocchio, from five degrees away", us, f"{sum(pinocchio())} of {NUMERIC} found")


@pytest.mark.filterwarnings("ignore")
def test_robotics_toolbox() -> None:
    """An extra: only where roboticstoolbox-python is installed."""
    if find_spec("roboticstoolbox") is None:
        print("  roboticstoolbox-python: not installed")
        return
    toolbox: Any = import_module("roboticstoolbox")
    robot: Any = toolbox.models.DH.Puma560()
    rows = np.array(some(puma("puma560"), NUMERIC))
    poses = [robot.fkine(q) for q in rows]
    us = timed(NUMERIC, lambda: [robot.ikine_a(T) for T in poses])
    show("puma560: roboticstoolbox, its closed form", us)
    pairs = list(zip(poses, rows, strict=True))[:10]
    us = timed(len(pairs), lambda: [robot.ikine_LM(T, q0=q + AWAY) for T, q in pairs])
    show("puma560: roboticstoolbox, Levenberg-Marquardt", us)
