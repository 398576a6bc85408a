"""What was found is a lab: with it the run is nearer to the log than without.

The encoders' noise of 0.01 degrees alone is about 0.39 mm at the tool.
"""

import numpy as np
import pytest

from tests.unit.validate.identify.test_identify import WITHOUT, log_of
from tests.unit.validate.support import turning_run
from vrts.base.source import SourceFile
from vrts.base.units import DEG, MM
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.pipeline.files import CHECKOUT
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene_in_lab
from vrts.validate.comparison import compare
from vrts.validate.errors import lengths, measures
from vrts.validate.identified_files import identified_lab
from vrts.validate.identify.identify import identify_log
from vrts.validate.offsets import Wanted
from vrts.validate.synthetic import Imperfect, logged

TIME = Wanted(time=True, base=False, tool=False)
PLAIN = "[lab]\n"
SCENE = (CHECKOUT / "scenes" / "cans-on-bases" / "scene.toml").read_text()


def laid(text: str) -> Scene:
    scene, told, _ = read_scene_in_lab(
        SourceFile("scene.toml", SCENE), SourceFile("lab.toml", text), None, None
    )
    assert scene is not None, told
    return scene


def corrected(lab: str = PLAIN) -> Run:
    """Return a program that turns the tool about all axes, run on the robot of a lab."""
    run = turning_run()
    return execute(run.module, laid(lab), run.scenario, "turns")


@pytest.mark.parametrize(
    ("robot", "before_mm", "after_mm"),
    [
        (WITHOUT._replace(zero_deg=(0.0, 0.0, 0.5, 0.0, 0.0, 0.0)), 3.0, 0.5),
        (WITHOUT._replace(tool_mm=(2.0, 0.0, 3.0), base_mm=(1.0, 0.0, 2.0)), 2.0, 0.5),
        (WITHOUT._replace(link_mm=(2.0, 0.0, 0.0, 0.0)), 1.0, 0.5),
    ],
    ids=["joint", "tool and base", "link"],
)
def test_the_run_with_the_lab_is_nearer_to_the_log(
    robot: Imperfect, before_mm: float, after_mm: float
) -> None:
    run = corrected()
    log = log_of(run, robot)
    before = measures(lengths(compare(run, log, TIME).after)).rms / MM
    other = corrected(identified_lab(identify_log(run, log)))
    after = measures(lengths(compare(other, log, TIME).after)).rms / MM
    print(f"path error {before:.2f} mm before, {after:.2f} mm with the lab")
    assert before > before_mm
    assert after < after_mm
    # and nothing is left to be found
    again = identify_log(other, log)
    assert [n.cause for n in again.numbers] == []


def test_an_interval_holds_what_was_put_in() -> None:
    run = corrected()
    log = log_of(run, WITHOUT._replace(zero_deg=(0.3, 0.0, 0.0, 0.0, 0.0, 0.0)))
    arm = laid(identified_lab(identify_log(run, log))).robot.arm
    assert arm.built is not None
    off, within = arm.built.off.shown[0], arm.built.within.off.shown[0]
    assert abs(off - 0.3 * DEG) <= 2.0 * within
    assert 0.0 < within < 0.01 * DEG


def test_a_simulated_log_of_a_robot_in_a_lab_shows_what_its_encoders_show() -> None:
    lab = "[lab]\n[lab.robot.built]\nstands_off_deg = [1, 0, 0, 0, 0, 0]\n"
    run = corrected()
    other = corrected(f"{lab}zero_deg = [0, 2, 0, 0, 0, 0]\n")
    quiet = WITHOUT._replace(noise_deg=0.0, encoder_deg=0.0)
    (_, plain, _), (_, joints, positions) = logged(run, quiet), logged(other, quiet)
    assert joints - plain == pytest.approx(np.tile([DEG, 0, 0, 0, 0, 0], (len(plain), 1)))
    wanted = np.array([other.at(max(t, 0.0)).X_WT.translation for t in (1.0, 2.0)])
    times = logged(other, quiet)[0]
    found = [positions[int(np.argmin(abs(times - t)))] for t in (1.0, 2.0)]
    assert np.array(found) == pytest.approx(wanted, abs=2e-2)
