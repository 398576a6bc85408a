"""Every run-time error: VAL's words and number, and what becomes of it."""

import pytest

from tests.support_engine import lines, runs, words
from vrts.engine.memory.records import Ending
from vrts.ir.runtime_errors import RuntimeErrorKind as Kind

PC = ".PROGRAM watch\nWAIT SIG(2001)\n.END\n.PROGRAM arm\nREADY\n.END\n"
DEEP = ".PROGRAM deep\nCALL deep\n.END\n"

RAISED = [
    (Kind.UNDEFINED_VALUE, "x = y", "val2"),
    (Kind.UNDEFINED_VALUE, "MOVE nowhere", "val2"),
    (Kind.ILLEGAL_VALUE, "SPEED 0", "val2"),
    (Kind.ILLEGAL_ARRAY_INDEX, "n = -1\na1[n] = 0", "val2"),
    (Kind.ILLEGAL_SIGNAL, "n = 1001\nSIGNAL n", "val2"),
    (Kind.UNDEFINED_PROGRAM, "CALL nosuch", "val2"),
    (Kind.INVALID_ARGUMENT, "TYPE PARAMETER(NOSUCH)", "vplus"),
    (Kind.ARGUMENT_MISMATCH, '$n = "p"\nCALLS $n(1,2,3)', "vplus"),
    (Kind.ARITHMETIC_OVERFLOW, "x = 1E30*1E30", "val2"),
    (Kind.NEGATIVE_SQUARE_ROOT, "x = SQRT(-1)", "val2"),
    (Kind.STACK_FULL, "CALL deep", "val2"),
    (Kind.DIVISION_BY_ZERO, "x = 1/0", "val2"),
    (Kind.DIVISION_BY_ZERO, "x = 1 MOD 0", "val2"),
    (Kind.STRING_OVERFLOW, '$s = "0123456789"\nDO\n$s = $s+$s\nUNTIL FALSE', "val2"),
    (Kind.CONTROL_STRUCTURE, "GOTO 5\nFOR i = 1 TO 2\n5 x = 1\nEND", "val2"),
    (Kind.ILLEGAL_JOINT, "n = 7\nDRIVE n, 10", "val2"),
    (Kind.OUT_OF_RANGE, "SET #p = TRANS(3000,0,0,90,90,0)", "val2"),
    (Kind.CANNOT_ALTER_CONFIGURATION, "MOVE a\nRIGHTY\nMOVES b", "val2"),
    (Kind.ILLEGAL_MOTION_FROM_HERE, "MOVES a", "val2"),
    (Kind.TOO_FAR, "MOVE TRANS(2000,0,0,90,90,0)", "val2"),
    (Kind.TOO_CLOSE, "MOVE TRANS(50,0,0,90,90,0)", "val2"),
    (Kind.ROBOT_POWER_OFF, "DISABLE POWER\nREADY", "val2"),
    (Kind.HAND_CLOSED_TOO_FAR, "GRASP 10", "val2"),
    (Kind.PROCESS_EXECUTING, "PCEXECUTE watch\nPCEXECUTE watch", "val2"),
    (Kind.ILLEGAL_RETURNE, "RETURNE", "val2"),
    (Kind.INVALID_SWITCH, "ENABLE NO.SUCH", "vplus"),
    (Kind.NOT_INSTALLED, "IOPUT 1 = 5", "val2"),
]
ELSEWHERE = {
    Kind.ILLEGAL_IN_PROCESS: "test_process: it ends the process control program",
    Kind.INVALID_NUMBER: "test_terminal: it needs an answer",
    Kind.JOINT_OUT_OF_RANGE: "below: its words name the joint",
}


def test_every_error_is_raised_somewhere() -> None:
    assert {kind for kind, _, _ in RAISED} | ELSEWHERE.keys() == set(Kind)


@pytest.mark.parametrize(("kind", "body", "dialect"), RAISED)
def test_the_program_stops_with_vals_words(kind: Kind, body: str, dialect: str) -> None:
    run = runs(body, PC + DEEP + ".PROGRAM p(x)\nx = 1\n.END\n", dialect=dialect)
    assert words(run) == [kind.value.words]
    assert run.ending is Ending.ERROR


@pytest.mark.parametrize(("kind", "body", "dialect"), RAISED)
def test_a_program_that_catches_it_learns_number_and_words(
    kind: Kind, body: str, dialect: str
) -> None:
    catch = ".PROGRAM catch\nTYPE /I0, ERROR(-1)\nTYPE $ERROR(ERROR(-1))\n.END\n"
    more = PC + DEEP + ".PROGRAM p(x)\nx = 1\n.END\n" + catch
    run = runs(f"REACTE catch\n{body}", more, dialect=dialect)
    texts = [text for _, text in lines(run)]
    assert texts == [str(kind.value.number), f"*{kind.value.words}*"]
    assert words(run) == []


JOINTS = [(1, 170.0), (2, 120.0), (3, 200.0), (4, 300.0), (5, 130.0), (6, 400.0)]


@pytest.mark.parametrize(("joint", "change"), JOINTS)
def test_a_joint_beyond_its_range_is_named(joint: int, change: float) -> None:
    catch = ".PROGRAM catch\nTYPE /I0, ERROR(-1)\nTYPE $ERROR(ERROR(-1))\n.END\n"
    drive = f"DRIVE {joint}, {change}"
    assert words(runs(drive)) == [f"Joint {joint} out of range"]
    texts = [text for _, text in lines(runs(f"REACTE catch\n{drive}", catch))]
    assert texts == [str(-1000 - joint), f"*Joint {joint} out of range*"]


def test_an_unknown_number_has_no_words() -> None:
    assert lines(runs("TYPE $ERROR(5), $ERROR(-99)"))[0][1] == ""


def test_nothing_of_a_step_that_fails_is_done() -> None:
    run = runs("x = 1\nx = 2+1/0")
    assert run.at(run.horizon_s).variables["x"] == 1.0
    run = runs("n = 1001\nSIGNAL 1, n")
    assert run.at(run.horizon_s).signals == {1}
