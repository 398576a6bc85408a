"""Files of runs say which model they went by; an unknown or altered one is told."""

from typing import Any

import pytest

from tests.support_controller import FOLDER
from tests.support_saved import BUSY, with_manifest
from vrts.controllers.models import FIRST, VPLUS
from vrts.controllers.values import digest
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.run_files.loading import check_again, load_run
from vrts.run_files.saving import saved_bytes
from vrts.run_files.simulated import simulate

BEFORE = (FOLDER / "readings.vrun").read_bytes()


def file_under(name: str) -> bytes:
    setting = with_controller(robot_alone(), name)
    text = BUSY.replace(b" MOVE a\n", b" DISABLE CP\n MOVE a\n DELAY 0.1\n")
    return saved_bytes(simulate(Request(ProgramFile(text, "x.v2"), setting, Reading("val2+"))))


@pytest.mark.parametrize("name", ["val2", "vplus", "vrts-1"])
def test_a_file_comes_again_under_its_model(name: str) -> None:
    loaded = load_run(file_under(name), "x.vrun")
    assert loaded.run is not None
    assert loaded.run.scene.controller.name == name
    assert check_again(loaded) is None


def test_a_file_that_names_none_went_by_the_first() -> None:
    loaded = load_run(BEFORE, "x.vrun")
    assert loaded.run is not None
    assert loaded.run.scene.controller is FIRST
    assert check_again(loaded) is None


def test_models_make_different_runs() -> None:
    ends = {name: load_run(file_under(name), "x").run for name in ("val2", "vplus", "vrts-1")}
    assert len({run.horizon_s for run in ends.values() if run is not None}) == 3


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"name": "val3"}, "there is no controller model `val3`"),
        ({"sha256": "0" * 64}, "the controller model `vplus` says something else"),
        ({"name": "vrts-1"}, "the controller model `vrts-1` says something else"),
        ({"name": "a\nb"}, "a controller has no proper name"),
        ({"name": None}, "a text is missing"),
    ],
)
def test_an_unknown_or_altered_model_is_told(change: dict[str, object], said: str) -> None:
    def changed(manifest: dict[str, Any]) -> None:
        manifest["origin"]["controller"].update(change)

    with pytest.raises(Refused) as caught:
        load_run(with_manifest(file_under("vplus"), changed), "x.vrun")
    (found,) = caught.value.diagnostics
    assert said in found.headline


def test_a_file_has_the_name_and_the_hash() -> None:
    seen: list[object] = []

    def look(manifest: dict[str, Any]) -> None:
        seen.append(manifest["origin"]["controller"])

    with_manifest(file_under("vplus"), look)
    assert seen == [{"name": "vplus", "sha256": digest(VPLUS)}]
