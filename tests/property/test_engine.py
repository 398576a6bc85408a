"""Laws of runs: what is cut and continued is what was never cut."""

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.support_programs import ROOT, cans, compiled, program
from vrts.engine.controller import advance, execute, start, truncate
from vrts.engine.run import OutOfHorizon, Run
from vrts.ir.commands import Execute, TimedCommand
from vrts.scene.default import robot_alone

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


@settings(max_examples=15)
@given(st.floats(0.0, END))
def test_what_is_cut_and_continued_was_never_cut(time_s: float) -> None:
    again = advance(truncate(WHOLE, time_s), WHOLE.until_s)
    assert again.events == WHOLE.events
    assert again.motions == WHOLE.motions
    assert again.timeline.segments == WHOLE.timeline.segments
    assert (again.ending, again.ended_s) == (WHOLE.ending, WHOLE.ended_s)
    for k in range(5):
        same_state(again, WHOLE, k * END / 5)


@settings(max_examples=15)
@given(st.floats(0.0, END), st.floats(0.0, 1.0))
def test_a_shorter_run_is_the_beginning_of_a_longer_one(time_s: float, part: float) -> None:
    run = advance(start(CARRY, CANS), time_s, [TimedCommand(0.0, Execute("main"))])
    known = tuple(event for event in WHOLE.events if event.time_s <= run.horizon_s)
    assert run.events == known
    same_state(run, WHOLE, part * run.horizon_s)


@settings(max_examples=15)
@given(st.lists(st.floats(0.0, END), min_size=1, max_size=4))
def test_growing_in_steps_is_growing_at_once(times: list[float]) -> None:
    run = advance(start(CARRY, CANS), 0.0, [TimedCommand(0.0, Execute("main"))])
    for time_s in sorted(times):
        run = advance(run, time_s)
    run = advance(run, WHOLE.until_s)
    assert run.events == WHOLE.events
    assert run.timeline.segments == WHOLE.timeline.segments


@settings(max_examples=40)
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
    times = [event.time_s for event in run.events]
    assert times == sorted(times)


@settings(max_examples=20)
@given(PROGRAMS, st.floats(0.0, 1.0))
def test_any_program_can_be_cut_anywhere(body: str, part: float) -> None:
    whole = execute(compiled(program(body)), robot_alone())
    again = advance(truncate(whole, part * whole.horizon_s), whole.until_s)
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
