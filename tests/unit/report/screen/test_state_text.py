"""The state of a run at an instant, as the terminal shows it."""

from tests.support_saved import busy, carrying
from vrts.base.units import deg
from vrts.engine.memory.events import Grasped, Released
from vrts.engine.run import Run
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.request import Request
from vrts.report.screen.state_text import MOST_OUTPUT, state_text
from vrts.run_files.simulated import simulate


def run_of(text: str) -> Run:
    found = simulate(Request(ProgramFile(text.encode(), "main.v2"), robot_alone()))
    assert found.run is not None, found.diagnostics
    return found.run


def test_everything_about_a_can_in_the_hand() -> None:
    run = carrying().run
    assert run is not None
    begin = next(e.time_s for e in run.events if isinstance(e, Grasped))
    end = next(e.time_s for e in run.events if isinstance(e, Released))
    state = run.at(0.5 * (begin + end))
    lines = state_text(run, state).splitlines()
    assert lines[0] == f"at {state.time_s:.3f} s, {state.finished} statements finished"
    assert lines[2].startswith("  line      1")
    assert "  called     6  main 4:  CALL carry(can1_grip, base2_put)" in lines
    joints = next(line.split() for line in lines if line.startswith("  deg  "))
    assert joints[1:] == [f"{round(deg(q), 3) + 0.0:.3f}" for q in state.configuration]
    assert any(line.startswith("  hand ") and line.endswith("holds can1") for line in lines)
    assert any(line.startswith("  can1 ") and line.endswith("in the hand") for line in lines)
    assert any(line.startswith("  can2 ") and line.endswith("on table") for line in lines)
    assert "  signals all off" in lines
    assert any(line.startswith("    start = ") for line in lines)  # of the program called


def test_what_happened_to_the_system_is_told() -> None:
    run = busy().run
    assert run is not None
    text = state_text(run, run.at(run.horizon_s))
    assert "  ended   error at " in text
    assert "  process watch " in text
    assert "the operator's 60 %" in text
    assert "PARAMETER HAND.TIME = 0.1" in text
    assert '    $t[2]   = "four"' in text
    assert "  terminal\n    | pass 2\n" in text


def test_statements_are_told_apart_within_an_instant() -> None:
    run = run_of(".PROGRAM main\n  n = 1\n  n = 2\n  n = 3\n.END\n")
    values = [state_text(run, run.at_statement(k)).splitlines()[-1] for k in (2, 3, 4)]
    assert values == ["    n = 1", "    n = 2", "    n = 3"]


def test_long_output_shows_its_end() -> None:
    run = run_of('.PROGRAM main\n  FOR i = 1 TO 50\n    TYPE "line", i\n  END\n.END\n')
    lines = state_text(run, run.at(run.horizon_s)).splitlines()
    assert f"  terminal, the last {MOST_OUTPUT} of 50 lines" in lines
    assert lines[-1] == "    | line 50"
    assert sum(line.startswith("    | ") for line in lines) == MOST_OUTPUT


def test_foreign_characters_cannot_steer_the_terminal() -> None:
    run = run_of('.PROGRAM main\n  $s = $CHR(27)+"[2J"\n  TYPE $s\n.END\n')
    assert "\x1b" not in state_text(run, run.at(run.horizon_s))
