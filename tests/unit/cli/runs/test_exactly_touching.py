"""A program that comes to rest where shapes touch exactly: python-fcl ends its process there.

The command goes on without it, and says what it says whoever proposes, and whether or not whoever
gives the second opinion lives to give it.
"""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.unit.cli.test_commands import vrts
from vrts.check.collision.collision import check_collisions
from vrts.marking.proposer.by_fcl import ByFcl
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene
from vrts.run_files.simulated import simulate

# found by trying: a thin rod whose side the hand touches to less than 0.1 µm where it stops
SCENE = """[objects.rod]
kind = "can"
fixed = true
at_mm = [339.1703677620917, 71.55728131090339, 1410.0387237390237]
radius_mm = 1
height_mm = 145
"""
PROGRAM = """.PROGRAM main()
        MOVE #PPOINT(-49.1, -59.8, 46.2, 41.2, 60.2, -62.5)
        DELAY 1
.END
"""

# the library as it is installed, but for one function: it ends the process as a throw through C++
ABORTING = """import importlib.machinery, importlib.util, os, sys
here = os.path.dirname(os.path.abspath(__file__))
elsewhere = [path for path in sys.path if os.path.abspath(path) != here]
spec = importlib.machinery.PathFinder.find_spec("fcl", elsewhere)
sys.modules["fcl"] = real = importlib.util.module_from_spec(spec)
spec.loader.exec_module(real)
def distance(*_):
    with open(os.path.join(here, "deaths"), "ab", buffering=0) as deaths:
        deaths.write(b"x")
    os.abort()
real.distance = distance
"""
MISSING = 'raise ImportError("no fcl")\n'
CANS = ROOT / "examples" / "01-cans-on-bases"


@pytest.fixture(scope="module", name="folder")
def folder_of_the_touch(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("touch")
    (folder / "scene.toml").write_text(SCENE)
    (folder / "touch.v2").write_text(PROGRAM)
    return folder


def test_python_fcl_dies_of_this_run(folder: Path) -> None:
    setting = load_scene(str(folder / "scene.toml"))
    program = ProgramFile(PROGRAM.encode(), "touch.v2")
    run = simulate(Request(program, setting, Reading("val2"))).run
    assert run is not None
    with ByFcl() as fcl:
        found = check_collisions(run.scene, run, proposer=fcl)
        assert fcl.deaths > 0, "it does not die of this any more: look for another touch"
    assert len(found.contacts) == 1
    assert found.certified


@pytest.mark.thorough
def test_the_command_says_the_same_whoever_proposes(folder: Path) -> None:
    words = ("verify", "touch.v2", "--scene", "scene.toml", "--color", "never")
    usual = vrts(*words, cwd=folder)  # coal proposes, and fcl gives the second opinion
    assert usual.returncode == 1
    assert b"the palm hits `rod`" in usual.stdout
    for engine in ("coal", "fcl", "own"):
        other = vrts(*words, "--engine", engine, cwd=folder)
        assert (other.returncode, other.stdout) == (usual.returncode, usual.stdout), engine
        assert other.stderr == usual.stderr, "nothing is told of a process that has ended"


def started(*words: str | Path, path: str) -> "subprocess.CompletedProcess[bytes]":
    """Start Python anew: where libraries are looked for is settled when it starts."""
    command = [sys.executable, "-m", "vrts.cli.main", *map(str, words)]
    return subprocess.run(
        command, env={**os.environ, "PYTHONPATH": path}, capture_output=True, check=False
    )


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("program", "status"), [("solution.v2", 0), ("submissions/hits-base.v2", 1)]
)
def test_a_second_opinion_that_dies_changes_neither_verdict_nor_mark_nor_status(
    tmp_path: Path, program: str, status: int
) -> None:
    words = ("verify", CANS / program, "--task", CANS / "task.toml", "--color", "never")
    said = {"installed": started(*words, path=str(ROOT))}
    for name, library in (("aborting", ABORTING), ("missing", MISSING)):
        place = tmp_path / name
        place.mkdir()
        (place / "fcl.py").write_text(library)
        said[name] = started(*words, path=f"{place}{os.pathsep}{ROOT}")
    deaths = (tmp_path / "aborting" / "deaths").read_bytes()
    assert deaths, "nobody was asked for a second opinion"
    assert b" / 10 " in said["installed"].stdout, "no mark"
    for name, found in said.items():
        assert found.returncode == status, name
        assert (found.stdout, found.stderr) == (said["installed"].stdout, b""), name
