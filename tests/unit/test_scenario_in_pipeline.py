"""A scenario file reaches the engine: by the option, and from beside a task, within its limits."""

import os
import subprocess
from dataclasses import replace
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import NO_CHECKS, Request
from vrts.pipeline.scenes import load_scene, with_scenario
from vrts.pipeline.setting import scenario_of
from vrts.pipeline.settings import load_task, setting_for
from vrts.pipeline.where import Where
from vrts.scene.model import Scenario

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SLIPS = EXAMPLE / "gripper-slips.toml"
WAITS = b".PROGRAM main\nWAIT SIG(1001)\nTYPE TIMER(1)\n.END\n"


def copy_of_the_task(folder: Path) -> Path:
    task = folder / "task.toml"
    task.write_text((EXAMPLE / "task.toml").read_text(encoding="utf-8"))
    return task


def file(folder: Path, text: str, name: str = "other.toml") -> Path:
    path = folder / name
    path.write_text(text)
    return path


def vrts(*words: str | Path, cwd: Path = ROOT) -> "subprocess.CompletedProcess[str]":
    plain = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "FORCE_COLOR")}
    return vrts_text(*words, cwd=cwd, env={**plain, "PYTHONPATH": str(ROOT)})


def test_the_engine_runs_under_the_scenario(tmp_path: Path) -> None:
    path = file(tmp_path, "seed = 3\n[[inputs]]\nsignal = 1001\non_s = [2.0]\n")
    setting = with_scenario(robot_alone(), path)
    found = assess(Request(ProgramFile(WAITS, "program"), setting, checks=NO_CHECKS))
    assert found.run is not None
    assert setting.scenario is not None
    assert found.run.scenario == setting.scenario.scenario
    assert found.run.ended_s == pytest.approx(2.0, abs=0.06)


def test_without_a_scenario_nothing_changes() -> None:
    assert scenario_of(robot_alone()) == Scenario()
    task = load_task(EXAMPLE)
    assert task.scenario is None
    assert task.task is not None
    limits = replace(Scenario().limits, time_s=task.task.t_max)
    assert scenario_of(task) == replace(Scenario(), limits=limits, locks=task.task.locks)


@pytest.mark.parametrize(("limit", "stopped"), [(10.0, 10.0), (300.0, None)])
def test_the_shorter_of_scenario_and_task_stops_a_run(
    limit: float, stopped: float | None, tmp_path: Path
) -> None:
    path = file(tmp_path, f"[limits]\ntime_s = {limit}\nmotions = 5\n")
    setting = setting_for(EXAMPLE / "solution.v2", Where(scenario=path))
    assert setting is not None
    assert setting.task is not None
    limits = scenario_of(setting).limits
    assert limits.time_s == (stopped or setting.task.t_max)
    assert limits.motions == 5


def test_a_scenario_beside_the_task_is_taken_and_counts_in_its_digest(tmp_path: Path) -> None:
    task = copy_of_the_task(tmp_path)
    plain = load_task(task).task
    assert plain is not None
    file(tmp_path, "seed = 3\n", "scenario.toml")
    digests = {plain.digest}
    for path in (task, tmp_path):
        setting = load_task(path)
        assert setting.scenario is not None
        assert setting.scenario.scenario.seed == 3
        assert setting.task is not None
        digests.add(setting.task.digest)
    assert len(digests) == 2
    file(tmp_path, "seed = 4\n", "scenario.toml")
    changed = load_task(task).task
    assert changed is not None
    assert changed.digest not in digests


def test_the_scenario_asked_for_replaces_the_one_beside_the_task(tmp_path: Path) -> None:
    task = copy_of_the_task(tmp_path)
    file(tmp_path, "no toml", "scenario.toml")
    with pytest.raises(Refused):
        load_task(task)
    setting = load_task(task, scenario=file(tmp_path, "seed = 5\n"))
    assert setting.scenario is not None
    assert setting.scenario.scenario.seed == 5


def test_a_scene_alone_takes_no_scenario_unless_asked(tmp_path: Path) -> None:
    file(tmp_path, "seed = 3\n", "scenario.toml")
    program = tmp_path / "a.v2"
    plain = setting_for(program, Where("cans-on-bases"))
    assert plain is not None
    assert plain.scenario is None
    asked = setting_for(program, Where("cans-on-bases", scenario=SLIPS))
    assert asked is not None
    assert asked.scenario is not None
    assert asked.scenario.title == "The first can slips out of the hand"


def test_a_missing_scenario_is_a_wrong_call_and_a_wrong_one_is_refused(tmp_path: Path) -> None:
    setting = load_scene("cans-on-bases")
    with pytest.raises(CannotRead):
        with_scenario(setting, tmp_path / "none.toml")
    with pytest.raises(Refused) as refused:
        with_scenario(setting, file(tmp_path, "sead = 3\n"))
    assert [d.rule.code for d in refused.value.diagnostics] == ["V602"]


def test_parameters_are_those_of_the_controller_but_the_one_with_six_numbers(
    tmp_path: Path,
) -> None:
    setting = with_scenario(robot_alone(), file(tmp_path, "[parameters]\nhand.time = 0.5\n"))
    assert setting.scenario is not None
    assert dict(setting.scenario.scenario.parameters) == {"hand.time": 0.5}
    with pytest.raises(Refused):
        with_scenario(robot_alone(), file(tmp_path, "[parameters]\nnest.pos = 0\n"))


def test_run_and_verify_take_the_option(tmp_path: Path) -> None:
    program = tmp_path / "waits.v2"
    program.write_bytes(WAITS)
    late = file(tmp_path, "[[inputs]]\nsignal = 1001\non_s = [2.0]\noff_s = [601]\n")
    result = vrts("run", program, "--scenario", late)
    assert result.returncode == 0
    assert "V478" in result.stderr
    assert "1 warning" in result.stderr
    assert float(result.stdout) == pytest.approx(2.0, abs=0.06)
    verified = vrts("verify", program, "--scene", "cans-on-bases", "--scenario", late)
    assert "V478" in verified.stderr
    assert verified.returncode == 0


def test_the_option_refuses_a_wrong_file_with_status_1_and_none_with_2(tmp_path: Path) -> None:
    program = tmp_path / "waits.v2"
    program.write_bytes(WAITS)
    wrong = vrts("run", program, "--scenario", file(tmp_path, "seed = nan\n"))
    assert wrong.returncode == 1
    assert "other.toml:1:8" in wrong.stderr
    missing = vrts("run", program, "--scenario", tmp_path / "none.toml")
    assert missing.returncode == 2
