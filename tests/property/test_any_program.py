"""Random steps under random commands: nothing raises, nothing jumps, all can be cut."""

from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_engine import main
from tests.support_programs import ALONE, compiled
from vrts.engine.controller import advance, execute, start, truncate
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.ir.commands import (
    Abort,
    AbortProcess,
    Answer,
    Command,
    DeletePrograms,
    DeleteVariables,
    Do,
    EndCycle,
    EndProcess,
    Execute,
    ForceSignals,
    Kill,
    Load,
    MonitorSpeed,
    Panic,
    Proceed,
    ProceedProcess,
    Retry,
    RetryProcess,
    RunSteps,
    SetVariable,
    StartProcess,
    TimedCommand,
)
from vrts.scene.model import FaultKind, Limits, PlannedFault, Scenario

UNTIL = 8.0  # [s]
SMALL = Limits(statements=3000, time_s=60.0)

# steps, with a bar between them
STEPS = """
MOVE a | MOVES b | MOVE c | MOVES d | APPRO a, 50 | APPROS b, -20 | DEPART 30 | DEPARTS 10 |
DRIVE 1, 10 | DRIVE 3, -20, 40 | DRAW 10, 20 | ALIGN | READY | DELAY 0.1 | BREAK | BRAKE |
SPEED 30 | SPEED 70 ALWAYS | SPEED 100 MMPS | COARSE | NONULL ALWAYS | SINGLE ALWAYS | MULTIPLE |
RIGHTY | LEFTY | FLIP | NOFLIP | ABOVE | BELOW | OPENI | CLOSE | OPEN | CLOSEI | RELAX | RELAXI |
GRASP 5, 99 | MOVET a, 10 | TOOL TRANS(0,0,50,90,-90,0) | TOOL NULL | BASE 10,0,0,5 | BASE |
SIGNAL 1, -2 | RESET | BITS 1,4 = n | WAIT | WAIT SIG(1001) | REACT 1001, sub |
REACTI 1002, sub, 5 | REACTI 1003 | IGNORE 1001 | LOCK 3 | LOCK 0 | REACTE err | REACTE |
PCEXECUTE pc, 2 | PCABORT | PCEND | TYPE n | PROMPT n | n = n+1 | x = 1/n | SET p = HERE |
MOVE p | MOVES p | SET #q = #DEST | MOVE #q | CALL sub | ENABLE CP | DISABLE CP | ENABLE DRY.RUN |
DISABLE DRY.RUN | DISABLE POWER | ENABLE POWER | ENABLE TRACE | DISABLE TRACE |
PARAMETER SPEED.MAX = 60 | TIMER 1 = 0 | WAIT TIMER(1) > 0.5 | STOP | PAUSE | HALT | GOTO 99 |
DAC 1 = 5 | HERE p | SET p = DEST | m[n] = n | DURATION 1 | DURATION 0.5 ALWAYS | ACCEL 50, 25 |
ACCEL 300 ALWAYS | SPEED 100, 20 | NEST | DRAW ,,-30 | MOVE p:RX(20) | MOVES p:RY(-30) |
APPROS p, 0.01 | SPEED 40 MONITOR | WAIT TAS(n,1)
"""
SUB_STEPS = """
MOVE a | MOVES b | n = n+2 | TYPE n | BREAK | RETURN | REACT 1001, sub | SPEED 20 | x = 1/0 |
PAUSE
"""
PROCESS_STEPS = """
WAIT | BRAKE | n = n+1 | SIGNAL 1 | REACTI 1002, pcs | WAIT SIG(1001) | TYPE n | x = 1/n |
PROMPT n
"""


def steps(text: str) -> st.SearchStrategy[str]:
    return st.sampled_from([step.strip() for step in text.split("|")])


COMMANDS: st.SearchStrategy[Command] = st.sampled_from(
    [
        Abort(),
        AbortProcess(),
        Answer("3"),
        Answer("bad"),
        DeletePrograms(("sub",)),
        DeleteVariables(("n", "p")),
        Do(compiled(".PROGRAM do.it\nREADY\n.END\n")),
        Do(compiled(".PROGRAM do.it\nx = 1/0\n.END\n")),
        EndCycle(),
        EndProcess(),
        Execute("main"),
        ForceSignals((-1001, 1002)),
        ForceSignals((-1002, 1003, -1003)),
        ForceSignals((1001,)),
        Kill(),
        Load(compiled(".PROGRAM sub\nn = 7\n.END\n")),
        MonitorSpeed(100),
        MonitorSpeed(30),
        Panic(),
        Proceed(),
        ProceedProcess(),
        Retry(),
        RetryProcess(),
        RunSteps(2, over_calls=True),
        RunSteps(3),
        SetVariable("n", (), 0.0),
        SetVariable("n", (), None),
        StartProcess("pc", 3),
    ]
)


def text_of(body: list[str], sub: list[str], err: list[str], pc: list[str], back: str) -> str:
    parts = {"sub": sub, "err": [*err, back], "pc": pc, "pcs": ["n = 5"]}
    more = "".join("\n".join([f".PROGRAM {name}", *rows, ".END\n"]) for name, rows in parts.items())
    return main("\n".join(["n = 0", *body, "99 n = n+1"]), more)


def timed(ticks: int, command: Command) -> TimedCommand:
    return TimedCommand(0.02 * ticks, command)


def scenario(
    inputs: list[tuple[int, int, bool]], answers: list[str], speed: float, stop: int | None
) -> Scenario:
    faults = () if stop is None else (PlannedFault(0.1 * stop, FaultKind.EMERGENCY_STOP),)
    return Scenario(
        inputs=tuple(sorted((0.02 * tick, signal, on) for tick, signal, on in inputs)),
        answers=tuple(answers),
        monitor_speed=speed,
        faults=faults,
        limits=SMALL,
    )


TICKS = st.integers(0, 350)
PROGRAMS = st.builds(
    text_of,
    st.lists(steps(STEPS), min_size=1, max_size=14),
    st.lists(steps(SUB_STEPS), max_size=4),
    st.lists(steps(SUB_STEPS), max_size=2),
    st.lists(steps(PROCESS_STEPS), max_size=5),
    st.sampled_from(["RETURNE", "RETURN", ""]),
)
TIMED = st.lists(st.builds(timed, TICKS, COMMANDS), max_size=8)
SCENARIOS = st.builds(
    scenario,
    st.lists(st.tuples(TICKS, st.integers(1001, 1003), st.booleans()), max_size=5),
    st.lists(st.sampled_from(["1", "bad", ""]), max_size=3),
    st.sampled_from([100.0, 47.0, 30.0]),
    st.none() | st.integers(0, 60),
)


def is_smooth(run: Run) -> None:
    """Check that neither positions nor velocities jump, and that motions follow one another."""
    for before, after in pairwise(run.timeline.segments):
        t = before.end_s - before.start_s
        assert before.end_s == after.start_s
        for a, b in zip(before.coefficients[:6], after.coefficients[:6], strict=True):
            here = sum(c * t**k for k, c in enumerate(a))
            speed = sum(k * c * t ** (k - 1) for k, c in enumerate(a) if k)
            assert abs(here - b[0]) < 1e-9
            assert abs(speed - (b[1] if len(b) > 1 else 0.0)) < 1e-6
    for before, after in pairwise(run.motions):
        assert before.end_s <= after.start_s + 1e-9


def can_be_asked(run: Run) -> None:
    """Ask for everything that a state knows, at many times."""
    for k in range(21):
        state = run.at(run.horizon_s * (k / 20))
        assert len(state.configuration) == 6
        assert state.monitor_speed > 0.0
        known = (state.variables, state.locals, state.call_stack, state.process_stack)
        assert all(part is not None for part in known)
        assert state.robot is None or state.robot.program
        assert state.output == "" or state.output in run.output
        assert state.poses is not None


@given(PROGRAMS, SCENARIOS)
@settings(max_examples=examples(80), deadline=None)
def test_any_program_ends_and_moves_smoothly(text: str, happens: Scenario) -> None:
    run = execute(compiled(text, "val2+"), ALONE, happens)
    assert run.ending not in (Ending.RUNNING, Ending.NOT_STARTED)
    is_smooth(run)
    can_be_asked(run)


@given(PROGRAMS, SCENARIOS, TIMED, TICKS)
@settings(max_examples=examples(80), deadline=None)
def test_any_operated_program_can_be_cut_and_continued(
    text: str, happens: Scenario, commands: list[TimedCommand], cut: int
) -> None:
    begin = start(compiled(text, "val2+"), ALONE, happens)
    first = TimedCommand(0.0, Execute("main"))
    run = advance(begin, UNTIL, [first, *commands])
    is_smooth(run)
    can_be_asked(run)
    at = 0.02 * cut
    later = [command for command in commands if command.time_s > at]
    again = advance(truncate(run, at), UNTIL, later)
    assert again.events == run.events
    assert again.timeline.segments == run.timeline.segments
    assert again.at(UNTIL).variables == run.at(UNTIL).variables
