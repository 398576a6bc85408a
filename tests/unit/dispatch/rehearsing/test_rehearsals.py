"""Programs carried out by an installed LinuxCNC, which nobody here wrote, and compared.

`.ci/run` installs it; elsewhere these tests are skipped. Ways of the installation are told first.
"""

import os
import shutil
from pathlib import Path
from typing import NamedTuple

import pytest

from tests.support_commands import vrts_text
from tests.support_programs import ROOT
from vrts.cli.shared.console import HOLDS, UNDETERMINED, WRONG
from vrts.dispatch.linuxcnc.export import exported_folder
from vrts.dispatch.rehearsing.installed import Installed, installed
from vrts.dispatch.rehearsing.rehearse import Rehearsal, expected, rehearse, with_scenario
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import free_setting
from vrts.pipeline.scenes import with_scenario as in_scenario
from vrts.pipeline.setting import Setting, scenario_of
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where

SPEED = 10.0
# LinuxCNC without a real-time kernel loses its place about once in a hundred rehearsals on a busy
# machine (manual/understand/linuxcnc.md); a program that is said wrongly moves otherwise every time
TRIED_AGAIN = 2
PROGRAMS = ROOT / "tests" / "data" / "linuxcnc"
EXAMPLES = ROOT / "examples"
LINUXCNC = installed()
REQUIRED = "VRTS_LINUXCNC"  # set where LinuxCNC has been installed for these tests


class Case(NamedTuple):
    """A program, and a scenario whose inputs are played."""

    program: Path
    scenario: Path | None = None
    scene: str | None = None  # None: the task's beside it
    motions: int = 0  # at least so many are compared

    @property
    def name(self) -> str:
        scenario = "" if self.scenario is None else f" {self.scenario.stem}"
        return f"{self.program.parent.name} {self.program.stem}{scenario}"


def cases() -> list[Case]:
    """Return every program of the folder in each of its scenarios, and the five examples."""
    found: list[Case] = []
    for folder in sorted(PROGRAMS.iterdir()):
        scenarios = sorted(set(folder.glob("*.toml")) - {folder / "task.toml"})
        program = folder / "program.v2"
        found += [Case(program, scenario) for scenario in scenarios] or [Case(program)]
    found += [Case(path) for path in sorted(EXAMPLES.glob("0[1-4]*/solution.v2"))]
    path = EXAMPLES / "05-validation"
    found += [Case(path / f"{name}.v2", scene="one-can-puma761") for name in ("path", "speeds")]
    return found


CASES = cases()


def rehearsed(case: Case, folder: Path, what: Installed, speed: float = SPEED) -> Rehearsal:
    """Export a program and carry it out."""
    setting = (
        setting_for(case.program)
        if case.scene is None
        else free_setting(Where(case.scene), case.program.parent)
    )
    assert setting is not None
    if case.scenario is not None:
        setting = in_scenario(setting, case.scenario)
    data = case.program.read_bytes()
    found = exported_folder(Request(ProgramFile(data, case.program.name), setting), None)
    assert found.files is not None, found.diagnostics
    for name, text in found.files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(text)
    return rehearse(folder, expected(folder), what, speed)


def required() -> Installed:
    """Return LinuxCNC; skip the test where it is not installed and need not be."""
    if isinstance(LINUXCNC, str):
        if os.environ.get(REQUIRED):
            pytest.fail(f"LinuxCNC was to be installed for this: {LINUXCNC}")
        pytest.skip(f"needs LinuxCNC: {LINUXCNC}")
    return LINUXCNC


def test_there_are_programs_enough_and_both_ways_of_each_decision() -> None:
    names = {case.program.parent.name for case in CASES}
    assert len([name for name in names if (PROGRAMS / name).is_dir()]) >= 10
    assert sum(case.program.is_relative_to(EXAMPLES) for case in CASES) == 6
    ways = {case.name for case in CASES if case.scenario is not None}
    assert {"07-decision program on", "07-decision program off"} < ways
    assert {f"09-sorting program {way}" for way in ("none", "first", "second", "both")} < ways
    assert len(CASES) >= 22


@pytest.mark.thorough
@pytest.mark.parametrize("case", [pytest.param(case, id=case.name) for case in CASES])
def test_linuxcnc_moves_as_vrts_verified(case: Case, tmp_path: Path) -> None:
    found = rehearsed(case, tmp_path, required())
    for _ in range(TRIED_AGAIN):
        if found.diagnostics == ():
            break
        print(f"rehearsed again: {[d.headline for d in found.diagnostics]}")
        found = rehearsed(case, tmp_path, required())
    assert found.diagnostics == ()
    moving = {k for k, m in enumerate(found.run.motions, start=1) if m.end_s > m.start_s}
    compared = {k for s in found.stretches for k in range(s.first, s.last + 1)}
    assert moving <= compared
    assert len(compared) >= 4
    assert all(s.holds for s in found.stretches)


@pytest.mark.thorough
def test_an_edit_by_hand_is_found(tmp_path: Path) -> None:
    what = required()
    case = Case(PROGRAMS / "01-stops" / "program.v2")
    assert rehearsed(case, tmp_path / "right", what).holds
    moved, cut = tmp_path / "moved", tmp_path / "cut"
    for folder, (before, after) in (
        (moved, ("[460] [-30] [0]", "[460] [-30] [3]")),
        (cut, ("o<v_trans> call", "o<v_trans call")),
    ):
        shutil.copytree(tmp_path / "right", folder)
        program = folder / "program.ngc"
        assert before in program.read_text()
        program.write_text(program.read_text().replace(before, after))
    other = rehearse(moved, expected(moved), what, SPEED)
    assert {d.rule.code for d in other.diagnostics} == {"V876"}
    assert max(s.end_mm for s in other.stretches) == pytest.approx(3.0, abs=0.01)
    refused = rehearse(cut, expected(cut), what, SPEED)
    assert [d.rule.code for d in refused.diagnostics][:1] == ["V875"]


@pytest.mark.thorough
def test_another_way_than_that_of_the_run_is_found(tmp_path: Path) -> None:
    what = required()
    folder = PROGRAMS / "07-decision"
    on = rehearsed(Case(folder / "program.v2", folder / "on.toml"), tmp_path, what)
    assert on.holds
    off = with_scenario(
        on.run, scenario_of(in_scenario(Setting(on.run.scene, None, ()), folder / "off.toml"))
    )
    assert rehearse(tmp_path, off, what, SPEED).holds
    # the inputs of one beside the run of the other
    mixed = expected(tmp_path)
    table = tmp_path / "program.ngc"
    table.write_text(table.read_text().replace("o<v_input> call [0]", "o<v_input> call [9]"))
    found = rehearse(tmp_path, mixed, what, SPEED)
    assert {d.rule.code for d in found.diagnostics} == {"V876"}


def test_the_command_says_what_is_missing(tmp_path: Path) -> None:
    folder = tmp_path / "out"
    program = PROGRAMS / "07-decision" / "program.v2"
    said = vrts_text("dispatch", "export", program, "--to", "linuxcnc", "-o", folder)
    assert said.returncode == HOLDS, said.stderr
    nothing = vrts_text("dispatch", "rehearse", folder, env={"PATH": str(tmp_path)})
    assert nothing.returncode == UNDETERMINED
    assert "nothing was rehearsed: linuxcnc is not installed here" in nothing.stderr
    assert "apt-get install" in nothing.stderr
    (folder / "machine.ini").unlink()
    broken = vrts_text("dispatch", "rehearse", folder)
    assert broken.returncode == WRONG
    assert "has no `machine.ini`" in broken.stderr


@pytest.mark.thorough
def test_the_command_writes_page_and_log_that_validate_reads(tmp_path: Path) -> None:
    required()
    folder = tmp_path / "out"
    program = PROGRAMS / "07-decision" / "program.v2"
    assert (
        vrts_text("dispatch", "export", program, "--to", "linuxcnc", "-o", folder).returncode == 0
    )
    off = program.with_name("off.toml")
    said = vrts_text("dispatch", "rehearse", folder, "--scenario", off, "--speed", "20")
    assert said.returncode == HOLDS, said.stderr
    assert "from stop to stop: path 0.0" in said.stdout
    page = (folder / "rehearsal.html").read_text()
    assert "LinuxCNC moves as vrts verified" in page
    log = vrts_text(
        *("validate", program, "--scene", "one-can-puma560", "--scenario", off),
        *("--log", folder / "linuxcnc.csv"),
    )
    assert log.returncode == HOLDS, log.stderr
