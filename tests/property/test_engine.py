"""Laws of runs: what is cut and continued is what was never cut; forks share the past."""

from itertools import pairwise

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_programs import ROOT, cans, compiled, program
from vrts.engine.controller import advance, execute, start, truncate
from vrts.engine.run import OutOfHorizon, Run
from vrts.ir.commands import (
    Abort,
    Answer,
    Command,
    Execute,
    ForceSignals,
    MonitorSpeed,
    Panic,
    Proceed,
    Retry,
    RunSteps,
    SetVariable,
    TimedCommand,
)
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario

CARRY = compiled((ROOT / "examples" / "01-cans-on-bases" / "solution.v2").read_text("utf-8"))
CANS = cans()
WHOLE = execute(CARRY, CANS)
END = WHOLE.horizon_s

LINES = st.sampled_from(
    [
        "MOVE a",
        "MOVE b",
        "MOVE c",
        "APPRO a, 50",
        "DEPART 20",
        "SPEED 30",
        "SPEED 60 ALWAYS",
        "OPENI",
        "CLOSEI",
        "SIGNAL 1",
        "SIGNAL -1",
        "BREAK",
        "DELAY 0.3",
        'TYPE "x"',
        "n = 1",
        "DRIVE 1, 5, 50",
    ]
)
BUSY = compiled(
    """.PROGRAM main
 n = 0
 REACT 1001, blink, 5
 REACTI 1002
 PCEXECUTE watch, -1
 WHILE n < 40 DO
   MOVE a
   CALL count(n, 2)
   m[n] = RANDOM
   MOVES b
   IF n == 10 THEN
     $t = "ten"
     SET spot[1] = HERE
   END
   SIGNAL 2001
   BREAK
   SIGNAL -2001
   PROMPT "go ", x
 END
.END
.PROGRAM count(k, by)
 AUTO old
 old = k
 k = old+by
.END
.PROGRAM blink()
 SIGNAL 3
 DEPART 30
 SIGNAL -3
 REACT 1001, blink, 5
.END
.PROGRAM watch
 WAIT SIG(2001)
 seen = seen+1
 SIGNAL 5
 WAIT SIG(-2001)
 SIGNAL -5
.END
.LOCATIONS
a 900 200 100 90 90 0
b 900 -200 100 90 90 0
.END
.REALS
seen 0
.END
""",
    "val2+",
)
LONGEST = 12.0  # [s] of a run of BUSY
TRAFFIC = Scenario(
    seed=3,
    inputs=tuple((0.7 * k, 1001 + k % 2, bool((k // 2) % 2)) for k in range(40)),
    answers=tuple(str(k) for k in range(20)),
)
COMMANDS: st.SearchStrategy[Command] = st.sampled_from(
    [
        Execute("main"),
        Abort(),
        Proceed(),
        Retry(),
        RunSteps(3),
        Panic(),
        MonitorSpeed(50.0),
        MonitorSpeed(100.0),
        MonitorSpeed(10.0),
        ForceSignals((1001,)),
        ForceSignals((-1001, 2001)),
        Answer("7"),
        SetVariable("n", (), 5.0),
        SetVariable("z", (2,), 1.5),
    ]
)
MOMENTS = st.integers(0, round(1000 * LONGEST)).map(lambda ms: ms / 1000)
TIMED = st.lists(st.builds(TimedCommand, MOMENTS, COMMANDS), max_size=6).map(
    lambda found: [TimedCommand(0.0, Execute("main")), *found]
)
PROGRAMS = st.lists(LINES, min_size=1, max_size=8).map(lambda lines: "\n".join(lines))


def same_state(a: Run, b: Run, time_s: float) -> None:
    one, other = a.at(time_s), b.at(time_s)
    assert one.configuration == other.configuration
    assert one.velocity == other.velocity
    assert one.hand_opening == other.hand_opening
    assert one.placements == other.placements or all(
        p._replace(end_s=0.0) == other.placements[name]._replace(end_s=0.0)
        for name, p in one.placements.items()
    )
    assert one.poses == other.poses
    assert one.held == other.held
    assert one.signals == other.signals
    assert one.variables == other.variables
    assert one.output == other.output
    assert one.call_stack == other.call_stack


def same_run(one: Run, other: Run) -> None:
    assert one.events == other.events
    assert one.motions == other.motions
    assert one.timeline.segments == other.timeline.segments
    assert (one.ending, one.ended_s) == (other.ending, other.ended_s)
    assert one.statements == other.statements
    for k in range(7):
        same_state(one, other, k * min(one.horizon_s, other.horizon_s) / 7)
    for k in range(7):
        finished = k * one.statements // 7
        assert one.at_statement(finished).variables == other.at_statement(finished).variables
        assert one.at_statement(finished).call_stack == other.at_statement(finished).call_stack


@settings(max_examples=examples(15))
@given(st.floats(0.0, END))
def test_what_is_cut_and_continued_was_never_cut(time_s: float) -> None:
    again = advance(truncate(WHOLE, time_s), WHOLE.until_s, closed=True)
    same_run(again, WHOLE)


@settings(max_examples=examples(15))
@given(st.floats(0.0, END), st.floats(0.0, 1.0))
def test_a_shorter_run_is_the_beginning_of_a_longer_one(time_s: float, part: float) -> None:
    run = advance(start(CARRY, CANS), time_s, [TimedCommand(0.0, Execute("main"))])
    known = tuple(event for event in WHOLE.events if event.time_s <= run.horizon_s)
    assert run.events == known
    same_state(run, WHOLE, part * run.horizon_s)


@settings(max_examples=examples(15))
@given(st.lists(st.floats(0.0, END), min_size=1, max_size=4))
def test_growing_in_steps_is_growing_at_once(times: list[float]) -> None:
    run = advance(start(CARRY, CANS), 0.0, [TimedCommand(0.0, Execute("main"))])
    for time_s in sorted(times):
        run = advance(run, time_s)
    run = advance(run, WHOLE.until_s, closed=True)
    assert run.events == WHOLE.events
    assert run.timeline.segments == WHOLE.timeline.segments


def run_of(commands: list[TimedCommand], until_s: float = LONGEST) -> Run:
    return advance(start(BUSY, robot_alone(), TRAFFIC), until_s, commands)


@settings(max_examples=examples(20))
@given(TIMED, st.lists(MOMENTS, min_size=1, max_size=5))
def test_an_operated_run_grows_in_steps(commands: list[TimedCommand], times: list[float]) -> None:
    whole = run_of(commands)
    run = start(BUSY, robot_alone(), TRAFFIC)
    left = sorted(commands, key=lambda c: c.time_s)
    for time_s in [*sorted(times), LONGEST]:
        due = [c for c in left if c.time_s <= time_s]
        left = left[len(due) :]
        run = advance(run, time_s, due)
    same_run(run, whole)


@settings(max_examples=examples(20))
@given(TIMED, MOMENTS)
def test_a_fork_with_the_same_commands_is_the_same_run(
    commands: list[TimedCommand], time_s: float
) -> None:
    whole = run_of(commands)
    later = [c for c in commands if c.time_s > time_s]
    same_run(advance(truncate(whole, time_s), LONGEST, later), whole)


@settings(max_examples=examples(15))
@given(TIMED, TIMED, MOMENTS)
@example(
    [
        TimedCommand(0.0, Execute("main")),
        TimedCommand(0.001, Abort()),
        TimedCommand(0.036, Execute("main")),
    ],
    [TimedCommand(0.0, Execute("main"))],
    0.035,
)
def test_forks_leave_each_other_alone(
    commands: list[TimedCommand], others: list[TimedCommand], time_s: float
) -> None:
    whole = run_of(commands)
    before = [whole.at(k * 1.2).variables for k in range(10)]
    common = truncate(whole, time_s)
    other = advance(common, LONGEST, [c for c in others if c.time_s >= time_s])
    again = advance(common, LONGEST, [c for c in commands if c.time_s > time_s])
    same_run(again, whole)
    assert [whole.at(k * 1.2).variables for k in range(10)] == before
    for k in range(5):  # the past is common
        same_state(other, whole, k * time_s / 5)


@settings(max_examples=examples(10))
@given(TIMED)
def test_statements_and_times_agree(commands: list[TimedCommand]) -> None:
    run = run_of(commands)
    tick = run.scene.robot.arm.tick
    for finished in range(0, run.statements, max(run.statements // 50, 1)):
        state = run.at_statement(finished)
        if state.time_s + tick <= run.horizon_s:
            assert run.at(state.time_s).finished >= finished
        if state.time_s >= tick:
            assert run.at(state.time_s - 0.5 * tick).finished <= finished


@settings(max_examples=examples(40))
@given(PROGRAMS)
def test_timelines_have_no_gaps_and_programs_end(body: str) -> None:
    run = execute(compiled(program(body)), robot_alone())
    assert run.ended_s is not None
    segments = run.timeline.segments
    if segments:
        assert segments[0].start_s == 0.0
        assert segments[-1].end_s == pytest.approx(run.horizon_s)
    for before, after in pairwise(segments):
        assert before.end_s == after.start_s
        assert before.start_s < before.end_s
        t = before.end_s - before.start_s
        for a, b in zip(before.coefficients, after.coefficients, strict=True):
            assert sum(c * t**k for k, c in enumerate(a)) == pytest.approx(b[0], abs=1e-9)
    times = [round(event.time_s * 1e9) for event in run.events]
    assert times == sorted(times)


@settings(max_examples=examples(20))
@given(PROGRAMS, st.floats(0.0, 1.0))
def test_any_program_can_be_cut_anywhere(body: str, part: float) -> None:
    whole = execute(compiled(program(body)), robot_alone())
    again = advance(truncate(whole, part * whole.horizon_s), whole.until_s, closed=True)
    assert again.events == whole.events
    assert again.timeline.segments == whole.timeline.segments


@pytest.mark.parametrize("time_s", [-0.001, END + 1.0])
def test_what_is_not_known_is_refused(time_s: float) -> None:
    with pytest.raises(OutOfHorizon):
        WHOLE.at(time_s)


def test_the_past_cannot_be_commanded() -> None:
    run = advance(start(CARRY, CANS), 2.0)
    with pytest.raises(ValueError, match="in the past"):
        advance(run, 3.0, [TimedCommand(1.0, Execute("main"))])
    with pytest.raises(ValueError, match="before the horizon"):
        advance(run, 1.0)
