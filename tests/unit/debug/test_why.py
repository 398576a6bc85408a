"""The debugger tells what was written last, and why the arm moves, where it stands."""

from pathlib import Path

import pytest

from tests.unit.debug.test_debugger import TEXT, debugger
from vrts.check.rules.hints import Hints
from vrts.debug.console import NO_HINTS, Console
from vrts.debug.debugger import Debugger


def console(there: Debugger, tmp_path: Path, hints: Hints = Hints.EDIT) -> Console:
    return Console(there, tmp_path, (), hints)


def test_the_last_write_is_that_of_the_instant_where_it_stands(tmp_path: Path) -> None:
    there = debugger()
    there.seek(there.run.horizon_s)
    last = console(there, tmp_path).enter("why n")
    assert "`n` is 4" in last
    assert "line 5 `n = n+1`: `n` is set to 4" in last
    there.seek(0.0)
    assert "line 5 `n = n+1`: `n` is set to 1" in console(there, tmp_path).enter("why n")


def test_a_motion_is_named_with_its_step(tmp_path: Path) -> None:
    there = debugger()
    motion = there.run.motions[0]
    there.seek((motion.start_s + motion.end_s) / 2)
    said = console(there, tmp_path).enter("why")
    assert "line 7 `MOVE far`: the tool goes to X 700 Y 300 Z 0" in said


def test_an_unknown_name_is_said_to_be_unknown(tmp_path: Path) -> None:
    there = debugger()
    assert "nothing here is called `nobody`" in console(there, tmp_path).enter("why nobody")


@pytest.mark.parametrize("line", ["why", "why n"])
def test_a_task_without_hints_lets_nothing_be_told(tmp_path: Path, line: str) -> None:
    there = debugger(TEXT)
    assert console(there, tmp_path, Hints.NOTHING).enter(line).strip() == NO_HINTS
