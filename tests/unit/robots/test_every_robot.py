"""One program on every robot: it takes the can, sets it on the base, and touches nothing else."""

import math

import pytest

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.check.judge import judge
from vrts.check.verdict import Answer
from vrts.engine.controller import execute
from vrts.engine.memory.records import Ending, Lie
from vrts.engine.run import Run
from vrts.lang.compiler import compile_source
from vrts.robots.catalog import names
from vrts.scene.block import location_block
from vrts.scene.model import Scenario, Scene
from vrts.scene.reading.scene_file import read_scene

SCENES = ROOT / "scenes"
ROBOTS = (*names(), "urdf")

PICK_AND_PLACE = """\
.PROGRAM pick
; the can goes from the table onto the base; approaches and departures are straight
  SPEED 80 ALWAYS
  OPENI
  MOVE safe
  APPRO can1_grip, 100
  SPEED 200 MMPS
  MOVES can1_grip
  CLOSEI
  DEPARTS 100
  APPRO base1_put, 100
  SPEED 200 MMPS
  MOVES base1_put
  OPENI
  DEPARTS 100
  MOVE safe
  TYPE "done"
.END
"""


def scene_of(robot: str) -> Scene:
    folder = SCENES / f"one-can-{robot}"
    source = SourceFile(f"{folder.name}/scene.toml", (folder / "scene.toml").read_text("utf-8"))
    scene, diagnostics = read_scene(source, folder)
    assert diagnostics == ()
    assert scene is not None
    return scene


def run_in(scene: Scene, program: str) -> Run:
    text = program + location_block(scene.locations)
    compilation = compile_source(SourceFile("pick.v2", text))
    assert compilation.module is not None
    assert not any(diagnostic.is_error for diagnostic in compilation.diagnostics)
    return execute(compilation.module, scene, Scenario(), "pick")


@pytest.mark.parametrize("robot", ROBOTS)
def test_the_can_is_put_on_the_base(robot: str) -> None:
    scene = scene_of(robot)
    run = run_in(scene, PICK_AND_PLACE)
    assert run.ending is Ending.COMPLETED
    assert run.findings == ()
    last = run.placements["can1"][-1]
    assert last.lie is Lie.RESTING
    assert last.support == "base1"
    wanted = scene.body("base1").X_WO.translation
    assert math.dist(last.X.translation[:2], wanted[:2]) < 1e-3


@pytest.mark.parametrize("robot", ROBOTS)
def test_nothing_is_touched_and_all_limits_are_kept(robot: str) -> None:
    scene = scene_of(robot)
    judgement = judge(scene, run_in(scene, PICK_AND_PLACE), None)
    assert {verdict.answer for verdict in judgement.verdicts} == {Answer.HOLDS}


@pytest.mark.parametrize("robot", ["ur5", "urdf"])
def test_a_blow_to_the_base_is_seen_on_any_robot(robot: str) -> None:
    scene = scene_of(robot)
    low = PICK_AND_PLACE.replace("  MOVES base1_put", "  MOVES base1_put:TRANS(0,0,40)")
    judgement = judge(scene, run_in(scene, low), None)
    headlines = [finding.headline for v in judgement.verdicts for finding in v.findings]
    assert "the held `can1` hits `base1`" in headlines


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_straight_line_out_of_the_workspace_is_a_finding(robot: str) -> None:
    scene = scene_of(robot)
    run = run_in(
        scene,
        ".PROGRAM pick\n  MOVE safe\n  SPEED 200 MMPS\n  MOVES safe:TRANS(0,3000,0)\n.END\n",
    )
    assert run.ending is not Ending.COMPLETED
    assert any(finding.is_error for finding in run.findings)


def test_branch_words_are_for_arms_that_have_branches() -> None:
    program = PICK_AND_PLACE.replace("  OPENI\n  MOVE safe", "  RIGHTY\n  OPENI\n  MOVE safe", 1)
    run = run_in(scene_of("ur5"), program)
    assert run.ending is Ending.COMPLETED
    assert [finding.rule.code for finding in run.findings] == ["V330"]
