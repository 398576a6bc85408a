"""The heights at which `why` says that a can is gripped are those at which the engine grips it."""

import pytest

from tests.support_programs import compiled
from vrts.base.units import MM
from vrts.engine.controller import execute
from vrts.engine.memory.events import Grasped
from vrts.pipeline.scenes import load_scene
from vrts.scene.model import Scenario
from vrts.why.hands import box_at, grip_heights
from vrts.why.slicing.executed import Steps

NEAR = 0.5  # mm


def grips(z_mm: float) -> bool:
    text = f"""\
.PROGRAM main()
OPENI
MOVE TRANS(800,-450,{z_mm:.3f},90,90,0)
CLOSEI
.END
"""
    run = execute(compiled(text), load_scene("cans-on-bases").scene, Scenario())
    return any(isinstance(e, Grasped) for e in run.events)


@pytest.mark.parametrize("beyond", [-NEAR, NEAR])
def test_the_highest_grip_is_where_the_pads_overlap_just_enough(beyond: float) -> None:
    run = execute(compiled("OPENI\n"), load_scene("cans-on-bases").scene, Scenario())
    _, high = grip_heights(Steps(run), box_at(Steps(run), "can1", 0.0))
    assert grips(high / MM + beyond) is (beyond < 0)
