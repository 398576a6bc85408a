"""A session that goes on and on: what it keeps has an end."""

import gc
from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from vrts.live import actions as do
from vrts.live.session.growing import growing_run
from vrts.live.session.growing.tidying import tidy

LOOP = """\
.PROGRAM loop()
10 DRIVE 1,30,100
    SIGNAL 3
    TYPE "there ", n
    DRIVE 1,-30,100
    SIGNAL -3
    n = n + 1
    GOTO 10
.END
"""


def test_a_looping_program_leaves_nothing_behind(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(growing_run, "REACH", 30.0)
    monkeypatch.setattr(growing_run, "CHECKPOINT", 10.0)
    monkeypatch.setattr(growing_run, "FORGETTING", 10.0)
    driven = Driven(tmp_path)
    driven.act(do.Upload("loop.v2", LOOP))
    driven.run(0.1)
    driven.typed("DO n = 0", "EXECUTE loop,-1")
    go_on(driven, 60)
    objects, motions = counted(driven)
    go_on(driven, 120)
    objects_after, motions_after = counted(driven)
    gc.unfreeze()
    assert motions_after - motions > 200
    assert objects_after - objects < 200, "of the file a row for every two minutes"


def go_on(driven: Driven, seconds: int) -> None:
    """Let time pass, with memory looked after as the session's process does it."""
    for _ in range(seconds // 10):
        driven.run(10.0)
        tidy()


def counted(driven: Driven) -> tuple[int, int]:
    """Return how many objects there are, and how many motions there were."""
    for heard in (driven.news, driven.frames, driven.log):
        heard.clear()
    tidy()
    gc.unfreeze()  # so that what was not given back is counted too
    objects = len(gc.get_objects())
    gc.freeze()
    return objects, len(driven.session.growing.machine.system.planner.given.motions)
