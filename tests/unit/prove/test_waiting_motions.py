"""Motions of no length that wait for the next one are not forgotten before they have ended."""

from tests.support_programs import compiled
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Environment
from vrts.prove.prove import prove
from vrts.scene.default import robot_alone

STAYS = """\
.PROGRAM main()
  READY
  FOR i = 1 TO 3
    IF SIG(1001) THEN
      DRIVE 1, 20, 60
    END
    READY
  END
.END
"""


def test_an_arm_that_is_there_already_goes_on() -> None:
    found = prove(compiled(STAYS), robot_alone(), Environment(), entry="main")
    assert found.answer is Answer.HOLDS
    assert found.covered.decisions >= 3
