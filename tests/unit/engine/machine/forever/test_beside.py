"""Both programs together: what ends although it looks endless, and what never ends."""

import pytest

from tests.support_engine import runs
from tests.support_programs import codes
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run
from vrts.scene.model import Limits, Region, Scenario, Sensor

POLLS = "n = 1\nWAIT"  # what an ordinary watchdog does, tick by tick
COUNTS = "j = j+1\nWAIT"
DATA = ".REALS\nj 0\nk 0\n.END\n"


def beside(main: str, watch: str, more: str = "", dialect: str = "val2+") -> Run:
    """Run a program beside a process control program `b`."""
    return runs(main, f".PROGRAM b\n{watch}\n.END\n{more}{DATA}", dialect=dialect)


ENDS = [
    ("PCEXECUTE b, -1\nDELAY 5\nMOVE a", POLLS),
    ("PCEXECUTE b, -1\nDELAY 5\nDELAY 5\nMOVE a", POLLS),
    ("PCEXECUTE b, -1\nDELAY 20", POLLS),
    ("PCEXECUTE b, -1\nSPEED 5\nMOVE a\nBREAK", POLLS),
    ("PCEXECUTE b, -1\nPARAMETER HAND.TIME = 20\nOPENI\nMOVE a", POLLS),
    ("PCEXECUTE b, -1\nMOVE a\nMOVE b\nWAIT DISTANCE(HERE,b) < 1", POLLS),
    ('PCEXECUTE b, 200\nDO\nWAIT\nUNTIL STATUS("b") == 0', POLLS),
    ('PCEXECUTE b, 200\nWAIT STATUS("b") == 0', POLLS),
    ("PCEXECUTE b\nWAIT SIG(2001)", "TIMER 1 = 0\nWAIT TIMER(1) > 300\nSIGNAL 2001"),
    ("PCEXECUTE b\nDELAY 40\nWAIT SIG(2001)", "TIMER 1 = 0\nWAIT TIMER(1) > 30\nSIGNAL 2001"),
    ("PCEXECUTE b, -1\nWAIT SIG(2001)", f"{COUNTS}\nIF j == 2000 THEN\nSIGNAL 2001\nEND"),
    (
        "PCEXECUTE b, -1\nDO\nWAIT\nUNTIL SIG(2001)",
        f"{COUNTS}\nIF j == 2000 THEN\nBITS 2001, 2 = 3\nEND",
    ),
    ("k = 2001\nPCEXECUTE b, -1\nWAIT SIG(2001)", f"{COUNTS}\nIF j == 200 THEN\nSIGNAL k\nEND"),
    ("n = 0\nPCEXECUTE b, -1\nWAIT n == 1", f"{COUNTS}\nIF j > 100 THEN\nx = TAS(n,1)\nEND"),
    (
        '$s = "a,b"\nPCEXECUTE b, -1\nWAIT $s <> "a,b"',
        f'{COUNTS}\nIF j > 99 THEN\n$t = $DECODE($s,",",0)\nEND',
    ),
    ("n = 0\nPCEXECUTE b, -1\nCALL w(n)", f"{COUNTS}\nIF j > 100 THEN\nCALL s(n)\nEND"),
    ("n = 0\nPCEXECUTE b, -1\nWAIT n == 1", f'{COUNTS}\nIF j > 100 THEN\nCALLS "s1"\nEND'),
    ("n = 0\nPCEXECUTE b, -1\nWAIT n == 1", f"REACTE e\n{COUNTS}\nx = 1/(100-j)"),
    (
        "n = 0\nPCEXECUTE b, -1\nWAIT n == 1",
        f"{COUNTS}\nIF j > 100 THEN\nCALL r1\nx = 1\nn = 1\nEND",
    ),
    (
        "n = 0\nREACT 2002, s1\nPCEXECUTE b, -1\nWAIT n == 1",
        f"{COUNTS}\nIF j > 100 THEN\nSIGNAL 2002\nEND",
    ),
    (
        "REACT 2002, h\nPCEXECUTE b, -1\nWAIT SIG(2001)",
        f"{COUNTS}\nIF j > 100 THEN\nSIGNAL 2002\nEND",
    ),
    (
        "REACT 2002, h\nPCEXECUTE b, -1\n10 MOVE a\nMOVE c\nGOTO 10",
        f"{COUNTS}\nIF j > 999 THEN\nSIGNAL 2002\nEND",
    ),
    ("PCEXECUTE b, -1\nWAIT PARAMETER(HAND.TIME) == 3", f"{COUNTS}\nPARAMETER HAND.TIME = j MOD 7"),
    ("PCEXECUTE b, -1\nWAIT SPEED(1) < 50", f"{COUNTS}\nIF j > 100 THEN\nSPEED 30 MONITOR\nEND"),
    ("PCEXECUTE b, -1\nWAIT SWITCH(TRACE)", f"{COUNTS}\nIF j > 99 THEN\nENABLE TRACE\nEND"),
    (
        "PCEXECUTE b\n10 WAIT\nIF SIG(2001) GOTO 20\nGOTO 10\n20 READY",
        "TIMER 1 = 0\nWAIT TIMER(1) > 50\nSIGNAL 2001",
    ),
    ("PCEXECUTE b\nDO\nPROMPT x\nWAIT\nUNTIL x == 7", "WAIT"),
    (
        "PCEXECUTE b, 50\nCALL q(0)",
        POLLS,
        ".PROGRAM q(i)\nAUTO l[5]\nl[1] = 0\nDO\nl[1] = l[1]+1\nWAIT\nUNTIL l[1] > 300\n.END\n",
    ),
    ("n = 0\nPCEXECUTE b, -1\nWAIT TAS(n,n+1) > 100", COUNTS),
    ("n = 0\nWAIT TAS(n,n+1) > 100", POLLS),
    ('$s = "a,b,c"\nWAIT $DECODE($s,",",0)+$DECODE($s,",",1) == "c"', POLLS),
]
MORE = (
    ".PROGRAM w(x)\nWAIT x == 1\n.END\n.PROGRAM s(x)\nx = 1\n.END\n.PROGRAM s1\nn = 1\n.END\n"
    ".PROGRAM e\nn = 1\nRETURNE\n.END\n.PROGRAM r1\nRETURN 1\n.END\n.PROGRAM h\nHALT\n.END\n"
)


@pytest.mark.parametrize("case", ENDS, ids=lambda case: str(case[0])[:40].replace("\n", "; "))
def test_what_may_still_happen_is_waited_for(case: tuple[str, ...]) -> None:
    body, watch, *more = case
    text = f".PROGRAM b\n{watch}\n.END\n{MORE}{''.join(more)}{DATA}"
    scenario = Scenario(answers=(*("1",) * 60, "7"))
    run = runs(body, text, scenario, dialect="val2+")
    assert run.ending in (Ending.COMPLETED, Ending.HALTED)
    assert not {"V502", "V503", "V504", "V505", "V511"} & set(codes(run))


NEVER = [
    ("PCEXECUTE b, -1\nWAIT SIG(2001)", "", "V502"),
    ("PCEXECUTE b, -1\nWAIT SIG(2001)", POLLS, "V502"),
    ("PCEXECUTE b, -1\nWAIT SIG(2001)", COUNTS, "V502"),
    ("PCEXECUTE b, -1\nWAIT SIG(2001)", "IF TIMER(1) > 9 THEN\nBRAKE\nEND\nWAIT", "V502"),
    ("PCEXECUTE b, -1\nWAIT SIG(2001)", "WAIT SIG(1001)\nSIGNAL 2001", "V502"),
    ("PCEXECUTE b, -1\nPROMPT x", POLLS, "V504"),
    ("PCEXECUTE b, -1\nWAIT DISTANCE(HERE,a) < 1", COUNTS, "V502"),
    ("PCEXECUTE b, -1\nDO\nWAIT\nUNTIL n == 9", f"{COUNTS}\nIF j == 1E6 THEN\nj = 0\nEND", "V503"),
    ("PCEXECUTE b, -1\n10 MOVE a\nMOVE c\nGOTO 10", "WAIT TIMER(1) > 5\nTIMER 1 = 0", "V503"),
    ("PCEXECUTE b, -1\n10 DELAY 1\nBREAK\nGOTO 10", POLLS, "V503"),
    ("n = 0\n10 n = n+1\nWAIT\nGOTO 10", "", "V503"),
    ("WAIT DISTANCE(HERE,a) < 1", "", "V502"),
    (
        "LOCK 5\nREACT 2002, s1\nPCEXECUTE b, -1\nWAIT n == 1",
        "SIGNAL 2002\nWAIT\nSIGNAL -2002\nWAIT",
        "V502",
    ),
]


@pytest.mark.parametrize("case", NEVER, ids=lambda case: f"{case[0][-30:]} | {case[1][:30]}")
def test_what_never_ends_ends_early(case: tuple[str, str, str]) -> None:
    body, watch, code = case
    run = beside(f"n = 0\n{body}", watch, MORE)
    assert codes(run) == [code]
    assert run.ending is Ending.LIMIT
    assert run.ended_s is not None
    assert run.ended_s < 10.0


def test_signals_that_go_on_and_off_by_themselves_repeat_too() -> None:
    run = runs("10 PULSE 3, 0.2\nWAIT\nGOTO 10", dialect="as")
    assert codes(run) == ["V503"]
    assert runs("DLYSIG 3, 40\nWAIT SIG(3)", dialect="as").ending is Ending.COMPLETED


def test_a_sensor_ends_a_wait_while_the_arm_moves() -> None:
    sensor = Sensor(1005, Region((0.7, -0.5, -0.5), (1.1, 0.5, 0.5)), ("tool",))
    more = f".PROGRAM b\n{POLLS}\n.END\n"
    body = "PCEXECUTE b, -1\nSPEED 5\nMOVE a\nWAIT SIG(1005)"
    assert runs(body, more, Scenario(sensors=(sensor,))).ending is Ending.COMPLETED


def test_cycles_that_are_counted_come_to_an_end() -> None:
    run = beside('PCEXECUTE b, 30\n10 WAIT\nIF STATUS("b") <> 0 GOTO 10', "WAIT\nn = 1")
    assert run.ending is Ending.COMPLETED


def test_a_limit_is_told_once_of_both_programs() -> None:
    scenario = Scenario(limits=Limits(time_s=20.0))
    more = ".PROGRAM b\nx = RANDOM\nWAIT\n.END\n"
    run = runs("PCEXECUTE b, -1\n10 x = RANDOM\nWAIT\nGOTO 10", more, scenario)
    assert codes(run) == ["V511"]


def test_a_limit_of_steps_tells_whose_they_are() -> None:
    more = ".PROGRAM b\n10 GOTO 10\n.END\n"
    run = runs(
        "PCEXECUTE b\n10 x = RANDOM\nWAIT\nGOTO 10", more, Scenario(limits=Limits(statements=5000))
    )
    (found,) = run.findings
    assert found.headline == "`b` is still running beside `main` after 5,000 steps"
    assert "of the steps are its own" in found.notes[0]
