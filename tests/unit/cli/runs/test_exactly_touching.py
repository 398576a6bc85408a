"""A program that comes to rest where shapes touch exactly: python-fcl ends its process there.

The command goes on without it, and says what it says whoever proposes.
"""

from pathlib import Path

import pytest

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


def test_the_command_says_the_same_whoever_proposes(folder: Path) -> None:
    words = ("verify", "touch.v2", "--scene", "scene.toml", "--color", "never")
    usual = vrts(*words, cwd=folder)  # coal proposes, and fcl gives the second opinion
    assert usual.returncode == 1
    assert b"the palm hits `rod`" in usual.stdout
    for engine in ("coal", "fcl", "own"):
        other = vrts(*words, "--engine", engine, cwd=folder)
        assert (other.returncode, other.stdout) == (usual.returncode, usual.stdout), engine
        assert other.stderr == usual.stderr, "nothing is told of a process that has ended"
