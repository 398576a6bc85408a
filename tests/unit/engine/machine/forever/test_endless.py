"""Programs that never end are found out; innocent ones are not."""

import pytest

from tests.support_engine import of_kind, runs
from vrts.base.diagnostic import Diagnostic
from vrts.engine.memory.events import ProgramEnded
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.scene.model import FaultKind, PlannedFault, Region, Scenario, Sensor

ENDLESS = [
    "10 GOTO 10",
    "i = 0\nWHILE i < 10 DO\nn = 5\nEND",
    "DO\nWAIT\nUNTIL SIG(1001)",
    "10 MOVE a\nMOVE b\nGOTO 10",
    "10 MOVE a\nBREAK\nMOVES b\nBREAK\nGOTO 10",
    "10 OPENI\nCLOSEI\nGOTO 10",
    "10 DELAY 1\nGOTO 10",
    "10 SIGNAL 1\nWAIT\nSIGNAL -1\nWAIT\nGOTO 10",
    "n = 0\n10 n = (n+1) MOD 7\nWAIT\nGOTO 10",
    "n = 0\n10 n = (n+1) MOD 7\nGOTO 10",
    '$s = "ab"\n10 $s = $MID($s,2,1)+$MID($s,1,1)\nGOTO 10',
    '10 TYPE "still here"\nGOTO 10',
    "10 CALL p\nGOTO 10",
    "REACT 1003, p\n10 WAIT\nGOTO 10",
    "10 SPEED 50\nMOVE a\nMOVE b\nGOTO 10",
]
FINE = [
    ("DO\nWAIT\nUNTIL TIMER(0) > 20", 600),
    ("n = 0\nDO\nn = n+1\nWAIT\nUNTIL n > 900", 600),
    ("FOR i = 1 TO 500\nMOVE #PPOINT(1)\nMOVE #PPOINT(2)\nEND", 600),
    ("DO\nx = RANDOM\nUNTIL x > 0.999", 600),
    ("m[1] = 0\nDO\nm[1] = m[1]+1\nk = 1\nUNTIL m[1] > 5000", 600),
    ("SET p = NULL\nDO\nSET p = SHIFT(p BY 1)\nUNTIL DX(p) > 3000", 600),
    ("FOR i = 1 TO 40\nDRIVE 1, 1\nDRIVE 1, -1\nBREAK\nEND", 600),
    ("FOR i = 1 TO 3000\nn = 1\nEND", 600),
    ('$s = ""\nDO\n$s = $s+"x"\nWAIT\nUNTIL LEN($s) > 100', 600),
    ("CALL deep(80)", 600),
    ("BITS 1,8 = 0\nDO\nBITS 1,8 = BITS(1,8)+1\nWAIT\nUNTIL BITS(1,8) == 255", 600),
    ("DO\nTIMER 1 = TIMER(1)+0.5\nWAIT\nUNTIL TIMER(1) > 40", 600),
    ("DAC 1 = 0\nFOR i = 1 TO 2000\nDAC 1 = i\nWAIT\nEND", 600),
]
MORE = ".PROGRAM p\nx = 1\n.END\n.PROGRAM deep(n)\nWAIT\nIF n > 0 THEN\nCALL deep(n-1)\nEND\n.END\n"


def errors(run: Run) -> list[str]:
    return [finding.rule.code for finding in run.findings if finding.is_error]


def found(run: Run) -> Diagnostic:
    (finding,) = (finding for finding in run.findings if finding.is_error)
    return finding


@pytest.mark.parametrize("body", ENDLESS)
def test_a_program_that_repeats_its_state_is_endless(body: str) -> None:
    run = runs(body, MORE)
    assert errors(run) == ["V503"]
    assert run.ending is Ending.LIMIT
    (ended,) = of_kind(run, ProgramEnded)
    assert ended.time_s < 120.0
    assert "steps" in found(run).notes[0] or "step" in found(run).notes[0]


@pytest.mark.parametrize(("body", "most_s"), FINE)
def test_a_program_that_ends_is_let_go_on(body: str, most_s: float) -> None:
    run = runs(body, MORE)
    assert errors(run) == []
    assert run.ending is Ending.COMPLETED
    assert run.ended_s is not None
    assert run.ended_s < most_s


def test_the_finding_says_where_and_how_long_it_takes() -> None:
    finding = found(runs("i = 0\nWHILE i < 10 DO\nDELAY 1\nBREAK\nEND"))
    assert finding.data["period_s"] == pytest.approx(1.0, abs=0.2)
    assert finding.primary is not None
    assert finding.primary.span.text in ("WHILE i < 10 DO", "DELAY 1", "BREAK", "END")
    assert "steps 2 to 5" in finding.notes[0]


def test_an_input_that_is_still_to_come_ends_the_loop() -> None:
    run = runs("DO\nWAIT\nUNTIL SIG(1001)", scenario=Scenario(inputs=((400.0, 1001, True),)))
    assert errors(run) == []
    assert run.ended_s == pytest.approx(400.0, abs=0.1)


def test_after_the_last_input_the_loop_is_endless() -> None:
    run = runs("DO\nWAIT\nUNTIL SIG(1002)", scenario=Scenario(inputs=((30.0, 1001, True),)))
    assert errors(run) == ["V503"]
    assert run.ended_s is not None
    assert 30.0 < run.ended_s < 60.0


def test_a_fault_that_is_still_to_come_may_end_it_too() -> None:
    fault = PlannedFault(200.0, FaultKind.INPUT_STUCK, 1001, on=True)
    assert errors(runs("DO\nWAIT\nUNTIL SIG(1001)", scenario=Scenario(faults=(fault,)))) == []


def test_a_process_program_that_counts_ends_the_loop() -> None:
    more = ".PROGRAM watch\nn = n+1\nWAIT\n.END\n"
    run = runs("n = 0\nPCEXECUTE watch, -1\nDO\nWAIT\nUNTIL n > 900", more)
    assert errors(run) == []


def test_a_signal_that_a_sensor_gives_ends_the_loop() -> None:
    here = Region((0.7, -0.5, -0.5), (1.1, 0.5, 0.5))
    body = "MOVE #PPOINT(0,-90,90,0,0,0)\nMOVE a\nDO\nWAIT\nUNTIL SIG(1005)"
    run = runs(body, scenario=Scenario(sensors=(Sensor(1005, here, ("tool",)),)))
    assert errors(run) == []


STUCK = [
    ("WAIT SIG(1001)", "V502"),
    ("MOVE a\nWAIT SIG(1001)", "V502"),
    ("n = 0\nWAIT n == 1", "V502"),
    ("PCEXECUTE watch\nWAIT SIG(1001)", "V502"),
    ("PROMPT x", "V504"),
]


@pytest.mark.parametrize(("body", "code"), STUCK)
def test_a_wait_that_nothing_ends(body: str, code: str) -> None:
    run = runs(body, ".PROGRAM watch\nWAIT SIG(1002)\n.END\n")
    assert errors(run) == [code]
    assert run.ending is Ending.LIMIT
    assert run.ended_s is not None
    assert run.ended_s < 5.0


NOT_STUCK = [
    ("WAIT TIMER(0) > 50", Scenario()),
    ("WAIT SIG(1001)", Scenario(inputs=((300.0, 1001, True),))),
    ("MOVE a\nWAIT DISTANCE(HERE, a) < 1", Scenario()),
    ("PULSE 3, 40\nWAIT SIG(-3)", Scenario()),
    ("OPENI\nCLOSE\nMOVE a\nWAIT HAND == 0", Scenario()),
]


@pytest.mark.parametrize(("body", "scenario"), NOT_STUCK)
def test_a_wait_that_something_ends(body: str, scenario: Scenario) -> None:
    dialect = "as" if "PULSE" in body else "val2"
    run = runs(body, scenario=scenario, dialect=dialect)
    assert errors(run) == []
    assert run.ending is Ending.COMPLETED
