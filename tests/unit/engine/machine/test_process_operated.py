"""The operator and the process control program."""

from tests.support_engine import driven, lines, main, refused
from vrts.engine.run import Run
from vrts.ir.commands import (
    AbortProcess,
    EndProcess,
    ForceSignals,
    ProceedProcess,
    RetryProcess,
    StartProcess,
)


def pc(lines_of_program: str) -> str:
    return f".PROGRAM watch\n{lines_of_program}\n.END\n"


def count(run: Run, time_s: float) -> float:
    value = run.at(time_s).variables["n"]
    assert isinstance(value, float)
    return value


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_the_operator_starts_and_stops_it() -> None:
    watch = main("DELAY 1", ".PROGRAM watch\nn = 0\nDO\nn = n+1\nWAIT\nUNTIL SIG(2001)\n.END\n")
    run = driven(
        watch,
        9.0,
        (1.0, StartProcess("watch")),
        (1.5, StartProcess("watch")),
        (2.0, AbortProcess()),
        (3.0, AbortProcess()),
        (4.0, ProceedProcess()),
        (5.0, EndProcess()),
        (6.0, ForceSignals((2001,))),
    )
    assert refused(run) == [
        "Process control program executing",
        "No program is executing",
    ]
    counts = [count(run, t) for t in (1.9, 2.5, 3.9, 5.5, 7.0, 8.0)]
    assert counts[1] == counts[2] > counts[0]
    assert counts[3] > counts[2]
    assert counts[4] == counts[5] > counts[3]
    state = run.at(9.0).process
    assert state is not None
    assert state.status.value == "completed"


def test_the_operator_may_retry_a_step_that_failed() -> None:
    text = main("x = 0\nPCEXECUTE watch\nWAIT TIMER(0) > 1\nx = 2\nDELAY 3", pc("TYPE 6/x"))
    run = driven(text, 5.0, (2.0, RetryProcess()))
    assert texts(run) == ["3"]
