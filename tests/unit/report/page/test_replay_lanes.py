"""Lanes keep the robot program, the process control program and signals apart."""

import pytest

from tests.support_runs import scene
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import compile_source
from vrts.report.page.replay_data import run_data
from vrts.report.page.replay_lanes import process_lines, robot_lines, signal_spans

TWO = SourceFile(
    "two.v2",
    """.PROGRAM main()
    PCEXECUTE lamp
    DELAY 1
    SIGNAL 2
    DELAY 1
    SIGNAL -2
.END
.PROGRAM lamp()
    SIGNAL 1
.END
""",
)


def executed(source: SourceFile) -> Run:
    compilation = compile_source(source)
    assert compilation.module is not None, compilation.diagnostics
    return execute(compilation.module, scene())


def test_two_programs_have_a_lane_each() -> None:
    run = executed(TWO)
    assert {line for _, line in process_lines(run, TWO)} == {9}
    of_robot = {line for _, line in robot_lines(run, TWO)}
    assert 9 not in of_robot
    assert {4, 6} <= of_robot
    rows = run_data(run, TWO)["events"]
    assert isinstance(rows, list)
    marked = [row for row in rows if row.get("process")]  # pyright: ignore[reportUnknownVariableType, reportUnknownMemberType]
    assert [(row["text"], row["line"]) for row in marked if row["kind"] == "signal"] == [  # pyright: ignore[reportUnknownVariableType]
        ("signal 1 on", 9)
    ]


def test_a_signal_left_on_is_on_to_the_end() -> None:
    run = executed(TWO)
    spans = signal_spans(run)
    assert list(spans) == [1, 2]
    ((start, end),) = spans[1]
    assert end == round(run.horizon_s, 3)
    ((on, off),) = spans[2]
    assert start <= on < off <= end
    assert off - on == pytest.approx(1.0, abs=0.028)  # a tick


def test_one_program_has_no_second_lane() -> None:
    alone = SourceFile("one.v2", ".PROGRAM main()\n    SIGNAL 3\n.END\n")
    run = executed(alone)
    assert process_lines(run, alone) == []
    assert list(signal_spans(run)) == [3]
