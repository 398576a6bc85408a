"""Two causes that look like a third one, ticks that hide a number, and errors that last."""

import numpy as np
import pytest

from tests.unit.validate.support import run_of, turning_run
from vrts.base.units import DEG
from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.identify import identify_again
from vrts.validate.identify.noise import lasting, left_over
from vrts.validate.identify.ticks import in_even_ticks
from vrts.validate.log.log import RobotLog
from vrts.validate.reports.identified_text import sentence
from vrts.validate.sampling import sampled

ACCELERATION, SPEEDS = Cause(Kind.ACCELERATION), Cause(Kind.SPEEDS)
THREE = b"""\
.PROGRAM three
  SPEED 60 ALWAYS
  MOVE #a
  BREAK
  MOVE #b
  BREAK
  MOVE #c
.END
.LOCATIONS
#a 0 -60 60 0 30 0
#b 50 -80 40 60 60 90
#c -40 -40 70 -50 -60 -120
.END
"""


@pytest.mark.thorough
def test_faster_joints_that_begin_more_slowly_are_no_slow_clock() -> None:
    again = Again(run_of(THREE))
    true = {SPEEDS: 0.0786, ACCELERATION: 0.056}
    run = again.with_values(true)
    times = np.arange(-0.5, run.horizon_s + 0.5, 0.028)
    joints = sampled(run, times).joints
    joints = joints + np.random.default_rng(3).normal(0.0, 0.01 * DEG, joints.shape)
    found = identify_again(again, RobotLog("log", "0" * 64, times, joints, None, True, ()))
    assert {n.cause for n in found.numbers} == set(true), sentence(found)
    assert found.fits
    for number in found.numbers:
        assert number.low <= true[number.cause] <= number.high


def test_acceleration_is_told_as_the_controller_carries_it_out() -> None:
    """It takes 224 ms, and is rounded up to even ticks of 28 ms."""
    again = Again(turning_run())
    arm = again.run.scene.robot.arm
    assert (arm.acceleration_time, arm.tick) == (0.224, 0.028)
    for set_to, carried_out in ((-0.0875, -0.056), (-0.056, -0.056), (0.01, 0.056), (0.0, 0.0)):
        told = in_even_ticks(again, ACCELERATION, set_to)
        assert told == pytest.approx(carried_out, abs=1e-9)
        (a, b) = (again.with_values({ACCELERATION: value}) for value in (set_to, told))
        assert [m.end_s for m in a.motions] == [m.end_s for m in b.motions]
    assert in_even_ticks(again, Cause(Kind.CORNERS), 0.02) == pytest.approx(0.0, abs=1e-9)
    assert in_even_ticks(again, Cause(Kind.CORNERS), 0.04) == pytest.approx(0.056, abs=1e-9)


def test_a_run_that_takes_as_many_ticks_is_the_same_run() -> None:
    again = Again(turning_run())
    assert again.with_values({SPEEDS: 1e-6}) is again.with_values({SPEEDS: 2e-6})
    assert again.with_values({SPEEDS: 0.1}) is not again.with_values({SPEEDS: 2e-6})


def test_errors_that_last_make_intervals_longer_and_those_of_chance_do_not() -> None:
    """What comes late by a third of the noise for half of the log, and then early."""
    chance, n = np.random.default_rng(4), 2000
    way = np.linspace(-1.0, 1.0, n)
    jacobian = np.zeros((n, 1, 2))
    jacobian[:, 0, 0], jacobian[:, 0, 1] = 1.0, way
    noise = chance.normal(0.0, 1.0, (n, 1))
    step = 0.33 * np.sign(way)[:, None] - 0.5 * way[:, None]  # a line is fitted to it before
    for residual, longer in ((noise, False), (noise + step, True)):
        factors = lasting(jacobian, residual, left_over(residual, np.zeros(1)))
        assert bool((factors > 1.2).any()) is longer, factors
        assert (factors >= 1.0).all()
