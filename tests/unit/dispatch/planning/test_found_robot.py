"""A robot as a lab says it was found: the program is verified on it, and within its intervals."""

from pathlib import Path

import numpy as np
import pytest

from tests.unit.dispatch.planning.test_plan import codes, main, planned
from vrts.base.pose import Z_AXIS, rotation_about
from vrts.dispatch.bundle import bundle_bytes, read_bundle
from vrts.dispatch.planning.asked import wish_of
from vrts.dispatch.planning.beside.margins import FOUND, world_doubt
from vrts.dispatch.planning.beside.trials import BASE, OBJECTS
from vrts.dispatch.planning.plan import plan
from vrts.pipeline.scenes import load_scene
from vrts.pipeline.setting import Setting

PLACES = ".LOCATIONS\nsafe 900 30 100 90 90 0\nlow 750 450 -155 90 90 0\n.END\n"
OVER = main("MOVE safe", "MOVE low", "BREAK", "MOVE safe", data=PLACES)  # 30 mm over `can2`


def setting(folder: Path, text: str) -> Setting:
    lab = folder / "lab.toml"
    lab.write_text(f"[lab]\ntitle = 'ours'\n[lab.robot.built]\n{text}")
    return load_scene("cans-on-bases", lab=lab)


def within(text: str) -> str:
    return f"[lab.robot.built.within]\n{text}"


@pytest.mark.thorough
def test_a_program_that_is_safe_on_the_assumed_robot_is_refused_on_the_one_found(
    tmp_path: Path,
) -> None:
    assert planned(OVER).bundle is not None
    refused = planned(OVER, setting(tmp_path, "stands_off_deg = [0, 3, 0, 0, 0, 0]\n"))
    assert "V801" in codes(refused)
    assert any("`can2`" in d.headline for d in refused.refused)


def test_what_the_log_left_open_is_a_margin_of_its_own(tmp_path: Path) -> None:
    """Three degrees at the shoulder are 40 mm there: enough for a finger to touch the can."""
    near = within("zero_deg = [0, 3, 0, 0, 0, 0]\n")
    refused = planned(OVER, setting(tmp_path, near))
    (one,) = [d for d in refused.refused if FOUND in d.notes[0]]
    assert "the zero of joint 2 at the upper end" in one.headline


@pytest.mark.thorough
def test_bundle_and_sheet_keep_the_robot_and_it_is_planned_again(tmp_path: Path) -> None:
    lab = "stands_off_deg = [0, 0, 0.05, 0, 0, 0]\ntool_mm = [0, 0, 1]\n"
    lab += within("stands_off_deg = [0, 0, 0.01, 0, 0, 0]\nspeed_percent = [1, 1, 1, 1, 1, 1]\n")
    found = planned(OVER, setting(tmp_path, lab))
    assert found.bundle is not None, found.refused
    margins = {m.name: m for m in found.bundle.manifest.margins}
    assert margins[FOUND].sentence == "holds in all of 4 cases"
    assert "of them for the robot as found" in margins["all off at once"].sentence
    sheet = found.bundle.sheet
    for words in ("joint 3", "+0.050 ± 0.010 deg", "Z of the tool", "+1.000 ± 0.000 mm"):
        assert words in sheet
    data = bundle_bytes(found.bundle)
    again = plan(wish_of(read_bundle(data)))
    assert again.bundle is not None
    assert bundle_bytes(again.bundle) == data
    plain = planned(OVER)
    assert plain.bundle is not None
    needed = {m.name: m for m in plain.bundle.manifest.margins}["all off at once"].sentence
    assert ", 5 mm needed" in needed, "nothing is carried: 3 mm and 2 mm"
    assert plain.bundle.manifest.robot.sha256 != found.bundle.manifest.robot.sha256
    assert FOUND not in {m.name for m in plain.bundle.manifest.margins}
    assert "as it was found" not in plain.bundle.sheet


@pytest.mark.thorough
def test_without_doubt_nothing_more_is_tried(tmp_path: Path) -> None:
    found = planned(OVER, setting(tmp_path, "zero_deg = [0, 0, 0.01, 0, 0, 0]\n"))
    assert found.bundle is not None, found.refused
    assert FOUND not in {m.name for m in found.bundle.manifest.margins}


def test_what_is_carried_and_turned_may_be_off_by_both_margins_twice() -> None:
    """Of a can taken by an arm whose base is off, turned, and brought beside another can."""
    base, can, other = (
        np.array([BASE, 0, 0]),
        np.array([-OBJECTS, 0, 0]),
        np.array([-OBJECTS, 0, 0]),
    )
    worst = 0.0
    for turn in np.linspace(0.0, np.pi, 181):
        R = np.array(rotation_about(Z_AXIS, turn)).reshape(3, 3)
        carried = base + R @ (can - base)  # where the hand has it beside where it should be
        worst = max(worst, float(np.linalg.norm(carried - other)))
    assert worst == pytest.approx(2.0 * (OBJECTS + BASE))
    assert world_doubt(carried=True) >= worst - 1e-12
    assert worst > max(2.0 * OBJECTS, OBJECTS + BASE), "what was asked for before"
