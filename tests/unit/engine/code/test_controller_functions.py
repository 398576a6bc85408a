"""Functions that ask the controller: states of robot and programs, clock, memory."""

import pytest

from tests.support_engine import lines, runs
from vrts.engine.run import Run

MORE = ".PROGRAM p\nWAIT\nWAIT SIG(2001)\n.END\n.PROGRAM q\n.END\n"


def texts(run: Run) -> list[str]:
    return [text for _, text in lines(run)]


def test_state_tells_whether_the_arm_moves_or_slows_down() -> None:
    run = runs(
        "TYPE STATE(1), STATE(2), STATE(9)\nMOVE #PPOINT(150,-90,90)\nWAIT TIMER(0) > 1\n"
        "TYPE STATE(2)\nBRAKE\nTYPE STATE(2)\nBREAK\nTYPE STATE(2)"
    )
    assert texts(run) == ["7 0 0", "1", "2", "0"]


def test_status_tells_what_a_program_does() -> None:
    run = runs(
        'TYPE STATUS("main"), STATUS("p"), STATUS("nosuch")\nPCEXECUTE p\nTYPE STATUS("P")\n'
        'WAIT TIMER(0) > 1\nTYPE STATUS("p")\nPCABORT\nTYPE STATUS("p")\nTYPE STATUS("q")',
        MORE,
    )
    first, started, waiting, aborted, idle = texts(run)
    assert first == "1 0 -1"
    assert started == "1"
    assert waiting in ("1", "3")
    assert aborted == "2"
    assert idle == "0"


def test_nobody_touches_the_pendant() -> None:
    assert texts(runs("TYPE PENDANT(1), PENDANT(50)")) == ["0 0"]


def test_free_memory_becomes_less() -> None:
    body = "TYPE /F0.4, FREE(0)\nFOR i = 1 TO 500\nm[i] = i\nEND\nTYPE /F0.4, FREE(0)"
    before, after = (float(text) for text in texts(runs(body, dialect="vplus")))
    assert 99.0 < after < before <= 100.0


def test_the_clock_of_the_controller_starts_at_a_fixed_instant() -> None:
    run = runs("TYPE $TIME()\nWAIT TIMER(0) > 62\nTYPE $TIME()\nTYPE TIME()", dialect="vplus")
    assert texts(run) == ["01-JAN-88 00:00:00", "01-JAN-88 00:01:02", "62"]
    assert texts(runs("TYPE $DATE(1)", dialect="as")) == ["01-JAN-1988"]


@pytest.mark.parametrize(
    ("location", "bits"),
    [
        ("a", 0),
        ("TRANS(3000,0,0,90,90,0)", 16384),
        ("TRANS(10,0,0,90,90,0)", 8192),
        ("#PPOINT(170)", 1),
        ("#PPOINT(170,100,0,-270)", 11),
        ("#PPOINT(0,-90,90)", 0),
    ],
)
def test_inrange_names_what_is_wrong(location: str, bits: int) -> None:
    assert texts(runs(f"TYPE INRANGE({location})")) == [str(bits)]


def test_inrange_agrees_with_move() -> None:
    for x in range(200, 1800, 100):
        place = f"TRANS({x},300,-200,90,90,0)"
        reachable = texts(runs(f"TYPE INRANGE({place})")) == ["0"]
        assert (runs(f"MOVE {place}").findings == ()) is reachable


def test_last_and_defined() -> None:
    run = runs(
        "TYPE LAST(m[]), DEFINED(m[]), DEFINED(m[3])\nm[3] = 1\nm[7] = 2\n"
        "TYPE LAST(m[]), DEFINED(m[]), DEFINED(m[3]), DEFINED(m[4])",
        dialect="vplus",
    )
    assert texts(run) == ["-1 0 0", "7 -1 -1 0"]


def test_priority_is_that_of_the_program() -> None:
    run = runs("TYPE PRIORITY\nLOCK 20\nTYPE PRIORITY\nLOCK\nTYPE PRIORITY", dialect="val2+")
    assert texts(run) == ["0", "20", "0"]


def test_tool_base_and_null() -> None:
    run = runs(
        "TOOL TRANS(1,2,3,90,-90,0)\nBASE 10,20\nTYPE DX(TOOL), DY(TOOL), DZ(TOOL)\n"
        "TYPE DX(BASE), DY(BASE), DZ(BASE)\nTYPE DX(NULL), DY(NULL)"
    )
    assert texts(run) == ["1 2 3", "10 20 0", "0 0"]
