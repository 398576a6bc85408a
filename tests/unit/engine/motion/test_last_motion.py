"""The arm still moves when the last step is done: what happens then, happens."""

import pytest

from tests.support_engine import TACC, TICK, driven, main, of_kind, runs, words
from vrts.engine.memory.events import SignalChanged
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.scene.model import FaultKind, PlannedFault, Region, Scenario, Sensor

LAST = "MOVE #PPOINT(150,-90,90,0,0,0)"
STOP = Scenario(faults=(PlannedFault(1.0, FaultKind.EMERGENCY_STOP),))


def both(body: str, more: str, scenario: Scenario) -> list[Run]:
    """Run to the end, and as a controller that goes on."""
    return [
        runs(body, more, scenario),
        driven(main(body, more), 5.0, scenario=scenario),
    ]


def test_an_emergency_stop_ends_the_run_with_an_error() -> None:
    for run in both(LAST, "", STOP):
        assert run.motions[0].cut
        assert run.motions[0].end_s == pytest.approx(1.0 + TACC, abs=TICK)
        assert words(run) == ["Robot power off"]
        assert run.ending is Ending.ERROR


def test_after_the_arm_has_come_to_rest_it_changes_nothing() -> None:
    late = Scenario(faults=(PlannedFault(3.0, FaultKind.EMERGENCY_STOP),))
    for run in both(LAST, "", late):
        assert run.ending is Ending.COMPLETED
        assert words(run) == []


def test_the_process_program_still_runs() -> None:
    guard = ".PROGRAM guard\nWAIT TIMER(0) > 0.5\nBRAKE\nSIGNAL 1\n.END\n"
    for run in both(f"PCEXECUTE guard\n{LAST}", guard, Scenario()):
        assert run.motions[0].cut
        assert [e.signal for e in of_kind(run, SignalChanged)] == [1]


def test_sensors_still_see() -> None:
    sensor = Sensor(1005, Region((-2.0, -2.0, -2.0), (-0.1, 2.0, 2.0)), ("tool",))
    scenario = Scenario(sensors=(sensor,))
    body = "MOVE #PPOINT(0,-45,135,0,60,0)\nBREAK\nMOVE #PPOINT(150,-45,135,0,60,0)"
    for run in both(body, "", scenario):
        assert [e.on for e in of_kind(run, SignalChanged)] == [True]
