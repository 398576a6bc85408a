"""Which model a run goes by: the command says it, the task, the lab, the scene, or nobody."""

from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.controllers.models import FIRST, USUAL, VAL2, VPLUS
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.refused import Refused
from vrts.pipeline.scenes import free_setting, load_scene
from vrts.pipeline.settings import load_task, setting_for
from vrts.pipeline.where import Where
from vrts.scene.default import robot_alone
from vrts.scene.model import Scene, controlled
from vrts.scene.reading.scene_file import read_scene, read_scene_in_lab

PLAIN = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text("utf-8") + "\n"
LOG = "ab" * 32
TASK = ROOT / "examples" / "01-cans-on-bases"


def codes(text: str, lab: str = "") -> list[str]:
    source = SourceFile("scene.toml", PLAIN + text)
    if not lab:
        return [d.rule.code for d in read_scene(source)[1] if d.is_error]
    found = read_scene_in_lab(source, SourceFile("lab.toml", lab), None, None)
    return [d.rule.code for d in found[1] if d.is_error]


def scene(text: str = "", lab: str = "[lab]\n") -> Scene:
    source = SourceFile("scene.toml", PLAIN + text)
    found, told, _ = read_scene_in_lab(source, SourceFile("lab.toml", lab), None, None)
    assert found is not None, told
    return found


def test_a_scene_that_names_none_goes_by_the_usual_one() -> None:
    assert scene().controller is USUAL
    assert robot_alone().controller is USUAL


def test_a_scene_names_one() -> None:
    found = scene('[controller]\nmodel = "vplus"\n')
    assert found.controller is VPLUS
    assert found.robot.arm.tick == 0.016


def test_the_lab_says_more_than_the_scene() -> None:
    lab = '[lab.controller]\nmodel = "vrts-1"\n'
    assert scene('[controller]\nmodel = "vplus"\n', lab).controller is FIRST


def test_an_unknown_name_is_told_with_the_nearest() -> None:
    assert codes('[controller]\nmodel = "val3"\n') == ["V606"]
    with pytest.raises(Refused) as caught:
        with_controller(load_scene("cans-on-bases"), "val3")
    assert [d.rule.code for d in caught.value.diagnostics] == ["V426"]


def test_a_fitted_lab_makes_a_model() -> None:
    lab = f'[lab.controller]\nmodel = "val2"\nfitted_from = ["{LOG}"]\nacceleration_s = 0.28\n'
    found = scene("", lab + "blend_s = 0.616\n")
    assert found.controller.name == "val2 fitted"
    assert found.controller.fitted_from == (LOG,)
    assert found.controller.pace.acceleration_s == 0.28
    assert (found.robot.arm.acceleration_time, found.robot.arm.blend_time) == (0.28, 0.616)
    again = controlled(found, VAL2)  # readings of another model; what was measured stays
    assert again.robot.arm.acceleration_time == 0.28


@pytest.mark.parametrize(
    ("said", "code"),
    [
        ("acceleration_s = 0.28", "V425"),
        (f'fitted_from = ["{LOG}"]', "V425"),
        ('fitted_from = ["day1"]\nacceleration_s = 0.28', "V425"),
        (f'fitted_from = ["{LOG}"]\nacceleration_s = 0.28\nblend_s = 0.2', "V898"),
        ("settling = 3", "V602"),
    ],
)
def test_numbers_without_a_log_are_refused(said: str, code: str) -> None:
    assert codes("", f'[lab.controller]\nmodel = "val2"\n{said}\n') == [code]
    if code == "V425":
        assert codes(f'[controller]\nmodel = "val2"\n{said}\n') == [code]


def test_a_task_names_one(tmp_path: Path) -> None:
    text = (TASK / "task.toml").read_text("utf-8")
    (tmp_path / "task.toml").write_text(text.replace("[task]", '[task]\ncontroller = "vplus"', 1))
    found = load_task(tmp_path)
    assert found.scene.controller is VPLUS
    assert found.stamps == ()
    other = with_controller(found, "val2")
    assert other.scene.controller is VAL2
    assert [d.rule.code for d in other.stamps] == ["V679"]
    assert with_controller(found, "vplus").stamps == ()


def test_a_task_that_names_none_knows_of_another() -> None:
    where = Where(task=TASK / "task.toml", controller="vrts-1")
    found = setting_for(None, where)
    assert found is not None
    assert found.scene.controller is FIRST
    assert [d.rule.code for d in found.stamps] == ["V679"]


def test_a_command_names_one_for_a_scene_or_a_robot_alone() -> None:
    for scene_name in ("cans-on-bases", None):
        found = free_setting(Where(scene=scene_name, controller="vplus"))
        assert found.scene.controller is VPLUS
        assert found.stamps == ()
