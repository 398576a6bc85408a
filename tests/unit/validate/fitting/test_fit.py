"""Speeds, acceleration and corners are found again in the logs of robots that have others."""

import hashlib
from pathlib import Path

import numpy as np
import pytest

from tests.unit.validate.support import EXAMPLE, run_of, speeds_run
from vrts.base.units import DEG
from vrts.engine.motion.plan import parameter
from vrts.engine.motion.profile import Profile
from vrts.engine.run import Run
from vrts.pipeline.refused import Refused
from vrts.validate.fitted import FittedRobot
from vrts.validate.fitted_files import fitted_json, fitted_text, lab_file
from vrts.validate.fitting import fit_robot
from vrts.validate.fitting.model import progress
from vrts.validate.fitting.speeds import Leg, speeds
from vrts.validate.log.log import GivenLog
from vrts.validate.synthetic import Imperfect, synthetic_log

SPEEDS = (82.0, 76.0, 97.0, 170.0, 195.0, 160.0)
LAB = f"""\
[lab.robot]
speed_deg_s = {list(SPEEDS)}
linear_mm_s = 830
acceleration_s = 0.28
blend_s = 0.392
"""
LINES = b"""\
.PROGRAM lines
  SPEED 40 ALWAYS
  MOVE p1
  BREAK
  MOVES p2
  MOVES p3
  BREAK
  MOVES p1
.END
.LOCATIONS
p1 750 -300 -100 90 90 0
p2 750 300 -100 90 90 0
p3 1050 300 -100 90 90 0
.END
"""
WITHIN = 0.02  # of the true number


def log_of(run: Run, robot: Imperfect) -> bytes:
    return "".join(synthetic_log(run, robot, "program.v2")).encode()


@pytest.fixture(scope="module")
def fitted(tmp_path_factory: pytest.TempPathFactory) -> tuple[FittedRobot, bytes]:
    true = run_of(speeds_run_text(), LAB, tmp_path_factory.mktemp("lab"))
    data = log_of(true, Imperfect(clock_s=40.0, seed=3))
    return fit_robot(speeds_run(), [GivenLog("day1.csv", (data,))]), data


def speeds_run_text() -> bytes:
    return (EXAMPLE / "speeds.v2").read_bytes()


def test_the_true_numbers_are_found_within_two_percent(fitted: tuple[FittedRobot, bytes]) -> None:
    found, _ = fitted
    for speed, true in zip(found.speeds, SPEEDS, strict=True):
        assert speed is not None
        assert speed.value / DEG == pytest.approx(true, rel=WITHIN)
        assert speed.low <= true * DEG <= speed.high
    assert found.acceleration_time.value == pytest.approx(0.28, rel=WITHIN)
    assert found.blend_time is not None
    assert found.blend_time.value == pytest.approx(0.392, rel=WITHIN)
    assert found.lag_s == pytest.approx(0.02, abs=0.006)
    assert found.linear_speed is None
    assert found.findings == ()


def test_the_file_takes_the_place_of_what_was_assumed(
    fitted: tuple[FittedRobot, bytes], tmp_path: Path
) -> None:
    found, data = fitted
    text = lab_file(found)
    assert f"# fitted from `day1.csv`, sha256 {hashlib.sha256(data).hexdigest()}\n" in text
    assert "# SYNTHETIC" in text
    arm = run_of(speeds_run_text(), text, tmp_path).scene.robot.arm
    assert arm.acceleration_time == 0.28
    assert arm.blend_time == 0.392
    for speed, true in zip(arm.speed, SPEEDS, strict=True):
        assert speed / DEG == pytest.approx(true, rel=WITHIN)


def test_a_run_with_the_file_takes_as_long_as_the_real_robot(
    fitted: tuple[FittedRobot, bytes], tmp_path: Path
) -> None:
    true = run_of(speeds_run_text(), LAB, tmp_path)
    again = run_of(speeds_run_text(), lab_file(fitted[0]), tmp_path)
    assert again.horizon_s == pytest.approx(true.horizon_s, abs=0.029)
    assert speeds_run().horizon_s != pytest.approx(true.horizon_s, abs=1.0)


def test_lines_tell_the_speed_of_lines_and_what_is_not_told_is_kept(tmp_path: Path) -> None:
    data = log_of(run_of(LINES, LAB, tmp_path), Imperfect(seed=4))
    found = fit_robot(run_of(LINES), [GivenLog("a.csv", (data,)), GivenLog("b.csv", (data,))])
    assert found.linear_speed is not None
    assert found.linear_speed.value == pytest.approx(0.83, rel=WITHIN)
    assert found.linear_speed.motions == 6
    assert found.blend_time is not None
    assert found.blend_time.value == pytest.approx(0.392, rel=0.04)  # one corner
    assert [d.rule.code for d in found.findings] == ["V895"]
    text = lab_file(found)
    assert "linear_mm_s = 8" in text
    assert "180.000,  # JT6: assumed; no motion told it" in text
    assert "no motion tells" in fitted_text(found)
    said = fitted_json(found)["speed_deg_s"]
    assert isinstance(said, list)
    assert None in said


TARGET = "MOVE #b\n.END\n.LOCATIONS\n#b 90 -60 90 0 0 0\n.END\n"


@pytest.mark.parametrize(
    ("program", "code", "came"),
    [
        (f".PROGRAM a\n ACCEL 50\n {TARGET}", "V893", "it sets ACCEL or DECEL"),
        (f".PROGRAM a\n DURATION 4 ALWAYS\n {TARGET}", "V893", "it sets DURATION"),
        ('.PROGRAM a\n TYPE "still"\n.END\n', "V889", "a program that moves the arm"),
    ],
)
def test_programs_that_tell_nothing_are_refused(program: str, code: str, came: str) -> None:
    run = run_of(program.encode())
    with pytest.raises(Refused) as caught:
        fit_robot(run, [GivenLog("log.csv", (log_of(speeds_run(), Imperfect()),))])
    (found,) = caught.value.diagnostics
    assert found.rule.code == code
    assert came in found.notes[0]


def test_the_model_is_that_of_the_engine() -> None:
    """The fit's formulas, for real numbers, give what the engine's give for whole ticks."""
    for ends in ((True, True), (True, False), (False, True), (False, False)):
        profile = Profile(1.4, 0.112, 0.14, *ends)
        x = np.linspace(-0.11, 1.53, 83)
        expected = [parameter(profile, float(value))[0] for value in x]
        assert progress(x, 1.4, 0.112, 0.14, ends=ends) == pytest.approx(expected, abs=1e-12)


def test_speeds_are_known_to_a_tick_of_the_longest_motion() -> None:
    tick, true = 0.028, 1.5

    def ticks(way: float) -> float:
        return -(-way / true // tick) * tick

    legs = [Leg((way, 0.0), 1.0, ticks(way)) for way in (1.0, 2.0, 5.0)]
    one, other = speeds(legs, (1.0, 2.0), tick, 0.1)
    assert one is not None
    assert other is None
    assert one.low <= true <= one.high
    assert (one.high - one.low) / true < 1.05 * tick * true / 5.0
