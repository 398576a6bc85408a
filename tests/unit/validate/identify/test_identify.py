"""A robot that is wrong in one way is said to be wrong in that way, and in no other."""

from typing import NamedTuple

import numpy as np
import pytest

from tests.unit.validate.support import path_run, speeds_run, turning_run
from vrts.base.units import DEG, MM
from vrts.engine.run import Run
from vrts.validate.identified_files import identified_lab
from vrts.validate.identify.again import Again
from vrts.validate.identify.causes import Cause, Kind
from vrts.validate.identify.clocks import soonest
from vrts.validate.identify.forward import Clock, Rows, residuals
from vrts.validate.identify.identified import Identified
from vrts.validate.identify.identify import identify_log
from vrts.validate.identify.noise import left_over
from vrts.validate.identify.solve import clock_columns, columns
from vrts.validate.log.log import RobotLog
from vrts.validate.reports.identified_json import identified_json
from vrts.validate.reports.identified_text import identified_text, sentence
from vrts.validate.synthetic import Imperfect, logged

WITHOUT = Imperfect(lag_s=0.0, base_mm=(0.0, 0.0, 0.0), seed=5)
ELSE = "nothing else is needed to explain the log"


class Fault(NamedTuple):
    """What is put into a robot, and what has to be found."""

    run: Run
    robot: Imperfect
    cause: Cause
    true: float
    positions: bool = True


def log_of(run: Run, robot: Imperfect, *, positions: bool = True) -> RobotLog:
    times, joints, points = logged(run, robot)
    shown = times * (1.0 + robot.rate_percent / 100.0) + robot.clock_s
    seen = np.round(points, 6) if positions else None  # a log has micrometres
    return RobotLog("log.csv", "0" * 64, shown, joints, seen, synthetic=True, findings=())


def found_in(fault: Fault) -> Identified:
    return identify_log(fault.run, log_of(fault.run, fault.robot, positions=fault.positions))


def must_name(fault: Fault) -> Identified:
    found = found_in(fault)
    assert [n.cause for n in found.numbers] == [fault.cause], sentence(found)
    (number,) = found.numbers
    assert number.value == pytest.approx(fault.true, abs=max(2.0 * number.half, 1e-6))
    assert found.fits
    assert sentence(found).endswith(ELSE)
    return found


def test_a_joint_that_stands_off_is_named_first() -> None:
    robot = WITHOUT._replace(zero_deg=(0.0, 0.0, 0.5, 0.0, 0.0, 0.0), clock_s=7.0)
    found = must_name(Fault(turning_run(), robot, Cause(Kind.ZERO, 2), 0.5 * DEG))
    assert sentence(found).startswith("joint 3 stands 0.50")
    assert found.clock_s == pytest.approx(-7.0, abs=0.002)
    assert identified_text(found).startswith(sentence(found) + "\n")
    told = identified_json(found)
    assert told["sentence"] == sentence(found)
    assert "joint 3 stands 0.50" in identified_lab(found)


def test_nothing_is_said_of_a_robot_without_faults() -> None:
    found = identify_log(turning_run(), log_of(turning_run(), WITHOUT))
    assert found.numbers == ()
    assert found.fits
    assert sentence(found) == "the log agrees with the run; nothing is off beyond noise"


def test_tool_and_base_are_told_apart_where_the_tool_turns() -> None:
    robot = WITHOUT._replace(tool_mm=(0.0, 0.0, 1.5), base_mm=(0.0, 0.8, 0.0))
    found = identify_log(turning_run(), log_of(turning_run(), robot))
    assert {n.cause for n in found.numbers} == {Cause(Kind.TOOL, 2), Cause(Kind.BASE, 1)}
    for number in found.numbers:
        true = 1.5 * MM if number.cause.kind is Kind.TOOL else 0.8 * MM
        assert number.value == pytest.approx(true, abs=0.01 * MM)


def test_what_cannot_be_told_apart_is_said() -> None:
    robot = WITHOUT._replace(base_turn_deg=0.3)
    log = log_of(turning_run(), robot)
    found = identify_log(turning_run(), log)
    assert found.numbers[0].cause in (Cause(Kind.TURN, 2), Cause(Kind.HIDDEN_ZERO, 0))
    pair = {Cause(Kind.TURN, 2), Cause(Kind.HIDDEN_ZERO, 0)}
    assert pair in [set(one) for one in found.pairs]
    words = "turn of the base about Z and zero of joint 1 cannot be told apart in this log"
    assert words in identified_text(found)
    assert "as well explained" in identified_text(found)


def test_noise_has_no_pattern_and_a_wave_below_it_has_one() -> None:
    noise = np.random.default_rng(2).normal(0.0, 1.0, (500, 2))
    noise[:, 1] += np.sin(np.arange(500) / 7.0)
    left = left_over(noise, np.zeros(2))
    assert left.patterned[0] == 0.0
    assert left.patterned[1] == pytest.approx(0.7, abs=0.1)
    assert left.times_correlated[0] < 1.2
    assert left.times_correlated[1] > 3.0


@pytest.mark.thorough
def test_a_pattern_that_no_cause_explains_is_said_to_not_fit() -> None:
    log = log_of(turning_run(), WITHOUT)
    assert log.joints is not None
    joints = log.joints.copy()
    joints[:, 4] += 0.3 * DEG * np.sin(3.0 * log.times)  # a gear that is out of round
    points = None
    wavy = RobotLog("log.csv", "0" * 64, log.times, joints, points, True, ())
    found = identify_log(turning_run(), wavy)
    assert not found.fits
    assert "does not fit the log" in sentence(found) or "no single cause" in sentence(found)


def test_derivatives_are_those_of_the_model() -> None:
    """A small change of each number moves the log as its column says."""
    again, log = Again(turning_run()), log_of(turning_run(), WITHOUT)
    assert log.joints is not None
    assert log.positions is not None
    rows = Rows(log.times[::20], log.joints[::20], log.positions[::20], 3.0)
    clock = Clock(np.array([0.01]), np.zeros(len(rows.times), np.intp))
    by = 1e-5
    for cause in (Cause(Kind.ZERO, 1), Cause(Kind.TOOL, 0), Cause(Kind.TURN, 1), Cause(Kind.RATE)):
        (column,) = np.moveaxis(columns(again, rows, clock, {}, [cause]), 2, 0)
        changed = residuals(again, rows, clock, {}) - residuals(again, rows, clock, {cause: by})
        assert changed / by == pytest.approx(column, abs=5e-3)
    (column,) = np.moveaxis(clock_columns(again, rows, clock, {}), 2, 0)
    later = Clock(clock.shifts + by, clock.which)
    changed = residuals(again, rows, clock, {}) - residuals(again, rows, later, {})
    assert changed / by == pytest.approx(column, abs=5e-3)


def single_faults() -> list[Fault]:
    zeros = [(0.0,) * k + (0.3,) + (0.0,) * (5 - k) for k in range(6)]
    turning, path = turning_run(), path_run()
    return [
        *(
            Fault(turning, WITHOUT._replace(zero_deg=z), Cause(Kind.ZERO, k), 0.3 * DEG)
            for k, z in enumerate(zeros)
        ),
        Fault(turning, WITHOUT._replace(link_mm=(1.0, 0, 0, 0)), Cause(Kind.LINK, 0, "a2"), 1 * MM),
        Fault(turning, WITHOUT._replace(link_mm=(0, 0, 0, 2.0)), Cause(Kind.LINK, 0, "d4"), 2 * MM),
        Fault(turning, WITHOUT._replace(tool_mm=(0, 3.0, 0)), Cause(Kind.TOOL, 1), 3 * MM),
        Fault(turning, WITHOUT._replace(speeds_percent=92.0), Cause(Kind.SPEEDS), -0.08),
        Fault(turning, WITHOUT._replace(rate_percent=0.5), Cause(Kind.RATE), 1 / 1.005 - 1.0),
        Fault(turning, WITHOUT._replace(lag_s=0.025), Cause(Kind.LAG, 1), 0.025),
        Fault(
            path,
            WITHOUT._replace(counted_link_mm=(0, 0, 0, 1.0)),
            Cause(Kind.COUNTED_LINK, 0, "d4"),
            1 * MM,
            positions=False,
        ),
    ]


@pytest.mark.thorough
@pytest.mark.parametrize("number", range(13))
def test_single_faults_are_named(number: int) -> None:
    must_name(single_faults()[number])


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("robot", "causes"),
    [
        ({"speeds_percent": 92.0, "lag_s": 0.02}, {Kind.SPEEDS, Kind.LAG}),
        ({"zero_deg": (0, 0.4, 0, 0, 0, 0), "speeds_percent": 92.0}, {Kind.ZERO, Kind.SPEEDS}),
        ({"zero_deg": (0, 0.4, 0, 0, 0, 0), "tool_mm": (0, 0, 2)}, {Kind.ZERO, Kind.TOOL}),
        ({"link_mm": (0, 0, 0, 2), "base_mm": (0, 1, 0)}, {Kind.LINK, Kind.BASE}),
        ({"rate_percent": 0.5, "zero_deg": (0, 0, 0, 0, 0.3, 0)}, {Kind.RATE, Kind.ZERO}),
    ],
)
def test_pairs_of_faults_are_named(robot: dict[str, object], causes: set[Kind]) -> None:
    run = turning_run()
    found = identify_log(run, log_of(run, WITHOUT._replace(**robot)))
    assert {n.cause.kind for n in found.numbers} == causes, sentence(found)
    assert len(found.numbers) == 2
    assert found.fits


@pytest.mark.thorough
def test_a_slow_robot_is_no_slow_clock_where_it_rests() -> None:
    """With many rests between motions the rate of the clock is told from the speeds."""
    run = speeds_run()
    found = identify_log(run, log_of(run, WITHOUT._replace(speeds_percent=92.0), positions=False))
    assert [n.cause for n in found.numbers] == [Cause(Kind.SPEEDS)], sentence(found)
    assert (Cause(Kind.RATE),) not in found.numbers[0].alike


def test_a_motion_that_comes_again_is_found_where_it_comes_first() -> None:
    """Among places that are as good, the soonest: else what follows runs out of log."""
    off = [0.4, 0.2, 0.011, 0.3, 0.5, 0.010, 0.3, 0.009]
    assert soonest(off) == 2
    assert soonest([0.4, 0.02, 0.001, 0.02, 0.4]) == 2
    assert soonest([0.3, 0.2, 0.1]) == 2
