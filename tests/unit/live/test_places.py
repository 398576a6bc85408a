"""The set of scenes of a server, and the lab that is laid over it."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from vrts.live.places import places_of, with_variants
from vrts.live.session.channel.messages import Start
from vrts.live.session.setting import UNTOLD, setting_of
from vrts.live.session.views.places import places_of as hand_places
from vrts.monitor.opening import opened
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.where import Where
from vrts.robots.arms.puma import PUMA_761, PUMA_762

LAB = """
[lab]
title = "Cellar"

[lab.robot]
name = "puma762"
"""


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    path = tmp_path / "cellar.toml"
    path.write_text(LAB)
    return path


def test_a_session_stands_in_the_lab_it_is_told(lab: Path, tmp_path: Path) -> None:
    (place,) = places_of(("cans-on-bases",), lab)
    found = setting_of(Start(1, str(tmp_path), place.scene, place.task, place.lab))
    (plain,) = places_of(("cans-on-bases",))
    without = setting_of(Start(1, str(tmp_path), plain.scene, plain.task, plain.lab))
    assert found.scene.title == f"{without.scene.title}, in Cellar"
    assert (without.scene.robot.arm, found.scene.robot.arm) == (PUMA_761, PUMA_762)


def test_rooms_get_a_task_with_variants_as_it_is_written(tmp_path: Path) -> None:
    lab = ROOT / "examples" / "08-own-numbers" / "lab1"
    (place, _) = places = places_of((str(lab / "task.toml"), "cans-on-bases"))
    assert with_variants(places) == ("lab1",)
    found = setting_of(Start(1, str(tmp_path), place.scene, place.task, place.lab))
    assert found.task is not None
    assert found.task.variants is None
    assert [one.name for one in hand_places(found.scene)] == ["safe"]
    assert found.sources.task is not None
    assert "variants" not in found.sources.task.text


@pytest.mark.parametrize(
    ("before", "after"), [("step = 30", "step = 29"), ("[[variants.without]]", "[[variants.with")]
)
def test_rooms_are_told_nothing_of_variants_that_are_wrong(
    tmp_path: Path, before: str, after: str
) -> None:
    lab = Path(shutil.copytree(ROOT / "examples" / "08-own-numbers" / "lab1", tmp_path / "lab1"))
    task = lab / "task.toml"
    task.write_text(task.read_text().replace(before, after))
    (place,) = places_of((str(task),))
    assert with_variants((place,)) == ("lab1",)
    with pytest.raises(Refused) as refused:
        setting_of(Start(1, str(tmp_path), place.scene, place.task, place.lab))
    assert [d.headline for d in refused.value.diagnostics] == [UNTOLD]


def test_the_monitor_speaks_to_the_arm_of_the_lab(lab: Path) -> None:
    dialogue, _ = opened((), Where("cans-on-bases", lab=lab), "val2", asks=False)
    assert dialogue.controller.run.scene.robot.arm == PUMA_762


def test_a_lab_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(CannotRead, match="no lab"):
        places_of(("cans-on-bases",), tmp_path / "none.toml")
