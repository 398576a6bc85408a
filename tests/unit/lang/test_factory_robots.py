"""Habits of FANUC, KRL, RAPID and URScript: one message each, with the step of VAL-II for it."""

import pytest

from tests.mistakes import compiled, said
from vrts.base.mending import edits_of, with_edits

HEAD = ".PROGRAM cell()\n n = 0\n SET pick = TRANS(400, 0, 0, 90, 90, 0)\n"
TAIL = "\n MOVE pick\n TYPE n\n.END\n"


def told(step: str) -> tuple[str, str, str]:
    """Return headline, help, and the steps after the edits of the one message about steps."""
    text = f"{HEAD} {step}{TAIL}"
    (found,) = said(compiled(text))
    mended = with_edits(text, edits_of([found]))
    return found.headline, " ".join(found.help), mended[len(HEAD) + 1 : -len(TAIL)]


@pytest.mark.parametrize(
    ("step", "after"),
    [
        ("WaitDI di1, 1", "WAIT SIG(1001)"),
        ("WaitDI di12, 0", "WAIT SIG(-1012)"),
        ("WaitDO do1, 1", "WAIT SIG(1)"),
        ("Set do1", "SIGNAL 1"),
        ("Reset do1", "SIGNAL -1"),
        ("WAIT DI[1]=ON", "WAIT SIG(1001)"),
        ("WAIT DI[101]=OFF", "WAIT SIG(-1101)"),
        ("WAIT DI[1]==ON", "WAIT SIG(1001)"),
        ("WAIT RI[2]", "WAIT SIG(1002)"),
        ("WAIT $IN[3]==TRUE", "WAIT SIG(1003)"),
        ("WAIT $IN[3]", "WAIT SIG(1003)"),
        ("WAIT FOR $IN[3]", "WAIT SIG(1003)"),
        ("WAIT FOR NOT $IN[3]", "WAIT NOT SIG(1003)"),
        ("IF DI[1]=ON THEN\n n = 2\n END", "IF SIG(1001) THEN\n n = 2\n END"),
        ("WAIT $IN[3]==FALSE AND SIG(1001)", "WAIT SIG(-1003) AND SIG(1001)"),
        ("WAIT 1.50(sec)", "DELAY 1.50"),
        ("DO[4]=ON", "SIGNAL 4"),
        ("DO[4]=OFF", "SIGNAL -4"),
        ("RO[1]=ON", "SIGNAL 1"),
        ("$OUT[4]=TRUE", "SIGNAL 4"),
        ("LIN pick C_VEL", "MOVES pick"),
        ("PTP pick C_PTP", "MOVE pick"),
        ("CP OFF", "DISABLE CP"),
        ("SWITCH CP ON", "ENABLE CP"),
        ("SET pick = p[500,0,100,90,90,0]", "SET pick = TRANS(500,0,100,90,90,0)"),
        ("BITS(1,8) = n", "BITS 1, 8 = n"),
        ("BITS 1,8 == n", "BITS 1, 8 = n"),
        ("READY home", "READY"),
        ("BREAK 2", "BREAK"),
        ("n = RANDOM(6)", "n = INT(6*RANDOM)+1"),
        ("n = RANDOM(2, 5)", "n = INT((5-2+1)*RANDOM)+2"),
        ("n = 1'200", "n = 1200"),
        ("DRAW TRANS(0, 0, 50)", "DRAW 0, 0, 50"),
        ("grip the part", "; grip the part"),
        ("move to the pick position", "; move to the pick position"),
    ],
)
def test_the_edit_writes_the_step_of_val_2(step: str, after: str) -> None:
    assert told(step)[2] == after


@pytest.mark.parametrize(
    ("step", "helps"),
    [
        ("J P[1] 100% FINE", "`SPEED 100`, `FINE` and `MOVE p[1]`"),
        ("L P[2] 200mm/sec CNT50", "`SPEED 200 MMPS` and `MOVES p[2]`"),
        ("WaitDI di_part, 1", "`WAIT SIG(1001)`"),
        ("SetDO doGrip, 1", "`SIGNAL 3`"),
        ("PulseDO \\PLength:=0.5, do3", "`DELAY 0.5`"),
        ("DO[4]=PULSE, 0.5sec", "`SIGNAL 4`"),
        ("LIN {X 400, Y 0, Z 100}", "`MOVES TRANS("),
        ("LBL[1]", "whole number"),
        ("BASE pick", "`BASE DX(pick), DY(pick), DZ(pick)`"),
        ("DRAW pick", "`MOVES pick`"),
        ("SPEED pick", "`SPEED 50`"),
        ("CLOSEI pick", "CLOSEI alone"),
        ("n = INT(6*RND)", "RANDOM"),
        ("n = LEN(z[])", "LEN counts the letters of a string"),
        ("MOVE pick;pick", "`pick:pick`"),
        ("IF DEFINED(pick) == 1 THEN\n n = 2\n END", "leave the comparison out"),
        ("MOVE TRANS(2000, 0, -100, 90, 90, 0)", "millimetres"),
    ],
)
def test_the_help_says_what_to_write(step: str, helps: str) -> None:
    assert helps in told(step)[1]


@pytest.mark.parametrize(
    "step",
    [
        "MOVE pick;pick the part up",
        "di[1] = n\n IF di[1] == 1 THEN\n n = 2\n END",
        "out[1] = TRUE\n TYPE out[1]",
        "SET slot[1] = pick\n row = 1\n MOVE slot[row*1+row-row+0*row]",
        "SET far = TRANS(2000, 0, 0, 90, 90, 0)\n MOVE pick:far",
    ],
)
def test_what_is_right_stays_unsaid(step: str) -> None:
    assert said(compiled(f"{HEAD} {step}{TAIL}")) == []
