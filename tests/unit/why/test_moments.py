"""Why at a moment: no cause is later than what it has caused."""

import numpy as np
import pytest

from tests.support_programs import ROOT, cans, compiled, robot_alone
from vrts.engine.controller import execute
from vrts.scene.model import Scene
from vrts.why.asking import why_at

WAITS = """.PROGRAM main
        MOVE near
        DELAY 0.5
        x = x+1
        CALL twice(x)
        MOVES far
        BREAK
        TYPE x
.END
.PROGRAM twice(n)
        n = n*2
        MOVE far
        BREAK
.END
.LOCATIONS
far 700 300 0 90 90 0
near 700 -300 0 90 90 0
.END
.REALS
x 0
.END
"""


SOLUTION = ROOT / "examples" / "01-cans-on-bases" / "solution.v2"


@pytest.mark.parametrize(
    ("text", "scene"), [(WAITS, robot_alone()), (SOLUTION.read_text("utf-8"), cans())]
)
def test_no_cause_comes_after_the_moment(text: str, scene: Scene) -> None:
    run = execute(compiled(text), scene)
    for time_s in np.linspace(0.0, run.horizon_s, 60).tolist():
        for link in why_at(run, time_s).links:
            assert link.time_s is None or link.time_s <= time_s + 1e-9, (time_s, link)
