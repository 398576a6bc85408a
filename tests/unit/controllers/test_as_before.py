"""The model `vrts-1` is what vrts did before controllers had models: saved runs come again."""

from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_controller import FOLDER, cases, kept, run_of, same, written
from vrts.controllers.models import VRTS_1
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.request import Request
from vrts.pipeline.settings import load_task
from vrts.run_files.loading import check_again, load_run
from vrts.run_files.simulated import simulate
from vrts.scene.default import robot_alone
from vrts.scene.model import controlled

EXAMPLES = sorted(path for path in kept() if path.startswith("examples/"))


def test_random_programs_run_as_they_did() -> None:
    before = kept()
    for case in cases():
        run = run_of(case, controlled(robot_alone(case.robot), VRTS_1))
        assert same(written(run), before[case.name]), case.text


@pytest.mark.thorough
@pytest.mark.parametrize("folder", sorted({Path(name).parts[1] for name in EXAMPLES}))
def test_examples_run_as_they_did(folder: str) -> None:
    setting = with_controller(load_task(ROOT / "examples" / folder), VRTS_1.name)
    for name in EXAMPLES:
        if Path(name).parts[1] == folder:
            program = ProgramFile((ROOT / name).read_bytes(), Path(name).name)
            run = simulate(Request(program, setting, Reading("val2+"))).run
            assert run is not None
            assert same(written(run), kept()[name]), name


@pytest.mark.parametrize("name", ["busy.vrun", "readings.vrun", "cans.vrun"])
def test_files_of_runs_come_again(name: str) -> None:
    loaded = load_run((FOLDER / name).read_bytes(), name)
    assert loaded.run is not None
    assert loaded.run.scene.controller == VRTS_1
    assert check_again(loaded) is None


def test_what_differs_is_noticed() -> None:
    name = "random 0"
    found = kept()[name]
    for change in ("horizon", "statements"):
        other = kept()[name]
        setattr(other, change, getattr(other, change) + 2)
        assert not same(found, other)
    other = kept()[name]
    other.joints[3][2] += 1
    assert same(found, other)
    other.joints[3][2] += 1
    assert not same(found, other)
    other = kept()[name]
    other.events = other.events[:-1]
    assert not same(found, other)
