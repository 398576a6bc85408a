"""A run that grows in place answers like one that is advanced, and forgets only what is old."""

from pathlib import Path

import pytest

from tests.unit.live.session.support import Driven
from vrts.base.source import SourceFile
from vrts.engine.controller import advance, start
from vrts.engine.machine.forget import forget
from vrts.engine.machine.machine import Machine
from vrts.engine.memory.events import Event
from vrts.engine.run import Run
from vrts.ir.commands import Execute, Load, MonitorSpeed, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.lang.compiler import compile_source
from vrts.live import actions as do
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.pipeline.scenes import load_scene
from vrts.scene.model import Scenario

PROGRAM = """\
.PROGRAM main()
    n = 0
 10 MOVE a
    MOVES SHIFT(a BY 0,80,0)
    n = n + 1
    $s = "turn"
    CALL sub(n)
    SIGNAL 5
    OPENI
    TYPE "n is ", n
    SIGNAL -5
    CLOSEI
    GOTO 10
.END
.PROGRAM sub(k)
    FOR i = 1 TO 20
      k = k + 0.01
    END
.END
.LOCATIONS
a 750 -150 0 0 90 0
.END
"""
SCENE = load_scene("cans-on-bases").scene
MODULE = compile_source(SourceFile("main", PROGRAM)).module or Module({}, ())
COMMANDS = [
    (0.0, Load(MODULE)),
    (0.1, Execute("main")),
    (31.7, MonitorSpeed(60.0)),
    (95.3, Panic()),
    (97.0, Execute("main")),
]


def grown(until_s: float) -> GrowingRun:
    growing = GrowingRun(SCENE, Scenario())
    waiting = list(COMMANDS)
    while growing.time_s < until_s:
        following = min(growing.time_s + 0.05, until_s)
        while waiting and waiting[0][0] <= following:
            growing.advance(waiting[0][0])
            growing.issue(waiting.pop(0)[1])
        growing.advance(following)
    return growing


def same(a: Run, b: Run, time_s: float) -> None:
    """Compare everything that can be asked of one instant."""
    first, second = a.at(time_s), b.at(time_s)
    assert first.finished == second.finished
    assert first.configuration == second.configuration
    assert first.velocity == pytest.approx(second.velocity, abs=1e-9)
    assert first.hand_opening == second.hand_opening
    assert first.poses == second.poses
    assert first.signals == second.signals
    assert first.variables == second.variables
    assert first.locals == second.locals
    assert first.call_stack == second.call_stack
    assert first.robot == second.robot
    assert first.monitor_speed == second.monitor_speed
    assert first.X_WT == second.X_WT


def test_growing_in_place_is_advancing() -> None:
    growing = grown(130.0)
    timed = [TimedCommand(time_s, command) for time_s, command in COMMANDS]
    run = advance(start(growing.run.module, SCENE), 130.0, timed)
    for k in range(261):
        same(growing.run, run, 0.5 * k)
    assert growing.run.events == run.events


@pytest.mark.parametrize("reach_s", [20.0, 60.0])
def test_what_is_forgotten_is_only_what_is_old(
    monkeypatch: pytest.MonkeyPatch, reach_s: float
) -> None:
    whole = grown(300.0)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.REACH", reach_s)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.FORGETTING", 7.0)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.CHECKPOINT", 3.0)
    short = grown(300.0)
    assert 300.0 - reach_s - 12.0 < short.known_from_s <= 300.0 - reach_s
    for k in range(200):
        time_s = short.known_from_s + (300.0 - short.known_from_s) * k / 199
        same(short.run, whole.run, time_s)
    assert len(short.machine.system.events) < len(whole.machine.system.events) / 3
    assert len(short.machine.robot.trace.instructions) < len(whole.machine.robot.trace.instructions)
    short.rewind(short.known_from_s + 5.3)
    whole.rewind(short.time_s)
    short.advance(short.time_s + 20.0)
    whole.advance(whole.time_s + 20.0)
    for k in range(50):
        same(short.run, whole.run, short.time_s - 0.4 * k)


def test_of_what_is_long_past_few_states_are_kept_and_any_time_can_be_gone_back_to(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    whole = grown(300.0)
    released: list[Machine] = []
    monkeypatch.setattr("vrts.live.session.growing.growing_run._release", released.append)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.CHECKPOINT", 3.0)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.RECENT", 30.0)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.SPARSE", 24.0)
    thin = grown(300.0)
    assert len(released) == 79  # every 3 s until 267 s, but for 11 that are 24 s apart
    for time_s in (290.3, 275.0, 100.3, 50.0, 1.7):
        thin.rewind(time_s)
        whole.rewind(time_s)
        same(thin.run, whole.run, time_s)
    thin.advance(20.0)
    whole.advance(20.0)
    same(thin.run, whole.run, 20.0)


def test_machines_of_the_past_share_their_events_when_some_are_forgotten() -> None:
    growing = grown(100.0)
    earlier = growing.machine.copy()
    growing.advance(130.0)
    forget([growing.machine, earlier], 60.0)
    now, then = growing.machine.system.events, earlier.system.events
    assert len(now) > len(then)
    assert now.shares_with(then)
    assert now[: len(then)] == then[:]
    assert now.numbers[: len(then)] == then.numbers
    growing.machine.issue((TimedCommand(130.0, Panic()),))
    growing.advance(131.0)
    assert len(then) < len(now), "what the one adds the other has not"


def test_news_come_once_and_in_order() -> None:
    growing = GrowingRun(SCENE, Scenario())
    growing.issue(Load(MODULE), Execute("main"))
    told: list[Event] = []
    for k in range(400):
        growing.advance(0.05 * k)
        told += growing.news()
    assert sorted(map(repr, told)) == sorted(map(repr, growing.run.events))
    assert [e.time_s for e in told] == pytest.approx(sorted(e.time_s for e in told), abs=0.05)


def test_a_crowd_of_events_shortens_the_history(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("vrts.live.session.growing.growing_run.MOST_EVENTS", 500)
    monkeypatch.setattr("vrts.live.session.growing.growing_run.CHECKPOINT", 3.0)
    growing = grown(200.0)
    assert growing.known_from_s > 0.0
    assert len(growing.machine.system.events) < 1500
    same(growing.run, grown(200.0).run, 200.0)


def test_a_time_that_is_forgotten_is_refused(tmp_path: Path) -> None:
    driven = Driven(tmp_path)
    driven.run(1.0)
    driven.session.growing.known_from_s = 0.5
    assert not driven.done(driven.act(do.Rewind(0.2))).accepted
