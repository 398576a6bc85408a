"""Whatever is done to a moving arm, its motion stays smooth and within its limits."""

from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_engine import main
from tests.support_programs import ALONE, compiled
from vrts.engine.controller import advance, start
from vrts.engine.run import Run
from vrts.ir.commands import (
    Abort,
    Command,
    Execute,
    ForceSignals,
    MonitorSpeed,
    Panic,
    Proceed,
    Retry,
    TimedCommand,
)
from vrts.robots.kinematics.kinematics import limit_violations

MODULE = compiled(
    main(
        "REACTI 1001, away ALWAYS\nREACT 1002, note ALWAYS\nPCEXECUTE guard, -1\n"
        "10 MOVE a\nMOVES d\nMOVE b\nBREAK\nMOVES d\nMOVES c\nDRIVE 1, 20, 60\nDELAY 0.2\n"
        "SPEED 40\nMOVE a\nGOTO 10",
        ".PROGRAM away\nSET was = DEST\nMOVE was\n.END\n.PROGRAM note\nn = 1\n.END\n"
        ".PROGRAM guard\nWAIT SIG(1003)\nBRAKE\nWAIT SIG(-1003)\n.END\n",
    )
)
UNTIL = 9.0  # [s]

COMMANDS: st.SearchStrategy[Command] = st.sampled_from(
    [
        MonitorSpeed(100),
        MonitorSpeed(60),
        MonitorSpeed(25),
        Abort(),
        Proceed(),
        Retry(),
        Panic(),
        Execute("main"),
        ForceSignals((1001,)),
        ForceSignals((-1001,)),
        ForceSignals((1002,)),
        ForceSignals((-1002,)),
        ForceSignals((1003,)),
        ForceSignals((-1003,)),
    ]
)
TIMES = st.integers(1, 700).map(lambda k: 0.01 * k)
TIMED = st.lists(st.builds(TimedCommand, TIMES, COMMANDS), max_size=12)


def disturbed(commands: list[TimedCommand]) -> Run:
    first = TimedCommand(0.0, Execute("main"))
    return advance(start(MODULE, ALONE), UNTIL, [first, *commands])


@given(TIMED)
@settings(max_examples=examples(60), deadline=None)
def test_positions_and_speeds_have_no_jumps(commands: list[TimedCommand]) -> None:
    run = disturbed(commands)
    for before, after in pairwise(run.timeline.segments):
        assert before.end_s == after.start_s
        t = before.end_s - before.start_s
        for a, b in zip(before.coefficients[:6], after.coefficients[:6], strict=True):
            here = sum(c * t**k for k, c in enumerate(a))
            speed = sum(k * c * t ** (k - 1) for k, c in enumerate(a) if k)
            assert abs(here - b[0]) < 1e-9
            assert abs(speed - (b[1] if len(b) > 1 else 0.0)) < 1e-6


@given(TIMED)
@settings(max_examples=examples(40), deadline=None)
def test_joints_stay_within_ranges_and_the_arm_rests_between_motions(
    commands: list[TimedCommand],
) -> None:
    run = disturbed(commands)
    arm = run.scene.robot.arm
    for k in range(200):
        assert limit_violations(arm, run.at(k * UNTIL / 200).configuration) == ()
    for before, after in pairwise(run.motions):
        assert before.end_s <= after.start_s + 1e-9
        if before.end_s < run.horizon_s and not before.blended:
            state = run.at(before.end_s)
            assert max(map(abs, state.velocity)) < 1e-6
            assert (
                max(abs(x - y) for x, y in zip(state.configuration, before.goal, strict=True))
                < 1e-8
            )


@given(TIMED, TIMES)
@settings(max_examples=examples(40), deadline=None)
def test_commands_change_only_what_comes_after_them(
    commands: list[TimedCommand], at: float
) -> None:
    early = [command for command in commands if command.time_s <= at]
    run, plain = disturbed(commands), disturbed(early)
    later = [command.time_s for command in commands if command.time_s > at]
    until = min(later, default=UNTIL)
    for k in range(40):
        t = until * k / 40
        assert run.at(t).configuration == plain.at(t).configuration
        assert run.at(t).finished == plain.at(t).finished
