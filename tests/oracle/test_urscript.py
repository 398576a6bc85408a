"""URScript as an interpreter from excerpts of UR's manual carries it out, beside the run."""

from pathlib import Path

import numpy as np
import pytest

from tests.oracle.urscript.drawn import AUTO, drawn
from tests.oracle.urscript.interpreter import Motion, Robot
from tests.oracle.urscript.values import NotTaken
from tests.support_commands import vrts_text
from tests.support_programs import ROOT
from tests.support_urscript import (
    carried_out,
    exported,
    flange_of,
    joints_alike,
    outputs,
    same,
    same_motions,
    told_alike,
)
from vrts.base.source import SourceFile
from vrts.dispatch.saying.table import read_table
from vrts.engine.memory.events import Printed
from vrts.pipeline.refused import Refused

PLACES = """.LOCATIONS
can1_grip         450.00  -150.00   -40.00    90.00    90.00     0.00
base1_put         480.00   250.00    20.00    90.00    90.00     0.00
safe              460.00    50.00   200.00    90.00    90.00     0.00
turn1              30.00    20.00    10.00    90.00   -80.00     5.00
.END
"""
CARRY = """.PROGRAM main
SPEED 60 ALWAYS
OPENI
MOVE safe
CALL carry(can1_grip, base1_put, 120)
MOVE safe
TYPE "done"
.END
.PROGRAM carry(start, goal, up)
APPRO start, up
SPEED 200 MMPS
MOVES start
CLOSEI
DEPARTS up
APPRO goal, up
SPEED 30
MOVES goal
OPENI
DEPARTS up
.END
"""
DECIDES = """.PROGRAM main
SIGNAL -1, 2
x = 0
FOR i = 1 TO 3
IF SIG(1001) AND (i <> 2) THEN
SET p = SHIFT(safe BY 10*i, -5, 0)
MOVE p
BREAK
SIGNAL 1
ELSE
MOVE safe:turn1
MOVES safe
BREAK
SIGNAL -1, 2001
END
x = x + i
END
CASE x OF
VALUE 6, 7:
DRAW 0, 20, -15
ANY
READY
END
WHILE x > 4 DO
DEPART 5
x = x - 1
END
DO
MOVES safe:TRANS(x, 0, 0, 90, -90, 10)
x = x - 2
UNTIL x < 0
BREAK
SET p = HERE
IF (DX(p) > 400) AND SIG(2001, -1001) THEN
MOVES p:INVERSE(turn1)
END
MOVE #j
BREAK
WAIT SIG(-1002)
SET p = HERE
MOVE p:turn1
TOOL TRANS(0, 0, 100, 90, -90, 0)
MOVES safe
MOVE NULL:safe
BREAK
SIGNAL -2
.END
"""
JOINTS = "#j 10 -80 95 -100 -85 5\n"


def test_a_can_is_carried_where_the_run_carried_it() -> None:
    folder, run = exported(CARRY + PLACES)
    assert folder.files is not None, folder.diagnostics
    text = folder.files["program.script"].decode()
    same(text, run, on=False)
    joints_alike(carried_out(text, run, on=False), run)
    hand = [(1, False), (0, True), (0, False), (1, True), (1, False), (0, True)]
    assert sorted(outputs(text, run, on=False)) == sorted(hand)
    assert "def prog_carry(own_start, own_goal, own_up):" in text
    assert text.count("prog_carry(") == 2
    assert ("text", "done") in carried_out(text, run, on=False)
    assert any(isinstance(m, Motion) and m.r > 0.0 for m in carried_out(text, run, on=False))


@pytest.mark.parametrize(
    "on", [False, pytest.param(True, marks=pytest.mark.thorough)], ids=["off", "on"]
)
def test_both_ways_of_decisions_lead_where_the_run_went(on: bool) -> None:
    text = DECIDES + PLACES.replace(".END", JOINTS + ".END")
    folder, run = exported(text, on)
    assert folder.files is not None, folder.diagnostics
    script = folder.files["program.script"].decode()
    same(script, run, on)
    first = [(0, False), (1, True)]  # the table begins with outputs 2 and 3
    loop = [(0, True), (0, False), (0, True)] if on else [(0, False)] * 3
    wanted = [(pin + 2, state) for pin, state in (*first, *loop, (1, False))]
    assert outputs(script, run, on) == wanted
    other, _ = exported(text, not on)
    assert other.files is not None
    same(other.files["program.script"].decode(), run, on, rounded=False)


@pytest.mark.parametrize(
    ("steps", "headline"),
    [
        ("IF x THEN\nMOVE safe\nEND\nSIGNAL 1", "the arm may still move when this looks"),
        ("MOVE safe\nIF SIG(1001) THEN\nMOVES safe\nEND", "the arm may still move when"),
        ("MOVET safe, 50", "URScript has nothing that means MOVET"),
        ("SET #q[1] = #PPOINT(0,-90,90,0,0,0)\nMOVE #q[1]", "URScript reads a list of joints"),
        ("CALL two(x)", "`x` is passed to `two`, which changes it too"),
        ("RIGHTY\nMOVE safe", "URScript has nothing that means arm branches"),
        ("REACTI 2001, halt1\nMOVE safe", "signal 2001 is watched and is no input"),
        ("REACTI 1001, two\nMOVE safe", "`two` takes arguments"),
        ("REACT 1001, go\nMOVE safe", "`go` may leave the arm moving"),
        ("REACT 1001, halt1, 2\nREACT 1002, halt1, 3", "reactions have different priorities"),
        ("REACT 1001, twice\nMOVE safe\nx = 3\nBREAK", "a reaction knows `x`, and the arm"),
        ("MOVE safe\nIF TIMER(1) > 2 THEN\nHALT\nEND", "the arm may still move when this"),
        ("TIMER x = 0\nMOVE safe", "the number of a timer is worked out"),
    ],
)
def test_what_ur_cannot_do_is_refused_with_the_line(steps: str, headline: str) -> None:
    more = ".PROGRAM halt1\nHALT\n.END\n.PROGRAM two(n)\nn = 1\nx = 2\n.END\n"
    more += ".PROGRAM go\nMOVE safe\n.END\n.PROGRAM twice\nx = 2 * x\n.END\n"
    text = f".PROGRAM main\nx = 1\n{steps}\n.END\n{more}{PLACES}"
    folder, _ = exported(text)
    assert folder.files is None
    found = [d for d in folder.diagnostics if d.is_error]
    assert found[0].rule.code == "V877"
    assert found[0].headline.startswith(headline)
    assert found[0].primary is not None
    assert found[0].primary.span.text in steps


def test_the_table_says_which_pin_is_which_signal() -> None:
    table = "[hand]\nopen = 6\nclose = 7\n[inputs]\n1001 = 4\n[outputs]\n1 = 5\n"
    steps = ".PROGRAM main\nSIGNAL 1\nIF SIG(1001) THEN\nMOVE safe\nEND\nMOVE safe\n.END\n"
    folder, _ = exported(steps + PLACES, table=table)
    assert folder.files is not None
    text = folder.files["program.script"].decode()
    assert "set_standard_digital_out(5, True)" in text
    assert "if (get_standard_digital_in(4)):" in text
    assert read_table(SourceFile("io.toml", folder.files["io.toml"].decode())).hand_open == 6
    folder, _ = exported(steps + PLACES, table=table.replace("= 4", "= 9"))
    assert [d.rule.code for d in folder.diagnostics if d.is_error] == ["V878"]


def test_the_table_says_what_hangs_on_the_flange() -> None:
    table = "[hand]\nopen = 0\nclose = 1\n[payload]\nmass_kg = 1.25\ncentre_mm = [0, 10, 65]\n"
    steps = ".PROGRAM main\nMOVE safe\n.END\n"
    folder, run = exported(steps + PLACES, table=table)
    assert folder.files is not None
    text = folder.files["program.script"].decode()
    robot = Robot(flange_of(run), run.scene.robot.arm.ready, lambda _: False)
    robot.run(text)
    assert robot.payload == 1.25
    assert "set_payload(1.25, [0.0, 0.01, 0.065])" in text
    assert "says 1.25 kg, its centre at 0, 10, 65 mm" in folder.files["sheet.md"].decode()
    again = SourceFile("io.toml", folder.files["io.toml"].decode())
    assert read_table(again, payloads=True).payload == ((1.25), (0.0, 10.0, 65.0))
    with pytest.raises(Refused):  # of another controller
        read_table(again)
    folder, _ = exported(steps + PLACES)
    assert folder.files is not None
    assert b"set_payload" not in folder.files["program.script"]
    assert b"**Payload is not set**" in folder.files["sheet.md"]


def test_the_interpreter_refuses_what_the_manual_does_not_have() -> None:
    robot = Robot(lambda _: np.eye(4), (0.0,) * 6, lambda _: False)
    for text, why in (
        ("def p():\n  movej(p[0,0,0,0,0])\nend\n", "six numbers"),
        ("def p():\n  x = y\nend\n", "has no value"),
        ("def p():\n  if 1:\n    sync()\n  end\nend\n", "True or False"),
        ("def p():\n  while True:\n    sync()\nend\n", "`end` is missing"),
        ("def p():\n  MOVE(3)\nend\n", "no function"),
        ("def p():\n  x = 1 + True\nend\n", "no numbers"),
        ("def p():\n  movel(p[0,0,0,0,0,0], z=3)\nend\n", "a, v, t, r"),
        ("def p():\n  if x == 1\nend\n", "`:` is missing"),
    ):
        with pytest.raises(NotTaken, match=why):
            robot.run(text)
    for place in (ROOT / "tests" / "oracle" / "urscript").glob("*.py"):
        assert "from vrts" not in place.read_text(encoding="utf-8")


def test_the_command_writes_a_folder_and_refuses_other_arms(tmp_path: Path) -> None:
    place = tmp_path / "prog.v2"
    place.write_text(CARRY + PLACES)
    call = ("dispatch", "export", place, "--to", "urscript", "-o", tmp_path / "out", "--scene")
    done = vrts_text(*call, "one-can-ur5")
    assert done.returncode == 0, done.stderr
    assert "not tried on a controller" in done.stderr
    assert "**Not tried on a controller.**" in (tmp_path / "out" / "sheet.md").read_text()
    place.write_text(".PROGRAM main\nREADY\n.END\n")
    done = vrts_text(*call, "one-can-puma560")
    assert done.returncode == 1
    assert "V878" in done.stderr


def test_a_program_has_variables_of_its_own_wherever_it_is_called() -> None:
    folder, run = exported(AUTO, dialect="vplus")
    assert folder.files is not None, folder.diagnostics
    script = folder.files["program.script"].decode()
    same(script, run, on=False)
    shown = [e.text.split() for e in run.events if isinstance(e, Printed)]
    told = [item[1] for item in carried_out(script, run, on=False) if item[0] == "text"]
    assert told == [float(word) for row in shown for word in row] == [61.0, 3.0]
    folder, _ = exported(
        AUTO.replace("x = 1\n", "x = 1\nIF n > 9 THEN\nCALL main\nEND\n"), dialect="vplus"
    )
    assert [d.rule.code for d in folder.diagnostics if d.is_error] == ["V877"]


PARTS = [
    pytest.param(k, marks=(pytest.mark.thorough,) if k > 0 else (), id=f"{10 * k}")
    for k in range(8)
]


@pytest.mark.thorough
@pytest.mark.parametrize("part", PARTS)
def test_programs_drawn_by_chance_do_the_same(part: int) -> None:
    """Motions, outputs with their times, what is typed, and both ways of decisions."""
    written = 0
    for number in range(10 * part, 10 * part + (10 if part else 2)):
        for ways in (0, 3):
            inputs = {1001: bool(ways & 1), 1002: bool(ways & 2), 1003: True}
            folder, run = exported(drawn(number), inputs=inputs)
            assert folder.files is not None, (number, folder.diagnostics)
            table = read_table(SourceFile("io.toml", folder.files["io.toml"].decode()))
            on = {pin for signal, pin in table.inputs.items() if inputs[signal]}
            text = folder.files["program.script"].decode()
            done = carried_out(text, run, lambda pin, on=on: pin in on)
            same_motions(done, run)
            told_alike(done, run, table.outputs)
            joints_alike(done, run)
            printed = [e.text.split() for e in run.events if isinstance(e, Printed)]
            told = [item[1] for item in done if item[0] == "text"]
            assert len(told) == sum(map(len, printed))
            for word, shown in zip(told, (w for row in printed for w in row), strict=True):
                assert word == shown or word == pytest.approx(float(shown), rel=1e-4, abs=6e-3)
            written += 1
    assert written >= 4
