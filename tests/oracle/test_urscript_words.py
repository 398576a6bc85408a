"""BASE, FRAME, BITS, outputs that are read, strings: words used now and then, beside the run."""

import pytest

from tests.oracle.urscript.interpreter import Motion
from tests.support_urscript import carried_out, exported, joints_alike, same_motions, told_alike
from vrts.base.source import SourceFile
from vrts.dispatch.saying.table import read_table
from vrts.engine.memory.events import Printed

PLACES = """.LOCATIONS
safe              460.00    50.00   200.00    90.00    90.00     0.00
left              440.00   110.00   250.00    85.00    88.00     5.00
right             470.00   -60.00   240.00    95.00    93.00    -8.00
down              470.00    40.00   140.00    90.00    90.00     0.00
o1                500.00     0.00   100.00     0.00     0.00     0.00
o2                600.00    40.00   120.00     0.00     0.00     0.00
o3                520.00   100.00    90.00     0.00     0.00     0.00
o4                450.00   100.00   100.00     0.00     0.00     0.00
.END
"""
CASES = {
    "base": """MOVE safe
BASE 20, -10, 15, 12
DEPARTS 10
DRAW 5, 10, 0
MOVE safe
DRAW 0, 20, 0
DEPARTS 15
BREAK
SET p = HERE
TYPE DX(p), DY(p)
BASE
MOVES p
TYPE DZ(p)""",
    "frame": """SET f = FRAME(o1, o2, o3, o4)
MOVE safe
FOR i = 0 TO 2
MOVES f:TRANS(20*i, 5, 60, 90, 90, 30)
MOVES f:TRANS(20*i, 5, 80, 90, 90, 30)
END
SET g = FRAME(o1, o1:TRANS(10), o1:TRANS(0,9), o4)
TYPE DX(g:TRANS(3,4,5)), DY(g:TRANS(3,4,5)), DZ(g:TRANS(3,4,5))
SET g = FRAME(o1, o1:TRANS(0,10), o1:TRANS(9,0), o4)
TYPE DX(g:TRANS(3,4,5)), DY(g:TRANS(3,4,5)), DZ(g:TRANS(3,4,5))
SET g = FRAME(o1, o1:TRANS(0,0,10), o1:TRANS(9,0), o4)
TYPE DX(g:TRANS(3,4,5)), DY(g:TRANS(3,4,5)), DZ(g:TRANS(3,4,5))""",
    "bits": """MOVE safe
BREAK
n = BITS(1001, 2)
BITS 1, 3 = 5
TYPE n
IF n == 2 THEN
MOVE left
END
BREAK
BITS 1, 3 = n + 1
MOVE right
BITS 1, 3 = 0
BREAK
x = 5
BITS 1, 3 = x / 2""",
    "outputs": """SIGNAL 1
MOVE safe
BREAK
IF SIG(1, -2) THEN
MOVE left
SIGNAL 2
END
BREAK
WAIT SIG(2)
IF BITS(1, 2) == 3 THEN
MOVE right
END
BREAK
RESET
IF SIG(-1) THEN
MOVE safe
END""",
    "joints": """MOVE safe
MOVES left
DRIVE 1, 12, 50
SPEED 40
DRIVE 6, -20
MOVE right
BREAK
HERE #q
DEPARTS 30
DRIVE 5, 8, 100
MOVE #q
BREAK
SET #w = #HERE
MOVES safe
MOVE #w""",
    "strings": """$name = "part"
$other = $name
MOVE safe
TYPE $other
$name = "none"
TYPE $name, 5""",
}


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("ways", [2, pytest.param(1, marks=pytest.mark.thorough)])
def test_words_do_what_they_do_in_the_run(name: str, ways: int) -> None:
    inputs = {1001: bool(ways & 1), 1002: bool(ways & 2)}
    folder, run = exported(f".PROGRAM main\n{CASES[name]}\n.END\n{PLACES}", inputs=inputs)
    assert folder.files is not None, folder.diagnostics
    table = read_table(SourceFile("io.toml", folder.files["io.toml"].decode()))
    on = {pin for signal, pin in table.inputs.items() if inputs[signal]}
    text = folder.files["program.script"].decode()
    done = carried_out(text, run, lambda pin: pin in on)
    same_motions(done, run, rounded=False)
    joints_alike(done, run)
    told_alike(done, run, table.outputs)
    shown = [word for e in run.events if isinstance(e, Printed) for word in e.text.split()]
    told = [item[1] for item in done if not isinstance(item, Motion) and item[0] == "text"]
    assert len(told) == len(shown)
    for word, printed in zip(told, shown, strict=True):
        assert word == printed or word == pytest.approx(float(printed), rel=1e-4, abs=6e-3)


def test_what_is_worked_out_in_the_run_is_refused() -> None:
    for step, says in (
        ("BITS x, 2 = 3", "the signals of BITS are worked out"),
        ("BITS 2001, 2 = 3", "BITS sets signals that are no outputs"),
        ('$a = $ENCODE(x)+"b"', "URScript's strings are only kept and told"),
        ("MOVE safe\nBITS 1, 2 = x", "the arm may still move"),
    ):
        folder, _ = exported(f".PROGRAM main\nx = 1\n{step}\n.END\n{PLACES}")
        assert next(d.headline for d in folder.diagnostics if d.is_error).startswith(says), step
