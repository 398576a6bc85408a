"""Who wrote what a step read, through arguments and loops, as chains of causes see it."""

from tests.support_programs import compiled
from vrts.engine.controller import execute
from vrts.ir.control import NextFor
from vrts.pipeline.scenes import load_scene
from vrts.repair.blame.trail import Trail
from vrts.scene.model import Scenario

TEXT = """\
.PROGRAM main()
FOR i = 1 TO 2
CALL sub(i)
END
.END
.PROGRAM sub(n)
n = n+5
TYPE n
.END
"""


def trail() -> Trail:
    return Trail(execute(compiled(TEXT), load_scene("cans-on-bases").scene, Scenario()))


def test_a_loop_reads_the_variable_that_a_program_it_called_has_changed() -> None:
    found = trail()
    after = next(k for k, s in enumerate(found.steps) if isinstance(s.instruction, NextFor))
    lines = {found.steps[w.step].line for w in found.reads(after) if w.step is not None}
    assert lines == {7}


def test_a_step_is_led_to_by_its_call() -> None:
    found = trail()
    within = next(k for k, step in enumerate(found.steps) if step.line == 7)
    by = found.caller(within)
    assert by is not None
    assert found.steps[by].line == 3
    assert found.caller(by) is None
