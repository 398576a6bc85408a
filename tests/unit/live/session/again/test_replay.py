"""A session repeated from its log is the same run, and its program makes the same motions."""

import itertools
import math
import random
from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from tests.unit.live.session.test_live_session import ABOVE_TABLE, DOWN, grasp
from vrts.base.pose import Pose
from vrts.engine.memory.records import Motion
from vrts.engine.run import Run
from vrts.live import actions as do
from vrts.live.session.again.replay import replay
from vrts.live.session.views.program import as_program
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Checks, Request

PROGRAM = """\
.PROGRAM wave()
    SPEED 60 ALWAYS
    MOVE p1
    MOVES SHIFT(p1 BY 0,50,0)
    MOVES p1
    BREAK
    TYPE "done"
.END
"""


def eventful(driven: Driven) -> None:
    """Use everything that moves something, at odd moments."""
    chance = random.Random(5)

    def wait(seconds: float) -> None:
        driven.run(seconds, beat_s=chance.uniform(0.011, 0.029))

    grasp(driven)
    driven.act(do.Step("world", 2, 1, 0.08))
    wait(1.03)
    driven.act(do.Record("p1"))
    driven.typed("DO SET p2 = SHIFT(p1 BY 0,60,30)", "DO MOVE p2", "WHERE", seconds=0.41)
    wait(0.9)
    driven.act(do.Jog("world", 0, -1, 1.0))
    for _ in range(9):
        wait(0.083)
        driven.act(do.Keep())
    driven.act(do.LetGo())
    wait(0.5)
    driven.act(do.Jog("joint", 5, 1, 0.7))
    wait(0.6)  # nothing is heard of the key
    driven.act(do.Upload("wave.v2", PROGRAM))
    wait(0.05)
    driven.typed("EXECUTE wave", seconds=0.7)
    driven.halt()
    wait(0.6)
    driven.typed("PROCEED", seconds=5.0)
    driven.typed("DO SIGNAL 3", "DO OPENI", seconds=0.5)
    driven.act(do.Go(ABOVE_TABLE, DOWN))
    wait(0.4)
    driven.act(do.Ready())
    wait(4.0)


def test_a_session_is_repeated_exactly_from_its_log(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    eventful(driven)
    run = driven.session.run
    again = replay(driven.start, driven.log, run.until_s)
    assert list(map(repr, again.events)) == list(map(repr, run.events))
    assert repr(again.motions) == repr(run.motions)
    assert again.at(again.until_s).variables == run.at(run.until_s).variables
    assert [again.at(t * 0.01).configuration for t in range(int(run.until_s * 100))] == [
        run.at(t * 0.01).configuration for t in range(int(run.until_s * 100))
    ]


def test_a_log_out_of_order_is_refused(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(1.0)
    driven.act(do.Hand(open=True))
    driven.run(1.0)
    driven.act(do.Hand(open=False))
    with pytest.raises(ValueError, match="reached"):
        replay(driven.start, list(reversed(driven.log)))


def test_a_session_becomes_a_program_that_makes_the_same_motions(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    eventful(driven)
    run = driven.session.run
    text = as_program(run, "lesson")
    found = assess(
        Request(
            ProgramFile(text.encode(), "program"),
            driven.session.setting,
            checks=Checks(collisions=False),
        )
    )
    assert not [d for d in found.diagnostics if d.is_error]
    again = found.run
    assert again is not None
    before, after = moved(run), moved(again)
    assert len(before) == len(after) >= 10
    joined = False
    for first, second in zip(before, after, strict=True):
        assert_same_ends(first, second)
        if not (joined and first.cut):  # of which the corner is another one
            assert_same_path(run, first, again, second)
        joined = first.blended
    assert run.at(run.horizon_s).held == again.at(again.horizon_s).held
    final, same = run.at(run.horizon_s).poses, again.at(again.horizon_s).poses
    for name, X in final.items():
        assert math.dist(X.translation, same[name].translation) < 1e-4


def moved(run: Run) -> list[Motion]:
    """Return the motions that went anywhere."""
    return [m for m in run.motions if math.dist(m.start, m.goal) > 1e-9]


def assert_same_ends(first: Motion, second: Motion) -> None:
    """Compare kind and end of two motions."""
    assert first.interpolation is second.interpolation
    assert apart(first.X_WT, second.X_WT) < 1e-5
    assert max(abs(a - b) for a, b in zip(first.goal, second.goal, strict=True)) < 1e-5


def assert_same_path(run: Run, first: Motion, again: Run, second: Motion) -> None:
    """Compare the paths of two motions: nowhere more than 0.01 mm from one another."""
    there = [again.at(t).X_WF for t in spread(second, again.horizon_s, 400)]
    for time_s in spread(first, run.horizon_s, 20):
        X_WF = run.at(time_s).X_WF
        assert off(X_WF, there) < 1e-5


def spread(motion: Motion, horizon_s: float, count: int) -> list[float]:
    """Return times of a motion."""
    end_s = min(motion.end_s, horizon_s)
    return [motion.start_s + (end_s - motion.start_s) * k / count for k in range(count + 1)]


def off(X: Pose, path: list[Pose]) -> float:
    """Return how far the origin of a pose is from a polyline [m]."""
    return min(
        _from_line(X.translation, a.translation, b.translation) for a, b in itertools.pairwise(path)
    )


def _from_line(p: tuple[float, ...], a: tuple[float, ...], b: tuple[float, ...]) -> float:
    along = [y - x for x, y in zip(a, b, strict=True)]
    length = sum(c * c for c in along)
    share = 0.0
    if length > 0.0:
        share = sum((y - x) * c for x, y, c in zip(a, p, along, strict=True)) / length
    share = min(max(share, 0.0), 1.0)
    return math.dist(p, [x + share * c for x, c in zip(a, along, strict=True)])


def apart(a: Pose, b: Pose) -> float:
    """Return the distance of two origins [m]."""
    return math.dist(a.translation, b.translation)


def test_nothing_done_is_a_program_too(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(0.1)
    found = assess(
        Request(
            ProgramFile(as_program(driven.session.run, "idle").encode(), "program"),
            driven.session.setting,
        )
    )
    assert not [d for d in found.diagnostics if d.is_error]


def test_names_that_were_taught_are_used(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.act(do.Go(ABOVE_TABLE, DOWN))
    driven.run(4.0)
    driven.act(do.Record("above.table"))
    driven.run(0.1)
    assert "MOVE above.table" in as_program(driven.session.run, "lesson")


def test_the_program_is_saved_into_the_users_folder(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    grasp(driven)
    assert driven.done(driven.act(do.Save("lesson"))).accepted
    driven.run(0.1)
    assert ".LOCATIONS" in (tmp_path / "ada" / "lesson.v2").read_text()
    assert "lesson" in driven.typed("DIRECTORY")
    assert not driven.done(driven.act(do.Save("../lesson"))).accepted
