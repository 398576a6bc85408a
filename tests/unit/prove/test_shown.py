"""A variable that TYPE works something out with decides something: it may go wrong there."""

import pytest

from tests.support_programs import compiled
from vrts.check.verdict import Answer
from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Wrong
from vrts.prove.prove import prove
from vrts.scene.default import robot_alone

SHARED = """\
.PROGRAM share()
  parts = 2
  IF SIG(1001) THEN
    parts = parts-1
  END
  IF SIG(1002) THEN
    parts = parts-1
  END
  TYPE {}
.END
"""


@pytest.mark.parametrize(
    "shown",
    [
        '"each: ", 60/parts',
        "a[parts-1]",
        "SQRT(parts-1)",
        "/I3, 1/parts",
    ],
)
def test_what_type_works_out_may_go_wrong(shown: str) -> None:
    start = '  $x = "abc"\n  a[0] = 1\n  a[1] = 1\n'
    text = SHARED.format(shown).replace("  parts = 2\n", start + "  parts = 2\n", 1)
    found = prove(compiled(text), robot_alone(), Environment(), entry="share")
    assert found.answer is Answer.VIOLATED
    assert found.found[0].wrong is Wrong.ERROR
    assert len(found.found[0].decisions) == 2


def test_a_variable_that_is_only_written_decides_nothing() -> None:
    text = SHARED.format('"parts: ", parts')
    assert prove(compiled(text), robot_alone(), Environment(), entry="share").answer is Answer.HOLDS
